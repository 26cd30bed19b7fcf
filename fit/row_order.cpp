#include "fit/row_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "fit/dwells.h"
#include "record/levels.h"
#include "record/median.h"

namespace raceway::fit {

namespace {

constexpr std::size_t fewest_blocks = 3, shortest_block = 4;
constexpr double a_pause = 3.0;  // of the usual time between rows
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Where blocks of rows begin in which a setting goes one way, as in a run-up, and starts again;
/// nothing where blocks are as short as chance makes them.
std::vector<bool> blocks_of(const record::Column& column, std::span<const std::size_t> rows) {
  std::vector<double> values;
  for (const std::size_t row : rows) values.push_back(column.values[row]);
  const double step = record::step_of(*column.channel, values);
  std::vector<bool> begins(rows.size(), false);
  std::size_t blocks = 1;
  double direction = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double change = values[i] - values[i - 1];
    if (!(std::abs(change) > step)) continue;
    if (change * direction < 0.0) {
      begins[i] = true;
      ++blocks;
      direction = 0.0;
    } else {
      direction = change;
    }
  }
  begins[0] = true;
  if (blocks < fewest_blocks || rows.size() < shortest_block * blocks) begins.clear();
  return begins;
}

/// True if a rig may have been set up anew before each block. A clock shows the time that this
/// took.
bool may_be_set_up_anew(const Record& record, std::span<const std::size_t> rows,
                        const std::vector<bool>& begins) {
  if (!record.complete(record::time)) return true;
  std::vector<double> within, between;
  for (std::size_t i = 1; i < rows.size(); ++i)
    (begins[i] ? between : within)
        .push_back(record.value(record::time, rows[i]) - record.value(record::time, rows[i - 1]));
  return record::median(between) > a_pause * record::median(within);
}

/// True if some load is constant in each block and differs between all blocks.
bool has_own_levels(const Record& record, std::span<const std::size_t> rows,
                    const std::vector<bool>& begins) {
  for (const record::Column& column : record.columns) {
    if (column.channel->role != record::Role::setting || column.channel->kind != "load") continue;
    const double step = record::step_of(*column.channel, column.values);
    std::vector<double> levels;
    bool stays = true;
    for (std::size_t i = 0; i < rows.size() && stays; ++i) {
      const double value = column.values[rows[i]];
      if (begins[i]) levels.push_back(value);
      stays = std::abs(value - levels.back()) <= step;
    }
    std::sort(levels.begin(), levels.end());
    const auto alike = [&](double a, double b) { return b - a <= step; };
    if (stays && std::adjacent_find(levels.begin(), levels.end(), alike) == levels.end())
      return true;
  }
  return false;
}

/// Blocks that look like runs nobody declared. Of several settings the one with most blocks;
/// temperature, which follows the others and jitters, only where no other setting has any.
void find_blocks(const Record& record, std::span<const std::size_t> rows, RowOrder& order) {
  if (rows.empty()) return;
  std::ptrdiff_t most = 0;
  bool first = true;
  for (const bool follows : {false, true})
    for (const record::Column& column : record.columns) {
      if (column.channel->role != record::Role::setting || column.channel->ratio == follows)
        continue;
      std::vector<bool> begins = blocks_of(column, rows);
      const auto count = std::count(begins.begin(), begins.end(), true);
      const bool swept = std::exchange(first, false);
      if (count <= most || (follows && !order.new_block.empty())) continue;
      most = count;
      order.new_block = std::move(begins);
      order.own_levels = swept && may_be_set_up_anew(record, rows, order.new_block) &&
                         has_own_levels(record, rows, order.new_block);
    }
}

/// True where a run begins before one that began earlier has ended.
bool runs_overlap(const Record& record) {
  std::map<int, std::pair<double, double>> span;
  for (std::size_t i = 0; i < record.rows(); ++i) {
    const double t = record.value(record::time, i);
    auto [it, fresh] = span.try_emplace(record.run_of(i), t, t);
    it->second.first = std::min(it->second.first, t);
    it->second.second = std::max(it->second.second, t);
  }
  std::vector<std::pair<double, double>> spans;
  for (const auto& [run, s] : span) spans.push_back(s);
  std::sort(spans.begin(), spans.end());
  for (std::size_t k = 1; k < spans.size(); ++k)
    if (spans[k].first < spans[k - 1].second) return true;
  return false;
}

}  // namespace

std::vector<std::size_t> order_of_rows(const Record& record) {
  const bool timed = record.complete(record::time);
  const bool by_run = record.has(record::run) && (!timed || runs_overlap(record));
  std::vector<std::span<const double>> keys;
  if (record.has(record::part)) keys.push_back(record.values(record::part));
  if (by_run) keys.push_back(record.values(record::run));
  if (timed) keys.push_back(record.values(record::time));
  for (const record::Role role : {record::Role::setting, record::Role::measured})
    for (const record::Column& c : record.columns)
      if (c.channel->role == role) keys.emplace_back(c.values);
  std::vector<std::size_t> order(record.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Without clock and runs the file may still show how the rig was driven.
  if (!timed && !record.has(record::run) && record.parts.empty()) {
    RowOrder as_written;
    find_blocks(record, order, as_written);
    if (as_written.own_levels) return order;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    for (const std::span<const double> key : keys) {
      const double x = std::isnan(key[a]) ? -unlimited : key[a];
      const double y = std::isnan(key[b]) ? -unlimited : key[b];
      if (x != y) return x < y;
    }
    return false;
  });
  return order;
}

std::string nested_settings(const Record& record, bool each_in_one_run) {
  std::string words;
  for (const record::Column& column : record.columns) {
    if (column.channel->role != record::Role::setting || !record.varies(*column.channel)) continue;
    const double step = record::step_of(*column.channel, column.values);
    std::map<int, std::pair<double, double>> range;
    for (std::size_t i = 0; i < record.rows(); ++i) {
      const auto [at, is_new] =
          range.try_emplace(record.run_of(i), column.values[i], column.values[i]);
      at->second.first = std::min(at->second.first, column.values[i]);
      at->second.second = std::max(at->second.second, column.values[i]);
    }
    const bool constant = std::all_of(range.begin(), range.end(), [&](const auto& run) {
      return run.second.second - run.second.first <= step;
    });
    if (each_in_one_run) {
      std::set<long long> levels;
      for (const auto& [run, ends] : range) levels.insert(std::llround(ends.first / step));
      if (levels.size() < range.size()) continue;
    }
    if (range.size() > 1 && constant)
      words += (words.empty() ? "" : " and ") + std::string(column.channel->words);
  }
  return words;
}

RowOrder row_order(const Record& record, std::span<const std::size_t> rows) {
  RowOrder order;
  order.has_time = !rows.empty();
  std::vector<double> steps;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double now = record.value(record::time, rows[i]);
    const bool first = i == 0 || record.part_of(rows[i]) != record.part_of(rows[i - 1]);
    const double before = first ? unset : record.value(record::time, rows[i - 1]);
    const double step = now - before;
    if (!std::isfinite(now)) order.has_time = false;
    // A step back: the clock of another run.
    order.step.push_back(first || step < 0.0 || !std::isfinite(step) ? unlimited : step);
    order.new_run.push_back(first || record.run_of(rows[i]) != record.run_of(rows[i - 1]));
    if (std::isfinite(order.step.back()) && step > 0.0) steps.push_back(step);
    const double state = record.value(dwell_state, rows[i]);
    order.new_state.push_back(first || !(state == record.value(dwell_state, rows[i - 1])));
    order.has_states = order.has_states || !order.new_state.back();
    // Records that were joined are no runs by themselves: what differs between them is their own.
    order.has_runs = order.has_runs || (!first && order.new_run.back());
  }
  if (steps.empty()) order.has_time = false;
  const double middle = order.has_time ? record::median(steps) : 1.0;
  order.median_step = middle;
  if (!order.has_runs && !record.has(record::run)) find_blocks(record, rows, order);
  for (double& step : order.step) step = order.has_time ? std::max(step / middle, 0.05) : unlimited;
  return order;
}

RowOrder order_of(const RowOrder& all, const std::vector<Eigen::Index>& some) {
  if (some.size() == all.step.size()) return all;
  RowOrder order = all;
  order.step.clear();
  order.new_run.clear();
  order.new_state.clear();
  order.new_block.clear();
  for (std::size_t k = 0; k < some.size(); ++k) {
    const auto i = static_cast<std::size_t>(some[k]);
    const bool joined = k > 0 && some[k] == some[k - 1] + 1;
    order.step.push_back(joined ? all.step[i] : unlimited);
    order.new_run.push_back(!joined || all.new_run[i]);
    order.new_state.push_back(!joined || all.new_state[i]);
    if (!all.new_block.empty()) order.new_block.push_back(!joined || all.new_block[i]);
  }
  return order;
}

}  // namespace raceway::fit
