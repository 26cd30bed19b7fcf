#pragma once

#include <cstddef>
#include <vector>

namespace raceway::fit {

/// Returns all `rows` if there are at most `most`. Otherwise, returns one random row from each of
/// `most` sections with nearly equal numbers of rows. The rows cover the whole record without a
/// fixed period. Equal arguments give equal results.
[[nodiscard]] std::vector<std::size_t> thinned(std::vector<std::size_t> rows, std::size_t most);

}  // namespace raceway::fit
