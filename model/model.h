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

/// Properties of the test rig. Loads and temperatures apply if a record lacks their columns.
struct Rig {
  double inertia = unset;  ///< inertia of all parts that coast down [kg m²]; NaN: not given
  /// True if the user declares the inertia as unknown; all torques then have one unknown common
  /// factor.
  bool unknown_inertia = false;
  int bearings = 1;                 ///< number of equal bearings whose torque the rig measures [1]
  double axial_load = unset;        ///< axial load per bearing [N]
  double radial_load = 0.0;         ///< radial load per bearing [N]
  double temperature = kelvin(40);  ///< bearing temperature [K]
  double room_temperature = unset;  ///< room temperature [K]; NaN: lowest temperature in the record
  double minimum_speed = 0.0;       ///< coast-down rows below this speed are excluded [rad/s]

  /// Returns true for a coast-down rig, where friction slows down the shaft and all parts on it.
  [[nodiscard]] bool coasts_down() const { return inertia > 0.0 || unknown_inertia; }
};

/// Shaft with its sets of bearings. A model without a shaft is one bearing on a rig.
struct Shaft {
  bearing::Arrangement arrangement;
  double external_load = 0.0;  ///< axial load, positive towards the tool [N]
  /// Measured temperatures of shaft, housing and rings. Parts without a measured temperature have
  /// the mounting temperature.
  std::optional<bearing::SetTemperatures> temperatures = {};
  /// True if the sets contain bearings that differ from Model::bearing.
  bool own_bearings = false;
};

/// Limiting speeds in the catalogue of a bearing [rad/s]; NaN if not given.
struct PrintedSpeed {
  double oil = unset, grease = unset;
};

/// Model of a bearing on a rig, or of bearing sets on a shaft, as entered by the user.
/// rig::RigSubject, shaft::ShaftSubject and spindle::SpindleSubject prepare the model for fits and
/// diagnosis.
struct Model {
  std::string name;
  /// Lowest and highest temperature in the record of a fit or diagnosis [K]; NaN without a record.
  double coldest = unset, hottest = unset;
  ModelBearing bearing;
  friction::Lubricant lubricant;
  /// Lubricant supply, such as oil bath; empty if not given. The supply excludes some effects.
  std::optional<friction::Supply> supply = {};
  friction::FrictionLaw law = friction::FrictionLaw::palmgren;
  /// Kind of load, such as P0, in the formulas of the laws palmgren, powers and contact-powers, and
  /// of all laws for rollers.
  friction::F1Load f1_load = friction::F1Load::P0;
  /// Parameter values, in the order of friction::parameters(law).
  std::vector<double> law_values;
  friction::contact::ContactData contact = {};  ///< further inputs of the contact law
  /// Torque table for the law `table`. A model with another law may also name a table; `diagnose`
  /// then tests the law `table` as an alternative. Null if the model names no table.
  std::shared_ptr<const friction::TorqueTable> table = nullptr;
  std::vector<effects::Effect> effects;  ///< effects in the order in which they were added
  bearing::EquilibriumOptions solver;
  /// True if traction determines the rotation of the balls instead of race control. Only for the
  /// contact law; see solve_balls().
  bool balanced_balls = false;
  LifeData life = {};
  PrintedSpeed printed_speed = {};  ///< catalogue speeds; NaN if the sets have different bearings
  Rig rig;
  /// Names of the parameters that a fit may change, as in parameters(). An empty list means
  /// default_free().
  std::vector<std::string> free;
  /// Shaft of the model. The member `bearing` above is then the first bearing of the front set.
  std::optional<Shaft> shaft = {};
  /// All other parts of a spindle, in a model of a whole spindle. Such a model also has `shaft`.
  std::optional<Spindle> spindle = {};
  /// Largest acceptable RMS error of each measured channel, with the name of the channel [SI].
  std::vector<record::NamedValue> tolerances = {};
  /// Covariance of the fitted parameters at their current values.
  std::optional<fit::Covariance> covariance = {};

  /// Returns the kind of this model, which selects the form of its effects: spindle, shaft or rig.
  [[nodiscard]] effects::Form form() const {
    if (spindle) return effects::Form::spindle;
    return shaft ? effects::Form::shaft : effects::Form::rig;
  }
};

}  // namespace raceway::model
