#include "files/table_exchange.h"

#include <fmt/format.h>

#include <cmath>

#include "record/units.h"
#include "text/error.h"
#include "text/units.h"

namespace raceway::files {
namespace {

/// Letters, digits and "_", a letter first.
std::string identifier(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter && !(c >= '0' && c <= '9')) c = '_';
  }
  if (text.empty() || text.front() == '_' || (text.front() >= '0' && text.front() <= '9'))
    text.insert(0, "x");
  return text;
}

void append_number(fmt::memory_buffer& out, double value) {
  if (std::isnan(value))
    fmt::format_to(std::back_inserter(out), ",NaN");
  else
    fmt::format_to(std::back_inserter(out), ",{:.12g}", value);
}

}  // namespace

std::string plain_table_text(const friction::StribeckTable& table) {
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "speed_rpm,axial_load_N,radial_load_N,temperature_C,friction_torque_Nmm");
  for (const std::string& name : table.columns) fmt::format_to(put, ",{}", identifier(name));
  fmt::format_to(put, ",status\n");
  for (std::size_t i = 0; i < table.points(); ++i) {
    const bearing::OperatingPoint point = table.point(table.first() + i);
    fmt::format_to(put, "{:.12g},{:.12g},{:.12g},{:.12g}", point.speed / rpm, point.axial_load,
                   point.radial_load, celsius(point.temperature));
    append_number(out, table.friction_moment[i] / N_mm);
    const auto row = table.row(i);
    for (std::size_t k = 0; k < row.size(); ++k)
      append_number(out, row[k] / text::column_unit(table.columns[k]));
    fmt::format_to(put, ",{}\n", bearing::name(table.status[i]));
  }
  return fmt::to_string(out);
}

std::string modelica_table_text(const friction::StribeckTable& table, std::string_view title) {
  if (table.slab.count != 1)
    throw text::InputError(
        "a Modelica table needs the whole table, not a slab: first join the slabs with raceway "
        "table --merge");
  const friction::TableAxes& axes = table.axes;
  const bool one = axes.radial_load.size() == 1 && axes.temperature.size() == 1;
  const bool curve = axes.axial_load.size() == 1;
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "#1\n# Friction torque [N m] of {}, by raceway {}\n# {}\n", title,
                 RACEWAY_VERSION,
                 curve ? "CombiTable1Ds: speed [rad/s], friction torque [N m]"
                       : "CombiTable2Ds: u1 (rows): speed [rad/s], u2 (columns): axial load [N]");
  for (std::size_t t = 0; t < axes.temperature.size(); ++t)
    for (std::size_t r = 0; r < axes.radial_load.size(); ++r) {
      std::string name = "friction_torque";
      if (!one)
        name +=
            identifier(fmt::format("_Fr{:.6g}_T{:.6g}", axes.radial_load[r], axes.temperature[t]));
      fmt::format_to(put, "# radial load {:.6g} N, {:.6g} C{}\n", axes.radial_load[r],
                     celsius(axes.temperature[t]),
                     curve ? fmt::format(", axial load {:.6g} N", axes.axial_load[0]) : "");
      fmt::format_to(put, "double {}({},{})\n", name, axes.speed.size() + (curve ? 0 : 1),
                     axes.axial_load.size() + 1);
      if (!curve) {
        out.push_back('0');
        for (const double load : axes.axial_load) fmt::format_to(put, " {:.12g}", load);
        out.push_back('\n');
      }
      for (std::size_t s = 0; s < axes.speed.size(); ++s) {
        fmt::format_to(put, "{:.12g}", axes.speed[s]);
        for (std::size_t a = 0; a < axes.axial_load.size(); ++a) {
          const double moment = table.friction_moment[table.index(s, a, r, t)];
          if (std::isnan(moment))
            throw text::InputError(
                fmt::format("a Modelica table needs a value at each point, but there is none at "
                            "{:.6g} rpm, {:.6g} N: use a smaller range",
                            axes.speed[s] / rpm, axes.axial_load[a]));
          fmt::format_to(put, " {:.12g}", moment);
        }
        out.push_back('\n');
      }
    }
  return fmt::to_string(out);
}

}  // namespace raceway::files
