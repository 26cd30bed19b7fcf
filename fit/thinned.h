#pragma once

#include <cstddef>
#include <vector>

namespace raceway::fit {

/// At most `most` of these rows, one at random from each of as many equal stretches: spread over
/// the time of a record, and in step with nothing that repeats in it. The same choice each time.
[[nodiscard]] std::vector<std::size_t> thinned(std::vector<std::size_t> rows, std::size_t most);

}  // namespace raceway::fit
