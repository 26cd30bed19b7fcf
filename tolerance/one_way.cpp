#include "tolerance/one_way.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace raceway::tolerance {
namespace {

constexpr double hardly_longer = 1.3;     // length of the way over its span
constexpr std::size_t parts_of_way = 60;  // of the record, so that noise adds little to the way

}  // namespace

bool goes_one_way(const fit::Means& means, std::size_t channel) {
  std::vector<double> list;
  for (const fit::Means::Mean& mean : means.list)
    if (mean.channel == channel) list.push_back(mean.measured);
  if (list.empty()) return true;
  std::vector<double> smooth;
  for (std::size_t k = 0; k < parts_of_way; ++k) {
    const std::size_t begin = k * list.size() / parts_of_way,
                      end = (k + 1) * list.size() / parts_of_way;
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) sum += list[i];
    if (end > begin) smooth.push_back(sum / static_cast<double>(end - begin));
  }
  double way = 0.0;
  for (std::size_t k = 1; k < smooth.size(); ++k) way += std::abs(smooth[k] - smooth[k - 1]);
  const auto [low, high] = std::minmax_element(smooth.begin(), smooth.end());
  return way < hardly_longer * (*high - *low);
}

}  // namespace raceway::tolerance
