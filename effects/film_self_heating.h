#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "effects/effect.h"

namespace raceway::effects {

/// Viscosity of a film heated by its own friction [m²/s].
///
///   ν = ν(T_film),   T_film = T + R P(T_film),   P = M(ν(T_film)) ω
///
/// T is the recorded temperature, R the thermal resistance between film and sensor, P the friction
/// power, and ω the shaft speed. M is the viscous moment of the friction law without other effects
/// on the lubricant. For the contact law, M is the whole friction moment. Usually P falls as the
/// temperature rises. The equation for T_film then has one solution, between T and T + R P(T). If P
/// rises with temperature because asperities touch, the lowest solution is above T + R P(T).
/// Source:   heat balance with one resistance R; R of 5 to 40 K/kW is assumed for a spindle
///           bearing.
/// Domain:   speed >= 0, R >= 0. Self-heating and a large distance between sensor and film have the
///           same influence on the data.
struct FilmSelfHeating {
  static constexpr std::string_view id = "film-self-heating";
  static constexpr std::string_view title = "oil film hotter than the temperature sensor";
  static constexpr std::string_view mechanism =
      "The friction power heats the oil film above the measured temperature, so the "
      "viscosity of the film falls. The effect is largest at high speed and high viscosity.";
  static constexpr std::string_view formula =
      "viscosity nu at T_film = T + R P, with the power P = M0 w calculated at T_film (T: "
      "recorded temperature, R: thermal resistance, M0: viscous moment, w: shaft speed)";
  static constexpr std::string_view source =
      "heat balance with one thermal resistance; the usual range is assumed";
  static constexpr std::array<std::string_view, 4> confused_with{
      "inlet-shear-heating", "replenishment-starvation", "shear-thinning", "viscous-exponent"};
  static constexpr std::string_view settled_by =
      "the temperature with a second sensor nearer to the film, for example at the outer ring";
  static constexpr std::array parameters{Parameter{.name = "resistance_K_per_kW",
                                                   .unit = "K/kW",
                                                   .initial = 15.0,
                                                   .lower = 0.0,
                                                   .upper = 500.0,
                                                   .plausible_lower = 2.0,
                                                   .plausible_upper = 60.0}};
  static constexpr double size_power = -1.0;
  static constexpr std::array needs{Need::speed_levels};

  static void lubricant(const LubricantInputs& in, std::span<const double> values, Film& film) {
    const double resistance = values[0] * 1e-3;
    if (!(resistance > 0.0) || !(in.state.speed > 0.0)) return;
    friction::BearingState<double> s = in.state;
    const double outside = s.temperature;
    // Temperature rise minus the rise from the friction power.
    const auto rise = [&](double temperature) {
      s.temperature = temperature;
      s.kinematic_viscosity = in.lubricant.kinematic_viscosity(temperature);
      return temperature - outside - resistance * in.base.film_moment(s) * s.speed;
    };
    double low = outside, f_low = rise(low);
    double high = outside - f_low, f_high = rise(high);  // the power is lower here than at `low`
    // At low speed and high temperature, thinner oil shifts load to the asperities. The power then
    // grows with temperature.
    for (int i = 0; i < 20 && f_high < 0.0; ++i) {
      low = high;
      f_low = f_high;
      high = outside + 2.0 * (high - outside);
      f_high = rise(high);
    }
    if (!std::isfinite(f_low) || !(f_high > 0.0)) return;
    // Secant method with the last two points; bisection if the secant leaves the bracket.
    double before = low, f_before = f_low, temperature = high, f = f_high;
    for (int i = 0; i < 60 && std::abs(f) > 1e-10; ++i) {
      double next = temperature - f * (temperature - before) / (f - f_before);
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      // No further floating-point number lies in the bracket.
      if (next == low || next == high) break;
      before = temperature;
      f_before = f;
      temperature = next;
      f = rise(temperature);
      (f > 0.0 ? high : low) = temperature;
    }
    film.temperature = temperature;
    film.kinematic_viscosity = in.lubricant.kinematic_viscosity(temperature);
  }

  /// Solves the equation for T_film by Newton's method.
  static bool lubricant_by_tangents(const LubricantInputs& in, std::span<const double> values,
                                    double temperature, const TangentAbout& tangent_about,
                                    Film& film) {
    const double rise = values[0] * 1e-3 * in.state.speed;  // temperature rise per N m [K]
    if (!(rise > 0.0)) return true;
    const double outside = in.state.temperature;
    if (std::isnan(temperature)) temperature = outside;
    for (int i = 0; i < 60; ++i) {
      const MomentTangent t = tangent_about(temperature);
      const double fall = 1.0 - rise * t.slope;
      if (!std::isfinite(t.moment) || !(fall > 0.0)) return false;
      temperature =
          outside + std::fmax(rise * (t.moment + t.slope * (outside - t.temperature)) / fall, 0.0);
      if (!(std::abs(temperature - t.temperature) <= t.reach)) continue;
      film.temperature = temperature;
      film.kinematic_viscosity = in.lubricant.kinematic_viscosity(temperature);
      return true;
    }
    return false;
  }
};

}  // namespace raceway::effects
