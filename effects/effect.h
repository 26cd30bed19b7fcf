#pragma once

#include <array>
#include <cstddef>
#include <functional>
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

/// Form of an effect: for a bearing on a rig, for the bearing sets on a shaft, or for a whole
/// spindle with computed temperatures.
enum class Form { rig, shaft, spindle };
inline constexpr std::array all_the_forms{Form::rig, Form::shaft, Form::spindle};

/// Returns the name in files: "rig", "shaft" or "spindle".
[[nodiscard]] std::string_view name(Form form);

/// Parameter of an effect, in the unit of the files.
using Parameter = record::NumberCard;

/// Data that the model and its record must have before an effect can be tested or fitted.
enum class Need {
  speed_levels,         ///< more than one speed
  load_levels,          ///< more than one load
  preload_levels,       ///< more than one preload of the sets; in a spindle, heat varies it
  viscosity_levels,     ///< more than one temperature
  time,                 ///< time of every row
  ring_temperatures,    ///< temperatures of inner and outer ring
  loads,                ///< on a rig: a load above zero in every row, for the ball equilibrium
  several_axial_loads,  ///< more than one axial load; several radial loads are not sufficient
  several_bearings,     ///< a rig that measures the torque of two or more bearings
  rising_and_falling,   ///< speeds approached from below and from above
  ball_load_law,        ///< a law or an effect that uses ball loads, such as the law contact
  palmgren_law,         ///< a law other than table and skf; the law skf already contains the effect
  opposed_sets,         ///< bearings at both ends of the shaft
  torque_standard,      ///< known torque that fixes the scale of the readings; no record has it
  cold_friction         ///< a spindle whose friction is computed with the forces of the cold sets
};

/// Returns the missing data in words: "time_s of every row".
[[nodiscard]] std::string_view text(Need need);
/// Returns the requirement that a channel has a value in every row, in words: "preload_N of every
/// row".
[[nodiscard]] std::string text(const record::Channel& channel);

/// Returns lubricant supplies in words: "an oil jet or an oil bath". Any one of these supplies is
/// sufficient.
[[nodiscard]] std::string text(std::span<const friction::Supply> supplies);

/// Values recorded with a row in addition to its operating point; NaN if not recorded.
struct Record {
  double time = unset;                    ///< time of the row in its file [s]
  double inner_ring_temperature = unset;  ///< [K]
  double outer_ring_temperature = unset;  ///< [K]
  int run = -1;
  /// Time since the start of the day [s]. In a record without long pauses (model/course.h): time
  /// since the start of the load sweep.
  double since_start = unset;
  double direction = unset;  ///< 1 if the speed was reached from below, -1 if from above
  const record::Record* rows = nullptr;  ///< all recorded rows; null if not known
  std::size_t row = 0;                   ///< index of this row in `rows`

  /// Returns a recorded value [SI]: time and ring temperatures from the members above, all other
  /// values from `rows`. NaN if not recorded.
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
  /// Torque that heats the film [N m]: for the law `contact` the whole moment, for every other law
  /// the viscous moment.
  [[nodiscard]] double film_moment(const friction::BearingState<double>& state) const {
    const friction::BaseMoments<double> base = moments(state);
    return law == friction::FrictionLaw::contact ? base.load + base.viscous : base.viscous;
  }
};

/// Entered or measured values [SI] that Actions::entry corrects before all other steps of a
/// prediction.
struct Entry {
  double viscosity_40C, viscosity_100C;  ///< viscosities of the oil
  double temperature;                    ///< temperature of the row
  /// Temperature at which a sensor has no error: room temperature of the rig, or temperature of the
  /// coldest row.
  double room;
};

/// Inputs of an effect on the condition of the bearing.
struct ConditionInputs {
  const bearing::Bearing& bearing;       ///< bearing without effects
  const bearing::OperatingPoint& point;  ///< operating point without effects
  const Record& record;
  /// Friction power of the base law at the entered load [W]; NaN if no effect uses it
  /// (Requirements::uses_power).
  double power;
};

/// Difference between the true and the entered condition of the bearing. The changes of several
/// effects add up.
struct Condition {
  double extra_axial_load = 0.0;  ///< added load in the direction of the entered axial load [N]
  double radial_growth = 0.0;     ///< growth of the inner raceway relative to the outer one [m]
  double tilt = 0.0;              ///< tilt of the inner ring about z, imposed by the shaft [rad]
  /// 0: entered ball material; 1: the other material (steel or silicon nitride); values between
  /// interpolate [1].
  double other_balls = 0.0;
  /// 0: entered mounting of the sets; 1: the other mounting (rigid or spring); values between
  /// interpolate [1].
  double other_mounting = 0.0;
  /// Relative error of the preload force: (real - entered)/entered [1].
  double preload_error = 0.0;
  [[nodiscard]] bool operator==(const Condition&) const = default;
  [[nodiscard]] bool finite() const;
  [[nodiscard]] bool changes_bearing() const { return radial_growth != 0.0 || other_balls != 0.0; }
};

/// Inputs of an effect on the lubricant.
struct LubricantInputs {
  const friction::Lubricant& lubricant;
  /// Bearing state with the oil viscosity at the temperature of the row.
  const friction::BearingState<double>& state;
  const BaseLaw& base;
};

/// Lubricant at the contacts, including the changes by effects on the lubricant.
struct Film {
  double kinematic_viscosity = unset;  ///< [m²/s]
  double temperature = unset;          ///< [K]
  double viscous_share = 1.0;          ///< factor on the viscous moment [1]
};

/// Linear approximation of the friction moment of the contact law as a function of temperature,
/// with the viscosity ν(T) of the oil:
///
///   M(T) = moment + slope (T - temperature),   |T - temperature| <= reach
struct MomentTangent {
  double temperature, moment, slope, reach;  ///< [K], [N m], [N m/K], [K]
};

/// Function that returns a stored tangent for a temperature near the given one [K], or computes the
/// tangent at the given temperature if none is stored.
using TangentAbout = std::function<MomentTangent(double temperature)>;

/// Inputs of an effect that adds a friction moment.
struct MomentInputs {
  /// Bearing state. Loads and film viscosity already include the changes by other effects.
  const friction::BearingState<double>& state;
  friction::BaseMoments<double> base;  ///< moments of the base law in `state` [N m]
  const Record& record;
};

/// Inputs of an effect on the reading of a measured channel.
struct ReadingInputs {
  double value;                          ///< predicted value of the measured channel [SI]
  const bearing::OperatingPoint& point;  ///< for a shaft, the axial load is the external load
  const Record& record;
};

/// Pitch diameter for which the plausible ranges of effects are given. For a bearing of pitch
/// diameter d_m, a range is multiplied by (d_m/60 mm)^p, where p is Nature::size_power.
inline constexpr double size_of_ranges = 60 * mm;

/// Description of an effect in words.
struct Card {
  std::string_view id = {};
  std::string_view title = {};      ///< title in one line
  std::string_view mechanism = {};  ///< physical mechanism in one or two sentences
  std::string_view formula = {};
  std::string_view source = {};
  /// Ids of effects and names of base parameters that have a similar influence on the data.
  std::span<const std::string_view> confused_with = {};
  /// Measurement that shows whether the effect is present: "the torque without seals".
  std::string_view settled_by = {};
  /// Datum that is wrong if this effect explains a misfit ("the oil card"); empty for a physical
  /// effect.
  std::string_view datum = {};
};

/// Requirements that a model and its data must meet before an effect can be used.
struct Requirements {
  std::span<const Need> needs = {};
  /// Channels that must have a number in every row, in addition to `needs`.
  std::span<const record::Channel* const> channels = {};
  /// Lubricant supplies with which the effect can occur; empty if it can occur with all supplies.
  std::span<const friction::Supply> supplies = {};
  bool needs_equilibrium = false;  ///< true: the effect uses ball loads or contact angles
  bool uses_power = false;         ///< true: the effect uses ConditionInputs::power
  bool uses_room = false;          ///< true: the effect uses Entry::room
  /// Further bearing data that the effect uses, with the names of friction::bearing_data().
  std::span<const std::string_view> bearing_data = {};
  bool for_rig = true;      ///< true: allowed in a model of a bearing on a rig
  bool for_shaft = true;    ///< true: allowed in a model of a shaft
  bool for_spindle = true;  ///< true: allowed in a model of a spindle

  /// Returns true if the effect can occur with this lubricant supply, or if the supply is unknown.
  [[nodiscard]] bool works_with(std::optional<friction::Supply> supply) const;
  /// Returns true if the effect is allowed in models of this form.
  [[nodiscard]] constexpr bool belongs_to(Form form) const {
    return form == Form::rig ? for_rig : form == Form::shaft ? for_shaft : for_spindle;
  }
  /// Returns true if the effect is allowed only in models of a spindle.
  [[nodiscard]] constexpr bool of_spindles_alone() const {
    return for_spindle && !for_rig && !for_shaft;
  }
};

/// Base laws that already contain an effect, and bearings that do not have the effect.
struct Exclusions {
  /// Text with the keys of the contact law that replace the effect, if the contact law already
  /// contains the effect. Empty if the effect may be added to the contact law.
  std::string_view within_contacts = {};
  /// True: the contact law contains the effect if oil_fraction > 0.
  bool within_oil_fraction = false;
  /// True: the effect changes the viscous moment. Such an effect is not allowed with the law
  /// `table`, because some friction tables give only the total moment. Effects on the lubricant and
  /// corrections of the base law are never allowed with this law and need no flag.
  bool of_viscous_moment = false;
  /// Reason why cylindrical rollers do not have the effect. Effects on the condition and effects
  /// that use ball loads need no text: they are never allowed for rollers.
  std::string_view not_for_rollers = {};
};

/// Properties of an effect that determine its weight in a verdict and the wording of the verdict.
struct Nature {
  /// True if all rotating parts contribute to the effect. In a coast-down, the effect is then the
  /// drag of all these parts and is added once, not once per bearing. The plausible upper
  /// limit of its size is for one bearing and does not apply to a coast-down.
  bool drags_on_the_rotor = false;
  /// Exponent p that adapts the plausible range of the effect's size parameter to the bearing. The
  /// stated range is for a pitch diameter of 60 mm and is multiplied by (d_m/60 mm)^p. With p = 0,
  /// the range is the same for bearings of all sizes.
  double size_power = 0.0;
  /// True if the effect increases and decreases as the machine warms up and cools down. The
  /// dependence on temperature, or the lag, distinguishes such an effect from other effects.
  bool follows_heat = false;
  bool base_law = false;   ///< true: corrects an exponent of the base law
  bool empirical = false;  ///< true: an empirical formula without a physical law
  bool spin = false;       ///< true: the moment comes from contacts in which the balls spin
  /// True if the effect changes the condition of the bearings but not the axial position of the
  /// shaft.
  bool friction_alone = false;
  bool as_mounted = false;      ///< true: changes how the sets are mounted (rigid or spring)
  bool of_each_record = false;  ///< true: its size may differ between records
};

/// Functions of an effect, for the steps of a prediction. A function is null if the effect does not
/// change this step. `values` are the parameter values in the order of the parameters.
struct Actions {
  /// Corrects entered or measured values.
  void (*entry)(Entry&, std::span<const double> values) = nullptr;
  /// Describes the wrong datum in words; null if the changes by `entry` describe it.
  std::string (*correction)(std::span<const double> values) = nullptr;
  /// Adds changes to the condition of the bearing: load, tilt, ring growth, ball material,
  /// mounting, preload.
  void (*condition)(const ConditionInputs&, std::span<const double> values, Condition&) = nullptr;
  /// Changes the film viscosity or the factor on the viscous moment. Several effects are applied in
  /// the order of the catalogue.
  void (*lubricant)(const LubricantInputs&, std::span<const double> values, Film&) = nullptr;
  /// Computes the same film as `lubricant`, by Newton's method from `temperature`, if tangents of
  /// the contact moment are known. Returns false if the method finds no solution.
  bool (*lubricant_by_tangents)(const LubricantInputs&, std::span<const double> values,
                                double temperature, const TangentAbout&, Film&) = nullptr;
  /// Added friction moment of one bearing [N m].
  double (*moment)(const MomentInputs&, std::span<const double> values) = nullptr;
  /// Friction moment per unit of the parameter. `unit_moment` replaces `moment` if the moment is
  /// proportional to a single parameter [N m per unit].
  double (*unit_moment)(const MomentInputs&) = nullptr;
  const OwnMoment* user_made = nullptr;  ///< moment of a user-defined effect
  /// Value that is added to the reading of `channel` [SI].
  double (*reading)(const ReadingInputs&, std::span<const double> values) = nullptr;
  /// Channel of `reading`; null if the effect changes no reading.
  const record::Channel* channel = nullptr;
  /// Changes heat sources and factors of a spindle.
  void (*spindle)(std::span<const double> values, SpindleCondition&) = nullptr;

  [[nodiscard]] bool has_moment() const { return moment || unit_moment || user_made; }
  /// Returns true if the effect changes the reading of this channel.
  [[nodiscard]] constexpr bool reads(const record::Channel& measured) const {
    return reading && *channel == measured;
  }
  /// Returns the first step that the effect changes: "entry", "condition", "lubricant", "moment",
  /// "reading" or "spindle".
  [[nodiscard]] std::string_view step() const;
};

/// Entry of one physical effect in the catalogue. Each effect is a struct in its own file (see
/// spin_friction.h). A Description has the same members as such a struct. The program finds a
/// Description by its id.
///
/// An effect with different laws for the sets of a shaft and for a bearing on a rig has two
/// descriptions with the same id and separate parameters. The kind of model selects the
/// description. A spindle uses the descriptions for a shaft, without the effects that the computed
/// temperatures already include.
struct Description : Card, Requirements, Exclusions, Nature, Actions {
  std::span<const Parameter> parameters = {};

  /// Returns true if the effect changes this measured channel. On a shaft, the channel is the axial
  /// position, which friction does not change, or the friction torque of the sets. In a spindle,
  /// the friction heat changes all channels.
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
  std::shared_ptr<const void> owner = nullptr;  ///< keeps a user-defined description alive

  /// Returns the added moment [N m]; 0 if the effect adds no moment.
  [[nodiscard]] double moment(const MomentInputs& inputs) const;
};

/// Returns the changes that these effects cause in a spindle. Effects without Actions::spindle are
/// ignored.
[[nodiscard]] SpindleCondition spindle_condition(std::span<const Effect> effects);

/// Returns the initial values of all parameters.
[[nodiscard]] std::vector<double> initial_values(const Description& description);
/// Returns the neutral value of each parameter, at which the effect has no influence. For a
/// parameter without a neutral value, returns the initial value.
[[nodiscard]] std::vector<double> neutral_values(const Description& description);

}  // namespace raceway::effects
