#include "files/series_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "files/detail/column_reader.h"
#include "files/detail/filled_inputs.h"
#include "files/detail/joined_series.h"
#include "files/detail/kept_columns.h"
#include "files/detail/transducers.h"
#include "fit/isolated_readings.h"
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

/// One file, whose columns may be a part of those of a record.
class SeriesReader {
 public:
  SeriesReader(text::CsvTable table, const Channels& wanted, const ReadOptions& options)
      : table_(std::move(table)),
        wanted_(wanted),
        found_(recognise(table_, options)),
        transducers_(options.columns.transducers),
        of_spindle_(options.of_spindle),
        date_order_(options.columns.date_order),
        settings_hold_(options.columns.settings_hold.value_or(
            options.of_spindle ? record::SettingsHold::until_row : record::SettingsHold::sampled)),
        dropped_(options.drop_nan ? drop_empty_rows(table_, inputs()) : std::string()),
        cells_(table_) {
    require(record::time);
    name_the_others(options.columns);
  }

  /// As it stands there: inputs are not filled.
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
    for (record::Column& column : kept_.columns) result.columns.push_back(std::move(column));
    for (std::size_t row = 0; row < table_.rows(); ++row) result.lines.push_back(table_.line(row));
    check_time(result);
    cells_.bad.throw_if_any();
    result.notes = notes();
    return result;
  }

  [[nodiscard]] const std::string& source() const { return table_.source; }
  [[nodiscard]] const Recognised& found() const { return found_; }
  [[nodiscard]] const std::optional<ColumnReader::ClockStart>& clock_start() const {
    return cells_.clock_start();
  }
  /// `why` it is needed, in words.
  void require(const Channel& channel, const std::string& why = {}) const {
    if (has(channel)) return;
    std::vector<std::string> others = found_.others;
    for (const ColumnSource& source : found_.columns) others.push_back(source.name);
    throw text::InputError(
        fmt::format(
            "{}:{}: column {} is missing{}{}; the header has {}\n{}{}", table_.source,
            table_.header_line, channel.name, why,
            why.empty() ? text::suggestion(channel.name, others) : std::string(),
            text::listed(table_.header), if_named_otherwise(table_),
            channel == record::time ? "" : ". If another file has this column, add --beside FILE"),
        place_in_header(table_, channel.name));
  }
  [[nodiscard]] bool has(const Channel& channel) const {
    return found_.find(channel) ||
           std::any_of(found_.constants.begin(), found_.constants.end(),
                       [&](const Recognised::Constant& c) { return *c.channel == channel; });
  }

 private:
  [[nodiscard]] bool is_wanted(const Channel& channel) const {
    const auto reads = [&](const Combination& c) {
      return std::any_of(c.terms.begin(), c.terms.end(),
                         [&](const Combination::Term& t) { return *t.transducer == channel; });
    };
    return wanted_.empty() ||
           std::any_of(wanted_.begin(), wanted_.end(),
                       [&](const Channel* w) { return *w == channel; }) ||
           std::any_of(transducers_.begin(), transducers_.end(), reads);
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

  /// A sensor that the model has under a name much like it, and the file not at all.
  void refuse_misspelt(const Channel& channel) const {
    if (!of_spindle_) return;
    std::vector<std::string> lacking;
    for (const Channel* c : wanted_)
      if (!found_.find(*c)) lacking.emplace_back(c->name);
    if (const auto near = text::nearest_name(channel.name, lacking))
      throw text::InputError(
          fmt::format("{}:{}: column {} is not a sensor of the model; did you mean {}?",
                      table_.source, table_.header_line, channel.name, *near),
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
               "motor_power_W",
               "machine_temperature_C",
               "coolant_inlet_temperature_C"};
    for (const Channel* c : wanted_) known.emplace_back(c->name);
    for (const std::string& name : found_.others) {
      if (const auto near = map.rules.empty() ? text::nearest_name(name, known) : std::nullopt)
        throw text::InputError(fmt::format("{}:{}: column {} is unknown; did you mean {}?",
                                           table_.source, table_.header_line, name, *near),
                               place_in_header(table_, name));
    }
    kept_ = kept_columns(table_, found_.others);
    unknown_ = kept_.statements(!map.rules.empty());
    if (!unknown_.empty() && map.rules.empty())
      unknown_.back() += fmt::format(
          " (a record {})",
          of_spindle_ ? "of a spindle can have the columns " + text::listed(known)
                      : "over time can have the columns NAME_temperature_C, NAME_feed_m_min, "
                        "NAME_speed_rpm, NAME_position_mm, NAME_current_A, "
                        "NAME_voltage_V, NAME in W, N, Nm, l_min, bar or percent, "
                        "coolant_on, displacement_NAME_um, displacement_NAME_urad, "
                        "offset_NAME_um, offset_NAME_urad");
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
              ? "occurs twice within a run; time must increase"
              : "goes back within a run; sort the rows, or separate the runs with run_id");
    }
  }

  std::vector<record::Note> notes() const {
    std::vector<record::Note> list = cells_.notes_on_form();
    list.insert(list.end(), found_.notes.begin(), found_.notes.end());
    if (!dropped_.empty()) list.push_back(record::note::left_out(dropped_));
    append(list, notes_of(record::note::filled_in, constants_));
    append(list, notes_of(record::note::unused, unknown_));
    if (!unused_.empty())
      list.push_back(record::note::unused(
          "columns not used, because the model does not predict them: " + text::listed(unused_)));
    return list;
  }

  text::CsvTable table_;
  const Channels& wanted_;
  Recognised found_;
  std::vector<Combination> transducers_;
  bool of_spindle_;
  std::optional<text::DateOrder> date_order_;
  record::SettingsHold settings_hold_;
  std::string dropped_;
  ColumnReader cells_;
  KeptColumns kept_;
  std::vector<std::string> unused_, constants_, unknown_;
};

/// Steps of time far beyond the usual one.
void note_gaps(Record& result, bool of_spindle) {
  constexpr std::string_view cold_start = ", and the spindle starts from rest";
  constexpr std::string_view warm_start =
      ", and initial_state = \"free\" in the model lets the run start warm";
  constexpr double far_beyond = 20.0, an_hour = 3600.0;
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
    result.notes.push_back(record::note::filled_in(
        fmt::format("{} gap{} in time, the first before {}, the longest {:.4g} s (usual interval "
                    "{:.4g} s). In a gap, {}",
                    count, count == 1 ? "" : "s", result.place(first), longest, usual,
                    result.settings_hold == record::SettingsHold::until_row
                        ? "the settings of the row after the gap apply"
                        : "temperatures are interpolated, and settings keep their value") +
            (longest > an_hour
                 ? ". If the settings changed during the gap, enter another run_id for "
                   "the rows after the gap; the displacement then has a new zero" +
                       std::string(of_spindle ? cold_start : warm_start)
                 : ""),
        {.line = result.line(first)}));
}

/// Readings of inputs that cannot be: a temperature has a past, and does not leave by more than all
/// it ever does.
void leave_out_impossible_inputs(Record& record) {
  std::vector<const Channel*> inputs;
  for (const record::Column& c : record.columns)
    // A load or a power may leap for a moment.
    if (c.channel->is_input() && c.channel->kind != record::offset_kind &&
        (record::is_temperature(*c.channel) || record::acts_by_amount(*c.channel)))
      inputs.push_back(c.channel);
  for (const Channel* channel : inputs) {
    fit::Isolated isolated = fit::without_isolated_readings(
        record, *channel,
        {.steady = false, .impossible = record::is_temperature(*channel) ? 1.0 : 3.0});
    if (!isolated.any()) continue;
    const std::string said = isolated.statement();
    record = std::move(isolated.record);
    record.notes.push_back(
        record::note::left_out(said, {.file = record.source, .key = std::string(channel->name)}));
  }
}

/// "2.5 h", "12 min", "40 s"
std::string length_text(double seconds) {
  return seconds >= 7200.0  ? fmt::format("{:.3g} h", seconds / 3600.0)
         : seconds >= 180.0 ? fmt::format("{:.3g} min", seconds / 60.0)
                            : fmt::format("{:.3g} s", seconds);
}

/// "line 402 to 461", also of several gaps: "line 402 to 461 and 2 more gaps"
std::string rows_text(const Record& record, const std::vector<std::size_t>& rows) {
  std::size_t gaps = 0, end = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    gaps += k == 0 || rows[k] != rows[k - 1] + 1 ? 1 : 0;
    if (gaps == 1) end = rows[k];
  }
  std::string text = record.place(rows.front());
  if (end != rows.front()) text += fmt::format(" to {}", record.line(end));
  if (gaps > 1) text += fmt::format(" and {} more gap{}", gaps - 1, gaps == 2 ? "" : "s");
  return text;
}

/// Fills inputs between their readings. Where one that counts was not read for too long the record
/// is broken: what was measured there takes no part. Rows before the first value of what a control
/// sets are left out, and a column that does not count and is broken in more than a tenth of the
/// rows.
void fill_inputs(Record& record, const Channels& needed, bool of_spindle) {
  constexpr double most_of_others = 0.1;
  std::vector<const Channel*> inputs;
  for (const record::Column& c : record.columns)
    if (c.channel->is_input()) inputs.push_back(c.channel);
  std::vector<bool> broken(record.rows()), empty(record.rows());
  for (const Channel* channel : inputs) {
    const FilledInput filled = fill_input(*channel, record);
    if (filled.note.empty()) continue;
    const record::Place place{.file = record.source, .key = std::string(channel->name)};
    record.notes.push_back(record::note::filled_in(filled.note, place));
    const bool is_needed =
        of_spindle || channel->kind == record::offset_kind ||
        std::any_of(needed.begin(), needed.end(), [&](const Channel* n) { return *n == *channel; });
    const std::size_t count = filled.far.empty() ? filled.empty.size() : filled.far.size();
    const bool may_be_needed = is_needed || (needed.empty() && filled.far.empty());
    // No row is lost for a power or a load that nobody asked for.
    const bool costs_rows = !is_needed && !filled.empty.empty() &&
                            !record::is_temperature(*channel) && !record::acts_by_amount(*channel);
    if (costs_rows || (!may_be_needed && static_cast<double>(count) >
                                             most_of_others * static_cast<double>(record.rows()))) {
      record.notes.push_back(record::note::unused(
          fmt::format("{} has no value for {} of {} rows: the column is not used", channel->name,
                      count, record.rows()),
          place));
      std::erase_if(record.columns, [&](const auto& c) { return *c.channel == *channel; });
      continue;
    }
    if (!filled.far.empty()) {
      const bool breaks = is_needed || needed.empty();
      record.notes.push_back(record::note::left_out(
          fmt::format(
              "{} has no reading for more than {}, {}: {}", channel->name,
              length_text(filled.longest), rows_text(record, filled.far),
              breaks ? "the program treats these rows as a gap of the record and does not use "
                       "their readings"
                     : "the values are interpolated, because the model does not use this column"),
          place));
      for (const std::size_t row : filled.far) broken[row] = broken[row] || breaks;
    }
    if (!filled.empty.empty())
      record.notes.push_back(
          record::note::left_out(fmt::format("rows before the first value of {} are not used: {}",
                                             channel->name, rows_text(record, filled.empty)),
                                 place));
    for (const std::size_t row : filled.empty) empty[row] = true;
  }
  for (record::Column& c : record.columns)
    if (c.channel->role == Role::measured)
      for (std::size_t row = 0; row < broken.size(); ++row)
        if (broken[row]) c.values[row] = unset;
  std::vector<std::size_t> whole;
  for (std::size_t row = 0; row < empty.size(); ++row)
    if (!empty[row]) whole.push_back(row);
  if (whole.size() == record.rows()) return;
  if (whole.empty())
    throw text::InputError(fmt::format("{}: no row has values for all inputs: {}", record.source,
                                       record.notes.back().text),
                           {.file = record.source});
  record = record.picked(whole);
}

/// Subtracts the offsets that a control added: the displacements are then those of the machine.
/// `in_file`: of a displacement that nobody wants here.
void take_offsets_off(Record& record, const std::function<bool(const Channel&)>& in_file) {
  std::vector<std::string> lone;
  for (const record::Column& offset : record.columns) {
    if (offset.channel->kind != record::offset_kind) continue;
    const std::string of = "displacement" + std::string(offset.channel->name.substr(6));
    const Channel& displacement = *record::series_channel(of);
    record::Column* const read = record.find(displacement);
    if (!read) {
      if (!in_file(displacement)) lone.emplace_back(offset.channel->name);
      continue;
    }
    for (std::size_t row = 0; row < read->values.size(); ++row)
      read->values[row] -= offset.values[row];
    record.notes.push_back(record::note::read_as(fmt::format(
        "the offset of the control, {1}, is subtracted from {0}", of, offset.channel->name)));
  }
  if (!lone.empty())
    record.notes.push_back(record::note::unused(
        fmt::format("{}: not used, because the record has no displacement for this offset",
                    text::listed(lone))));
  std::erase_if(record.columns,
                [](const record::Column& c) { return c.channel->kind == record::offset_kind; });
}

using Files = std::vector<std::unique_ptr<SeriesReader>>;

/// Throws InputError where files have some transducers and lack others that a displacement is made
/// of, and where they have this displacement, too.
void require_transducers(const Files& files, const ColumnMap& map, const Channels& wanted) {
  const auto here = [&](const Channel& channel) {
    return std::any_of(files.begin(), files.end(), [&](const auto& f) { return f->has(channel); });
  };
  const auto is_here = [&](const Combination::Term& t) { return here(*t.transducer); };
  if (std::none_of(map.transducers.begin(), map.transducers.end(), [&](const Combination& c) {
        return std::any_of(c.terms.begin(), c.terms.end(), is_here);
      }))
    return;
  for (const Combination* c : combinations_for(map, wanted)) {
    for (const Combination::Term& t : c->terms)
      if (!is_here(t))
        files.front()->require(*t.transducer,
                               fmt::format(", from which {} [transducers] calculates {}",
                                           c->place.text(), c->displacement->name));
    if (here(*c->displacement))
      throw text::InputError(
          fmt::format("{} has a column {}, which {} [transducers] calculates from other columns; "
                      "keep one of the two",
                      files.front()->source(), c->displacement->name, c->place.text()),
          c->place);
  }
}

/// Throws InputError for a column that none of the files has, of those that are needed and of those
/// that the map names.
Files readers_of(const Source& source, const Channels& wanted, const Channels& needed,
                 const ReadOptions& options) {
  Files files;
  const auto add = [&](const Source& one) {
    files.push_back(
        std::make_unique<SeriesReader>(read_measurements(one, options), wanted, options));
  };
  add(source);
  for (const Source& other : source.beside) add(other);
  const auto none = [&](const auto& has) { return std::none_of(files.begin(), files.end(), has); };
  for (const ColumnRule* rule : files.front()->found().not_here)
    if (!may_be_missing(*rule, options) &&
        none([&](const auto& f) { return f->has(*rule->channel); }))
      throw text::InputError(fmt::format("{}: neither this file nor the files joined with it have "
                                         "the column {}, which {} uses for {}",
                                         source.name, options.columns.headers_of(*rule->channel),
                                         rule->place.text(), rule->key),
                             rule->place);
  for (const Channel* c : needed)
    if (none([&](const auto& f) { return f->has(*c); })) files.front()->require(*c);
  require_transducers(files, options.columns, wanted);
  return files;
}

}  // namespace

ReadOptions over_time(ReadOptions options) {
  options.over_time = true;
  return options;
}

record::Record read_series(const Source& source, const Channels& wanted, const Channels& needed,
                           const ReadOptions& given) {
  ReadOptions options = over_time(given);
  options.of_several = !source.beside.empty();
  const Files files = readers_of(source, wanted, needed, options);
  std::vector<SeriesPart> parts;
  for (const auto& file : files) {
    Record part = file->read();
    parts.push_back({std::move(part), file->clock_start()});
  }
  Record record = parts.size() > 1 ? joined_series(parts) : std::move(parts.front().record);
  for (const ColumnRule* rule : files.front()->found().not_here)
    if (may_be_missing(*rule, options) && !record.has(*rule->channel))
      record.notes.push_back(record::note::left_out(
          fmt::format("no column {}, which {} uses for {}: there are no readings to compare with",
                      options.columns.headers_of(*rule->channel), rule->place.text(), rule->key),
          {.file = record.source, .key = rule->header}));
  leave_out_impossible_inputs(record);
  combine_transducers(record, options.columns, wanted);
  fill_inputs(record, needed, options.of_spindle);
  take_offsets_off(record, [&](const Channel& c) {
    return std::any_of(files.begin(), files.end(), [&](const auto& f) { return f->has(c); }) ||
           !combinations_for(options.columns, {&c}).empty();
  });
  note_gaps(record, options.of_spindle);
  return record;
}

}  // namespace raceway::files
