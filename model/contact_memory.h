#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "effects/effect.h"
#include "friction/contact/contact_law.h"

namespace raceway::model {

/// Ball equilibrium, shared by all objects that use it.
using Balance = std::shared_ptr<const bearing::BearingEquilibrium>;

/// Stores contact results of one row for fits that need almost equal results repeatedly, because
/// the integrals over the contact ellipses take most of the time.
///
/// The key of a result consists of equilibrium, oil, temperature and the parameters of the law,
/// except the factors of rolling and hysteresis. For effects of film self-heating, results at a
/// nearby temperature come from linear extrapolation along the viscosity curve ν(T) of the oil.
/// Accuracy: relative error 1e-7 for extrapolated results; other results equal the results of
///           contact_result().
class ContactMemory {
 public:
  /// Returns the contact result for the bearing state `s` with the ball equilibrium `balls`.
  /// `values` are the parameter values of the contact law, in all functions of this class.
  [[nodiscard]] friction::contact::ContactResult at(const Balance& balls,
                                                    const friction::BearingState<double>& s,
                                                    std::span<const double> values);
  /// Stores a result that was computed elsewhere.
  void know(const Balance& balls, const friction::BearingState<double>& s,
            std::span<const double> values, const friction::contact::ContactResult& result) {
    (void)remember(balls, s, values, result);
  }
  /// Returns the friction moment of the bearing state `s`, and its derivative with respect to
  /// temperature along ν(T) of the oil. Both values are for a stored temperature near
  /// s.temperature, or for s.temperature itself if no stored temperature is near enough.
  [[nodiscard]] effects::MomentTangent tangent(const Balance& balls,
                                               friction::BearingState<double> s,
                                               std::span<const double> values);
  /// Returns the temperature of the last requested tangent [K]; NaN if no tangent was requested.
  [[nodiscard]] double last_temperature() const { return last_temperature_; }

 private:
  /// Sliding, rolling and hysteresis at both races, and drag: [N m], or [N m/K] for a slope.
  using Parts = std::array<double, 7>;
  struct Known {
    Balance balls;  // kept alive so that no other equilibrium gets its address
    double viscosity_40C, viscosity_100C, temperature, viscosity;
    std::vector<double> values;  // parameter values of the law
    friction::contact::ContactResult result;
    bool along_oil;      // true if the viscosity is that of the oil at `temperature`
    Parts slope{};       // derivative by temperature, along ν(T)
    double reach = 0.0;  // range in which the slope is valid [K]; 0: no slope yet
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

  std::vector<Known> known_;  // newest first; a vector, because many rows store nothing
  double last_temperature_ = unset;
};

}  // namespace raceway::model
