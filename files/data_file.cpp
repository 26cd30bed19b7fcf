#include "files/data_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "files/detail/column_reader.h"
#include "files/detail/data_columns.h"
#include "files/detail/impossible_cells.h"
#include "files/detail/kept_columns.h"
#include "files/subject.h"
#include "rig/coast_down.h"
#include "rig/fall_times.h"
#include "rig/torque_sensor.h"
#include "rig/unknown_inertia.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Record;
using record::Role;

std::string names_of(const std::vector<const Channel*>& channels) {
  std::vector<std::string> names;
  for (const Channel* c : channels) names.emplace_back(c->name);
  return text::listed(names) + (names.size() == 1 ? " is" : " are");
}

class Reader {
 public:
  Reader(text::CsvTable table, const model::ModelSubject& subject, const ReadOptions& options)
      : table_(std::move(table)),
        subject_(subject),
        expected_(subject.expected()),
        sensor_(options.sensor),
        date_order_(options.columns.date_order),
        columns_(find_columns(table_, subject, expected_, options)),
        dropped_{options.drop_nan ? drop_empty_rows(table_, used_columns()) : std::string(),
                 drop_impossible_rows(table_, columns_that_count())},
        kept_(kept_columns(table_, columns_.others)),
        cells_(table_),
        notes_(columns_.notes) {
    append(notes_,
           notes_of(record::note::unused, kept_.statements(!options.columns.rules.empty()), {}));
    for (const std::string& line : dropped_)
      if (!line.empty()) notes_.push_back(record::note::left_out(line, {.file = table_.source}));
  }

  Record read() {
    for (const DataColumns::Place& place : columns_.places) {
      if (place.channel->role == Role::run)
        values(*place.channel) = cells_.named(place, runs_);
      else if (cells_.is_stamped(place))
        values(*place.channel) = cells_.times(place, date_order_);
      else if (columns_.signal && *place.channel == record::friction_torque)
        values(*place.channel) = numbers(*columns_.signal, *place.channel);
      else
        values(*place.channel) = numbers(place, *place.channel);
    }
    if (columns_.signal_deviation)
      values(record::torque_deviation) =
          numbers(*columns_.signal_deviation, record::torque_deviation);
    if (!columns_.falls.empty()) read_falls();
    cells_.check_decimal_marks();
    note_form();
    fill_in();
    if (!falls_.empty()) return torque_of_falls();
    if (columns_.coast_down()) {
      const Record samples = coast_down();
      return torque(
          [&](const model::Rig& of) { return rig::coast_down_torque(samples, of).record; });
    }
    cells_.bad.throw_if_any();
    if (columns_.signal) make_torques();
    note_what_is_left_out();
    return record();
  }

 private:
  /// By row [SI]; empty where there is no such column and no default.
  std::vector<double>& values(const Channel& channel) {
    return values_[static_cast<std::size_t>(
        std::find(record::channels.begin(), record::channels.end(), channel) -
        record::channels.begin())];
  }
  [[nodiscard]] bool has(const Channel& channel) const { return columns_.find(channel); }
  [[nodiscard]] std::string cell(const DataColumns::Place& place, std::size_t row) const {
    return table_.shown(row, place.column);
  }

  /// Beside other sensors one need not have read; then nothing is known of its scatter either.
  [[nodiscard]] bool may_be_empty(const Channel& channel, std::size_t row) const {
    if (!columns_.keeps(channel)) return true;  // measured, but not what the model predicts
    if (columns_.measured.size() < 2) return false;
    if (channel.role != Role::deviation) return channel.role == Role::measured;
    return table_.is_empty(row, columns_.find(*record::find_channel(channel.of))->column);
  }

  /// Of a column that stands for channel `c`.
  std::vector<double> numbers(const DataColumns::Place& place, const Channel& c) {
    const auto& below_zero = expected_.signed_inputs;
    const bool with_sign = std::any_of(below_zero.begin(), below_zero.end(),
                                       [&](const Channel* s) { return *s == c; });
    return cells_.numbers(place, with_sign, [&](std::size_t row) { return may_be_empty(c, row); });
  }

  /// Signals of the torque sensor, and their deviations, become torques.
  void make_torques() {
    std::vector<int> lines;
    for (std::size_t row = 0; row < table_.rows(); ++row) lines.push_back(table_.line(row));
    rig::SensedTorques sensed = rig::sensed_torques(*sensor_, values(record::friction_torque),
                                                    values(record::torque_deviation), lines);
    values(record::friction_torque) = std::move(sensed.torque);
    values(record::torque_deviation) = std::move(sensed.std);
    notes_.insert(notes_.end(), sensed.notes.begin(), sensed.notes.end());
  }

  /// Columns whose cells count.
  [[nodiscard]] std::vector<ColumnSource> used_columns() const {
    std::vector<ColumnSource> used = columns_.falls;
    if (columns_.signal_deviation) used.push_back(*columns_.signal_deviation);
    for (const DataColumns::Place& place : columns_.places)
      if (columns_.keeps(*place.channel) && !is_unused(*place.channel)) used.push_back(place);
    return used;
  }

  /// The same without which a row has no meaning: of several measured columns one need not have
  /// been read.
  [[nodiscard]] std::vector<ColumnSource> columns_that_count() const {
    std::vector<ColumnSource> list = used_columns();
    if (columns_.measured.size() > 1)
      std::erase_if(list, [](const auto& c) { return c.channel->role == Role::measured; });
    return list;
  }

  /// How the file is written comes first, then what was said of its columns.
  void note_form() {
    const std::vector<record::Note> form = cells_.notes_on_form();
    notes_.insert(notes_.begin(), form.begin(), form.end());
  }

  void fill_in() {
    for (const Recognised::Constant& c : columns_.constants) {
      if (c.channel->role == Role::time || c.channel->role == Role::run) continue;
      std::vector<double>& column = values(*c.channel);
      column.assign(table_.rows(), c.value);
      notes_.push_back(record::note::filled_in(
          fmt::format("{}: {:.6g} {} for all rows, from {}", c.channel->name,
                      c.channel->in_unit(c.value), c.channel->unit, c.from),
          {.key = std::string(c.channel->name)}));
    }
    for (const model::Expected::Partner& p : expected_.partners)
      if (has(*p.partner) && !has(*p.channel) && !columns_.constant(*p.channel))
        notes_.push_back(
            record::note::filled_in(fmt::format("no column {}: {}", p.channel->name, p.from),
                                    {.key = std::string(p.channel->name)}));
    for (const model::Expected::Default& d : expected_.defaults) {
      if (has(*d.channel) || !values(*d.channel).empty()) continue;
      values(*d.channel).assign(table_.rows(), d.value);
      notes_.push_back(record::note::filled_in(
          fmt::format("no column {}: {:.6g} {} for all rows, from {}", d.channel->name,
                      d.channel->in_unit(d.value), d.channel->unit, d.from),
          {.key = std::string(d.channel->name)}));
    }
  }

  void note_what_is_left_out() {
    if (!columns_.unused.empty()) {
      const std::size_t count = columns_.measured.size() + columns_.unused.size();
      notes_.push_back(record::note::unused(fmt::format(
          "{} measured columns: {} used, {} not used", count == 2 ? "two" : std::to_string(count),
          names_of(columns_.measured), names_of(columns_.unused))));
    }
    for (const auto& [channel, words] : expected_.unused)
      if (has(*channel))
        notes_.push_back(record::note::unused(words, {.key = std::string(channel->name)}));
    if (!has(record::time)) return;
    const std::vector<double>& time = values(record::time);
    std::unordered_map<double, double> last_time;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      const auto [last, is_new] = last_time.emplace(run_of(row), time[row]);
      if (!is_new && time[row] < last->second) {
        notes_.push_back(record::note::read_as(
            fmt::format("time_s goes back at line {}; the rows are used in the order of the file",
                        table_.line(row)),
            {.file = table_.source, .line = table_.line(row), .key = "time_s"}));
        return;
      }
      last->second = time[row];
    }
  }

  [[nodiscard]] double run_of(std::size_t row) {
    return has(record::run) ? values(record::run)[row] : 0.0;
  }

  /// A column of the file that the model has no use for takes no part in anything.
  [[nodiscard]] bool is_unused(const Channel& channel) const {
    return has(channel) && std::any_of(expected_.unused.begin(), expected_.unused.end(),
                                       [&](const auto& u) { return *u.first == channel; });
  }

  /// Columns in the order of the table of channels.
  Record record() {
    Record result{.source = table_.source,
                  .columns = {},
                  .runs = std::move(runs_),
                  .lines = {},
                  .notes = std::move(notes_)};
    for (const Channel& channel : record::channels)
      if (!values(channel).empty() && columns_.keeps(channel) && !is_unused(channel))
        result.set(channel, std::move(values(channel)));
    for (record::Column& column : kept_.columns) result.columns.push_back(std::move(column));
    for (std::size_t row = 0; row < table_.rows(); ++row) result.lines.push_back(table_.line(row));
    return result;
  }

  /// Time and speed, without slow rows; time does not go back within a run.
  Record coast_down() {
    if (!has(record::run)) {
      runs_.emplace_back("1");
      values(record::run).assign(table_.rows(), 0.0);
      notes_.push_back(record::note::filled_in("no column run_id: all rows are read as one run",
                                               {.key = "run_id"}));
    }
    std::vector<double> last_time(runs_.size(), -std::numeric_limits<double>::infinity());
    std::vector<std::size_t> fast;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      double& last = last_time[static_cast<std::size_t>(values(record::run)[row])];
      const double now = values(record::time)[row];
      if (now < last)
        cells_.bad.add(table_.line(row), record::time.name, cell(*columns_.find(record::time), row),
                       "must not go back within a run");
      if (!std::isnan(now)) last = now;
      if (!(values(record::speed)[row] < expected_.minimum_speed)) fast.push_back(row);
    }
    cells_.bad.throw_if_any();
    const double minimum = record::speed.in_unit(expected_.minimum_speed);
    if (fast.empty())
      throw text::InputError(fmt::format("{}: all {} rows have a speed below minimum_speed_rpm = "
                                         "{:.6g} of [rig], so no row can be used",
                                         table_.source, table_.rows(), minimum),
                             {.file = table_.source, .key = std::string(record::speed.name)});
    if (fast.size() < table_.rows())
      notes_.push_back(record::note::left_out(fmt::format(
          "{} of {} rows have a speed below minimum_speed_rpm = {:.6g} and are not used",
          table_.rows() - fast.size(), table_.rows(), minimum)));
    return record().picked(fast);
  }

  /// Falls by row, and the middle of their speeds as the speed.
  void read_falls() {
    falls_.resize(table_.rows());
    for (const DataColumns::Place& place : columns_.falls) {
      const std::vector<double> list = numbers(place, *place.channel);
      for (std::size_t row = 0; row < list.size(); ++row)
        (*place.channel == speed_from  ? falls_[row].from
         : *place.channel == speed_to  ? falls_[row].to
         : *place.channel == fall_time ? falls_[row].time
                                       : falls_[row].time_deviation) = list[row];
    }
    for (std::size_t row = 0; row < falls_.size(); ++row) {
      const rig::Fall& f = falls_[row];
      values(record::speed).push_back(0.5 * (f.from + f.to));
      if (f.to >= f.from)
        cells_.bad.add(
            table_.line(row), speed_to.name, cell(columns_.falls[1], row),
            fmt::format("must be below speed_from_rpm = {} rpm", cell(columns_.falls[0], row)));
    }
  }

  /// Without falls to slow speeds.
  Record torque_of_falls() {
    cells_.bad.throw_if_any();
    std::vector<std::size_t> fast;
    std::vector<rig::Fall> falls;
    for (std::size_t row = 0; row < falls_.size(); ++row)
      if (!(falls_[row].to < expected_.minimum_speed)) {
        fast.push_back(row);
        falls.push_back(falls_[row]);
      }
    const double minimum = record::speed.in_unit(expected_.minimum_speed);
    if (fast.empty())
      throw text::InputError(fmt::format("{}: no fall of the speed ends above minimum_speed_rpm = "
                                         "{:.6g} of [rig], so no row can be used",
                                         table_.source, minimum),
                             {.file = table_.source, .key = std::string(record::speed.name)});
    if (fast.size() < table_.rows())
      notes_.push_back(record::note::left_out(fmt::format(
          "{} of {} falls of the speed end below minimum_speed_rpm = {:.6g} and are not used",
          table_.rows() - fast.size(), table_.rows(), minimum)));
    const Record what = record().picked(fast);
    return torque([&](const model::Rig& of) { return rig::fall_torque(what, falls, of); });
  }

  /// `of` makes torques with the inertia of a rig.
  template <typename Of>
  [[nodiscard]] Record torque(const Of& of) const {
    try {
      model::Rig assumed = subject_.model().rig;
      if (!assumed.unknown_inertia) return of(assumed);
      assumed.inertia = 1.0;
      const Record unit = of(assumed);
      assumed.inertia = rig::matching_inertia(*make_subject(subject_.model(), unit), unit);
      Record result = of(assumed);
      result.notes.push_back(record::note::assumed(
          fmt::format("inertia_kgm2 = \"unknown\": the program assumes {:.4g} kg m2, so that the "
                      "mean measured torque equals the mean torque of the unfitted model. Torques, "
                      "f0, z and all values in N mm have an unknown common factor; the record "
                      "determines only the shape of the torque curve",
                      assumed.inertia),
          {.key = "inertia_kgm2"}));
      result.up_to_a_factor = true;
      return result;
    } catch (const std::invalid_argument& e) {
      const std::string message = e.what();
      throw text::InputError(
          message.starts_with(table_.source) ? message : table_.source + ": " + message,
          {.file = table_.source});
    }
  }

  text::CsvTable table_;
  const model::ModelSubject& subject_;
  model::Expected expected_;
  std::optional<rig::TorqueSensor> sensor_;
  std::optional<text::DateOrder> date_order_;
  DataColumns columns_;
  std::array<std::string, 2> dropped_;  // what is said of rows without a number
  KeptColumns kept_;
  ColumnReader cells_;
  std::array<std::vector<double>, record::channels.size()> values_;  // [SI]
  std::vector<rig::Fall> falls_;  // by row; empty but in a file of times between two speeds
  std::vector<std::string> runs_;
  std::vector<record::Note> notes_;
};

}  // namespace

Record read_record(const Source& source, const model::ModelSubject& subject,
                   const ReadOptions& options) {
  return Reader(read_measurements(source, options), subject, options).read();
}

}  // namespace raceway::files
