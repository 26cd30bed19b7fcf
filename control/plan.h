#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/control_settings.h"
#include "correction/model.h"

/// Describes corrections as numbers for a control. Every format of `export` is written from these
/// numbers.
///
/// All numbers are in the units of files: um (urad for an angle), C, K, W, rpm, m/min, s, N mm.
/// Every slow part is a sum of parallel sections. Each section has a state s that follows its
/// target by
///
///   s += (1 - exp(-dt/tau)) (target - s),   dt the time since the last call, as measured
///
/// Inputs that vary linearly between two samples, such as temperatures, use the exact step for a
/// ramp. A transfer function that is a sum of lags (correction::parallel_form()) becomes sections.
/// Other transfer functions run as difference equations with a fixed interval between calls.
namespace raceway::control {

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// A number that the control supplies at each call.
struct ControlInput {
  std::string column{};      ///< "front_bearing_temperature_C"
  std::string identifier{};  ///< unique name for languages without hyphens
  std::string unit{};        ///< "C"
  bool temperature = false;
  bool by_amount = true;  ///< true: the absolute value is used, as for speeds, feeds and coolant
  /// Range of the input in the data of the fit; NaN if not known. For several models, the range is
  /// the intersection of the ranges of the models.
  double lowest = unset, highest = unset;
  /// Plausible range, largest rate [1/s] and longest standstill [s]; NaN means that a limit is not
  /// checked.
  double plausible_low = unset, plausible_high = unset, fastest_per_s = unset, stuck_s = unset;
  /// Time constant of a filter on the input, for the parts of the correction that follow the input
  /// without lag [s]; 0: no filter.
  double smoothing_s = 0.0;
};

/// Joint range of the inputs in the data of the fit: |weights (x - mean)| is at most `farthest`.
/// Speeds, feeds and the coolant state enter with their absolute value.
struct ControlTogether {
  std::vector<std::size_t> inputs{};
  std::vector<double> mean{};
  std::vector<double> weights{};  ///< lower triangle, row by row [1 over the unit of the input]
  double farthest = unset;
};

/// Friction torque of a spindle, interpolated linearly between its points and constant beyond them.
/// The absolute value of a load is used if the load axis has no negative value.
struct ControlTable {
  std::string file{};
  /// Increasing values, at least one per axis; exactly one if no input supplies a value for the
  /// axis.
  std::vector<double> speed_rpm{}, axial_load_N{}, radial_load_N{}, temperature_C{};
  std::vector<double> torque_Nmm{};  ///< in the order of the axes; the speed varies fastest
};

/// Input u of a part of a correction.
struct ControlDrive {
  enum class Kind {
    rise,   ///< mean rise of temperatures from their first values, minus the rise of the reference
            ///< [K]
    size,   ///< mean of the inputs; a speed x enters as x (x/1000)^(exponent - 1)
    power,  ///< torque of a table times the speed [W]
    motor   ///< exp(-n/n0) while the motor turns, else 0
  } kind = Kind::size;
  std::vector<std::size_t> inputs{};  ///< inputs of the kinds rise and size
  std::size_t reference = nowhere;    ///< reference temperature of a rise
  /// Inputs that supply the loads and the temperature for the table of a power.
  std::size_t axial_load = nowhere, radial_load = nowhere, temperature = nowhere;
  double temperature_C = unset;            ///< temperature for the table if no input supplies it
  std::size_t table = nowhere;             ///< table of the kind power
  double exponent = 1.0;                   ///< exponent of the kind size
  double decay_rpm = unset;                ///< n0 of the kind motor
  double lowest = unset, highest = unset;  ///< range of a power in the data of the fit
  std::string unit{};                      ///< "K"
  /// Input of the window, the position of an axis. The window is a factor: 0 outside the outer
  /// points, 1 between the inner points, and linear between an outer and an inner point.
  std::size_t window = nowhere;
  double window_from = unset, window_full_from = unset, window_full_to = unset, window_to = unset;
  bool window_of_drive = false;  ///< true: the window multiplies u; false: the displacement
};

/// A lag whose input is a ControlDrive.
struct ControlSection {
  std::string channel{};
  std::size_t drive = nowhere;
  double gain = unset;  ///< [um] per unit of the drive
  double time_constant_s = unset;
  bool straight = false;  ///< true: u is linear between samples; false: constant
  double direct = 0.0;    ///< share of gain u that acts at once, because the sensor lags
  /// Factors on the gain and on the time constant while coolant_on is 0.
  double off_gain = 1.0, off_time_constant = 1.0;
  /// The time constant is multiplied by f = 1/(1 + speed_factor n/10 000 rpm), and the gain by
  /// f^gain_power.
  double speed_factor = 0.0, gain_power = 1.0;
  /// Factor on the time constant while the drive is below the state of the section divided by gain.
  double falling = 1.0;
};

/// A function of the drive: a line, a power law, or a table that is constant beyond its ends.
struct ControlCurve {
  enum class Kind { line, power_law, table } kind = Kind::line;
  double factor = 0.0;  ///< slope of a line, or factor of a power law
  double other = 0.0;   ///< value of a line at 0, or exponent of a power law
  std::vector<double> input{}, value{};
};

/// A section whose target and time constant depend on its drive. The drive is a power or a load.
struct ControlElement {
  std::string channel{};
  std::size_t drive = nowhere;
  double scale = 1.0;
  ControlCurve gain_um{}, time_constant_s{};
  /// Range of the drive, in its unit: `from` <= drive < `limit`. Outside this range, the section
  /// does not change. -1e30 and infinity mean no bound.
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
/// The equation advances in a call that comes `sampling_s` after the previous call (within
/// interval_tolerance). In other calls, y does not change.
struct ControlEquation {
  std::string channel{};
  std::size_t drive = nowhere;
  double scale = 1.0;         ///< factor of y [1]
  double sampling_s = unset;  ///< equal in all equations of a plan
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

/// One displacement.
struct ControlAxis {
  std::string column{};      ///< "displacement_z_um"
  std::string identifier{};  ///< unique name for languages without hyphens
  std::string name{};        ///< name of the model
  std::string letter{};      ///< machine axis that the output moves: "z"; empty if not given
  double sign = -1.0, limit_um = 100.0, slew_um_s = 1.0;
  double unit_um = 1.0;  ///< unit of the output, in um
  bool counts = false;   ///< true: the output is a whole number of these units
  std::string output{};  ///< name of the output, such as "offset_z_um" or "offset_z_counts"
  bool angle = false;    ///< true: all numbers in um are in urad instead
  double offset_um = 0.0;
  /// Trust in the model as a text from correction::name(), and the reason. Both are empty if the
  /// trust is not known.
  std::string trust{}, trust_because{};
  std::vector<ControlSection> sections{};
  std::vector<ControlElement> elements{};
  std::vector<ControlFeedthrough> feedthroughs{};
  std::vector<ControlEquation> equations{};
  std::vector<ControlKinematic> kinematics{};
};

/// A record with the results of `correct`. The exported program contains this record, so that users
/// can check the program on their control.
struct ControlCheck {
  struct Row {
    double time_s = unset;
    std::vector<double> inputs{};            ///< in their units, in the order of the plan
    std::vector<double> displacements_um{};  ///< one for each axis of the plan
  };
  std::vector<Row> rows{};  ///< empty without a record
};

struct ControlPlan {
  std::string source{};  ///< name of the model file
  std::vector<ControlInput> inputs{};
  std::size_t speed = nowhere,
              coolant = nowhere;            ///< indices of speed_rpm and coolant_on in `inputs`
  std::vector<ControlTogether> together{};  ///< one for each model with a joint range
  std::vector<ControlTable> tables{};
  std::vector<ControlDrive> drives{};
  std::vector<ControlAxis> axes{};
  ControlCheck check{};
  correction::ControlSettings settings{};  ///< settings for all inputs and axes
  /// One sentence for each part of the models that the plan lacks or changes, and for each check
  /// that the program cannot make.
  std::vector<std::string> notes{};
  /// One sentence for each physically impossible property of a difference equation.
  std::vector<std::string> warnings{};
};

/// Returns the ControlInput for a column, without its range and its checks.
[[nodiscard]] ControlInput input_of(const record::Channel& channel);

/// Returns the index of the input of a column, or `nowhere`.
[[nodiscard]] std::size_t place_of(const ControlPlan& plan, std::string_view column);

/// Makes a plan. Throws InputError for parts that a control cannot run: polynomials that never
/// decay, polynomials with different sampling intervals, and user-defined formulas.
[[nodiscard]] ControlPlan control_plan(const std::vector<correction::Model>& models,
                                       const correction::ControlSettings& settings,
                                       const std::string& source);

/// Merges equal drives and tables and sorts them in the order in which axes use them. Gives inputs
/// and displacements names that are valid in the target languages.
void in_order(ControlPlan& plan);

/// Increases stuck_s, the time after which a sensor counts as stuck, if a working sensor was
/// constant for `still_s`. The new time is 1.5 times `still_s`, rounded up to 10 minutes, and at
/// most one day. The function changes only temperatures, only to a longer time, and only if
/// `settings` have the default of stuck_s. Returns a sentence on the change; empty if nothing
/// changed. `where` names the record in which the sensor was constant.
[[nodiscard]] std::string allow_to_stand(ControlInput& input, double still_s,
                                         const correction::ControlSettings& settings,
                                         const std::string& where);

/// Returns the unit of the displacement of an axis: "um" or "urad".
[[nodiscard]] constexpr std::string_view unit_of(const ControlAxis& axis) {
  return axis.angle ? "urad" : "um";
}

/// Returns the text on the trust in the model of an axis; empty if not known.
[[nodiscard]] std::string trust_line(const ControlAxis& axis);

/// Changes the output of every axis to whole counts, for LinuxCNC.
void count_in_whole_numbers(ControlPlan& plan);

/// Returns the interval between two calls that the equations of a plan need [s]; NaN if there are
/// no equations.
[[nodiscard]] double sampling_of(const ControlPlan& plan);

/// Returns the indices of the inputs that an axis uses, in increasing order.
[[nodiscard]] std::vector<std::size_t> used_inputs(const ControlPlan& plan,
                                                   const ControlAxis& axis);

}  // namespace raceway::control
