#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/control_settings.h"
#include "correction/model.h"

/// Describes corrections by coefficients for a machine control. `raceway export` writes every
/// format from these coefficients.
///
/// All numbers are in the units of files: um (urad for an angle), C, K, W, rpm, m/min, s, N mm.
/// Every slow part of a displacement is a sum of parallel sections (lags). The state s of a section
/// follows its target (gain times input) with the time constant tau:
///
///   s += (1 - exp(-dt/tau)) (target - s),   dt: measured time since the last call
///
/// For inputs that vary linearly between two samples, such as temperatures, an additional term
/// makes s exact. A transfer function that is a sum of lags (correction::parallel_form()) is
/// exported as sections. Any other transfer function is exported as a difference equation, which
/// needs a fixed interval between calls.
namespace raceway::control {

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// An input of the exported program. The control supplies its value at each call.
struct ControlInput {
  std::string column{};      ///< name of the column, such as "front_bearing_temperature_C"
  std::string identifier{};  ///< unique name for languages without hyphens
  std::string unit{};        ///< unit of the column, such as "C"
  bool temperature = false;
  bool by_amount = true;  ///< true: the absolute value is used, as for speeds, feeds and coolant
  /// Range of the input in the training data; NaN if not known. For several models, the range is
  /// the intersection of their ranges.
  double lowest = unset, highest = unset;
  /// Plausible range, largest change per second, and longest time without a change [s]. The program
  /// does not check a limit that is NaN.
  double plausible_low = unset, plausible_high = unset, fastest_per_s = unset, stuck_s = unset;
  /// Time constant of a filter on the input [s]; 0: no filter. The filter is for the parts of the
  /// correction that follow the input without lag.
  double smoothing_s = 0.0;
};

/// Joint range of the inputs x in the training data: the norm |weights (x - mean)| is at most
/// `farthest`. Speeds, feeds and the coolant state enter with their absolute value.
struct ControlTogether {
  std::vector<std::size_t> inputs{};
  std::vector<double> mean{};
  std::vector<double> weights{};  ///< lower triangle, row by row [1 over the unit of the input]
  double farthest = unset;
};

/// Table of the friction torque of a spindle. The program interpolates linearly between the points.
/// Beyond the edge of the table, it uses the value at the edge. It uses the absolute value of a
/// load if the load axis has no negative value.
struct ControlTable {
  std::string file{};
  /// Increasing grid values of each axis, at least one. An axis of load or temperature has exactly
  /// one value if no input supplies the load or temperature.
  std::vector<double> speed_rpm{}, axial_load_N{}, radial_load_N{}, temperature_C{};
  std::vector<double> torque_Nmm{};  ///< one value for each grid point; the speed varies fastest
};

/// Quantity u that drives a part of a correction, computed from the inputs.
struct ControlDrive {
  enum class Kind {
    rise,   ///< mean rise of temperatures from their first values, minus the rise of the reference
            ///< [K]
    size,   ///< mean of the inputs; a speed x [rpm] enters as x (x/1000)^(exponent - 1)
    power,  ///< friction torque from a table times the speed [W]
    motor   ///< exp(-n/n0) while the motor turns at the speed n, else 0
  } kind = Kind::size;
  std::vector<std::size_t> inputs{};  ///< indices of the inputs, for `rise` and `size`
  std::size_t reference = nowhere;    ///< index of the reference temperature, for `rise`
  /// Indices of the inputs that supply loads and temperature for the table of a power; `nowhere` if
  /// no input does.
  std::size_t axial_load = nowhere, radial_load = nowhere, temperature = nowhere;
  double temperature_C = unset;  ///< temperature for the table if no input supplies it [C]
  std::size_t table = nowhere;   ///< index of the table, for `power`
  double exponent = 1.0;         ///< exponent of a speed, for `size` [1]
  double decay_rpm = unset;      ///< n0, for `motor`
  double lowest = unset, highest = unset;  ///< range of a power in the training data [W]
  std::string unit{};                      ///< unit of u, such as "K"
  /// Index of the input on which the window depends: the position of a machine axis. The window is
  /// a factor: 0 outside `window_from` and `window_to`, 1 between `window_full_from` and
  /// `window_full_to`, and linear between.
  std::size_t window = nowhere;
  double window_from = unset, window_full_from = unset, window_full_to = unset, window_to = unset;
  bool window_of_drive = false;  ///< true: the window multiplies u; false: the displacement
};

/// A lag whose input is a ControlDrive.
struct ControlSection {
  std::string channel{};
  std::size_t drive = nowhere;
  double gain = unset;  ///< [um] per unit of u
  double time_constant_s = unset;
  bool straight = false;  ///< true: u is linear between samples; false: u is constant
  /// The section adds (1 - direct) s + direct gain u to the displacement, with its state s.
  /// `direct` is the time constant of the sensor divided by `time_constant_s` [1]: see the effect
  /// sensor-lag. Without this effect, it is 0.
  double direct = 0.0;
  /// Factors on the gain and on the time constant while coolant_on is 0.
  double off_gain = 1.0, off_time_constant = 1.0;
  /// At the speed n, the time constant is multiplied by f = 1/(1 + speed_factor n/10 000 rpm), and
  /// the gain is multiplied by f^gain_power.
  double speed_factor = 0.0, gain_power = 1.0;
  /// Factor on the time constant while u is below the state of the section divided by `gain`.
  double falling = 1.0;
};

/// A function of a drive u: a line, a power law, or a table that is linear between its points and
/// constant beyond its ends.
struct ControlCurve {
  enum class Kind { line, power_law, table } kind = Kind::line;
  double factor = 0.0;  ///< slope of a line, or factor of a power law
  double other = 0.0;   ///< value of a line at 0, or exponent of a power law
  std::vector<double> input{}, value{};
};

/// A lag whose gain and time constant depend on its drive, a power or a load.
struct ControlElement {
  std::string channel{};
  std::size_t drive = nowhere;
  double scale = 1.0;
  ControlCurve gain_um{}, time_constant_s{};
  /// Range of the drive, in its unit: `from` <= drive < `limit`. Outside this range, the state of
  /// the lag does not change. -1e30 and infinity mean no bound.
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
/// The program advances the equation in a call that comes `sampling_s` after the previous call
/// (within interval_tolerance). In other calls, y does not change. u is the drive.
struct ControlEquation {
  std::string channel{};
  std::size_t drive = nowhere;
  double scale = 1.0;         ///< factor that multiplies y in the displacement [1]
  double sampling_s = unset;  ///< sampling interval; equal in all equations of a plan
  std::vector<double> numerator{},
      denominator{};  ///< numerator: [um] per unit of the drive; denominator: [1], of equal length
};

/// Largest allowed difference between the interval of two calls and the sampling interval, relative
/// to the sampling interval [1].
inline constexpr double interval_tolerance = 0.05;

/// Instant part of a displacement that follows the speed n [rpm]: A n^(1 - B exp(-C n)).
struct ControlKinematic {
  double A_um = unset, B = unset, C_per_rpm = unset;
};

/// Correction of one displacement, and the output that it moves.
struct ControlAxis {
  std::string column{};      ///< column of the displacement, such as "displacement_z_um"
  std::string identifier{};  ///< unique name for languages without hyphens
  std::string name{};        ///< name of the model
  std::string letter{};      ///< machine axis that the output moves, such as "z"; may be empty
  double sign = -1.0, limit_um = 100.0, slew_um_s = 1.0;
  double unit_um = 1.0;  ///< unit of the output, in um
  bool counts = false;   ///< true: the output is a whole number of `unit_um`
  std::string output{};  ///< name of the output, such as "offset_z_um" or "offset_z_counts"
  bool angle = false;    ///< true: all numbers in um are in urad instead
  double offset_um = 0.0;
  /// Trust in the model ("good", "within-range" or "do-not-use"), and the reason. Both are empty if
  /// the trust is not known.
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
    std::vector<double> inputs{};  ///< in their units, in the order of ControlPlan::inputs
    std::vector<double> displacements_um{};  ///< one for each axis of the plan [um] or [urad]
  };
  std::vector<Row> rows{};  ///< empty without a check record
};

struct ControlPlan {
  std::string source{};  ///< name of the model file
  std::vector<ControlInput> inputs{};
  std::size_t speed = nowhere,
              coolant = nowhere;            ///< indices of speed_rpm and coolant_on in `inputs`
  std::vector<ControlTogether> together{};  ///< one for each model with a joint range of inputs
  std::vector<ControlTable> tables{};
  std::vector<ControlDrive> drives{};
  std::vector<ControlAxis> axes{};
  ControlCheck check{};
  correction::ControlSettings settings{};  ///< settings for all inputs and axes
  /// One sentence for each part of the models that is missing or changed in the plan, and for each
  /// check that the program cannot make.
  std::vector<std::string> notes{};
  /// One sentence for each physically impossible property of a difference equation.
  std::vector<std::string> warnings{};
};

/// Returns the ControlInput for a column of a record, without its range and its limits.
[[nodiscard]] ControlInput input_of(const record::Channel& channel);

/// Returns the index of the input with this column name in `plan.inputs`; `nowhere` if no input has
/// this name.
[[nodiscard]] std::size_t place_of(const ControlPlan& plan, std::string_view column);

/// Makes the plan that exports these models. Throws InputError for parts that a control cannot run:
/// transfer functions whose response never decays, difference equations with different sampling
/// intervals, and user-defined formulas.
[[nodiscard]] ControlPlan control_plan(const std::vector<correction::Model>& models,
                                       const correction::ControlSettings& settings,
                                       const std::string& source);

/// Merges equal drives and tables, and sorts them in the order in which axes use them. Sets the
/// identifiers of inputs and axes to names that are valid in the target languages.
void in_order(ControlPlan& plan);

/// Increases stuck_s, the time after which the program reports a constant sensor as stuck, because
/// a working sensor was constant for `still_s` [s]. The new time is 1.5 times `still_s`, rounded up
/// to 10 minutes, and at most one day. The function changes only temperature inputs, only to a
/// longer time, and only if `settings` have the default of stuck_s. Returns a sentence that
/// describes the change; empty if nothing changed. `where` names the record in which the sensor was
/// constant.
[[nodiscard]] std::string allow_to_stand(ControlInput& input, double still_s,
                                         const correction::ControlSettings& settings,
                                         const std::string& where);

/// Returns the unit of the displacement of an axis: "um" or "urad".
[[nodiscard]] constexpr std::string_view unit_of(const ControlAxis& axis) {
  return axis.angle ? "urad" : "um";
}

/// Returns one line of text on the trust in the model of an axis; empty if the trust is not known.
[[nodiscard]] std::string trust_line(const ControlAxis& axis);

/// Changes the output of every axis to whole counts, as LinuxCNC requires.
void count_in_whole_numbers(ControlPlan& plan);

/// Returns the interval between calls that the difference equations of a plan need [s]; NaN if the
/// plan has no difference equation.
[[nodiscard]] double sampling_of(const ControlPlan& plan);

/// Returns the indices of the inputs that an axis uses, in increasing order.
[[nodiscard]] std::vector<std::size_t> used_inputs(const ControlPlan& plan,
                                                   const ControlAxis& axis);

}  // namespace raceway::control
