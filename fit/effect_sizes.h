#pragma once

#include <string>
#include <vector>

#include "fit/attribution.h"
#include "fit/diagnose.h"
#include "fit/evidence.h"
#include "fit/hold_out.h"

/// What a fitted explanation says in numbers.
namespace raceway::fit {

/// Numbers of one member of an explanation, in the unit of the files. A size is plausible within
/// three times the range met in practice, give or take two standard errors.
[[nodiscard]] std::vector<EffectSize> sizes_of(const Problem& problem, const Explanation& e,
                                               std::size_t member);

/// Whether the sizes of all members are.
[[nodiscard]] bool sizes_plausible(const Problem& problem, const Explanation& e);

/// Sizes of all members: "c = 3.1 +- 0.2 um".
[[nodiscard]] std::string size_text(const Problem& problem, const Explanation& e);

/// 95 % interval of the size of one member. A bent law has none: its exponents are no physics.
[[nodiscard]] Interval size_interval(const Evidence& evidence, const Explanation& e,
                                     std::size_t member);

/// Base parameters without and with the explanation.
[[nodiscard]] std::vector<BaseShift> base_shifts(const Evidence& evidence, const Explanation& e);

/// Root mean square error over the blocks that the fit did not see, in all blockings, SI; NaN for a
/// bent law and without blockings.
[[nodiscard]] double cross_validated(const Evidence& evidence, const Explanation& e,
                                     const std::vector<Blocking>& blockings);

}  // namespace raceway::fit
