#pragma once

#include <cstddef>
#include <vector>

namespace raceway::fit {

/// Returns at most `most` of these rows: one random row from each of `most` sections with equal
/// numbers of rows. The rows cover the whole record without a fixed period. The choice is the same
/// for each call.
[[nodiscard]] std::vector<std::size_t> thinned(std::vector<std::size_t> rows, std::size_t most);

}  // namespace raceway::fit
