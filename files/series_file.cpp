#include "files/series_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/detail/column_reader.h"
#include "files/detail/filled_inputs.h"
#include "record/median.h"
#include "record/series_channel.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Record;
using record::Role;
using Channels = std::vector<const Channel*>;

text::Place place_in_header(const text::CsvTable& table, std::string_view column) {
  return {table.source, table.header_line, std::string(column)};
}

class SeriesReader {
 public:
  SeriesReader(text::CsvTable table, const Channels& wanted, const Channels& needed,
               const ReadOptions& options)
      : table_(std::move(table)),
        wanted_(wanted),
        found_(recognise(table_, options.columns, true, options.of_spindle)),
        of_spindle_(options.of_spindle),
        date_order_(options.columns.date_order),
        settings_hold_(options.columns.settings_hold.value_or(
            options.of_spindle ? record::SettingsHold::until_row : record::SettingsHold::sampled)),
        dropped_(options.drop_nan ? drop_empty_rows(table_, inputs()) : std::string()),
        cells_(table_) {
    require(record::time);
    for (const Channel* c : needed) require(*c);
    name_the_others(options.columns);
  }

  Record read() {
    Record result{.source = table_.source, .settings_hold = settings_hold_};
    for (const ColumnSource& source : found_.columns) {
      const Channel& c = *source.channel;
      if (c.role == Role::measured && !is_wanted(c)) {
        refuse_misspelt(c);
        unused_.emplace_back(c.name);
        continue;
      }
      std::vector<std::string> names;
      if (c.role == Role::run) {
        result.set(c, cells_.named(source, c == record::run ? result.runs : names));
      } else if (cells_.is_stamped(source)) {
        result.set(c, cells_.times(source, date_order_));
      } else {
        // A control tells the direction; heat does not know it.
        const bool with_sign =
            c == record::speed || c == record::axial_load || c == record::radial_load;
        result.set(c,
                   cells_.numbers(source, with_sign, [&](std::size_t) { return may_be_empty(c); }));
      }
    }
    cells_.check_decimal_marks();
    for (const Recognised::Constant& constant : found_.constants) set_constant(constant, result);
    for (std::size_t row = 0; row < table_.rows(); ++row) result.lines.push_back(table_.line(row));
    check_time(result);
    cells_.bad.throw_if_any();
    for (const ColumnSource& source : found_.columns)
      if (may_be_empty(*source.channel) && source.channel->role != Role::measured)
        if (std::string note = fill_input(*source.channel, result, cells_.bad); !note.empty())
          filled_.push_back(std::move(note));
    cells_.bad.throw_if_any();
    take_offsets_off(result);
    result.notes = notes(result);
    return result;
  }

 private:
  [[nodiscard]] bool is_wanted(const Channel& channel) const {
    return wanted_.empty() || std::any_of(wanted_.begin(), wanted_.end(),
                                          [&](const Channel* w) { return *w == channel; });
  }

  /// Readings need not have been taken in every row, and inputs are filled between theirs.
  static bool may_be_empty(const Channel& c) {
    return c.role == Role::measured || c.role == Role::setting || c.role == Role::recorded;
  }

  [[nodiscard]] std::vector<ColumnSource> inputs() const {
    std::vector<ColumnSource> list;
    for (const ColumnSource& source : found_.columns)
      if (source.channel->role != Role::measured) list.push_back(source);
    return list;
  }

  void require(const Channel& channel) const {
    if (found_.find(channel)) return;
    for (const Recognised::Constant& c : found_.constants)
      if (*c.channel == channel) return;
    std::vector<std::string> others = found_.others;
    for (const ColumnSource& source : found_.columns) others.push_back(source.name);
    throw text::InputError(
        fmt::format("{}:{}: column {} is missing{}; the header has {}", table_.source,
                    table_.header_line, channel.name, text::suggestion(channel.name, others),
                    text::listed(table_.header)),
        place_in_header(table_, channel.name));
  }

  /// Subtracts the offsets that a control added: the displacements are then those of the machine.
  void take_offsets_off(Record& result) {
    std::vector<std::string> lone;
    for (const record::Column& offset : result.columns) {
      if (offset.channel->kind != record::offset_kind) continue;
      const std::string of =
          "displacement" + std::string(offset.channel->variable.substr(6)) + "_um";
      record::Column* const read = result.find(*record::series_channel(of));
      if (!read) {
        if (!found_.find(*record::series_channel(of))) lone.emplace_back(offset.channel->name);
        continue;
      }
      for (std::size_t row = 0; row < read->values.size(); ++row)
        read->values[row] -= offset.values[row];
      without_.push_back(fmt::format("{1}, which the control added, is subtracted from {0}", of,
                                     offset.channel->name));
    }
    if (!lone.empty())
      lone_ = fmt::format("{}: the record has no displacement of that name", text::listed(lone));
    std::erase_if(result.columns,
                  [](const record::Column& c) { return c.channel->kind == record::offset_kind; });
  }

  /// A sensor that the model has under a name much like it, and the file not at all.
  void refuse_misspelt(const Channel& channel) const {
    if (!of_spindle_) return;
    std::vector<std::string> lacking;
    for (const Channel* c : wanted_)
      if (!found_.find(*c)) lacking.emplace_back(c->name);
    if (const auto near = text::nearest_name(channel.name, lacking))
      throw text::InputError(
          fmt::format("{}:{}: column {} is no sensor of the model; did you mean {}?", table_.source,
                      table_.header_line, channel.name, *near),
          place_in_header(table_, channel.name));
  }

  void name_the_others(const ColumnMap& map) {
    std::vector<std::string> known{"time_s", "speed_rpm", "run_id", "setup_id", "coolant_on"};
    if (of_spindle_)
      known = {"time_s",
               "run_id",
               "speed_rpm",
               "axial_load_N",
               "coolant_on",
               "ambient_temperature_C",
               "radial_load_N",
               "moment_Nm",
               "belt_force_N",
               "motor_heat_W",
               "machine_temperature_C",
               "coolant_inlet_temperature_C"};
    for (const Channel* c : wanted_) known.emplace_back(c->name);
    for (const std::string& name : found_.others) {
      if (const auto near = map.rules.empty() ? text::nearest_name(name, known) : std::nullopt)
        throw text::InputError(fmt::format("{}:{}: column {} is unknown; did you mean {}?",
                                           table_.source, table_.header_line, name, *near),
                               place_in_header(table_, name));
    }
    if (!found_.others.empty())
      unknown_ = fmt::format(
          "column{} {} unknown and ignored: a record {}", found_.others.size() == 1 ? "" : "s",
          text::listed(found_.others) + (found_.others.size() == 1 ? " is" : " are"),
          of_spindle_ ? "of a spindle has " + text::listed(known)
                      : "over time has NAME_temperature_C, NAME_feed_m_min, NAME_speed_rpm, "
                        "coolant_on, displacement_NAME_um, offset_NAME_um");
  }

  void set_constant(const Recognised::Constant& constant, Record& result) {
    if (constant.channel->role == Role::time || constant.channel->role == Role::run) return;
    result.set(*constant.channel, std::vector<double>(table_.rows(), constant.value));
    constants_.push_back(fmt::format("{}: {:.6g} {} for all rows, from {}", constant.channel->name,
                                     constant.channel->in_unit(constant.value),
                                     constant.channel->unit, constant.from));
  }

  /// A record over time is none where time goes back.
  void check_time(const Record& result) {
    const ColumnSource* const source = found_.find(record::time);
    const std::span<const double> time = result.values(record::time);
    for (std::size_t row = 1; row < time.size(); ++row) {
      if (result.run_of(row) != result.run_of(row - 1) || !(time[row] <= time[row - 1])) continue;
      cells_.bad.add(
          table_.line(row), record::time.name, table_.shown(row, source->column),
          time[row] == time[row - 1]
              ? "stands twice within a run: time must rise"
              : "goes back within a run: sort the rows, or tell the runs apart by run_id");
    }
  }

  std::vector<record::Note> notes(const Record& result) const {
    std::vector<record::Note> list = cells_.notes_on_form();
    list.insert(list.end(), found_.notes.begin(), found_.notes.end());
    if (!dropped_.empty()) list.push_back(record::note::left_out(dropped_));
    append(list, notes_of(record::note::filled_in, filled_));
    append(list, notes_of(record::note::filled_in, constants_));
    append(list, notes_of(record::note::read_as, without_));
    if (!unknown_.empty()) list.push_back(record::note::unused(unknown_));
    if (!lone_.empty()) list.push_back(record::note::unused(lone_));
    if (!unused_.empty())
      list.push_back(record::note::unused("not predicted by the model: " + text::listed(unused_)));
    note_gaps(result, list);
    return list;
  }

  /// Steps of time far beyond the usual one.
  void note_gaps(const Record& result, std::vector<record::Note>& list) const {
    constexpr double far_beyond = 20.0;
    const std::span<const double> time = result.values(record::time);
    std::vector<double> steps;
    for (std::size_t row = 1; row < time.size(); ++row)
      if (result.run_of(row) == result.run_of(row - 1)) steps.push_back(time[row] - time[row - 1]);
    if (steps.empty()) return;
    const double usual = record::median(steps);
    std::size_t count = 0, first = 0;
    double longest = 0.0;
    for (std::size_t row = 1; row < time.size(); ++row) {
      const double step = time[row] - time[row - 1];
      if (result.run_of(row) != result.run_of(row - 1) || !(step > far_beyond * usual)) continue;
      if (count++ == 0) first = row;
      longest = std::max(longest, step);
    }
    if (count > 0)
      list.push_back(record::note::filled_in(
          fmt::format(
              "{} gap{} in time, the first before {}, the longest {:.4g} s where rows come every "
              "{:.4g} s: {}",
              count, count == 1 ? "" : "s", result.place(first), longest, usual,
              settings_hold_ == record::SettingsHold::until_row
                  ? "the settings of the row behind it hold"
                  : "temperatures are carried over it in a straight line, all else as it was"),
          {.line = result.line(first)}));
  }

  text::CsvTable table_;
  const Channels& wanted_;
  Recognised found_;
  bool of_spindle_;
  std::optional<text::DateOrder> date_order_;
  record::SettingsHold settings_hold_;
  std::string dropped_;
  ColumnReader cells_;
  std::vector<std::string> unused_, constants_, filled_, without_;
  std::string unknown_, lone_;
};

}  // namespace

ReadOptions over_time(ReadOptions options) {
  options.over_time = true;
  return options;
}

record::Record read_series(const Source& source, const Channels& wanted, const Channels& needed,
                           const ReadOptions& options) {
  return SeriesReader(read_measurements(source, over_time(options)), wanted, needed, options)
      .read();
}

}  // namespace raceway::files
