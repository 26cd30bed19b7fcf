#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bearing/operating_point.h"
#include "effects/spindle_condition.h"
#include "friction/friction_law.h"
#include "friction/lubricant.h"
#include "friction/state.h"
#include "record/channel.h"
#include "record/parameter.h"
#include "record/record.h"

namespace raceway::effects {

class OwnMoment;

/// Form of an effect: for a bearing on a rig, for the sets on a shaft, or for a whole spindle with
/// temperatures of its own.
enum class Form { rig, shaft, spindle };
inline constexpr std::array all_the_forms{Form::rig, Form::shaft, Form::spindle};

/// Name in files: "rig", "shaft", "spindle".
[[nodiscard]] std::string_view name(Form form);

/// A number of an effect in the unit of the files; the effect converts it.
using Parameter = record::NumberCard;

/// Data that a model and its record must offer before an effect can be tested or fitted.
enum class Need {
  speed_levels,         ///< more than one speed
  load_levels,          ///< more than one load
  preload_levels,       ///< more than one preload of the sets
  viscosity_levels,     ///< more than one temperature
  time,                 ///< a time of every row
  ring_temperatures,    ///< temperatures of inner and outer ring
  loads,                ///< loads above zero, so that the balls can be solved for
  several_axial_loads,  ///< more than one axial load, even if other settings vary
  several_bearings,     ///< a rig that measures the torque of two or more bearings
  rising_and_falling,   ///< speeds approached from below and from above
  ball_load_law,    ///< another effect that uses ball loads: base laws see the entered load only
  palmgren_law,     ///< the SKF law contains this already
  opposed_sets,     ///< bearings at both ends of the shaft
  torque_standard,  ///< known torque that fixes the scale of the readings
  cold_friction     ///< a spindle whose friction follows the forces of its cold sets
};

/// Missing data in words: "time_s of every row".
[[nodiscard]] std::string_view text(Need need);
/// As above, for a channel that must have a number in every row: "preload_N of every row".
[[nodiscard]] std::string text(const record::Channel& channel);

/// Any of these supplies is enough: "an oil jet or an oil bath".
[[nodiscard]] std::string text(std::span<const friction::Supply> supplies);

/// Values recorded with a row in addition to its operating point; NaN if not recorded.
struct Record {
  double time = unset;                    ///< by the clock of the file [s]
  double inner_ring_temperature = unset;  ///< [K]
  double outer_ring_temperature = unset;  ///< [K]
  int run = -1;
  double since_start = unset;  ///< time since the day or the passage through the loads began [s]
  double direction = unset;    ///< 1 where the speed was reached from below, -1 from above
  const record::Record* rows = nullptr;  ///< all recorded rows; null if not known
  std::size_t row = 0;                   ///< index of this row

  /// Returns a recorded value [SI]: time and ring temperatures as above, all else from `rows`. NaN
  /// if not recorded.
  [[nodiscard]] double value(const record::Channel& channel) const;
};

/// The base law of a model with its parameter values.
struct BaseLaw {
  friction::FrictionLaw law = friction::FrictionLaw::palmgren;
  std::span<const double> values;
  [[nodiscard]] friction::BaseMoments<double> moments(
      const friction::BearingState<double>& state) const {
    return friction::base_moments<double>(law, state, values);
  }
  /// Torque that heats the film [N m]: the whole moment of the contact law, or the viscous moment
  /// of a formula for the whole bearing.
  [[nodiscard]] double film_moment(const friction::BearingState<double>& state) const {
    const friction::BaseMoments<double> base = moments(state);
    return law == friction::FrictionLaw::contact ? base.load + base.viscous : base.viscous;
  }
};

/// Entered or measured values [SI], before any other effect acts on them.
struct Entry {
  double viscosity_40C, viscosity_100C;  ///< viscosities of the oil
  double temperature;                    ///< temperature of the row
  double room;  ///< temperature at which a sensor reads true: the rig's own, or the coldest row's
};

/// Inputs of an effect on the condition of the bearing.
struct ConditionInputs {
  const bearing::Bearing& bearing;       ///< as entered
  const bearing::OperatingPoint& point;  ///< as entered
  const Record& record;
  double power;  ///< loss of the base law at the entered load [W]; see Requirements::uses_power
};

/// True condition of the bearing, as a change from the entered one. Changes of several effects add.
struct Condition {
  double extra_axial_load = 0.0;  ///< in the direction of the entered one [N]
  double radial_growth = 0.0;     ///< growth of the inner raceway against the outer one [m]
  double tilt = 0.0;              ///< tilt of the inner ring about z, held by the shaft [rad]
  double other_balls = 0.0;       ///< share of the way from the entered ball material to the other
                                  ///< one of steel and silicon nitride [1]
  double other_mounting = 0.0;    ///< share of the way from the entered mounting of the sets to
                                  ///< the other one of rigid and spring [1]
  double preload_error = 0.0;     ///< relative error of an entered preload force: real over
                                  ///< entered, less one [1]
  [[nodiscard]] bool operator==(const Condition&) const = default;
  [[nodiscard]] bool finite() const;
  [[nodiscard]] bool changes_bearing() const { return radial_growth != 0.0 || other_balls != 0.0; }
};

/// Inputs of an effect on the lubricant.
struct LubricantInputs {
  const friction::Lubricant& lubricant;
  const friction::BearingState<double>& state;  ///< at the viscosity of the row's temperature
  const BaseLaw& base;
};

/// Lubricant at the contacts, after the effects on it.
struct Film {
  double kinematic_viscosity = unset;  ///< [m²/s]
  double temperature = unset;          ///< [K]
  double viscous_share = 1.0;          ///< remaining share of the viscous moment [1]
};

/// Inputs of an added moment.
struct MomentInputs {
  const friction::BearingState<double>& state;  ///< true loads, viscosity of the film
  friction::BaseMoments<double> base;           ///< moments of the base law there [N m]
  const Record& record;
};

/// Inputs of an effect on the reading of a measured channel.
struct ReadingInputs {
  double value;                          ///< predicted value of that channel [SI]
  const bearing::OperatingPoint& point;  ///< on a shaft, the axial load is external
  const Record& record;
};

/// Pitch diameter for which the ranges of scaled sizes hold.
inline constexpr double size_of_ranges = 60 * mm;

/// Description of an effect in words.
struct Card {
  std::string_view id = {};
  std::string_view title = {};      ///< one line
  std::string_view mechanism = {};  ///< mechanism in a sentence or two
  std::string_view formula = {};
  std::string_view source = {};
  /// Ids of effects and names of base parameters.
  std::span<const std::string_view> confused_with = {};
  /// A measurement that shows whether the effect is present: "the torque without seals".
  std::string_view settled_by = {};
  /// The wrong datum if this effect explains a misfit ("the oil card"); empty for physics.
  std::string_view datum = {};
};

/// Requirements of an effect on a model and its data.
struct Requirements {
  std::span<const Need> needs = {};
  /// Channels that must have a number in every row, in addition to `needs`.
  std::span<const record::Channel* const> channels = {};
  /// Supplies of lubricant with which it can act; empty for all.
  std::span<const friction::Supply> supplies = {};
  bool needs_equilibrium = false;  ///< uses ball loads or contact angles
  bool uses_power = false;         ///< looks at ConditionInputs::power
  /// Replacement in the contact law, in words, if that law contains the effect. Empty if the effect
  /// may be added to that law too.
  std::string_view within_contacts = {};
  /// Further bearing data that it uses, named as in friction::bearing_data().
  std::span<const std::string_view> bearing_data = {};
  bool for_rig = true;      ///< may stand in a model of a bearing on a rig
  bool for_shaft = true;    ///< may stand in a model of a shaft
  bool for_spindle = true;  ///< may stand in a model of a spindle

  /// True if it can act with this supply, or with an unknown one.
  [[nodiscard]] bool works_with(std::optional<friction::Supply> supply) const;
  /// True if it has this form and may stand in a model of it.
  [[nodiscard]] constexpr bool belongs_to(Form form) const {
    return form == Form::rig ? for_rig : form == Form::shaft ? for_shaft : for_spindle;
  }
  /// True if it acts only in spindles.
  [[nodiscard]] constexpr bool of_spindles_alone() const {
    return for_spindle && !for_rig && !for_shaft;
  }
};

/// Properties by which a verdict weighs and words an effect.
struct Nature {
  /// True if all rotating parts contribute. On a rig that coasts down it is then the drag of all
  /// these parts, counted once and not per bearing; the plausible range is for the bearing alone.
  bool drags_on_the_rotor = false;
  /// Exponent of the pitch diameter in the range of its size, which holds for 60 mm. 0: the same
  /// range for bearings of all sizes.
  double size_power = 0.0;
  /// True if it warms up and cools down with the machine. Temperature or lag separates it from
  /// other effects.
  bool follows_heat = false;
  bool base_law = false;        ///< corrects an exponent of the base law
  bool empirical = false;       ///< a shape without a law of physics
  bool spin = false;            ///< its moment arises where the balls spin
  bool friction_alone = false;  ///< a condition that does not move the sets
  bool as_mounted = false;      ///< a condition of the sets as they were mounted, before they turn
  bool of_each_record = false;  ///< may differ between several records
};

/// Steps of a reading at which an effect acts: the non-null ones. `values` are in the order of its
/// parameters.
struct Actions {
  /// Corrects entered or measured values.
  void (*entry)(Entry&, std::span<const double> values) = nullptr;
  /// Describes the wrong datum at these values; null if `entry` is enough.
  std::string (*correction)(std::span<const double> values) = nullptr;
  /// Adds to the load and condition of the bearing.
  void (*condition)(const ConditionInputs&, std::span<const double> values, Condition&) = nullptr;
  /// Changes viscosity or viscous share. Several effects act in the order of the catalogue.
  void (*lubricant)(const LubricantInputs&, std::span<const double> values, Film&) = nullptr;
  /// Added friction moment of one bearing [N m].
  double (*moment)(const MomentInputs&, std::span<const double> values) = nullptr;
  /// Used instead of `moment` if that is one parameter times this [N m per unit of the parameter].
  double (*unit_moment)(const MomentInputs&) = nullptr;
  const OwnMoment* user_made = nullptr;  ///< the moment of a user-made effect
  /// Added to the reading of `channel` [SI].
  double (*reading)(const ReadingInputs&, std::span<const double> values) = nullptr;
  const record::Channel* channel = nullptr;  ///< measured channel of the reading step; else null
  /// Changes heat sources and factors of a spindle.
  void (*spindle)(std::span<const double> values, SpindleCondition&) = nullptr;

  [[nodiscard]] bool has_moment() const { return moment || unit_moment || user_made; }
  /// True if it acts on the reading of this channel.
  [[nodiscard]] constexpr bool reads(const record::Channel& measured) const {
    return reading && *channel == measured;
  }
  /// First step at which it acts: "entry", "condition", "lubricant", "moment", "reading" or
  /// "spindle".
  [[nodiscard]] std::string_view step() const;
};

/// Entry of one physical effect in the catalogue. Each effect is a struct in its own file (see
/// spin_friction.h); this is its type-erased form, chosen by name at run time.
///
/// An effect that acts differently in the sets of a shaft and in a bearing on a rig has two
/// descriptions with one id and separate parameters. The model decides which one applies. A spindle
/// has the effects of its sets in the form of a shaft, except those that its temperatures already
/// include.
struct Description : Card, Requirements, Nature, Actions {
  std::span<const Parameter> parameters = {};

  /// True if it changes a measured channel of this subject: for a shaft its position, which
  /// friction does not move, or the friction torque of its sets. In a spindle the heat of friction
  /// moves all channels.
  [[nodiscard]] bool moves(Form form,
                           const record::Channel& measured = record::axial_displacement) const {
    if (form != Form::shaft || !belongs_to(form)) return belongs_to(form);
    if (measured == record::friction_torque) return !reads(record::axial_displacement);
    return reads(record::axial_displacement) || (condition && !friction_alone);
  }
};

/// An active effect of a model, with its parameter values.
struct Effect {
  const Description* description = nullptr;
  std::vector<double> values;
  std::shared_ptr<const void> owner = nullptr;  ///< keeps a user-made description alive

  /// Added moment [N m]; 0 if the effect acts at other steps.
  [[nodiscard]] double moment(const MomentInputs& inputs) const;
};

/// Returns the changes of a spindle by these effects; other effects change nothing here.
[[nodiscard]] SpindleCondition spindle_condition(std::span<const Effect> effects);

/// Initial values of all parameters.
[[nodiscard]] std::vector<double> initial_values(const Description& description);
/// As above, with every parameter that has one at its neutral value.
[[nodiscard]] std::vector<double> neutral_values(const Description& description);

}  // namespace raceway::effects
