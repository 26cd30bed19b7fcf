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

/// Data of the test rig, used where a record has none.
struct Rig {
  double inertia = unset;           ///< of all that coasts down [kg m²]; NaN: not given
  bool unknown_inertia = false;     ///< said to be unknown: torques up to a common factor
  int bearings = 1;                 ///< equal bearings whose torque the rig sees [1]
  double axial_load = unset;        ///< per bearing, for rows without that column [N]
  double radial_load = 0.0;         ///< per bearing [N]
  double temperature = kelvin(40);  ///< [K]
  double room_temperature = unset;  ///< [K]; NaN: the coldest row of a record
  double minimum_speed = 0.0;       ///< slower coast-down rows are left out [rad/s]

  /// True where friction slows down the shaft, with all that turns on it.
  [[nodiscard]] bool coasts_down() const { return inertia > 0.0 || unknown_inertia; }
};

/// The shaft that a model stands for, where it is more than one bearing on a rig.
struct Shaft {
  bearing::Arrangement arrangement;
  double external_load = 0.0;  ///< axial, positive towards the tool [N]
  /// Temperatures that are not measured stay at the mounting temperature.
  std::optional<bearing::SetTemperatures> temperatures = {};
  /// A set has bearings of its own: what the model says of its bearing is not of all.
  bool own_bearings = false;
};

/// Speeds that a catalogue prints for a bearing [rad/s]; NaN where it prints none.
struct PrintedSpeed {
  double oil = unset, grease = unset;
};

/// Model of a bearing on a rig, or of the sets on a shaft, as the user has it. rig::RigSubject and
/// shaft::ShaftSubject present it to the loop.
struct Model {
  std::string name;
  /// Temperature range of the rows of the record in use [K]; NaN without a record.
  double coldest = unset, hottest = unset;
  ModelBearing bearing;
  friction::Lubricant lubricant;
  std::optional<friction::Supply> supply = {};  ///< rules out effects; empty if not given
  friction::FrictionLaw law = friction::FrictionLaw::palmgren;
  friction::F1Load f1_load = friction::F1Load::P0;  ///< of the palmgren law; of rollers of all
  std::vector<double> law_values;                   ///< in the order of friction::parameters(law)
  friction::contact::ContactData contact = {};      ///< of the contact law
  /// Torque of the law `table`, under another law of its candidate; null where the model names
  /// none.
  std::shared_ptr<const friction::TorqueTable> table = nullptr;
  std::vector<effects::Effect> effects;  ///< added so far, in order
  bearing::EquilibriumOptions solver;
  /// No race holds the balls: traction turns them. Of the contact law alone; see solve_balls().
  bool balanced_balls = false;
  LifeData life = {};
  PrintedSpeed printed_speed = {};  ///< none where the bearings of the sets are not one kind
  Rig rig;
  /// Names of what may be re-fitted, as parameters() has them; default_free() where empty.
  std::vector<std::string> free;
  /// The first bearing of its front set is `bearing`.
  std::optional<Shaft> shaft = {};
  /// Surroundings of the sets in a model of a whole spindle; `shaft` is then set too.
  std::optional<Spindle> spindle = {};
  /// Errors acceptable to the user, by the name of the measured channel [SI].
  std::vector<record::NamedValue> tolerances = {};
  /// Covariance of fitted parameters, at their values here.
  std::optional<fit::Covariance> covariance = {};

  /// The form of the effects that it may have.
  [[nodiscard]] effects::Form form() const {
    if (spindle) return effects::Form::spindle;
    return shaft ? effects::Form::shaft : effects::Form::rig;
  }
};

}  // namespace raceway::model
