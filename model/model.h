#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "bearing/bearing.h"
#include "bearing/bearing_equilibrium.h"
#include "effects/effect.h"
#include "fit/covariance.h"
#include "friction/contact/contact_data.h"
#include "friction/friction_law.h"
#include "friction/lubricant.h"
#include "friction/torque_table.h"
#include "model/life_data.h"
#include "model/model_bearing.h"
#include "model/spindle.h"
#include "record/parameter.h"

namespace raceway::model {

/// Properties of the test rig. If a record has no column for a load or temperature, the value of
/// the rig is used.
struct Rig {
  double inertia = unset;  ///< inertia of all parts that coast down [kg m²]; NaN: not given
  /// True if the user declares the inertia as unknown. All torques of the record then have one
  /// common unknown factor.
  bool unknown_inertia = false;
  int bearings = 1;                 ///< number of equal bearings on the rig [1]
  double axial_load = unset;        ///< axial load per bearing [N]
  double radial_load = 0.0;         ///< radial load per bearing [N]
  double temperature = kelvin(40);  ///< temperature of the bearing [K]
  double room_temperature = unset;  ///< room temperature [K]; NaN: lowest temperature in the record
  double minimum_speed = 0.0;       ///< coast-down rows below this speed are excluded [rad/s]

  /// Returns true for a coast-down rig, where friction slows down the shaft and all parts on it.
  [[nodiscard]] bool coasts_down() const { return inertia > 0.0 || unknown_inertia; }
};

/// Shaft with its bearing sets.
struct Shaft {
  bearing::Arrangement arrangement;
  double external_load = 0.0;  ///< axial load, positive towards the tool [N]
  /// Measured temperatures of shaft, housing and rings. Parts without a measured temperature have
  /// the temperature at mounting.
  std::optional<bearing::SetTemperatures> temperatures = {};
  /// True if the sets contain bearings that differ from Model::bearing.
  bool own_bearings = false;
};

/// Limiting speeds in the catalogue of a bearing [rad/s]; NaN if not given.
struct PrintedSpeed {
  double oil = unset, grease = unset;
};

/// Model of a bearing on a rig, of bearing sets on a shaft, or of a spindle, as entered by the
/// user. rig::RigSubject, shaft::ShaftSubject and spindle::SpindleSubject prepare the model for
/// fits and diagnosis.
struct Model {
  std::string name;
  /// Lowest and highest temperature in the record of a fit or diagnosis [K]; NaN without a record.
  double coldest = unset, hottest = unset;
  ModelBearing bearing;
  friction::Lubricant lubricant;
  /// Lubricant supply, such as oil bath; empty if not given. Some effects occur only with certain
  /// kinds of supply.
  std::optional<friction::Supply> supply = {};
  friction::FrictionLaw law = friction::FrictionLaw::palmgren;
  /// Choice of the load in the friction formulas, such as the static equivalent load P0. The choice
  /// applies to the laws palmgren, powers and contact-powers, and to all laws for rollers.
  friction::F1Load f1_load = friction::F1Load::P0;
  /// Values of the parameters of the friction law, in the order of friction::parameters(law).
  std::vector<double> law_values;
  friction::contact::ContactData contact = {};  ///< further inputs of the contact law
  /// Torque table for the law `table`. A model with another law may also name a table; `diagnose`
  /// then tests the law `table` as an alternative. Null if the model names no table.
  std::shared_ptr<const friction::TorqueTable> table = nullptr;
  std::vector<effects::Effect> effects;  ///< effects, in the order in which they were added
  bearing::EquilibriumOptions solver;
  /// True if the oil traction determines the rotation of the balls; false if race control
  /// determines the rotation. Only the contact law allows true; see solve_balls().
  bool balanced_balls = false;
  LifeData life = {};
  /// Limiting speeds in the catalogue of the bearing; NaN if the sets have different bearings.
  PrintedSpeed printed_speed = {};
  Rig rig;
  /// Names of the parameters that a fit may change. parameters() lists the possible names. If the
  /// list is empty, a fit may change the parameters in default_free().
  std::vector<std::string> free;
  /// Shaft with its bearing sets; empty for one bearing on a rig. In a model with a shaft,
  /// Model::bearing is the first bearing of the front set.
  std::optional<Shaft> shaft = {};
  /// All parts of a spindle except the bearing sets; empty if the model is not a spindle. A model
  /// with `spindle` also has `shaft`.
  std::optional<Spindle> spindle = {};
  /// Largest acceptable RMS error of each measured channel [SI], with the name of the channel.
  std::vector<record::NamedValue> tolerances = {};
  /// Covariance of the fitted parameters; empty if no parameters were fitted.
  std::optional<fit::Covariance> covariance = {};

  /// Returns the kind of this model: spindle, shaft or rig. The kind determines which effects are
  /// possible.
  [[nodiscard]] effects::Form form() const {
    if (spindle) return effects::Form::spindle;
    return shaft ? effects::Form::shaft : effects::Form::rig;
  }
};

}  // namespace raceway::model
