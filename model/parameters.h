#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/model.h"
#include "record/parameter.h"

namespace raceway::model {

/// All numbers of a model that may be fitted, with start and value as the model has them: base law
/// first, then arrangement and bearing, then the effects in their order.
///
///   f0, z, y; mu_bl, scale ... base law           friction.f0
///   preload_N                  force on each side at standstill
///                                                 arrangement.preload_N
///   inner_conformity, outer_conformity            bearing.inner_conformity
///   conformity                 of both grooves, where they are equal in the model
///   contact_angle_deg          free contact angle; the force of preload stays
///   convection_factor          of a spindle       ambient.convection_factor
///   lubricant_conductance_W_K                     bearing.lubricant_conductance_W_K
///   outer_conductance_W_m2K    where the model gives it
///                                                 seat.outer_conductance_W_m2K
///   flange_conductance_W_K                        housing.flange_conductance_W_K
///   motor.heat_W, drive.heat_W, NAME.heat_W       motor.heat_W, heat.2.heat_W of the third
///   [[heat]] motor.heat_factor ...      where heat_W is a formula
///                                                 motor.heat_factor
///   mixed-lubrication.K_rs     "id.name" of an effect
///                                                 effect.2.K_rs of the third effect
///
/// Of the bearing there are none without a shaft, and none where the sets have different bearings;
/// its numbers hold for all bearings in the arrangement. No preload where it is not given as a
/// force. `neutral` and the plausible range belong to effects; NaN elsewhere.
[[nodiscard]] std::vector<record::Parameter> parameters(const Model& model);

/// The range in which a number of an effect is met at a bearing of this size. Up to its bound where
/// whatever turns on the shaft of a coast-down adds to it, since that has no published size.
[[nodiscard]] std::pair<double, double> plausible_range(const effects::Description& effect,
                                                        const effects::Parameter& number,
                                                        const Model& model);

/// The bounds of a number of an effect in the unit of the files; the record's where the number has
/// to lie within it.
[[nodiscard]] std::pair<double, double> bounds_of(const effects::Parameter& number,
                                                  const Model& model);

/// Place of a parameter in a model, its addresses resolved once: a fit sets numbers thousands
/// of times.
class ParameterPlace {
 public:
  /// Throws std::invalid_argument for an address that the model does not have.
  ParameterPlace(const Model& model, const record::Parameter& parameter);

  /// Value in the unit of the file. `model` must have the effects of the model that it was made
  /// for.
  [[nodiscard]] double get(const Model& model) const;
  /// Throws std::invalid_argument where bearing or arrangement cannot take the value.
  void set(Model& model, double value) const;
  /// Index of the effect that it belongs to, -1 for all else.
  [[nodiscard]] int effect() const { return effect_; }
  /// Index of the thermometer of a spindle whose position it is; empty for every other parameter.
  [[nodiscard]] std::optional<std::size_t> sensor() const {
    return kind_ == Kind::sensor ? std::optional(index_) : std::nullopt;
  }

 private:
  enum class Kind { law, effect, preload, bearing, spindle, inlet, heat, sensor };
  void resolve(const Model& model, const std::string& address);

  Kind kind_ = Kind::law;
  int effect_ = -1;
  std::size_t index_ = 0;  // in the values of law or effect, of a number or a sensor of a spindle
  std::vector<double bearing::BearingGeometry::*> members_;
  double factor_ = 1.0;  // to the unit of the members
};

/// The number at the addresses of a parameter, in the unit of the files. Throws as ParameterPlace.
[[nodiscard]] double get(const Model& model, const record::Parameter& parameter);
void set(Model& model, const record::Parameter& parameter, double value);

/// palmgren: f0, z (y is rarely told apart from z); of rollers f0, f1      skf: mu_EHL, K_rs
/// contact: rolling_factor            table: scale
[[nodiscard]] std::vector<std::string> default_free(friction::FrictionLaw law);

/// Default for a spindle: f0, or its counterpart in the law. The preload of an arrangement that is
/// given as a force, which assembly makes uncertain; otherwise what the law has.
[[nodiscard]] std::vector<std::string> default_free(const Model& model);

}  // namespace raceway::model
