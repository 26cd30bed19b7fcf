#include "files/new_correction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "correction/identify.h"
#include "files/correction_file.h"
#include "files/detail/column_source.h"
#include "files/detail/series_columns.h"
#include "files/detail/transducers.h"
#include "files/series_doubts.h"
#include "files/series_file.h"
#include "record/series_channel.h"
#include "text/error.h"
#include "text/names.h"
#include "text/printable.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Record;

constexpr std::size_t most_channels = 4;  // beyond it single lags go astray
constexpr double least_rise = 0.5;        // [K]
constexpr double a_tenth = 0.1;

/// Between the lowest and the highest value; 0 of none.
double width_of(const record::Column& column) {
  double low = unset, high = unset;
  for (const double v : column.values) low = std::fmin(low, v), high = std::fmax(high, v);
  return high > low ? high - low : 0.0;
}

/// With two digits.
double rounded(double value) {
  if (!(std::abs(value) > 0.0)) return value;
  const double place = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
  return place * std::round(value / place);
}

/// Of the longest run [s].
double length_of(const Record& record) {
  const std::span<const double> time = record.values(record::time);
  double longest = 0.0;
  for (std::size_t row = 1, first = 0; row < time.size(); ++row) {
    if (record.run_of(row) != record.run_of(row - 1)) first = row;
    longest = std::max(longest, time[row] - time[first]);
  }
  return longest;
}

/// Temperatures that vary, the speed where there are none.
std::vector<const record::Column*> driving(const Record& record) {
  std::vector<const record::Column*> list;
  for (const record::Column& c : record.columns)
    if (c.channel->is_input() && record::is_temperature(*c.channel) && width_of(c) > least_rise)
      list.push_back(&c);
  if (const record::Column* const speed = record.find(record::speed);
      list.empty() && speed && width_of(*speed) > 0.0)
    list.push_back(speed);
  return list;
}

correction::Model model_of(const Record& record, const record::Column& displacement,
                           const std::vector<const record::Column*>& inputs) {
  const double travel = width_of(displacement), least = 0.1 * um;
  correction::Model m{.displacement = displacement.channel,
                      .tolerance = rounded(std::max(a_tenth * travel, least))};
  if (inputs.size() > most_channels) return m;
  const double share = travel / static_cast<double>(inputs.size());
  for (const record::Column* input : inputs) {
    correction::DrivenChannel c = correction::driven_by(*input->channel, m);
    // Rounded in the unit of the file.
    const double per_unit = um / c.input.factor();
    c.sections = {{.gain = rounded(share / width_of(*input) / per_unit) * per_unit,
                   .time_constant = rounded(a_tenth * length_of(record))}};
    m.channels.push_back(std::move(c));
  }
  return m;
}

/// The text with a remark behind lines that begin with these keys.
std::string with_remarks(const std::string& text,
                         const std::vector<std::pair<std::string_view, std::string_view>>& of_key) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view(text).substr(begin, end - begin);
    begin = end + 1;
    result += line;
    for (const auto& [key, remark] : of_key)
      if (line.starts_with(key) && line.substr(key.size()).starts_with(" ="))
        result += fmt::format("  # {}", remark);
    result += '\n';
  }
  return result;
}

}  // namespace

NewCorrection new_correction(const Source& source, const ReadOptions& given) {
  ReadOptions options = over_time(given);
  const SeriesColumns columns = series_columns(tables_of(source, options), {}, options.columns);
  const std::string combined = transducers_text(options.columns);
  if (!columns.all_ours)
    options.columns = parse_column_map(columns.text + "\n" + combined, "[columns]");
  const Record record = read_series(source, {}, {}, options);
  const std::vector<const record::Column*> inputs = driving(record);
  std::vector<correction::Model> models;
  for (const record::Column& c : record.columns)
    if (c.channel->role == record::Role::measured) models.push_back(model_of(record, c, inputs));
  if (models.empty())
    throw text::InputError(
        fmt::format("{}: no column is a displacement; name the column of the displacement in a "
                    "file for --columns, such as displacement_z_um = \"HEADER\"; the header has {}",
                    source.name, text::listed(read_measurements(source, options).header)),
        {.file = source.name});

  NewCorrection made;
  const std::string name =
      text::printable(std::filesystem::path(record.source).filename().string());
  const std::string next =
      inputs.size() > most_channels
          ? fmt::format(
                "{} temperatures vary, which is too many for one channel each. This command uses "
                "all of them:\n# raceway identify THIS-FILE RECORD --lags auto -o FOUND.toml",
                inputs.size())
          : "This command finds gains and time constants:\n# raceway identify THIS-FILE RECORD -o "
            "FOUND.toml";
  const std::string comment = fmt::format(
      "First correction from {}. Replace the values that are marked as assumed.\n# {}", name, next);
  made.text = with_remarks(
      new_corrections(models, comment),
      {{"tolerance_um", "assumed: 10 % of the range of the readings; enter your tolerance"},
       {"tolerance_urad", "assumed: 10 % of the range of the readings; enter your tolerance"},
       {"offset_um", "assumed; identify finds this constant"},
       {"offset_urad", "assumed; identify finds this constant"},
       {"sections",
        "assumed: gain from the range of the readings, time constant of 10 % of the duration of "
        "the longest run"}});
  if (!columns.all_ours) made.text += "\n" + columns.text;
  if (!combined.empty()) made.text += "\n" + combined;
  (void)parse_correction(made.text, "new correction");  // it reads back
  made.notes = record.notes;
  for (const Doubt& doubt : series_doubts(record, std::vector<correction::Model>()))
    made.notes.push_back(record::note::unit(doubt.text, {.file = source.name}));
  if (inputs.empty())
    made.notes.push_back(
        record::note::assumed("no temperature varies by more than 0.5 K, and the speed is "
                              "constant, so the model has no channel",
                              {.file = source.name}));
  return made;
}

}  // namespace raceway::files
