#pragma once

#include <string_view>

namespace raceway::fit {

enum class FitStatus {
  not_run,
  converged,
  iteration_limit,
  failed,         ///< the fit stopped without reaching a minimum
  nothing_to_fit  ///< no parameter is free, or the fit keeps every parameter at its start value
};

/// Returns the status as the JSON results state it, for example "iteration_limit".
[[nodiscard]] constexpr std::string_view name(FitStatus status) {
  switch (status) {
    case FitStatus::not_run:
      return "not_run";
    case FitStatus::converged:
      return "converged";
    case FitStatus::iteration_limit:
      return "iteration_limit";
    case FitStatus::failed:
      return "failed";
    case FitStatus::nothing_to_fit:
      return "nothing_to_fit";
  }
  return "unknown";
}

}  // namespace raceway::fit
