#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/control_settings.h"
#include "correction/model.h"

/// Corrections as numbers for a control, the source of every format of `export`.
///
/// Units are the units of the files throughout: um (of an angle urad in its place), C, K, W, rpm,
/// m/min, s, N mm. Every slow part is a sum of parallel sections. Each section has a state that
/// follows its target by
///
///   s += (1 - exp(-dt/tau)) (target - s),   dt the time since the last call, as measured
///
/// Inputs that vary linearly between two samples, as temperatures, use the exact ramp step.
/// Polynomials with poles of lags become sections; others run as difference equations with a fixed
/// interval between calls.
namespace raceway::control {

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// A number that the control supplies at each call.
struct ControlInput {
  std::string column{};      ///< "front_bearing_temperature_C"
  std::string identifier{};  ///< unique name for languages without hyphens
  std::string unit{};        ///< "C"
  bool temperature = false;
  bool by_amount = true;  ///< acts by magnitude: speeds, feeds, coolant
  /// Range of the input in the data of the fit; NaN if not known.
  double lowest = unset, highest = unset;
  /// Plausible range, largest rate [1/s] and longest standstill [s]; NaN: not checked.
  double plausible_low = unset, plausible_high = unset, fastest_per_s = unset, stuck_s = unset;
  double smoothing_s = 0.0;  ///< time constant for its instant parts
};

/// Joint range of the inputs in the data of the fit: |weights (x - mean)| is at most `farthest`.
/// All but temperatures enter by their absolute value.
struct ControlTogether {
  std::vector<std::size_t> inputs{};
  std::vector<double> mean{};
  std::vector<double> weights{};  ///< lower triangle, row by row [1 over the unit of the input]
  double farthest = unset;
};

/// Friction torque of a spindle, linear between its points, constant beyond them. A load enters by
/// magnitude if its axis has no negative value.
struct ControlTable {
  std::string file{};
  /// Increasing values, at least one per axis; exactly one if no input of the drive reads the axis.
  std::vector<double> speed_rpm{}, axial_load_N{}, radial_load_N{}, temperature_C{};
  std::vector<double> torque_Nmm{};  ///< in this order, speed runs fastest
};

/// Input u of a part.
struct ControlDrive {
  enum class Kind {
    rise,   ///< mean of temperatures less their first ones, and less the rise of the reference [K]
    size,   ///< mean of inputs, speeds to a power: x (x/1000)^(exponent - 1)
    power,  ///< torque of a table times the speed [W]
    motor   ///< exp(-n/n0) while it turns, else 0
  } kind = Kind::size;
  std::vector<std::size_t> inputs{};  ///< inputs of rise and size
  std::size_t reference = nowhere;    ///< reference temperature of a rise
  /// Inputs for reading the table of a power.
  std::size_t axial_load = nowhere, radial_load = nowhere, temperature = nowhere;
  double temperature_C = unset;            ///< value if no input has it
  std::size_t table = nowhere;             ///< table of a power
  double exponent = 1.0;                   ///< exponent of a size
  double decay_rpm = unset;                ///< n0 of a motor
  double lowest = unset, highest = unset;  ///< range of a power, as for an input
  std::string unit{};                      ///< "K"
  /// Share of the drive's parts at this input: 0 outside of the outer points, 1 between the inner
  /// ones, linear between.
  std::size_t window = nowhere;
  double window_from = unset, window_full_from = unset, window_full_to = unset, window_to = unset;
  bool window_of_drive = false;  ///< the window multiplies u; else the displacement of the parts
};

/// A lag of its drive.
struct ControlSection {
  std::string channel{};
  std::size_t drive = nowhere;
  double gain = unset;  ///< [um] per unit of the drive
  double time_constant_s = unset;
  bool straight = false;  ///< u is linear between samples; else constant until the next
  double direct = 0.0;    ///< share of gain u that acts at once, for a sensor that lags
  double off_gain = 1.0, off_time_constant = 1.0;  ///< ratios where coolant_on is 0
  double speed_factor = 0.0, gain_power = 1.0;     ///< tau f, K f^g, f = 1/(1 + s n/10 000 rpm)
  double falling = 1.0;                            ///< ratio of tau where the target is nearer 0
};

/// A function of the drive: a line, a power law, or a table that is constant beyond its ends.
struct ControlCurve {
  enum class Kind { line, power_law, table } kind = Kind::line;
  double factor = 0.0;  ///< slope of a line
  double other = 0.0;   ///< a line's value at 0, a power law's exponent
  std::vector<double> input{}, value{};
};

/// A section with target and time constant that depend on the drive, a power or a load.
struct ControlElement {
  std::string channel{};
  std::size_t drive = nowhere;
  double scale = 1.0;
  ControlCurve gain_um{}, time_constant_s{};
  /// Range of the drive, in its unit: from `from` on and below `limit`; outside it the section
  /// stands still. -1e30 and infinite mean no bound.
  double from = 0.0, limit = unset;
};

/// Instant part: gain u.
struct ControlFeedthrough {
  std::string channel{};
  std::size_t drive = nowhere;
  double gain = unset;  ///< [um] per unit of the drive
};

/// A difference equation with poles other than lags:
///
///   y(k) = sum numerator(i) u(k-i) - sum denominator(i) y(k-i),   denominator(0) = 1
///
/// Advances in calls that come `sampling_s` after the call before, and stands still in others.
struct ControlEquation {
  std::string channel{};
  std::size_t drive = nowhere;
  double scale = 1.0;         ///< factor of y [1]
  double sampling_s = unset;  ///< equal in all equations of a plan
  std::vector<double> numerator{},
      denominator{};  ///< [um] per unit of the drive; [1], of equal length
};

/// Largest deviation of an interval between two calls from the sampling, as a share of it.
inline constexpr double interval_tolerance = 0.05;

/// Instant part: A n^(1 - B exp(-C n)).
struct ControlKinematic {
  double A_um = unset, B = unset, C_per_rpm = unset;
};

/// One displacement.
struct ControlAxis {
  std::string column{};      ///< "displacement_z_um"
  std::string identifier{};  ///< as of an input
  std::string name{};        ///< name of the model
  std::string letter{};      ///< axis that it moves: "z"; empty if not given
  double sign = -1.0, limit_um = 100.0, slew_um_s = 1.0;
  double unit_um = 1.0;  ///< unit of the output
  bool counts = false;   ///< output in whole numbers of it
  std::string output{};  ///< "offset_z_um", "offset_z_mm", "offset_z_counts", "offset_b_urad"
  bool angle = false;    ///< urad instead of um in all of its numbers
  double offset_um = 0.0;
  /// Trust in its model, in the words of correction::name(), and the reason; empty if not known.
  std::string trust{}, trust_because{};
  std::vector<ControlSection> sections{};
  std::vector<ControlElement> elements{};
  std::vector<ControlFeedthrough> feedthroughs{};
  std::vector<ControlEquation> equations{};
  std::vector<ControlKinematic> kinematics{};
};

/// A record with the result of `correct`, stored with the numbers to check the program.
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
              coolant = nowhere;            ///< indices of the inputs with a special role
  std::vector<ControlTogether> together{};  ///< one for each model that states it
  std::vector<ControlTable> tables{};
  std::vector<ControlDrive> drives{};
  std::vector<ControlAxis> axes{};
  ControlCheck check{};
  correction::ControlSettings settings{};  ///< settings for all inputs and axes
  /// Parts of the models that are missing in the plan or differ, a sentence each.
  std::vector<std::string> notes{};
  /// Physically implausible properties of its parts, one sentence each.
  std::vector<std::string> warnings{};
};

/// Returns the input of a column; its range and its checks are not set.
[[nodiscard]] ControlInput input_of(const record::Channel& channel);

/// Returns the index of the input of a column, or `nowhere`.
[[nodiscard]] std::size_t place_of(const ControlPlan& plan, std::string_view column);

/// Makes a plan. Throws InputError for parts that no control can run: polynomials that never decay,
/// polynomials with two samplings, a user-made formula.
[[nodiscard]] ControlPlan control_plan(const std::vector<correction::Model>& models,
                                       const correction::ControlSettings& settings,
                                       const std::string& source);

/// Merges equal drives and tables, in the order in which axes use them, and gives inputs and
/// displacements names valid in the target languages.
void in_order(ControlPlan& plan);

/// Extends the time until a sensor counts as stuck, if a working sensor stood still for longer:
/// half as long again, in whole 10 minutes, one day at most; only a temperature for which
/// `settings` leave stuck_s to its default. Returns a sentence, empty where nothing changed.
/// `where`: it stood still, "in drift.csv".
[[nodiscard]] std::string allow_to_stand(ControlInput& input, double still_s,
                                         const correction::ControlSettings& settings,
                                         const std::string& where);

/// Unit of the displacement of an axis: "um", or "urad".
[[nodiscard]] constexpr std::string_view unit_of(const ControlAxis& axis) {
  return axis.angle ? "urad" : "um";
}

/// Text on the trust of an axis; empty if not known.
[[nodiscard]] std::string trust_line(const ControlAxis& axis);

/// Offsets of every axis in whole counts, for LinuxCNC.
void count_in_whole_numbers(ControlPlan& plan);

/// Interval between two calls required by the equations of a plan [s]; NaN without equations.
[[nodiscard]] double sampling_of(const ControlPlan& plan);

/// Indices of the inputs used by an axis, increasing.
[[nodiscard]] std::vector<std::size_t> used_inputs(const ControlPlan& plan,
                                                   const ControlAxis& axis);

}  // namespace raceway::control
