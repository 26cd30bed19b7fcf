#pragma once

#include <span>
#include <string>
#include <vector>

#include "spindle/power_laws.h"
#include "spindle/spindle.h"
#include "spindle/step_fit.h"

namespace raceway::spindle {

/// Input that changes in a step: the speed of a spindle at rest, or a load at the nose of a
/// rotating spindle.
enum class Stepped { speed, axial_load, radial_load };

/// Response of a spindle at rest to a step of speed or power at t = 0, or response of a settled,
/// rotating spindle to a load. Displacements from a load are relative to the settled displacement.
struct StepResponse {
  Stepped stepped = Stepped::speed;
  double load = unset;           ///< load after the step [N]; NaN: the speed steps
  std::string load_case = {};    ///< name of an imported load case; empty if simulated
  double speed = unset;          ///< [rad/s]; NaN: only the power is known
  double power_start = unset;    ///< friction loss of all bearings at t = 0 [W]
  double power_end = unset;      ///< friction loss at the end, the power of K(P) and T(P) [W]
  double kinematic = unset;      ///< immediate displacement [m]
  double end = unset;            ///< displacement at the end minus the kinematic part [m]
  double front_force = unset;    ///< force of the front set at t = 0 [N]
  double highest_force = unset;  ///< largest force of the front set during the step [N]
  StepFit fit = {};              ///< fit to the displacement minus the kinematic part
  Status status = Status::not_run;
  std::string message = {};  ///< reason if there is no fit
  /// Data of the fit: time since the step [s], displacement minus the kinematic part [m].
  std::vector<double> time = {}, displacement = {};
  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// Cooling at rest after the end of the fastest step. Values are NaN if the cooling was not
/// requested or did not converge.
struct CoolDown {
  StepFit fit = {};  ///< fit to the cooling
  /// Time constants at P = 0 for the gains of the step before the cooling [s]: for the single lag,
  /// and for the two lags.
  double one = unset, fast = unset, slow = unset;
  [[nodiscard]] bool known() const { return one > 0.0; }
};

/// Steps of a load at one speed, each starting from the settled spindle.
struct LoadSteps {
  Stepped stepped = Stepped::axial_load;
  double speed = unset;                  ///< [rad/s]
  std::vector<StepResponse> steps = {};  ///< steps by rising load
  double unloaded = unset;               ///< time constant after removal of the largest load [s]
};

struct StepResponses {
  std::vector<StepResponse> steps = {};  ///< in the order of the request
  CoolDown cool_down = {};
  std::vector<LoadSteps> loads = {};  ///< axial loads first, by speed
};

struct StepOptions {
  double duration = 4 * 3600.0;  ///< duration of each step [s]
  /// Interval between rows of a response [s]. Load steps use a quarter of this interval.
  double row = 120.0;
  Inputs inputs = {};     ///< all inputs except the speed
  bool cool_down = true;  ///< true adds a cooling of equal length after the fastest step
  const std::atomic<bool>* cancelled = nullptr;  ///< true ends the work with fit::Cancelled
};

/// Simulates a step to each of these speeds [rad/s] from rest at ambient temperature, in parallel
/// and with the effects of the model, and fits one lag and two lags to each response.
///
/// The power is not constant during a step: it may fall by half as the oil gets thinner. Gain and
/// time constant are assigned to the power at the end of the step. Throws std::invalid_argument for
/// a model that is not a spindle, for speeds that are not above 0, and for fewer than three rows. A
/// step that did not converge has a status but no fit.
[[nodiscard]] StepResponses step_responses(const model::Model& model,
                                           std::span<const double> speeds,
                                           const StepOptions& options = {});

/// Simulates load steps [N] at each of these speeds [rad/s]. Each step starts from the settled
/// spindle without the load. One lag is fitted to the displacement after the immediate part. The
/// power in a response is the total power of all bearings, not the increase by the load.
///
/// Throws std::invalid_argument like step_responses(), and for loads that are 0 or not in ascending
/// order.
[[nodiscard]] std::vector<LoadSteps> load_step_responses(const model::Model& model, Stepped stepped,
                                                         std::span<const double> speeds,
                                                         std::span<const double> loads,
                                                         const StepOptions& options = {});

/// Returns the load, the gain and the time constant of each load step that has a fit.
[[nodiscard]] std::vector<LagAt> at_loads(const LoadSteps& loads);

/// The single lag of a fit, or the faster or the slower of two lags.
enum class WhichLag { one, fast, slow };
/// Returns the final power, the gain and the time constant of each step with a fit.
[[nodiscard]] std::vector<LagAt> at_powers(std::span<const StepResponse> steps,
                                           WhichLag which = WhichLag::one);

/// Returns true if one lag is not enough for at least one step, and two lags were found for all
/// converged steps.
[[nodiscard]] bool need_two(std::span<const StepResponse> steps);

}  // namespace raceway::spindle
