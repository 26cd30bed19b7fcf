#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/model.h"
#include "record/parameter.h"

namespace raceway::model {

/// Returns all parameters of a model that a fit can change, with their values in the model. The
/// order is: base law, arrangement, bearing, spindle, effects. Each line below gives the name of a
/// parameter and its addresses in the model file.
///
///   f0, z, y, mu_bl, scale ...  friction.f0, friction.z and so on
///   limiting_traction           lubricant.limiting_traction
///   preload_N                   arrangement.preload_N: force on each set at standstill
///   inner_conformity            bearing.inner_conformity; outer_conformity likewise
///   conformity                  both conformities, if they are equal in the model
///   contact_angle_deg           bearing.contact_angle_deg: free contact angle. The preload
///                               force is independent of this value
///   convection_factor           ambient.convection_factor of a spindle
///   lubricant_conductance_W_K   bearing.lubricant_conductance_W_K
///   outer_conductance_W_m2K     seat.outer_conductance_W_m2K, if the model gives it
///   flange_conductance_W_K      housing.flange_conductance_W_K
///   inlet_temperature_C         coolant.inlet_temperature_C of the first circuit
///   flow_l_min                  coolant.flow_l_min of the first circuit
///   NAME.inlet_temperature_C    coolant.circuit.1.inlet_temperature_C of the third circuit, if
///                               the circuit gives it
///   NAME.flow_l_min             coolant.circuit.1.flow_l_min of the third circuit
///   motor.heat_W, drive.heat_W  motor.heat_W, drive.heat_W
///   NAME.heat_W                 heat.2.heat_W of the third [[heat]]
///   motor.heat_factor ...       motor.heat_factor ..., in place of heat_W if heat_W is a formula
///   sensor.NAME.position_mm     sensor.2.position_mm of the third sensor
///   mixed-lubrication.K_rs      effect.2.K_rs of the third effect; the name is "id.name"
///
/// Indices in addresses begin at 0, and coolant.circuit.0 is the second circuit. Parameters of the
/// bearing exist only with a shaft whose sets have equal bearings. A parameter of the bearing has
/// one value for all bearings of the arrangement. The preload is a parameter only if the model file
/// gives a preload force. Plausible range and neutral value (record::Parameter::neutral) are given
/// for parameters of effects; for all other parameters, they are NaN.
[[nodiscard]] std::vector<record::Parameter> parameters(const Model& model);

/// Returns the usual range of an effect's parameter for the size of the model's bearing, in the
/// unit of the files. No range is published for effects to which all rotating parts of a coast-down
/// rig contribute. For these effects, the upper limit is the upper bound of the parameter.
[[nodiscard]] std::pair<double, double> plausible_range(const effects::Description& effect,
                                                        const effects::Parameter& number,
                                                        const Model& model);

/// Returns the bounds of an effect's parameter in the unit of the files. If
/// record::NumberCard::of_the_record is true, the bounds are the lowest and the highest recorded
/// temperature.
[[nodiscard]] std::pair<double, double> bounds_of(const effects::Parameter& number,
                                                  const Model& model);

/// Place of a parameter in a model. Create the place once before a fit, because a fit sets
/// parameters thousands of times.
class ParameterPlace {
 public:
  /// Throws std::invalid_argument for an address that the model does not have.
  ParameterPlace(const Model& model, const record::Parameter& parameter);

  /// Returns the value in the unit of the model file. `model` must have the same effects as the
  /// model that the constructor received.
  [[nodiscard]] double get(const Model& model) const;
  /// Sets the value, in the unit of the model file. Throws std::invalid_argument if the bearing or
  /// the arrangement cannot have this value.
  void set(Model& model, double value) const;
  /// Returns the index of the effect to which the parameter belongs; -1 if it belongs to no effect.
  [[nodiscard]] int effect() const { return effect_; }
  /// Returns the index of the thermometer whose position is the parameter; empty for all other
  /// parameters.
  [[nodiscard]] std::optional<std::size_t> sensor() const {
    return kind_ == Kind::sensor ? std::optional(index_) : std::nullopt;
  }

 private:
  enum class Kind { law, effect, preload, bearing, spindle, coolant, heat, sensor };
  void resolve(const Model& model, const std::string& address);

  Kind kind_ = Kind::law;
  int effect_ = -1;
  // index of the parameter in the list of its kind: values of the law, of the effect or of the
  // spindle, values of all circuits, heat sources, or sensors
  std::size_t index_ = 0;
  std::vector<double bearing::BearingGeometry::*> members_;
  double factor_ = 1.0;  // factor to the unit of the members
};

/// Returns the value at the addresses of a parameter, in the unit of the files. Throws the same
/// exceptions as the functions of ParameterPlace.
[[nodiscard]] double get(const Model& model, const record::Parameter& parameter);
void set(Model& model, const record::Parameter& parameter, double value);

/// Returns the parameters of a friction law that a fit changes by default:
///
///   palmgren         f0, z; not y, because data rarely separate y from z. For rollers: f0, f1
///   powers           all parameters; also for contact-powers
///   skf              mu_EHL, K_rs
///   contact          rolling_factor
///   table            scale
[[nodiscard]] std::vector<std::string> default_free(friction::FrictionLaw law);

/// Returns the parameters of a model that are free by default. For a spindle, only the first
/// default parameter of the law is free, such as f0. For an arrangement with a preload force, only
/// the preload is free, because assembly makes the preload uncertain. For models without a spindle
/// and without a preload force, the defaults of the law apply.
[[nodiscard]] std::vector<std::string> default_free(const Model& model);

}  // namespace raceway::model
