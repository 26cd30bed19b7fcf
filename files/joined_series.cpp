#include "files/detail/joined_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "record/median.h"
#include "record/series_channel.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Record;
using record::Role;

/// Several files of one record, each with a clock of its own, on one clock.
class SeriesOfFiles {
 public:
  explicit SeriesOfFiles(const std::vector<SeriesPart>& parts) {
    for (const SeriesPart& part : parts) {
      parts_.push_back(part.record);
      clocks_.push_back(part.clock);
    }
  }

  Record read() {
    find_starts();
    find_times();
    Record result{.source = parts_.front().source, .settings_hold = parts_.front().settings_hold};
    result.set(record::time, times_);
    for (std::size_t k = 0; k < parts_.size(); ++k) add(parts_[k], result);
    hold_into_runs(result);
    for (Record& part : parts_)
      for (record::Note& one : part.notes) {
        one.text.insert(0, part.source + ": ");
        result.notes.push_back(std::move(one));
      }
    result.notes.push_back(
        record::note::read_as(fmt::format("{} are joined into one record of {} rows{}",
                                          text::listed(names()), result.rows(), clock_words()),
                              {.file = result.source}));
    return in_common(std::move(result));
  }

 private:
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> list;
    for (const Record& part : parts_) list.push_back(part.source);
    return list;
  }

  [[nodiscard]] std::string clock_words() const {
    return clocks_.front() ? ""
                           : "; the program assumes that time_s has the same start in all files";
  }

  /// All times count from the first row of the first file.
  void find_starts() {
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const std::span<const double> time = parts_[k].values(record::time);
      if (std::adjacent_find(time.begin(), time.end(), std::greater_equal()) != time.end())
        throw text::InputError(
            fmt::format("{}: the time does not increase from run to run, so other files cannot be "
                        "joined; sort the runs, and give dates or times that increase through all "
                        "runs",
                        parts_[k].source),
            {.file = parts_[k].source, .key = "time_s"});
      const auto &first = clocks_.front(), &own = clocks_[k];
      if (first.has_value() != own.has_value() || (first && first->kind != own->kind))
        throw text::InputError(
            fmt::format(
                "the times of {} and {} cannot be joined, because one has {} and the other has {}",
                parts_.front().source, parts_[k].source, words(first), words(own)),
            {.file = parts_[k].source, .key = "time_s"});
      for (std::size_t other = 0; first && other < k; ++other) require_one_clock(other, k);
    }
    for (std::size_t k = 0; k < parts_.size(); ++k)
      if (clocks_[k])
        for (double& t : parts_[k].find(record::time)->values) t += begin_of(k) - begin_of(0);
  }

  /// The first time of a file on a clock without the changes that other files saw before it.
  [[nodiscard]] double begin_of(std::size_t k) const {
    constexpr double hour = 3600.0;
    const double begin = clocks_[k]->begin;
    std::vector<ColumnReader::ClockChange> before;
    for (const auto& clock : clocks_)
      for (const ColumnReader::ClockChange& c : clock->changes)
        if (c.time < begin && std::none_of(before.begin(), before.end(),
                                           [&](const auto& other) { return is_same(c, other); }))
          before.push_back(c);
    double without = begin;
    for (const ColumnReader::ClockChange& c : before) without += c.forward ? -hour : hour;
    return without;
  }

  static bool is_same(const ColumnReader::ClockChange& a, const ColumnReader::ClockChange& b) {
    constexpr double day = 86400.0;
    return a.forward == b.forward && std::abs(a.time - b.time) < day;
  }

  /// Throws InputError where dates of one file have an offset from UTC and those of the other have
  /// none, or where the clock of one file changes to or from summer time and the clock of the other
  /// shows no such change.
  void require_one_clock(std::size_t a, std::size_t b) const {
    const ColumnReader::ClockStart &one = *clocks_[a], &other = *clocks_[b];
    const auto refuse = [&](const std::string& problem, std::size_t file, int line) {
      throw text::InputError(
          fmt::format("{}, so the files cannot be joined. Give the dates of all files with their "
                      "offset from UTC, such as 2024-10-27T02:30:00+01:00, or all in standard time",
                      problem),
          {.file = parts_[file].source, .line = line, .key = "time_s"});
    };
    if (one.has_zone != other.has_zone)
      refuse(fmt::format("the dates of {} have an offset from UTC, and the dates of {} have none",
                         parts_[one.has_zone ? a : b].source, parts_[one.has_zone ? b : a].source),
             one.has_zone ? b : a, 0);
    for (const auto& [changing, still] : {std::pair(a, b), std::pair(b, a)})
      for (const ColumnReader::ClockChange& c : clocks_[changing]->changes) {
        const ColumnReader::ClockStart& start = *clocks_[still];
        const double last = start.begin + parts_[still].values(record::time).back();
        const bool covers = start.begin < c.time && last > c.time;
        const bool agrees =
            std::any_of(start.changes.begin(), start.changes.end(),
                        [&](const ColumnReader::ClockChange& s) { return is_same(s, c); });
        if (covers && !agrees)
          refuse(fmt::format("{}:{}: the clock goes {} by one hour, and {} shows no such change",
                             parts_[changing].source, c.line, c.forward ? "forward" : "back",
                             parts_[still].source),
                 changing, c.line);
      }
  }

  static std::string words(const std::optional<ColumnReader::ClockStart>& start) {
    return !start                                          ? "seconds"
           : start->kind == ColumnReader::ClockKind::dates ? "dates"
                                                           : "times of day";
  }

  void find_times() {
    for (const Record& part : parts_) {
      const std::span<const double> time = part.values(record::time);
      times_.insert(times_.end(), time.begin(), time.end());
    }
    std::sort(times_.begin(), times_.end());
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
  }

  void add(const Record& part, Record& result) const {
    const std::span<const double> time = part.values(record::time);
    for (const record::Column& column : part.columns) {
      const Channel& c = *column.channel;
      if (c == record::time) continue;
      if (result.has(c)) {
        if (c.role == Role::kept) continue;
        throw text::InputError(
            fmt::format(
                "{}: column {} is also in another of the joined files; keep it in one file only",
                part.source, c.name),
            {.file = part.source, .key = std::string(c.name)});
      }
      if (c.role == Role::run) {
        if (c == record::run) result.runs = part.runs;
        result.set(c, until_next(column.values, time));
        continue;
      }
      std::vector<double> values(times_.size(), unset);
      for (std::size_t row = 0; row < time.size(); ++row)
        values[static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), time[row]) -
                                        times_.begin())] = column.values[row];
      result.set(c, std::move(values));
    }
  }

  /// A setting of another file than the runs does not end with a run.
  static void hold_into_runs(Record& result) {
    for (record::Column& c : result.columns) {
      if (!c.channel->is_input() || record::course_of(*c.channel) != record::Course::held) continue;
      double last = unset;
      for (std::size_t row = 0; row < c.values.size(); ++row) {
        const bool begins = row > 0 && result.run_of(row) != result.run_of(row - 1);
        if (begins && std::isnan(c.values[row])) c.values[row] = last;
        if (!std::isnan(c.values[row])) last = c.values[row];
      }
    }
  }

  /// A run lasts until the first row of the next one.
  [[nodiscard]] std::vector<double> until_next(const std::vector<double>& values,
                                               std::span<const double> time) const {
    std::vector<double> all;
    std::size_t row = 0;
    for (const double t : times_) {
      while (row + 1 < time.size() && time[row + 1] <= t) ++row;
      all.push_back(values[row]);
    }
    return all;
  }

  /// True for a log with a row for every change of what a control sets: what its last row says
  /// holds on. A log that samples has even rows, most of them as the one before, and ends with its
  /// last.
  [[nodiscard]] bool is_log_of_changes(const Record& part) const {
    constexpr double much_longer = 10.0, uneven = 2.0, most = 0.9;
    if (part.settings_hold == record::SettingsHold::until_row) return false;
    const std::span<const double> time = part.values(record::time);
    std::vector<bool> changes(time.size());
    for (const record::Column& c : part.columns) {
      const Role role = c.channel->role;
      if (role == Role::time || role == Role::run || role == Role::kept) continue;
      if (!c.channel->is_input() || !record::acts_by_amount(*c.channel)) return false;
      double last = unset;
      for (std::size_t row = 0; row < time.size(); ++row) {
        if (std::isnan(c.values[row])) continue;
        changes[row] = changes[row] || c.values[row] != last;
        last = c.values[row];
      }
    }
    const auto count = static_cast<double>(std::count(changes.begin(), changes.end(), true));
    // The last row may say that the log ended.
    if (count < most * static_cast<double>(time.size() - 1)) return false;
    const auto steps_of = [](std::span<const double> times) {
      std::vector<double> steps;
      for (std::size_t row = 1; row < times.size(); ++row)
        steps.push_back(times[row] - times[row - 1]);
      return steps;
    };
    const std::vector<double> steps = steps_of(time);
    if (steps.size() < 2) return true;
    const double usual = record::median(steps);
    return *std::max_element(steps.begin(), steps.end()) > uneven * usual ||
           usual > much_longer * record::median(steps_of(times_));
  }

  /// Without the ends at which a file with inputs has no rows.
  [[nodiscard]] Record in_common(Record record) const {
    double begin = times_.front(), end = times_.back();
    for (const Record& part : parts_) {
      if (std::none_of(part.columns.begin(), part.columns.end(),
                       [](const record::Column& c) { return c.channel->is_input(); }))
        continue;
      begin = std::max(begin, part.values(record::time).front());
      const double last = part.values(record::time).back();
      if (last < times_.back() && is_log_of_changes(part))
        record.notes.push_back(record::note::filled_in(
            fmt::format("{} has one row for each change of a setting: its last row, at "
                        "{:.6g} s, applies until the end of the record",
                        part.source, last),
            {.file = part.source, .key = "time_s"}));
      else
        end = std::min(end, last);
    }
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < times_.size(); ++row)
      if (times_[row] >= begin && times_[row] <= end) rows.push_back(row);
    if (rows.empty())
      throw text::InputError(fmt::format("{} have no time in common, so they cannot be joined; "
                                         "check their dates and units of time",
                                         text::listed(names())),
                             {.file = record.source, .key = "time_s"});
    if (rows.size() == record.rows()) return record;
    record.notes.push_back(record::note::left_out(
        fmt::format(
            "{} rows before {:.6g} s or after {:.6g} s are not used, because one of the joined "
            "files does not cover this time",
            record.rows() - rows.size(), begin, end),
        {.file = record.source}));
    return record.picked(rows);
  }

  std::vector<Record> parts_;
  std::vector<std::optional<ColumnReader::ClockStart>> clocks_;
  std::vector<double> times_;
};

}  // namespace

Record joined_series(const std::vector<SeriesPart>& parts) { return SeriesOfFiles(parts).read(); }

}  // namespace raceway::files
