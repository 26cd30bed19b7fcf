#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "bearing/bearing_equilibrium.h"
#include "effects/effect.h"
#include "friction/contact/contact_law.h"

namespace raceway::model {

/// Shared pointer to a ball equilibrium.
using Balance = std::shared_ptr<const bearing::BearingEquilibrium>;

/// Stores contact results of one row of a record. A fit needs equal or nearly equal results many
/// times, and the integrals over the contact ellipses take most of the computing time.
///
/// A stored result is valid for the same ball equilibrium, oil and temperature, and for the same
/// parameters of the contact law, except the factors of rolling and hysteresis, which may differ.
/// For effects of film self-heating, results at a nearby temperature T are extrapolated linearly
/// along the viscosity curve ν(T) of the oil.
///
/// Accuracy: relative error 1e-7 for extrapolated results; other results equal the results of
///           contact_result().
class ContactMemory {
 public:
  /// Returns the contact result for the bearing state `s` with the ball equilibrium `balls`. In all
  /// functions of this class, `values` are the parameter values of the contact law.
  [[nodiscard]] friction::contact::ContactResult at(const Balance& balls,
                                                    const friction::BearingState<double>& s,
                                                    std::span<const double> values);
  /// Stores a contact result that the caller has computed.
  void know(const Balance& balls, const friction::BearingState<double>& s,
            std::span<const double> values, const friction::contact::ContactResult& result) {
    (void)remember(balls, s, values, result);
  }
  /// Returns the friction moment of the bearing state `s` and the derivative of the moment with
  /// respect to temperature. The derivative includes the change of the oil viscosity ν(T) with
  /// temperature. If a result for a temperature near s.temperature is stored, the function returns
  /// moment and derivative at the stored temperature.
  [[nodiscard]] effects::MomentTangent tangent(const Balance& balls,
                                               friction::BearingState<double> s,
                                               std::span<const double> values);
  /// Temperature of the result that the last call of tangent() returned [K]; NaN before the first
  /// call.
  [[nodiscard]] double last_temperature() const { return last_temperature_; }

 private:
  /// Moments of sliding, rolling and hysteresis at both races, and of drag [N m], or the
  /// derivatives of these moments with respect to temperature [N m/K].
  using Parts = std::array<double, 7>;
  struct Known {
    Balance balls;  // kept alive so that no other equilibrium gets its address
    double viscosity_40C, viscosity_100C, temperature, viscosity;
    std::vector<double> values;  // parameter values of the law
    friction::contact::ContactResult result;
    bool along_oil;      // true if `viscosity` is ν(`temperature`) of the oil
    Parts slope{};       // derivatives with respect to temperature, along ν(T) of the oil
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
