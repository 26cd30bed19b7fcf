#pragma once

#include <span>
#include <string>
#include <vector>

#include "spindle/power_laws.h"
#include "spindle/spindle.h"
#include "spindle/step_fit.h"

namespace raceway::spindle {

/// Response of a spindle at rest to one speed, or one power, from t = 0 on.
struct StepResponse {
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

struct StepResponses {
  std::vector<StepResponse> steps = {};  ///< in the order asked for
  CoolDown cool_down = {};
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

/// Gain and time constant of each step that has them, at its power at the end: of one lag, or of
/// the faster or the slower of two.
enum class WhichLag { one, fast, slow };
[[nodiscard]] std::vector<AtPower> at_powers(std::span<const StepResponse> steps,
                                             WhichLag which = WhichLag::one);

/// Returns true if one lag does not fit one of the steps, and all of them have two.
[[nodiscard]] bool need_two(std::span<const StepResponse> steps);

}  // namespace raceway::spindle
