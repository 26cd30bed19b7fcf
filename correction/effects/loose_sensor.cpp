#include "correction/effects/loose_sensor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <span>
#include <string>

#include "correction/leaps.h"
#include "correction/simulation.h"
#include "record/series_channel.h"

namespace raceway::correction {
namespace {

constexpr double most_seen = 0.9;        // share of the rise: above it nothing came loose
constexpr double told_by_share = 0.15;   // below it the rise is no longer in the reading
constexpr double two_ends_apart = 0.15;  // by which the shares at both ends may differ
// Of a reading above the room [K]: both sensors may be a last digit of 0.1 K off, and the air at
// the sensor differs from the mean of the room.
constexpr double error_of_rise = 0.3;
constexpr Leap faint{.size = 0.25, .of_beside = 3.0};  // more than two last digits of 0.1 K
constexpr std::size_t most_ends = 6;                   // that are tried where none shows
constexpr double hour = 3600.0;

/// The rows in which a sensor was loose, and which share of the rise it saw at both ends [1].
struct Loose {
  std::size_t begin = 0, end = 0;
  double seen = unset, until = unset;
};

/// True for a sensor on a body. One that measures the room hangs in the air already.
bool can_come_loose(const Channel* column) {
  return record::is_temperature(*column) && !record::is_ambient(*column);
}

class Sensor {
 public:
  Sensor(const Series& series, const Channel& column)
      : record_(series.record()),
        time_(record_.values(record::time)),
        read_(record_.values(column)),
        leaps_(leaping_rows(record_, column)),
        faint_leaps_(leaping_rows(record_, column, faint)),
        room_(read_.size()) {
    std::vector<std::span<const double>> ambient;
    for (const record::Column& c : record_.columns)
      if (record::is_ambient(*c.channel) && c.channel != &column) ambient.emplace_back(c.values);
    const double coldest = *std::min_element(
        read_.begin(), read_.end(), [](double a, double b) { return a < b || std::isnan(b); });
    for (std::size_t k = 0; k < read_.size(); ++k) {
      double sum = 0.0;
      for (const std::span<const double> a : ambient) sum += a[k];
      room_[k] = ambient.empty() ? coldest : sum / static_cast<double>(ambient.size());
    }
  }

  /// The first time that it came loose. An end that no clear leap shows lies at a faint one with
  /// the same share, or where the sensor was as cold as the room: each such time, the nearest
  /// first, and the end of the record.
  [[nodiscard]] std::vector<Loose> loose() const {
    for (auto leap = leaps_.begin(); leap != leaps_.end(); ++leap) {
      const double seen = rise(*leap) / rise(*leap - 1);
      std::vector<Loose> list;
      if (is_share(seen)) {
        const auto back = std::find_if(std::next(leap), leaps_.end(), [&](std::size_t row) {
          return std::abs(rise(row - 1) / rise(row) - seen) < two_ends_apart;
        });
        if (back != leaps_.end()) return {between(*leap, *back)};
        for (const std::size_t end : ends_after(*leap, seen))
          list.push_back({*leap, end, seen, seen});
      } else if (is_share(1.0 / seen)) {
        for (const std::size_t begin : begins_before(*leap, 1.0 / seen))
          list.push_back({begin, *leap, 1.0 / seen, 1.0 / seen});
      }
      if (!list.empty()) return list;
    }
    return {};
  }

  /// As it would have read where it was loose.
  [[nodiscard]] std::vector<double> mended(const Loose& l) const {
    std::vector<double> values(read_.begin(), read_.end());
    const double from = time_[l.begin], to = time_[l.end - 1];
    const bool by_share = std::min(l.seen, l.until) >= told_by_share;
    const double before = read_[l.begin - 1], after = l.end < read_.size() ? read_[l.end] : before;
    for (std::size_t k = l.begin; k < l.end; ++k) {
      const double way = to > from ? (time_[k] - from) / (to - from) : 0.0;
      values[k] = by_share ? room_[k] + rise(k) / std::lerp(l.seen, l.until, way)
                           : std::lerp(before, after, way);
    }
    return values;
  }

  [[nodiscard]] std::string words(const Loose& l) const {
    return fmt::format(
        "from {:.3g} h to {} the sensor showed {:.0f} % of the temperature rise above the "
        "room temperature",
        time_[l.begin] / hour,
        l.end < read_.size() ? fmt::format("{:.3g} h", time_[l.end] / hour)
                             : std::string("the end of the record"),
        50.0 * (l.seen + l.until));
  }

 private:
  [[nodiscard]] static bool is_share(double share) { return share >= 0.0 && share < most_seen; }
  [[nodiscard]] double rise(std::size_t row) const { return read_[row] - room_[row]; }
  /// True where the rise is so small that a sensor could come loose, or return, without a leap.
  [[nodiscard]] bool is_cold(std::size_t row, double seen) const {
    return std::abs(rise(row)) * (1.0 - seen) <
           seen_leap_of_a_sensor * std::max(seen, told_by_share);
  }
  /// Loose between two leaps. The share at the smaller rise is the less certain one: where its
  /// error explains the difference, both ends have the share that fits them best.
  [[nodiscard]] Loose between(std::size_t begin, std::size_t end) const {
    const double before = rise(begin - 1), after = rise(end);
    const double seen = rise(begin) / before, until = rise(end - 1) / after;
    if (std::abs(seen - until) * std::min(std::abs(before), std::abs(after)) > error_of_rise)
      return {begin, end, seen, until};
    const double both =
        (rise(begin) * before + rise(end - 1) * after) / (before * before + after * after);
    return {begin, end, both, both};
  }
  /// True where the rises of a row and of its loose neighbour have this share.
  [[nodiscard]] bool fits(std::size_t tight, std::size_t loose, double seen) const {
    return std::abs(seen * rise(tight) - rise(loose)) < error_of_rise;
  }
  /// Rows after a leap at which the sensor may have returned: faint leaps, the first row of each
  /// cold stretch, and the end.
  [[nodiscard]] std::vector<std::size_t> ends_after(std::size_t row, double seen) const {
    std::vector<std::size_t> list;
    for (const std::size_t k : faint_leaps_)
      if (k > row && list.size() < most_ends && fits(k, k - 1, seen)) list.push_back(k);
    for (bool was = false; row < read_.size() && list.size() < most_ends; ++row) {
      const bool is = is_cold(row, seen);
      if (is && !was) list.push_back(row);
      was = is;
    }
    if (list.size() < most_ends) list.push_back(read_.size());
    return list;
  }
  /// Rows before a leap at which the sensor may have come loose: faint leaps, the row behind each
  /// cold stretch, and the second of all.
  [[nodiscard]] std::vector<std::size_t> begins_before(std::size_t row, double seen) const {
    std::vector<std::size_t> list;
    for (auto k = faint_leaps_.rbegin(); k != faint_leaps_.rend(); ++k)
      if (*k < row && list.size() < most_ends && fits(*k - 1, *k, seen)) list.push_back(*k);
    for (bool was = false; row > 1 && list.size() < most_ends; --row) {
      const bool is = is_cold(row - 1, seen);
      if (is && !was) list.push_back(row);
      was = is;
    }
    if (list.size() < most_ends) list.push_back(1);
    return list;
  }

  const record::Record& record_;
  std::span<const double> time_, read_;
  std::vector<std::size_t> leaps_, faint_leaps_;
  std::vector<double> room_;
};

}  // namespace

std::vector<Effect> LooseSensor::possible(const Surroundings& in) const {
  const std::vector<const Channel*> used = inputs_of(in.model);
  if (std::none_of(used.begin(), used.end(), can_come_loose)) return {};
  return {at()};
}

std::vector<fit::Fault> LooseSensor::faults(const FittedRecord& in) const {
  const record::Record& record = in.series.record();
  const bool one_clock = record.runs.size() < 2 && record.parts.empty();
  std::vector<fit::Fault> list;
  for (const Channel* const column : inputs_of(in.model)) {
    if (!one_clock || !can_come_loose(column)) continue;
    const Sensor sensor(in.series, *column);
    for (const Loose& loose : sensor.loose()) {
      auto without = std::make_shared<record::Record>(record);
      without->find(*column)->values = sensor.mended(loose);
      list.push_back({.id = std::string(loose_card.id),
                      .certain = false,
                      .datum = fmt::format("the sensor of {}", column->name),
                      .correction = sensor.words(loose),
                      .without = std::move(without)});
    }
  }
  return list;
}

}  // namespace raceway::correction
