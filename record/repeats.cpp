#include "record/repeats.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <string_view>

namespace raceway::record {
namespace {

bool near(double a, double b, double relative, double absolute) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b)) + absolute;
}

/// The inputs of a record, those of one kind with a common size: a radial load of 0.01 N beside
/// 1000 N of axial load is none.
class Points {
 public:
  explicit Points(const Record& record) : part_(record.values(part)) {
    std::map<std::string_view, std::size_t> kinds;
    for (const Column& c : record.columns) {
      if (!c.channel->is_input()) continue;
      const std::string_view kind = c.channel->kind.empty() ? c.channel->name : c.channel->kind;
      kinds.try_emplace(kind, kinds.size());
      inputs_.push_back({&c, kinds.at(kind)});
    }
    kinds_ = kinds.size();
    const auto sweeps = std::find_if(inputs_.begin(), inputs_.end(),
                                     [](const Input& i) { return i.column->channel->ratio; });
    if (sweeps != inputs_.end()) order_ = sweeps->column;
  }

  /// What rows are sorted by; nothing where no input is on a ratio scale.
  [[nodiscard]] double key(std::size_t row) const {
    const double value = order_ ? order_->values[row] : 0.0;
    return std::isnan(value) ? 0.0 : value;
  }

  [[nodiscard]] bool alike(std::size_t a, std::size_t b, const SamePoint& same) const {
    if (!part_.empty() && part_[a] != part_[b]) return false;
    std::vector<double> largest(kinds_, 0.0);
    for (const Input& i : inputs_)
      for (const std::size_t row : {a, b})
        largest[i.kind] = std::fmax(largest[i.kind], std::abs(i.column->values[row]));
    return std::all_of(inputs_.begin(), inputs_.end(), [&](const Input& i) {
      return near(i.column->values[a], i.column->values[b], 0.0,
                  i.column->channel->ratio ? same.relative * largest[i.kind] : same.temperature);
    });
  }

 private:
  struct Input {
    const Column* column;
    std::size_t kind;
  };
  std::span<const double> part_;
  std::vector<Input> inputs_;
  std::size_t kinds_ = 0;
  const Column* order_ = nullptr;
};

}  // namespace

std::vector<RepeatGroup> find_repeats(const Record& record, const SamePoint& same,
                                      std::span<const std::size_t> rows) {
  std::vector<std::size_t> order(rows.begin(), rows.end());
  if (rows.empty()) {
    order.resize(record.rows());
    std::iota(order.begin(), order.end(), std::size_t{0});
  }
  const Points points(record);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return points.key(a) < points.key(b); });
  // Each row joins the first group whose first row it equals; only groups of nearly its key count.
  std::vector<RepeatGroup> groups;
  std::size_t oldest = 0;
  for (const std::size_t i : order) {
    while (oldest < groups.size() &&
           !near(points.key(groups[oldest].front()), points.key(i), same.relative, 0.0))
      ++oldest;
    std::size_t g = oldest;
    while (g < groups.size() && !points.alike(groups[g].front(), i, same)) ++g;
    if (g == groups.size())
      groups.push_back({i});
    else
      groups[g].push_back(i);
  }
  std::erase_if(groups, [](const RepeatGroup& g) { return g.size() < 2; });
  return groups;
}

}  // namespace raceway::record
