#include "report/table_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "record/units.h"
#include "text/error.h"

namespace raceway::report {
namespace {

constexpr double width = 720, height = 440;  // [px]
constexpr double left = 70, right = 110, top = 50, bottom = 55;
// Told apart also by who sees no red or green.
constexpr std::array<std::string_view, 7> colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#333333"};

/// Steps of 1, 2 or 5 times a power of ten, about six of them.
double step_of(double range) {
  const double rough = range / 6.0, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (rough <= factor * power * (1 + 1e-9)) return factor * power;
  return 10.0 * power;
}

struct Scale {
  double from, to, start, length;
  [[nodiscard]] double operator()(double value) const {
    return start + (value - from) / (to - from) * length;
  }
};

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

std::string label(double x, double y, std::string_view anchor, std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                     escaped(text));
}

std::string grid(const Scale& x, const Scale& y) {
  std::string svg;
  for (double v = 0; v <= x.to * (1 + 1e-9); v += step_of(x.to)) {
    if (v < x.from) continue;
    svg += fmt::format("<path d=\"M{0:.1f} {1} V{2}\" stroke=\"#ddd\"/>\n", x(v), top,
                       height - bottom);
    svg += label(x(v), height - bottom + 18, "middle", fmt::format("{:.6g}", v));
  }
  for (double v = 0; v <= y.to * (1 + 1e-9); v += step_of(y.to)) {
    svg +=
        fmt::format("<path d=\"M{0} {1:.1f} H{2}\" stroke=\"#ddd\"/>\n", left, y(v), width - right);
    svg += label(left - 8, y(v) + 4, "end", fmt::format("{:.6g}", v));
  }
  svg += label((left + width - right) / 2, height - 12, "middle", "speed [rpm]");
  svg += fmt::format(
      "<text transform=\"translate(18 {}) rotate(-90)\" text-anchor=\"middle\">friction torque [N "
      "mm]</text>\n",
      (top + height - bottom) / 2);
  return svg;
}

/// What stands at the end of a curve.
struct CurveName {
  double y;
  std::string_view colour;
  std::string text;
};

/// From the lowest up, none on another.
std::string names_of_curves(std::vector<CurveName> names) {
  constexpr double line = 15;
  std::sort(names.begin(), names.end(), [](const auto& a, const auto& b) { return a.y > b.y; });
  std::string svg;
  double room = height;
  for (const CurveName& name : names) {
    room = std::min(name.y, room - line);
    svg += fmt::format("<text x=\"{}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n", width - right + 8,
                       room, name.colour, name.text);
  }
  return svg;
}

}  // namespace

std::string table_svg(const friction::StribeckTable& table, std::string_view title) {
  if (table.slab.count != 1)
    throw text::InputError("--plot draws only a whole table; join the slabs first",
                           {.key = "--plot"});
  const friction::TableAxes& axes = table.axes;
  const bool by_load = axes.axial_load.size() > 1 || axes.temperature.size() == 1;
  const std::size_t curves = by_load ? axes.axial_load.size() : axes.temperature.size();
  const auto moment = [&](std::size_t curve, std::size_t s) {
    return table.friction_moment[table.index(s, by_load ? curve : 0, 0, by_load ? 0 : curve)] /
           N_mm;
  };
  double most = 0.0;
  for (std::size_t k = 0; k < curves; ++k)
    for (std::size_t s = 0; s < axes.speed.size(); ++s)
      if (const double m = moment(k, s); m > most) most = m;
  if (!(most > 0))
    throw text::InputError("--plot: no point of the table has a torque to draw", {.key = "--plot"});
  const double fastest = std::max(axes.speed.back() / rpm, 1.0);
  const Scale x{0.0, fastest, left, width - left - right};
  const Scale y{0.0, most * 1.05, height - bottom, -(height - top - bottom)};
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"100%\" height=\"100%\" "
      "fill=\"white\"/>\n",
      width, height);
  svg += label(left, 22, "start", fmt::format("Friction torque of {}", title));
  svg += label(left, 40, "start",
               by_load ? fmt::format("radial load {:.6g} N, {:.6g} C", axes.radial_load[0],
                                     celsius(axes.temperature[0]))
                       : fmt::format("axial load {:.6g} N, radial load {:.6g} N",
                                     axes.axial_load[0], axes.radial_load[0]));
  svg += grid(x, y);
  std::vector<CurveName> names;
  for (std::size_t k = 0; k < curves; ++k) {
    const std::string_view colour = colours[k % colours.size()];
    std::string path;
    bool gap = true;
    double end = unset;
    for (std::size_t s = 0; s < axes.speed.size(); ++s) {
      const double m = moment(k, s);
      if (std::isnan(m)) {
        gap = true;
        continue;
      }
      path += fmt::format("{}{:.1f} {:.1f}", gap ? "M" : "L", x(axes.speed[s] / rpm), y(m));
      gap = false;
      end = y(m);
    }
    if (path.empty()) continue;
    svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n", path,
                       colour);
    names.push_back({end + 4, colour,
                     by_load ? fmt::format("{:.6g} N", axes.axial_load[k])
                             : fmt::format("{:.6g} C", celsius(axes.temperature[k]))});
  }
  svg += names_of_curves(std::move(names));
  return svg + "</svg>\n";
}

}  // namespace raceway::report
