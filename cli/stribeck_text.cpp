#include "cli/stribeck_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/band_flag.h"
#include "cli/text_table.h"

namespace raceway::cli {

void print_table(const model::Model& model, const friction::StribeckTable& t) {
  fmt::print("Friction torque [N mm] of {}\n", model.name);
  const auto of_band = static_cast<std::size_t>(
      std::find(t.columns.begin(), t.columns.end(), "friction_torque_band_Nmm") -
      t.columns.begin());
  const auto torque = [&](std::size_t point) {
    const std::string text = number(t.friction_moment[point] / N_mm, 4);
    if (of_band == t.columns.size() || std::isnan(t.friction_moment[point])) return text;
    return text + " " + band_text(t.row(point)[of_band], N_mm);
  };
  // The loads of one axis stand side by side; of cylindrical rollers the radial ones, which they
  // carry alone.
  const auto print_across = [&](const std::vector<double>& loads, const auto& point) {
    std::vector<TextTable::Column> heads{{"speed", "rpm"}};
    for (const double load : loads) heads.push_back({fmt::format("{:.6g} N", load), "N mm"});
    TextTable table(heads);
    for (std::size_t s = 0; s < t.axes.speed.size(); ++s) {
      std::vector<std::string> row{fmt::format("{:.6g}", t.axes.speed[s] / rpm)};
      for (std::size_t load = 0; load < loads.size(); ++load) row.push_back(torque(point(s, load)));
      table.add(row);
    }
    fmt::print("{}", table.text(terminal_width()));
  };
  for (std::size_t k = 0; k < t.axes.temperature.size(); ++k) {
    if (model.bearing.rollers()) {
      fmt::print("\n{:.4g} C, columns: radial load\n", celsius(t.axes.temperature[k]));
      print_across(t.axes.radial_load,
                   [&](std::size_t s, std::size_t r) { return t.index(s, 0, r, k); });
      continue;
    }
    for (std::size_t r = 0; r < t.axes.radial_load.size(); ++r) {
      fmt::print("\nradial load {:.6g} N, {:.4g} C, columns: axial load\n", t.axes.radial_load[r],
                 celsius(t.axes.temperature[k]));
      print_across(t.axes.axial_load,
                   [&](std::size_t s, std::size_t a) { return t.index(s, a, r, k); });
    }
  }
}

}  // namespace raceway::cli
