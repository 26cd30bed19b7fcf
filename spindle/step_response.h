#pragma once

#include <span>
#include <string>
#include <vector>

#include "spindle/power_laws.h"
#include "spindle/spindle.h"
#include "spindle/step_fit.h"

namespace raceway::spindle {

/// Input that changes in a step: the speed of a spindle that was at rest, or a load at the nose of
/// a rotating spindle.
enum class Stepped { speed, axial_load, radial_load };

/// Response of a spindle to a step at t = 0. A speed step starts from rest. A load case that was
/// imported from a file is a step of the friction loss, which also starts from rest. A load step
/// starts from the steady state of a rotating spindle, and the displacements are relative to the
/// steady state without the load.
struct StepResponse {
  Stepped stepped = Stepped::speed;
  double load = unset;         ///< load after the step [N]; NaN for a step of speed or power
  std::string load_case = {};  ///< name of a load case from a file; empty for a simulation
  double speed = unset;        ///< speed [rad/s]; NaN if only the power is known
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

/// Cooling at standstill after the end of the fastest speed step. All values are NaN if the cooling
/// was not requested, or if the simulation of step or cooling did not converge.
struct CoolDown {
  StepFit fit = {};  ///< fit to the decrease of the displacement during the cooling
  /// Time constants of the cooling [s], fitted with the gains of the preceding step. These time
  /// constants apply to the friction loss 0 W. `one` belongs to the fit with one lag. `fast` and
  /// `slow` belong to the fit with two lags, and are NaN if the step has no fit with two lags.
  double one = unset, fast = unset, slow = unset;
  [[nodiscard]] bool known() const { return one > 0.0; }
};

/// Load steps at one speed. Each step starts from the steady state without the load.
struct LoadSteps {
  Stepped stepped = Stepped::axial_load;
  double speed = unset;                  ///< [rad/s]
  std::vector<StepResponse> steps = {};  ///< sorted by load, ascending
  /// Time constant of the displacement after removal of the load with the largest magnitude [s];
  /// NaN if this load step or the removal did not converge.
  double unloaded = unset;
};

struct StepResponses {
  std::vector<StepResponse> steps = {};  ///< speed steps, in the order of the given speeds
  CoolDown cool_down = {};
  /// Steps of axial loads, then steps of radial loads, each in the order of the speeds.
  std::vector<LoadSteps> loads = {};
};

struct StepOptions {
  double duration = 4 * 3600.0;  ///< duration of each step [s]
  /// Interval between rows of a speed step [s]. Load steps use a quarter of this interval.
  double row = 120.0;
  Inputs inputs = {};     ///< all inputs except speed and stepped load
  bool cool_down = true;  ///< true: after the fastest step, the spindle cools for `duration`
  /// Flag that cancels the work; null if not used. If the flag becomes true, the functions throw
  /// fit::Cancelled.
  const std::atomic<bool>* cancelled = nullptr;
};

/// Simulates a step from rest at ambient temperature to each of these speeds [rad/s], with the
/// effects of the model. Fits one lag and two lags to each response. The speeds are simulated in
/// parallel.
///
/// The friction loss may fall by half during a step, because the warm oil is thinner. at_powers()
/// assigns the fitted gain and time constant to the friction loss at the end of the step. Throws
/// std::invalid_argument for a model that is not a spindle, for speeds that are not above 0, and
/// for a duration shorter than three intervals between rows. If a step did not converge, only
/// speed, status and message of the response are set.
[[nodiscard]] StepResponses step_responses(const model::Model& model,
                                           std::span<const double> speeds,
                                           const StepOptions& options = {});

/// Simulates load steps [N] at each of these speeds [rad/s]. Each step starts from the steady state
/// without the load. The lags are fitted to the displacement minus the immediate displacement at t
/// = 0. `power_start` and `power_end` of a response are the total friction loss of all bearings,
/// not only the increase caused by the load.
///
/// Throws std::invalid_argument like step_responses(), and for loads that are 0 or not in ascending
/// order.
[[nodiscard]] std::vector<LoadSteps> load_step_responses(const model::Model& model, Stepped stepped,
                                                         std::span<const double> speeds,
                                                         std::span<const double> loads,
                                                         const StepOptions& options = {});

/// Returns load, gain and time constant for each converged load step. Gain and time constant are
/// from the fit with one lag.
[[nodiscard]] std::vector<LagAt> at_loads(const LoadSteps& loads);

/// Lag of a StepFit: the single lag, or the faster or the slower of two lags.
enum class WhichLag { one, fast, slow };
/// Returns the friction loss at the end of the step, and gain and time constant of the lag `which`,
/// for each converged step with this lag.
[[nodiscard]] std::vector<LagAt> at_powers(std::span<const StepResponse> steps,
                                           WhichLag which = WhichLag::one);

/// Returns true if a model of these steps needs two lags: StepFit::two_needed is true for at least
/// one converged step, and all converged steps have a fit with two lags.
[[nodiscard]] bool need_two(std::span<const StepResponse> steps);

}  // namespace raceway::spindle
