#include "spindle/spindle.h"

namespace raceway::spindle {

std::string_view name(Status status) {
  switch (status) {
    case Status::converged:
      return "converged";
    case Status::no_equilibrium:
      return "no_equilibrium";
    case Status::thermal_runaway:
      return "thermal_runaway";
    case Status::step_limit:
      return "step_limit";
    case Status::not_run:
      break;
  }
  return "not_run";
}

std::string_view words(Status status) {
  switch (status) {
    case Status::converged:
      return "converged";
    case Status::no_equilibrium:
      return "the bearing sets have no equilibrium; heat, speed or a load can remove the preload "
             "of rigidly mounted sets";
    case Status::thermal_runaway:
      return "thermal runaway: the friction heat grows faster than heat can leave (heat raises the "
             "preload of rigidly mounted sets and closes the clearance of roller bearings)";
    case Status::step_limit:
      return "the maximum number of time steps was reached";
    case Status::not_run:
      break;
  }
  return "not run";
}

}  // namespace raceway::spindle
