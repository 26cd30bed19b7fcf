#include "files/table_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <unordered_map>

#include "files/detail/table_columns.h"
#include "files/detail/table_grid.h"
#include "record/units.h"
#include "text/csv.h"
#include "text/detail/csv_text.h"
#include "text/error.h"
#include "text/input_file.h"
#include "text/names.h"
#include "text/units.h"

namespace raceway::files {
namespace {

using bearing::SolveStatus;

SolveStatus status_of(std::string_view text, const text::Place& place) {
  for (const SolveStatus status :
       {SolveStatus::not_run, SolveStatus::converged, SolveStatus::no_equilibrium,
        SolveStatus::iteration_limit, SolveStatus::singular, SolveStatus::not_finite})
    if (bearing::name(status) == text) return status;
  throw text::InputError(
      fmt::format("{}: status = {}: must be a solver status, such as converged or no_equilibrium",
                  place.text(), text::quoted(text)),
      place);
}

std::string shown(const bearing::OperatingPoint& point) {
  return fmt::format(
      "speed_rpm {:.12g}, axial_load_N {:.12g}, radial_load_N {:.12g}, temperature_C "
      "{:.12g}",
      point.speed / rpm, point.axial_load, point.radial_load, celsius(point.temperature));
}

std::string model_text_of(const text::CsvTable& csv) {
  std::string text;
  for (const std::string& comment : csv.comments) {
    if (!comment.starts_with(text::model_mark)) continue;
    std::string_view line = std::string_view(comment).substr(text::model_mark.size());
    if (line.starts_with(' ')) line.remove_prefix(1);
    text.append(line).push_back('\n');
  }
  return text;
}

/// Different values of one column, in increasing order.
std::vector<double> axis_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// A slab's file, taken apart.
struct SlabFile {
  std::string name;
  std::size_t index = 0, count = 0, points = 0, of = 0;  ///< index from 1
  std::uint64_t grid = 0;
  std::string head;       ///< without the slab's line, up to and with the names of the columns
  std::string_view rows;  ///< in the text it came from
};

SlabFile slab_file(const SlabText& file) {
  SlabFile slab;
  slab.name = file.name;
  const std::string_view text = file.text;
  std::size_t begin = 0;
  for (bool comment = true; comment && begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string_view line = text.substr(begin, end - begin);
    comment = line.starts_with('#');
    begin = end;
    if (line.starts_with(slab_mark) && slab.count == 0) {
      unsigned long long grid = 0;
      if (std::sscanf(std::string(line).c_str(), "# slab %zu/%zu: %zu of %zu points, grid %llx",
                      &slab.index, &slab.count, &slab.points, &slab.of, &grid) != 5 ||
          slab.index == 0 || slab.index > slab.count)
        slab.count = 0;
      slab.grid = grid;
      continue;
    }
    slab.head += line;
  }
  if (slab.count == 0)
    throw text::InputError(
        file.name + ": the file is not a slab of a table; raceway table --slab writes slabs",
        {.file = file.name});
  slab.rows = text.substr(begin);
  const auto rows = static_cast<std::size_t>(std::count(slab.rows.begin(), slab.rows.end(), '\n'));
  if (rows != slab.points || (!slab.rows.empty() && slab.rows.back() != '\n'))
    throw text::InputError(
        fmt::format("{}: the file has only {} of its {} points; was it truncated?", file.name, rows,
                    slab.points),
        {.file = file.name});
  return slab;
}

/// What makes b a slab of another table than a; empty if nothing.
std::string stranger(const SlabFile& a, const SlabFile& b) {
  if (a.count != b.count)
    return fmt::format(
        "the first belongs to a table of {} slabs, the second to a table of {} slabs", a.count,
        b.count);
  if (a.of != b.of || a.grid != b.grid) return "they have different speeds, loads or temperatures";
  if (a.head != b.head)
    return "they come from different models or versions of raceway, or have different columns";
  return {};
}

std::size_t place_on(const std::vector<double>& axis, double value) {
  return static_cast<std::size_t>(std::lower_bound(axis.begin(), axis.end(), value) - axis.begin());
}

}  // namespace

std::string merged_table_text(const std::vector<SlabText>& slabs) {
  if (slabs.empty()) throw text::InputError("raceway table: --merge needs the names of the slabs");
  std::vector<SlabFile> files;
  for (const SlabText& slab : slabs) files.push_back(slab_file(slab));
  std::sort(files.begin(), files.end(),
            [](const SlabFile& a, const SlabFile& b) { return a.index < b.index; });
  const SlabFile& first = files.front();
  for (const SlabFile& file : files)
    if (const std::string why = stranger(first, file); !why.empty())
      throw text::InputError(
          fmt::format("{} and {} are slabs of different tables: {}", first.name, file.name, why),
          {.file = file.name});
  for (std::size_t k = 1; k < files.size(); ++k)
    if (files[k].index == files[k - 1].index)
      throw text::InputError(fmt::format("slab {}/{} is given twice: {} and {}", files[k].index,
                                         first.count, files[k - 1].name, files[k].name),
                             {.file = files[k].name});
  std::size_t size = first.head.size(), points = 0, next = 1;  // the first that is missing
  for (const SlabFile& file : files) {
    if (next == file.index) ++next;
    points += file.points;
    size += file.rows.size();
  }
  if (files.size() < first.count)
    throw text::InputError(fmt::format("missing slabs: {} of {}; the first is {}/{}",
                                       first.count - files.size(), first.count, next, first.count));
  if (points != first.of)
    throw text::InputError(
        fmt::format("{}: the slabs have {} points in total, but the table has {} points",
                    first.name, points, first.of),
        {.file = first.name});
  std::string text;
  text.reserve(size);
  text += first.head;
  for (const SlabFile& file : files) text += file.rows;
  return text;
}

void refuse_slab(const text::CsvTable& csv) {
  for (const std::string& comment : csv.comments)
    if (comment.starts_with(slab_mark))
      throw text::InputError(
          csv.source +
              ": the file is only one slab of a table; join all slabs with raceway table --merge",
          {.file = csv.source});
}

std::vector<std::size_t> points_of_rows(const text::CsvTable& csv, const TableInputs& inputs,
                                        friction::StribeckTable& table) {
  const std::string& source = csv.source;
  const std::size_t rows = csv.rows();
  table.axes = {axis_of(inputs[0]), axis_of(inputs[1]), axis_of(inputs[2]), axis_of(inputs[3])};
  try {
    friction::validate(table.axes);
  } catch (const std::invalid_argument& error) {
    throw text::InputError(source + ": " + error.what(), {.file = source});
  }

  const std::array axes{&table.axes.speed, &table.axes.axial_load, &table.axes.radial_load,
                        &table.axes.temperature};
  double points = 1.0;
  for (const auto* axis : axes) points *= static_cast<double>(axis->size());
  // Far beyond what can be complete, an index would no longer be a number that counts exactly.
  constexpr double countable = 1e15;
  if (points > countable)
    throw text::InputError(
        fmt::format("{}: the rows do not form a grid of speeds, loads and temperatures", source),
        {.file = source});
  std::unordered_map<std::size_t, std::size_t> row_of_index;
  row_of_index.reserve(rows);
  std::vector<std::size_t> point_of_row;
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t index =
        table.index(place_on(*axes[0], inputs[0][i]), place_on(*axes[1], inputs[1][i]),
                    place_on(*axes[2], inputs[2][i]), place_on(*axes[3], inputs[3][i]));
    const auto [twin, is_new] = row_of_index.emplace(index, i);
    if (!is_new)
      throw text::InputError(
          fmt::format("{}:{}: the point {} is already in line {}", source, csv.line(i),
                      shown(table.point(index)), csv.line(twin->second)),
          {.file = source, .line = csv.line(i)});
    point_of_row.push_back(index);
  }
  const std::size_t size = table.axes.size();
  if (size != rows) {
    std::size_t missing = 0;
    while (row_of_index.count(missing) > 0) ++missing;
    throw text::InputError(
        fmt::format("{}: the grid is incomplete: {} speeds x {} axial loads x {} radial loads x {} "
                    "temperatures are {} points, but the file has {}; for example, {} is missing",
                    source, axes[0]->size(), axes[1]->size(), axes[2]->size(), axes[3]->size(),
                    size, rows, shown(table.point(missing))),
        {.file = source});
  }
  return point_of_row;
}

TableFile parse_table(std::string text, const std::string& source) {
  const text::CsvTable csv = text::parse_csv(std::move(text), source);
  TableFile file;
  file.source = source;
  refuse_slab(csv);
  file.model_text = model_text_of(csv);

  std::array<std::size_t, leading_columns.size()> at{};
  for (std::size_t k = 0; k < at.size(); ++k) {
    const auto column = csv.column(leading_columns[k]);
    if (!column)
      throw text::InputError(
          fmt::format("{}:{}: column {} is missing{}", source, csv.header_line, leading_columns[k],
                      text::suggestion(leading_columns[k], csv.header)),
          {source, csv.header_line, std::string(leading_columns[k])});
    at[k] = *column;
  }
  const auto status = csv.column(status_column);
  std::vector<std::size_t> further;
  for (std::size_t k = 0; k < csv.header.size(); ++k) {
    if (std::find(at.begin(), at.end(), k) != at.end() || k == status) continue;
    further.push_back(k);
    file.table.columns.push_back(csv.header[k]);
  }

  const std::size_t rows = csv.rows();
  TableInputs inputs;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    inputs[k].reserve(rows);
    const double factor = k == 0 ? rpm : 1.0;
    const double offset = k == 3 ? celsius_zero : 0.0;
    for (std::size_t i = 0; i < rows; ++i)
      inputs[k].push_back(csv.number(i, at[k]) * factor + offset);
  }
  friction::StribeckTable& table = file.table;
  const std::vector<std::size_t> point_of_row = points_of_rows(csv, inputs, table);
  const std::size_t size = rows;
  table.friction_moment.assign(size, unset);
  table.status.assign(size, SolveStatus::not_run);
  table.values.assign(size * table.columns.size(), unset);
  std::vector<double> factors;
  for (const std::string& name : table.columns) factors.push_back(text::column_unit(name));
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t index = point_of_row[i];
    const auto value = [&csv, row = i](std::size_t column) {
      return csv.cell(row, column).empty() ? unset : csv.number(row, column);
    };
    const std::string_view word = status ? csv.cell(i, *status) : std::string_view();
    const double moment = value(at[4]);
    table.friction_moment[index] = moment * N_mm;
    if (status)
      table.status[index] = status_of(word, {source, csv.line(i), std::string(status_column)});
    else
      table.status[index] = std::isnan(moment) ? SolveStatus::not_run : SolveStatus::converged;
    if (table.status[index] == SolveStatus::converged && std::isnan(moment))
      throw text::InputError(
          fmt::format("{}:{}: friction_torque_Nmm is empty, but the status is converged", source,
                      csv.line(i)),
          {source, csv.line(i), "friction_torque_Nmm"});
    for (std::size_t k = 0; k < further.size(); ++k)
      table.values[index * further.size() + k] = value(further[k]) * factors[k];
  }
  return file;
}

TableFile read_table(const std::string& path) {
  return parse_table(text::read_text(path), text::input_name(path));
}

}  // namespace raceway::files
