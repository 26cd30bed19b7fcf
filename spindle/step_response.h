#pragma once

#include <span>
#include <string>
#include <vector>

#include "spindle/power_laws.h"
#include "spindle/spindle.h"
#include "spindle/step_fit.h"

namespace raceway::spindle {

/// Input of a step response: the speed of a spindle at rest, or a load at the nose of a rotating
/// spindle.
enum class Stepped { speed, axial_load, radial_load };

/// Response of a spindle to a step at t = 0. A speed step starts from rest, as does a step of the
/// friction loss in an imported load case. A load step starts from the steady state of a rotating
/// spindle, and the displacements are relative to the steady state without the load.
struct StepResponse {
  Stepped stepped = Stepped::speed;
  double load = unset;         ///< load after the step [N]; NaN: step of speed or power
  std::string load_case = {};  ///< name of an imported load case; empty if simulated
  double speed = unset;        ///< speed [rad/s]; NaN: only the power is known
  double power_start = unset;  ///< friction loss of all bearings at t = 0 [W]
  /// Friction loss of all bearings at the end [W]: the power P in the laws for gain K(P) and time
  /// constant T(P).
  double power_end = unset;
  double kinematic = unset;      ///< displacement that follows the step without delay [m]
  double end = unset;            ///< displacement at the end minus `kinematic` [m]
  double front_force = unset;    ///< axial force of the front set at t = 0 [N]
  double highest_force = unset;  ///< largest axial force of the front set during the step [N]
  StepFit fit = {};              ///< fit of lags to `displacement`
  Status status = Status::not_run;
  std::string message = {};  ///< reason if the simulation did not converge
  /// Rows of the fit: time since the step [s], and displacement minus `kinematic` [m].
  std::vector<double> time = {}, displacement = {};
  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// Cooling at standstill after the end of the fastest speed step. Values are NaN if the cooling was
/// not requested, or if step or cooling did not converge.
struct CoolDown {
  StepFit fit = {};  ///< fit to the decrease of the displacement since the end of the step
  /// Time constants of the cooling [s], fitted with the gains of the preceding step. They are the
  /// time constants at the friction loss 0 W. `one` belongs to the fit with one lag, `fast` and
  /// `slow` belong to the fit with two lags, and are NaN if the step has no such fit.
  double one = unset, fast = unset, slow = unset;
  [[nodiscard]] bool known() const { return one > 0.0; }
};

/// Load steps at one speed. Each step starts from the steady state without the load.
struct LoadSteps {
  Stepped stepped = Stepped::axial_load;
  double speed = unset;                  ///< [rad/s]
  std::vector<StepResponse> steps = {};  ///< in ascending order of load
  /// Time constant after removal of the load with the largest absolute value [s]; NaN if its load
  /// step or the removal did not converge.
  double unloaded = unset;
};

struct StepResponses {
  std::vector<StepResponse> steps = {};  ///< in the order of the given speeds
  CoolDown cool_down = {};
  std::vector<LoadSteps> loads = {};  ///< axial loads, then radial loads; each by speed
};

struct StepOptions {
  double duration = 4 * 3600.0;  ///< duration of each step [s]
  /// Interval between rows of a speed step [s]. Load steps use a quarter of this interval.
  double row = 120.0;
  Inputs inputs = {};     ///< all inputs except speed and stepped load
  bool cool_down = true;  ///< true: simulate cooling of the same duration after the fastest step
  /// Flag of the caller; null: none. If the flag is true, the functions throw fit::Cancelled.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Simulates a step from rest at ambient temperature to each of these speeds [rad/s], with the
/// effects of the model. Fits one lag and two lags to each response. The speeds are simulated in
/// parallel.
///
/// The friction loss is not constant during a step: it may fall by half as the oil becomes thinner.
/// Gain and time constant are assigned to the friction loss at the end of the step. Throws
/// std::invalid_argument for a model that is not a spindle, for speeds that are not above 0, and
/// for a duration shorter than three intervals between rows. A step that did not converge has only
/// a speed, a status and a message.
[[nodiscard]] StepResponses step_responses(const model::Model& model,
                                           std::span<const double> speeds,
                                           const StepOptions& options = {});

/// Simulates load steps [N] at each of these speeds [rad/s]. Each step starts from the steady state
/// without the load. The lags are fitted to the displacement minus the immediate displacement at
/// t = 0. `power_start` and `power_end` of a response are the total friction loss of all bearings,
/// not only its increase by the load.
///
/// Throws std::invalid_argument like step_responses(), and for loads that are 0 or not in ascending
/// order.
[[nodiscard]] std::vector<LoadSteps> load_step_responses(const model::Model& model, Stepped stepped,
                                                         std::span<const double> speeds,
                                                         std::span<const double> loads,
                                                         const StepOptions& options = {});

/// Returns the load, and gain and time constant of the single lag, for each converged load step.
[[nodiscard]] std::vector<LagAt> at_loads(const LoadSteps& loads);

/// Lag of a StepFit: the single lag, or the faster or the slower of two lags.
enum class WhichLag { one, fast, slow };
/// Returns the friction loss at the end, the gain and the time constant of a lag, for each
/// converged step that has this lag.
[[nodiscard]] std::vector<LagAt> at_powers(std::span<const StepResponse> steps,
                                           WhichLag which = WhichLag::one);

/// Returns true if `two_needed` is true for at least one converged step, and all converged steps
/// have a fit with two lags.
[[nodiscard]] bool need_two(std::span<const StepResponse> steps);

}  // namespace raceway::spindle
