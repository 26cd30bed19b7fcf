#pragma once

#include <cstddef>
#include <vector>

namespace raceway::fit {

/// Returns all `rows` if their number is at most `most`. Otherwise, divides the rows into `most`
/// sections with nearly equal numbers of rows, and returns one random row from each section. The
/// chosen rows cover the whole record without a fixed period. Equal arguments give equal results.
[[nodiscard]] std::vector<std::size_t> thinned(std::vector<std::size_t> rows, std::size_t most);

}  // namespace raceway::fit
