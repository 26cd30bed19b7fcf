#include "files/displacement_curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "files/detail/column_source.h"
#include "files/detail/impossible_cells.h"
#include "record/channel.h"
#include "text/bad_cells.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/names.h"
#include "text/printable.h"

namespace raceway::files {
namespace {

struct Column {
  const record::Channel* channel;
  bool required;
  double shaft::DisplacementPoint::*member;
};

constexpr std::size_t displacement = 1;  // its place among the columns
constexpr std::array curve_columns{
    Column{&record::speed, true, &shaft::DisplacementPoint::speed},
    Column{&record::axial_displacement, true, &shaft::DisplacementPoint::displacement},
    Column{&record::displacement_deviation, false, &shaft::DisplacementPoint::std}};

using Places = std::array<std::optional<ColumnSource>, curve_columns.size()>;

Places places(const text::CsvTable& table, const Recognised& found) {
  Places result;
  for (std::size_t k = 0; k < curve_columns.size(); ++k) {
    const std::string_view name = curve_columns[k].channel->name;
    if (const ColumnSource* const source = found.find(*curve_columns[k].channel)) {
      result[k] = *source;
      continue;
    }
    const std::string place = fmt::format("{}:{}", table.source, table.header_line);
    if (curve_columns[k].required)
      throw text::InputError(fmt::format("{}: column {} is missing{}", place, name,
                                         text::suggestion(name, table.header)),
                             {table.source, table.header_line, std::string(name)});
    for (const std::string& other : table.header)
      if (text::edit_distance(other, name) == 1)
        throw text::InputError(
            fmt::format("{}: column {} is unknown; did you mean {}?", place, other, name),
            {table.source, table.header_line, other});
  }
  return result;
}

/// What the columns that are not read mean for the fit.
std::vector<record::Note> notes_on_others(const text::CsvTable& table, const Places& read) {
  std::vector<record::Note> notes =
      notes_of(record::note::read_as, table.notes, {.file = table.source});
  std::string names;
  std::size_t count = 0;
  constexpr std::size_t shown = 4;
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    if (std::any_of(read.begin(), read.end(), [&](const auto& r) { return r && r->column == c; }))
      continue;
    if (++count <= shown) names += (names.empty() ? "" : ", ") + table.header[c];
    const bool condition =
        table.header[c] == record::preload.name || table.header[c] == record::axial_load.name;
    for (std::size_t row = 1; condition && row < table.rows(); ++row)
      if (table.shown(row, c) != table.shown(0, c)) {
        notes.push_back(
            record::note::unused(fmt::format("{} changes from row to row, but the law depends on "
                                             "speed only: fit each curve separately",
                                             table.header[c]),
                                 {.key = table.header[c]}));
        break;
      }
  }
  if (count > 0)
    notes.push_back(record::note::unused(fmt::format(
        "not used: {}{}", names, count > shown ? fmt::format(" and {} more", count - shown) : "")));
  return notes;
}

DisplacementCurve curve_of(text::CsvTable table, const ReadOptions& options) {
  const Recognised found = recognise(table, options);
  const Places read = places(table, found);
  std::vector<ColumnSource> needed;
  for (const auto& place : read)
    if (place) needed.push_back(*place);
  for (const std::string& note : {options.drop_nan ? drop_empty_rows(table, needed) : std::string(),
                                  drop_impossible_rows(table, needed)})
    if (!note.empty()) table.notes.push_back(note);
  const auto status = table.column("status");
  DisplacementCurve curve{.source = table.source, .notes = notes_on_others(table, read)};
  curve.notes.insert(curve.notes.end(), found.notes.begin(), found.notes.end());
  text::BadCells bad(table.source, table.rows());
  std::size_t without = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (status && table.is_empty(row, read[displacement]->column) &&
        table.shown(row, *status) != "converged") {
      ++without;
      continue;
    }
    shaft::DisplacementPoint point;
    for (std::size_t k = 0; k < curve_columns.size(); ++k) {
      if (!read[k]) continue;
      point.*curve_columns[k].member = si_of_cell(table, row, *read[k], false, bad).value;
    }
    curve.points.push_back(point);
  }
  bad.throw_if_any();
  if (without > 0)
    curve.notes.push_back(record::note::left_out(
        fmt::format("{} of {} rows have no displacement (see the column status) and are not used",
                    without, table.rows())));
  return curve;
}

}  // namespace

DisplacementCurve read_displacement_curve(const Source& source, const ReadOptions& options) {
  return curve_of(read_measurements(source, options), options);
}

std::string displacement_table_text(const shaft::DisplacementTable& table,
                                    std::string_view source) {
  std::string text = fmt::format(
      "# Axial displacement of the shaft against speed, from {}\n"
      "# raceway {}\n"
      "# between two rows, the displacement is a cubic with the values and slopes of both rows "
      "(Hermite); {}\n"
      "# do not use the cubics below the first or above the last speed\n"
      "speed_rpm,axial_displacement_um,slope_um_rpm\n",
      text::printable(source), RACEWAY_VERSION,
      table.monotone ? "the whole curve only rises or only falls"
                     : "between two rows, the displacement only rises or only falls");
  for (std::size_t i = 0; i < table.speed.size(); ++i)
    text += fmt::format("{:.12g},{:.12g},{:.12g}\n", table.speed[i] / rpm,
                        table.displacement[i] / um, table.slope[i] / (um / rpm));
  return text;
}

}  // namespace raceway::files
