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

/// Kind of model in which an effect is used: a bearing on a test rig, the bearing sets on a shaft,
/// or a whole spindle with computed temperatures.
enum class Form { rig, shaft, spindle };
inline constexpr std::array all_the_forms{Form::rig, Form::shaft, Form::spindle};

/// Returns the name of the kind of model in files: "rig", "shaft" or "spindle".
[[nodiscard]] std::string_view name(Form form);

/// Parameter of an effect, in the unit that model files use.
using Parameter = record::NumberCard;

/// Property of a model or of its record without which an effect cannot be tested or fitted.
enum class Need {
  speed_levels,  ///< more than one speed
  load_levels,   ///< more than one load
  /// More than one preload, or more than one axial load if the torque of the sets is measured. A
  /// spindle always has several preloads, because heat changes the preload.
  preload_levels,
  viscosity_levels,     ///< more than one temperature
  time,                 ///< time of every row
  ring_temperatures,    ///< temperatures of inner and outer ring
  loads,                ///< a load above zero in every row, for models of a rig
  several_axial_loads,  ///< more than one axial load; several radial loads are not sufficient
  several_bearings,     ///< a rig that measures the torque of two or more bearings
  rising_and_falling,   ///< speeds approached from below and from above
  ball_load_law,        ///< base law (such as `contact`) or effect that uses ball loads
  /// A base law other than `skf` and `table`. The law `skf` already contains each effect that has
  /// this need, and a friction table may contain it.
  palmgren_law,
  opposed_sets,     ///< bearing sets at both ends of the shaft
  torque_standard,  ///< known torque to calibrate the sensor; a record never contains it
  cold_friction     ///< a model that computes friction with the preload of the cold sets
};

/// Returns the needed property in words, such as "time_s of every row".
[[nodiscard]] std::string_view text(Need need);
/// Returns the requirement that a channel has a value in every row, in words: "preload_N of every
/// row".
[[nodiscard]] std::string text(const record::Channel& channel);

/// Returns alternative lubricant supplies in words: "an oil jet or an oil bath".
[[nodiscard]] std::string text(std::span<const friction::Supply> supplies);

/// Values of a recorded row in addition to its operating point. Values that were not recorded are
/// NaN.
struct Record {
  double time = unset;                    ///< time of the row in its file [s]
  double inner_ring_temperature = unset;  ///< [K]
  double outer_ring_temperature = unset;  ///< [K]
  int run = -1;
  /// Time since the start of the day [s]. If the record has no long pauses (model/course.h), this
  /// is the time since the start of the load sweep.
  double since_start = unset;
  double direction = unset;  ///< 1 if the speed was reached from below, -1 if from above
  const record::Record* rows = nullptr;  ///< all recorded rows; null if not known
  std::size_t row = 0;                   ///< index of this row in `rows`

  /// Returns a recorded value of this row [SI]; NaN if it was not recorded. Time and ring
  /// temperatures come from the members of this struct, and all other values from `rows`.
  [[nodiscard]] double value(const record::Channel& channel) const;
};

/// Base law: friction law of a model, without its effects. The struct also gives the parameter
/// values of the law.
struct BaseLaw {
  friction::FrictionLaw law = friction::FrictionLaw::palmgren;
  std::span<const double> values;
  [[nodiscard]] friction::BaseMoments<double> moments(
      const friction::BearingState<double>& state) const {
    return friction::base_moments<double>(law, state, values);
  }
  /// Returns the friction moment that heats the lubricant film [N m]. For the law `contact`, this
  /// is the whole moment; for all other laws, it is the viscous moment.
  [[nodiscard]] double film_moment(const friction::BearingState<double>& state) const {
    const friction::BaseMoments<double> base = moments(state);
    return law == friction::FrictionLaw::contact ? base.load + base.viscous : base.viscous;
  }
};

/// Entered or measured values [SI]. Actions::entry corrects these values before all other steps of
/// a prediction.
struct Entry {
  double viscosity_40C, viscosity_100C;  ///< viscosities of the oil
  double temperature;                    ///< temperature of the row
  /// Temperature at which the temperature sensor has no error. This is the room temperature of the
  /// rig, or the temperature of the coldest row if the room temperature is unknown.
  double room;
};

/// Inputs of an effect on the condition of the bearing.
struct ConditionInputs {
  const bearing::Bearing& bearing;       ///< bearing without effects
  const bearing::OperatingPoint& point;  ///< operating point without effects
  const Record& record;
  /// Friction power of the base law at the entered load [W]; NaN if no effect uses this power
  /// (Requirements::uses_power).
  double power;
};

/// Difference between the true and the entered condition of the bearing. The differences from
/// several effects are added.
struct Condition {
  double extra_axial_load = 0.0;  ///< added load in the direction of the entered axial load [N]
  double radial_growth = 0.0;     ///< radial growth of the inner minus the outer raceway [m]
  double tilt = 0.0;              ///< tilt of the inner ring about z, imposed by the shaft [rad]
  /// Share of the other ball material [1]. 0 means the entered material, and 1 the other material
  /// (silicon nitride instead of steel, or steel instead of silicon nitride).
  double other_balls = 0.0;
  /// Share of the other type of preload [1]. 0 means the entered type, and 1 the other type (spring
  /// instead of rigid, or rigid instead of spring).
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
  /// Bearing state. Its viscosity is the viscosity of the oil at the temperature of the row.
  const friction::BearingState<double>& state;
  const BaseLaw& base;
};

/// Properties of the lubricant in the contacts. Effects such as film-self-heating change these
/// values.
struct Film {
  double kinematic_viscosity = unset;  ///< [m²/s]
  double temperature = unset;          ///< [K]
  double viscous_share = 1.0;          ///< factor on the viscous moment [1]
};

/// Linear approximation of the friction moment M of the contact law as a function of the film
/// temperature T:
///
///   M(T) = moment + slope (T - temperature),   |T - temperature| <= reach
struct MomentTangent {
  double temperature, moment, slope, reach;  ///< units: [K], [N m], [N m/K], [K]
};

/// Function that returns a tangent of the moment for a temperature [K]. The tangent may
/// touch the curve at a slightly different temperature, MomentTangent::temperature.
using TangentAbout = std::function<MomentTangent(double temperature)>;

/// Inputs of an effect that adds a friction moment.
struct MomentInputs {
  /// State of the bearing. The loads and the film viscosity in this state already include the
  /// changes by effects on the bearing condition and on the lubricant.
  const friction::BearingState<double>& state;
  friction::BaseMoments<double> base;  ///< moments of the base law in this bearing state [N m]
  const Record& record;
};

/// Inputs of an effect on the reading of a measured channel.
struct ReadingInputs {
  double value;                          ///< predicted value of the measured channel [SI]
  const bearing::OperatingPoint& point;  ///< for a shaft, its axial load is the external load
  const Record& record;
};

/// Pitch diameter to which the plausible ranges of effect parameters refer. For a bearing of
/// another pitch diameter d_m, a range is multiplied by (d_m/60 mm)^p, where p is
/// Nature::size_power.
inline constexpr double size_of_ranges = 60 * mm;

/// Description of an effect in words.
struct Card {
  std::string_view id = {};
  std::string_view title = {};      ///< title in one line
  std::string_view mechanism = {};  ///< physical mechanism in one or two sentences
  std::string_view formula = {};
  std::string_view source = {};
  /// Ids of effects and names of parameters of the base law that have a similar influence on the
  /// data.
  std::span<const std::string_view> confused_with = {};
  /// Measurement that shows whether the effect is present, such as "the torque without seals".
  std::string_view settled_by = {};
  /// Input data that are wrong if this effect explains a misfit, such as "the preload"; empty for a
  /// physical effect.
  std::string_view datum = {};
};

/// Requirements that a model and its data must meet before an effect can be used.
struct Requirements {
  std::span<const Need> needs = {};
  /// Channels that must have a number in every row, in addition to `needs`.
  std::span<const record::Channel* const> channels = {};
  /// Lubricant supplies with which the effect can occur; empty if the effect can occur with all
  /// supplies.
  std::span<const friction::Supply> supplies = {};
  bool needs_equilibrium = false;  ///< true: the effect uses ball loads or contact angles
  bool uses_power = false;         ///< true: the effect uses ConditionInputs::power
  bool uses_room = false;          ///< true: the effect uses Entry::room
  /// Bearing data that the effect uses, even if the base law does not use them; names as in
  /// friction::bearing_data().
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

/// Base laws that already contain an effect, and bearings in which the effect does not occur.
struct Exclusions {
  /// Text that names the keys of a model file with which the contact law describes the mechanism of
  /// the effect. If the text is empty, the contact law does not contain the effect, and the
  /// effect may be added.
  std::string_view within_contacts = {};
  /// True: the contact law already contains the effect if the model has oil_fraction > 0.
  bool within_oil_fraction = false;
  /// True: the effect changes the viscous moment. Such an effect is not allowed with the law
  /// `table`, because some friction tables give only the total moment. Effects on the lubricant and
  /// corrections of the base law are never allowed with the law `table`, so they do not need this
  /// flag.
  bool of_viscous_moment = false;
  /// Reason why the effect does not occur with cylindrical rollers. Effects on the condition and
  /// effects that use ball loads need no text, because they are never allowed for rollers.
  std::string_view not_for_rollers = {};
};

/// Properties of an effect that influence the conclusion of diagnose() (verdict) and its wording.
struct Nature {
  /// True if all rotating parts contribute to the effect, not only the bearings. In a coast-down,
  /// the effect is then the drag of all these parts, which is added once, not once per bearing. The
  /// plausible upper limit of the size parameter is for one bearing, so the program does not apply
  /// this limit to a coast-down.
  bool drags_on_the_rotor = false;
  /// Exponent p that adapts the plausible range of the size parameter to the bearing. The stated
  /// range is for a pitch diameter of 60 mm. For a pitch diameter d_m, the range is multiplied by
  /// (d_m/60 mm)^p. With p = 0, the range is the same for bearings of all sizes.
  double size_power = 0.0;
  /// True if the effect increases and decreases as the machine warms up and cools down.
  bool follows_heat = false;
  bool base_law = false;   ///< true: the effect changes an exponent in the base law
  bool empirical = false;  ///< true: the formula is empirical, without a physical law
  bool spin = false;  ///< true: the friction moment comes from contacts in which the balls spin
  /// True if the effect changes the condition of the bearings (Condition), but not the axial
  /// position of the shaft.
  bool friction_alone = false;
  bool as_mounted = false;      ///< true: the effect changes the type of preload, rigid or spring
  bool of_each_record = false;  ///< true: the size of the effect may differ between records
};

/// Functions of an effect. Each function belongs to one step of a prediction, and is null if the
/// effect does not change this step. `values` are the parameter values in the order of the
/// parameters.
struct Actions {
  /// Corrects entered or measured values.
  void (*entry)(Entry&, std::span<const double> values) = nullptr;
  /// Returns a text about the wrong data, such as "the true preload is 0.8 times the entered
  /// preload". If this function is null, the program writes a text about the values that the
  /// function `entry` changes.
  std::string (*correction)(std::span<const double> values) = nullptr;
  /// Adds changes to the condition of the bearing, such as load, tilt, ring growth or preload.
  void (*condition)(const ConditionInputs&, std::span<const double> values, Condition&) = nullptr;
  /// Changes the film viscosity or the factor on the viscous moment. Effects with this function are
  /// applied in the order of the catalogue.
  void (*lubricant)(const LubricantInputs&, std::span<const double> values, Film&) = nullptr;
  /// Computes the film like the function `lubricant`, but approximates the moment of the contact
  /// law by tangents (TangentAbout). Newton's method finds the film temperature, with `temperature`
  /// as start value. The function returns false if the method finds no solution.
  bool (*lubricant_by_tangents)(const LubricantInputs&, std::span<const double> values,
                                double temperature, const TangentAbout&, Film&) = nullptr;
  /// Returns the added friction moment of one bearing [N m].
  double (*moment)(const MomentInputs&, std::span<const double> values) = nullptr;
  /// Returns the friction moment per unit of the parameter [N m per unit]. This function is used
  /// instead of `moment` if the effect has a single parameter and the moment is proportional to it.
  double (*unit_moment)(const MomentInputs&) = nullptr;
  const OwnMoment* user_made = nullptr;  ///< moment of a user-defined effect
  /// Returns the value that is added to the reading of `channel` [SI].
  double (*reading)(const ReadingInputs&, std::span<const double> values) = nullptr;
  /// Channel whose reading the function `reading` changes; null if the effect changes no reading.
  const record::Channel* channel = nullptr;
  /// Changes the heat sources of a spindle and the factors on its heat transfer.
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

/// Description of one physical effect in the catalogue of effects. Each effect is a struct in its
/// own file (see spin_friction.h). catalogue.cpp copies the members of this struct to a
/// Description.
///
/// Some effects have different formulas for a bearing on a rig and for the bearing sets of a shaft.
/// They have two descriptions with the same id and separate parameters, and the kind of model
/// selects the description. A spindle uses the descriptions for a shaft, except for effects that
/// its computed temperatures already include.
struct Description : Card, Requirements, Exclusions, Nature, Actions {
  std::span<const Parameter> parameters = {};

  /// Returns true if the effect changes this measured channel. On a shaft, a friction moment
  /// changes the torque of the sets, but not the axial position. In a spindle, the friction heat
  /// changes all channels.
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
  std::shared_ptr<const void> owner = nullptr;  ///< keeps a user-defined `description` alive

  /// Returns the added moment [N m]; 0 if the effect adds no moment.
  [[nodiscard]] double moment(const MomentInputs& inputs) const;
};

/// Returns the changes that these effects cause in a spindle. Effects for which Actions::spindle is
/// null change nothing.
[[nodiscard]] SpindleCondition spindle_condition(std::span<const Effect> effects);

/// Returns the initial values of all parameters.
[[nodiscard]] std::vector<double> initial_values(const Description& description);
/// Returns the neutral value of each parameter, at which the effect has no influence. If a
/// parameter has no neutral value, its initial value is returned.
[[nodiscard]] std::vector<double> neutral_values(const Description& description);

}  // namespace raceway::effects
