#include "session/law_statement.h"

#include <fmt/core.h>

#include "text/number_text.h"

namespace raceway::session {

using text::number;

using shaft::KinematicLawVerdict;

std::string law_statement(const shaft::KinematicLawFit& f, const std::string& table) {
  const std::string tolerance = fmt::format("{:.4g} um (the error of this law in its publication)",
                                            shaft::kinematic_law_tolerance / um);
  const std::string share =
      fmt::format("{:.4g} % of the largest displacement", 100.0 * shaft::kinematic_law_share);
  if (f.verdict == KinematicLawVerdict::follows)
    return fmt::format(
        "The law follows the curve: its mean absolute error is within both {} and {}.", tolerance,
        share);
  const std::string& limit = f.mae > shaft::kinematic_law_tolerance ? tolerance : share;
  if (f.verdict == KinematicLawVerdict::scatter)
    return fmt::format(
        "The mean absolute error is above {}, but the residual changes randomly from row to row: "
        "the rows scatter by {} um, and the law fits within this scatter.",
        limit, number(f.scatter / um, 2));
  return fmt::format(
      "The law does not follow the curve: its mean absolute error is above {}, and the residual is "
      "smooth, so three parameters cannot describe this curve. Use the monotone table instead "
      "({}).",
      limit, table);
}

}  // namespace raceway::session
