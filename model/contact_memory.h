#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "effects/film_self_heating.h"
#include "friction/contact/contact_law.h"

namespace raceway::model {

/// Balls in balance, shared by all that look at them.
using Balance = std::shared_ptr<const bearing::BearingEquilibrium>;

/// Stored contact results of one row, for fits that need nearly the same ones repeatedly: the
/// integrals over the ellipses take most of their time.
///
/// The key of a result is balance, oil, temperature and the parameters of the law; factors of
/// rolling and hysteresis may differ. Along ν(T) of the oil it is known close by too, in proportion
/// to the temperature, for films that warm themselves. Accuracy: by temperature 1e-7; all else is
/// what contact_result() gives.
class ContactMemory {
 public:
  /// Result for the state `s` with the balls `balls`.
  [[nodiscard]] friction::contact::ContactResult at(const Balance& balls,
                                                    const friction::BearingState<double>& s,
                                                    std::span<const double> values);
  /// Stores a result found elsewhere for a state.
  void know(const Balance& balls, const friction::BearingState<double>& s,
            std::span<const double> values, const friction::contact::ContactResult& result) {
    (void)remember(balls, s, values, result);
  }
  /// The whole moment of that state as it goes with temperature along ν(T) of its oil, about one
  /// that is known close to s.temperature, or there.
  [[nodiscard]] effects::FilmSelfHeating::Tangent tangent(const Balance& balls,
                                                          friction::BearingState<double> s,
                                                          std::span<const double> values);
  /// Temperature of the last tangent requested [K]; NaN if none was.
  [[nodiscard]] double last_temperature() const { return last_temperature_; }

 private:
  /// Sliding, rolling and hysteresis at both races, drag: [N m], or [N m/K] of a slope.
  using Parts = std::array<double, 7>;
  struct Known {
    Balance balls;  // kept, so that no other balance has its address
    double viscosity_40C, viscosity_100C, temperature, viscosity;
    std::vector<double> values;  // of the law
    friction::contact::ContactResult result;
    bool along_oil;      // viscosity is that of the oil at `temperature`
    Parts slope{};       // by temperature, along ν(T)
    double reach = 0.0;  // [K] to which the slope is good; 0: no slope yet
  };
  [[nodiscard]] static bool alike(const Known& known, const Balance& balls,
                                  const friction::BearingState<double>& s,
                                  std::span<const double> values);
  [[nodiscard]] static Parts parts(const friction::contact::ContactResult& result);
  [[nodiscard]] static friction::contact::ContactResult moved(const Known& known, double rise,
                                                              std::span<const double> values);
  Known& remember(const Balance& balls, const friction::BearingState<double>& s,
                  std::span<const double> values, const friction::contact::ContactResult& result);
  void find_slope(Known& known, friction::BearingState<double> s);

  std::vector<Known> known_;  // the newest first; a vector, as many rows never remember
  double last_temperature_ = unset;
};

}  // namespace raceway::model
