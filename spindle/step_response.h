#pragma once

#include <span>
#include <string>
#include <vector>

#include "spindle/power_laws.h"
#include "spindle/spindle.h"
#include "spindle/step_fit.h"

namespace raceway::spindle {

/// Input that steps: the speed of a spindle at rest, or a load at the nose of one that turns.
enum class Stepped { speed, axial_load, radial_load };

/// Response of a spindle at rest to one speed, or one power, from t = 0 on; or of a spindle that
/// has settled at a speed to a load. Displacements of a load are those beyond the settled ones.
struct StepResponse {
  Stepped stepped = Stepped::speed;
  double load = unset;           ///< that steps [N]; NaN: the speed steps
  std::string load_case = {};    ///< of one that was read; empty of one that was simulated
  double speed = unset;          ///< [rad/s]; NaN: only its power is known
  double power_start = unset;    ///< loss of all bearings at t = 0 [W]
  double power_end = unset;      ///< at the end: the power of K(P) and T(P) [W]
  double kinematic = unset;      ///< displacement that is there at once [m]
  double end = unset;            ///< displacement at the end less the kinematic one [m]
  double front_force = unset;    ///< of the cold set at that speed [N]
  double highest_force = unset;  ///< of the front set in between [N]
  StepFit fit = {};              ///< of the displacement less the kinematic one
  Status status = Status::not_run;
  std::string message = {};  ///< why there is no fit
  /// Data of the fit: time since the step [s], displacement less the kinematic part [m].
  std::vector<double> time = {}, displacement = {};
  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// Back to rest from the end of the fastest step. NaN where it was not asked for or did not end
/// well.
struct CoolDown {
  StepFit fit = {};  ///< of the way back
  /// Time constants at P = 0 with the gains of that step [s]: of its one lag, of its two.
  double one = unset, fast = unset, slow = unset;
  [[nodiscard]] bool known() const { return one > 0.0; }
};

/// Steps of a load at one speed, each from the settled spindle.
struct LoadSteps {
  Stepped stepped = Stepped::axial_load;
  double speed = unset;                  ///< [rad/s]
  std::vector<StepResponse> steps = {};  ///< by load, rising
  double unloaded = unset;               ///< time constant after the largest load has gone [s]
};

struct StepResponses {
  std::vector<StepResponse> steps = {};  ///< in the order asked for
  CoolDown cool_down = {};
  std::vector<LoadSteps> loads = {};  ///< axial loads first, by speed
};

struct StepOptions {
  double duration = 4 * 3600.0;                  ///< of each step [s]
  double row = 120.0;                            ///< between rows of the fit [s]
  Inputs inputs = {};                            ///< all but the speed
  bool cool_down = true;                         ///< one for as long, after the fastest step
  const std::atomic<bool>* cancelled = nullptr;  ///< as Simulator::stop_on()
};

/// Simulates a step to each of these speeds [rad/s] from rest at the ambient temperature, side by
/// side and with the effects of the model, and fits lags to them.
///
/// The power is not constant in a step: it may fall by half as the oil thins. That at the end goes
/// with gain and time constant.
/// Throws std::invalid_argument for a model that is no spindle, speeds that are not above 0, less
/// than three rows. A step that did not converge has a status and no fit.
[[nodiscard]] StepResponses step_responses(const model::Model& model,
                                           std::span<const double> speeds,
                                           const StepOptions& options = {});

/// Simulates steps of a load [N] at each of these speeds [rad/s]. A step begins from the settled
/// spindle without the load. One lag is fitted to what follows the displacement at once. The power
/// in a response is the power of all bearings, not what the load adds.
///
/// Throws std::invalid_argument as step_responses(), and for loads of 0 or that do not rise.
[[nodiscard]] std::vector<LoadSteps> load_step_responses(const model::Model& model, Stepped stepped,
                                                         std::span<const double> speeds,
                                                         std::span<const double> loads,
                                                         const StepOptions& options = {});

/// Gain and time constant of each step of a load that has them, over the load.
[[nodiscard]] std::vector<LagAt> at_loads(const LoadSteps& loads);

/// Gain and time constant of each step that has them, at its power at the end: of one lag, or of
/// the faster or the slower of two.
enum class WhichLag { one, fast, slow };
[[nodiscard]] std::vector<LagAt> at_powers(std::span<const StepResponse> steps,
                                           WhichLag which = WhichLag::one);

/// Returns true if one lag does not fit one of the steps, and all of them have two.
[[nodiscard]] bool need_two(std::span<const StepResponse> steps);

}  // namespace raceway::spindle
