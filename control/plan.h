#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/control_settings.h"
#include "correction/model.h"

/// Describes the corrections that an exported program computes on a machine control. `raceway
/// export` writes every format from the coefficients in ControlPlan.
///
/// All numbers are in the units of files: um (urad for an angle), C, K, W, rpm, m/min, s, N mm.
/// Every slow part of a displacement is a sum of parallel first-order lags, which are called
/// sections. The state s of a section follows its target (gain times input) with the time constant
/// tau:
///
///   s += (1 - exp(-dt/tau)) (target - s),   dt: measured time since the last call
///
/// Some inputs, such as temperatures, are assumed linear between two samples. For a linear input,
/// the exported program adds a term to this formula, which makes s exact. A transfer function that
/// equals a sum of lags (correction::parallel_form()) is exported as sections. Any other transfer
/// function is exported as a difference equation. A difference equation needs a fixed interval
/// between calls.
namespace raceway::control {

/// Index of an input or table that does not exist.
inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// An input of the exported program. The control supplies the value of the input at each call.
struct ControlInput {
  std::string column{};      ///< name of the column, such as "front_bearing_temperature_C"
  std::string identifier{};  ///< unique name that is valid in all target languages
  std::string unit{};        ///< unit of the column, such as "C"
  bool temperature = false;
  bool by_amount = true;  ///< true: the program uses the absolute value, as for speeds and feeds
  /// Range of the input in the training data; NaN if not known. For a plan with several models, the
  /// range is the intersection of their ranges.
  double lowest = unset, highest = unset;
  /// Limits for the check of the sensor: plausible range, largest change per second, and longest
  /// time without a change [s]. The exported program does not check a limit that is NaN.
  double plausible_low = unset, plausible_high = unset, fastest_per_s = unset, stuck_s = unset;
  /// Time constant of a filter on the input [s]; 0 means no filter. Only those parts of the
  /// correction that follow the input without lag use the filtered value.
  double smoothing_s = 0.0;
};

/// Joint range of several inputs x in the training data: the norm |weights (x - mean)| is at most
/// `farthest`. The absolute values of speeds and feeds are used.
struct ControlTogether {
  std::vector<std::size_t> inputs{};
  std::vector<double> mean{};
  std::vector<double> weights{};  ///< lower triangular matrix, row by row [1/unit of the input]
  double farthest = unset;
};

/// Table of the friction torque of a spindle. The exported program interpolates linearly between
/// the points. Outside the table, the program uses the value at the nearest edge. If a load axis
/// has no negative value, the program uses the absolute value of the load.
struct ControlTable {
  std::string file{};
  /// Increasing grid values of each axis, at least one. If no input supplies a load or the
  /// temperature, the axis of this quantity has exactly one value.
  std::vector<double> speed_rpm{}, axial_load_N{}, radial_load_N{}, temperature_C{};
  std::vector<double> torque_Nmm{};  ///< one value for each grid point; the speed varies fastest
};

/// Quantity u that drives a part of a correction, computed from the inputs.
struct ControlDrive {
  enum class Kind {
    /// Mean rise of the input temperatures since the first call, minus the rise of the reference
    /// temperature [K].
    rise,
    /// Mean of the inputs. In this mean, x (x/1000)^(exponent - 1) replaces a speed x [rpm]. Above
    /// the highest speed of the training data, the tangent at this speed limits the power.
    size,
    power,  ///< friction torque from a table times the speed [W]
    motor   ///< exp(-n/n0) while the spindle turns at the speed n, else 0 [1]
  } kind = Kind::size;
  std::vector<std::size_t> inputs{};  ///< for Kind::rise and Kind::size: indices of the inputs
  /// For Kind::rise: index of the input with the reference temperature.
  std::size_t reference = nowhere;
  /// For Kind::power: indices of the inputs with the loads and the temperature of the torque table;
  /// `nowhere` if no input supplies this quantity.
  std::size_t axial_load = nowhere, radial_load = nowhere, temperature = nowhere;
  /// For Kind::power: temperature if no input supplies it [C].
  double temperature_C = unset;
  std::size_t table = nowhere;  ///< for Kind::power: index in ControlPlan::tables
  double exponent = 1.0;        ///< for Kind::size: exponent of a speed [1]
  double decay_rpm = unset;     ///< for Kind::motor: n0 in exp(-n/n0) [rpm]
  /// For Kind::power: range of the power in the training data [W].
  double lowest = unset, highest = unset;
  std::string unit{};  ///< unit of u, such as "K"
  /// A drive may act only in a window: a range of one input, such as the position of a machine
  /// axis. `window` is the index of this input; `nowhere` means that there is no window. The factor
  /// of the window depends on this input. The factor is 0 below `window_from` and above
  /// `window_to`, 1 from `window_full_from` to `window_full_to`, and linear between 0 and 1.
  std::size_t window = nowhere;
  double window_from = unset, window_full_from = unset, window_full_to = unset, window_to = unset;
  /// If true, the factor of the window multiplies u. If false, the factor multiplies the
  /// displacement that u causes.
  bool window_of_drive = false;
};

/// First-order lag whose input u is a ControlDrive.
struct ControlSection {
  std::string channel{};
  std::size_t drive = nowhere;
  double gain = unset;  ///< [um] per unit of u
  double time_constant_s = unset;
  /// If true, u is linear between two samples. If false, u is constant between two samples.
  bool straight = false;
  /// Share of the section that follows u without lag [1]. The section adds (1 - direct) s + direct
  /// gain u to the displacement (s: state of the section). If the model contains the effect
  /// sensor-lag, `direct` is the time constant of the sensor divided by `time_constant_s`.
  /// Otherwise `direct` is 0.
  double direct = 0.0;
  /// Factors that multiply the gain and the time constant while coolant_on is 0.
  double off_gain = 1.0, off_time_constant = 1.0;
  /// At the speed n, the time constant is multiplied by f = 1/(1 + speed_factor n/10 000 rpm), and
  /// the gain is multiplied by f^gain_power.
  double speed_factor = 0.0, gain_power = 1.0;
  /// Factor that multiplies the time constant while u is below s/gain (s: state of the section), as
  /// when the machine cools down.
  double falling = 1.0;
};

/// Function of a drive u: a line, a power law or a table. A table is linear between its points and
/// constant beyond its ends.
struct ControlCurve {
  enum class Kind { line, power_law, table } kind = Kind::line;
  double factor = 0.0;  ///< slope of a line, or factor of a power law
  double other = 0.0;   ///< value of a line at u = 0, or exponent of a power law
  std::vector<double> input{}, value{};
};

/// First-order lag whose gain and time constant depend on its drive. The drive is a power or a
/// load.
struct ControlElement {
  std::string channel{};
  std::size_t drive = nowhere;
  double scale = 1.0;
  ControlCurve gain_um{}, time_constant_s{};
  /// Range of the drive, in the unit of the drive: `from` <= drive < `limit`. Outside this range,
  /// the state of the lag does not change. `from` = -1e30 or `limit` = infinity means that there is
  /// no bound.
  double from = 0.0, limit = unset;
};

/// Instant part of a displacement: the gain times the drive.
struct ControlFeedthrough {
  std::string channel{};
  std::size_t drive = nowhere;
  double gain = unset;  ///< [um] per unit of the drive
};

/// A difference equation that is not a sum of lags:
///
///   y(k) = sum numerator(i) u(k-i) - sum denominator(i) y(k-i),   denominator(0) = 1
///
/// u is the drive, and k is the number of the call. The exported program computes a new y in a call
/// that comes `sampling_s` after the previous call (within interval_tolerance). In other calls, y
/// does not change.
struct ControlEquation {
  std::string channel{};
  std::size_t drive = nowhere;
  double scale = 1.0;         ///< factor that multiplies y in the displacement [1]
  double sampling_s = unset;  ///< sampling interval, equal in all equations of a plan [s]
  /// Coefficients of the equation: numerator [um per unit of the drive] and denominator [1]. Both
  /// lists have the same length.
  std::vector<double> numerator{}, denominator{};
};

/// Largest allowed difference between the interval of two calls and the sampling interval, relative
/// to the sampling interval [1].
inline constexpr double interval_tolerance = 0.05;

/// Instant part of a displacement that follows the speed n [rpm]: A n^(1 - B exp(-C n)).
struct ControlKinematic {
  double A_um = unset, B = unset, C_per_rpm = unset;
};

/// Correction of one displacement, and the output of the program that compensates the displacement.
struct ControlAxis {
  std::string column{};      ///< column of the displacement, such as "displacement_z_um"
  std::string identifier{};  ///< unique name that is valid in all target languages
  std::string name{};        ///< name of the model
  std::string letter{};      ///< machine axis that the output moves, such as "z"; may be empty
  double sign = -1.0, limit_um = 100.0, slew_um_s = 1.0;
  double unit_um = 1.0;  ///< size of one unit of the output [um]
  bool counts = false;   ///< true: the output is a whole number of counts of the size `unit_um`
  std::string output{};  ///< name of the output, such as "offset_z_um" or "offset_z_counts"
  bool angle = false;    ///< true: the displacement is an angle, in urad instead of um
  double offset_um = 0.0;
  /// Level of trust in the model ("good", "within-range" or "do-not-use"), and the reason for this
  /// level. Both texts are empty if the trust is not known.
  std::string trust{}, trust_because{};
  std::vector<ControlSection> sections{};
  std::vector<ControlElement> elements{};
  std::vector<ControlFeedthrough> feedthroughs{};
  std::vector<ControlEquation> equations{};
  std::vector<ControlKinematic> kinematics{};
};

/// Rows of inputs with the displacements that `correct` predicts. The exported program contains
/// these rows, so that users can check the program on their control.
struct ControlCheck {
  struct Row {
    double time_s = unset;
    std::vector<double> inputs{};  ///< values in the order and units of ControlPlan::inputs
    std::vector<double> displacements_um{};  ///< one for each axis [um], or [urad] for an angle
  };
  std::vector<Row> rows{};  ///< empty if the plan has no check record
};

struct ControlPlan {
  std::string source{};  ///< name of the model file
  std::vector<ControlInput> inputs{};
  std::size_t speed = nowhere,
              coolant = nowhere;  ///< indices of speed_rpm and coolant_on in `inputs`
  /// Joint ranges of the inputs, one for each model that has a joint range.
  std::vector<ControlTogether> together{};
  std::vector<ControlTable> tables{};
  std::vector<ControlDrive> drives{};
  std::vector<ControlAxis> axes{};
  ControlCheck check{};
  correction::ControlSettings settings{};  ///< settings for all inputs and axes
  /// One sentence for each part of the models that the plan omits or changes, and for each check
  /// that the exported program cannot make.
  std::vector<std::string> notes{};
  /// Warnings about poles of difference equations: one sentence for each kind of pole that a
  /// thermal system cannot have, such as a complex pole.
  std::vector<std::string> warnings{};
};

/// Returns the ControlInput for a column of a record. The range in the training data and the limits
/// of the sensor check are NaN.
[[nodiscard]] ControlInput input_of(const record::Channel& channel);

/// Returns the index of the input with this column name in `plan.inputs`; `nowhere` if no input has
/// this name.
[[nodiscard]] std::size_t place_of(const ControlPlan& plan, std::string_view column);

/// Returns the plan of a program that corrects displacements with these models. Throws InputError
/// for parts that a control cannot run: transfer functions whose response never decays, difference
/// equations with different sampling intervals, and user-defined formulas.
[[nodiscard]] ControlPlan control_plan(const std::vector<correction::Model>& models,
                                       const correction::ControlSettings& settings,
                                       const std::string& source);

/// Merges equal drives and equal tables, and sorts drives and tables in the order in which the axes
/// use them. Sets the identifiers of inputs and axes to names that are valid in the target
/// languages.
void in_order(ControlPlan& plan);

/// Increases stuck_s, the time after which the exported program reports a constant sensor as stuck.
/// `still_s` is the longest time in which the working sensor was constant [s]. The new stuck_s is
/// 1.5 times `still_s`, rounded up to 10 minutes, and at most one day. The function never reduces
/// stuck_s. The function does nothing if the input is not a temperature, or if the user gives
/// stuck_s in `settings`. `where` names the record in which the sensor was constant. Returns a
/// sentence that describes the change, or an empty text.
[[nodiscard]] std::string allow_to_stand(ControlInput& input, double still_s,
                                         const correction::ControlSettings& settings,
                                         const std::string& where);

/// Returns the unit of the displacement of an axis: "um" or "urad".
[[nodiscard]] constexpr std::string_view unit_of(const ControlAxis& axis) {
  return axis.angle ? "urad" : "um";
}

/// Returns one line of text with the trust level of the model of an axis, and with the reason for
/// this level; empty if the level is not known.
[[nodiscard]] std::string trust_line(const ControlAxis& axis);

/// Changes the output of every axis to a whole number of counts, as LinuxCNC requires.
void count_in_whole_numbers(ControlPlan& plan);

/// Returns the interval between calls that the difference equations of a plan need [s]; NaN if the
/// plan has no difference equation.
[[nodiscard]] double sampling_of(const ControlPlan& plan);

/// Returns the indices of the inputs that an axis uses, in increasing order.
[[nodiscard]] std::vector<std::size_t> used_inputs(const ControlPlan& plan,
                                                   const ControlAxis& axis);

}  // namespace raceway::control
