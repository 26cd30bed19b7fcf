#include "fit/thinned.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

namespace raceway::fit {

std::vector<std::size_t> thinned(std::vector<std::size_t> rows, std::size_t most) {
  if (rows.size() <= most) return rows;
  boost::random::mt19937 engine(20210305);
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < most; ++k) {
    const std::size_t begin = k * rows.size() / most, end = (k + 1) * rows.size() / most;
    boost::random::uniform_int_distribution<std::size_t> any(begin, end - 1);
    chosen.push_back(rows[any(engine)]);
  }
  return chosen;
}

}  // namespace raceway::fit
