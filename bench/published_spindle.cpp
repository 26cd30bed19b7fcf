// Draws the published kinematic displacement [Brecher2021, eq. 10], a computed spindle that
// reproduces it, and the law fitted to that spindle: docs/kinematic-law.svg.
//
//   published_spindle > docs/kinematic-law.svg

#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "shaft/fit_kinematic_law.h"

namespace {

using namespace raceway;

// D 15.875 mm, d_m 110 mm, Z 18, 25 deg, f 0.535, 1500 N: two at the front, one at the rear.
bearing::Arrangement spindle() {
  const auto one = std::make_shared<const bearing::Bearing>(
      bearing::BearingGeometry{.ball_count = 18,
                               .ball_diameter = 15.875 * mm,
                               .pitch_diameter = 110 * mm,
                               .contact_angle = 25 * degree,
                               .inner_conformity = 0.535,
                               .outer_conformity = 0.535},
      bearing::steel(), bearing::steel());
  return bearing::Arrangement(
      {.front = {{one}, {one}}, .rear = {{one}}, .preload = bearing::PreloadForce{1500.0}});
}

struct Axes {
  double left, bottom, width, height;  // of the plot on the page
  double top_value, base_value;        // at its upper and lower edge [um]
  [[nodiscard]] double x(double n) const { return left + width * n / 10000.0; }
  [[nodiscard]] double y(double u) const {
    return bottom - height * (u - base_value) / (top_value - base_value);
  }
};

template <typename U>
void line(const Axes& axes, std::string_view style, const U& u) {
  fmt::print("<path fill=\"none\" {} d=\"M", style);
  for (int n = 0; n <= 10000; n += 100) fmt::print(" {:.1f} {:.1f}", axes.x(n), axes.y(u(n)));
  fmt::print("\"/>\n");
}

void frame(const Axes& axes, double step, std::string_view title) {
  const int lines = static_cast<int>((axes.top_value - axes.base_value) / step + 1e-9);
  for (int k = 0; k <= lines; ++k) {
    const double u = axes.base_value + k * step;
    fmt::print("<path stroke=\"#ddd\" d=\"M {:.1f} {:.1f} h {:.1f}\"/>\n", axes.left, axes.y(u),
               axes.width);
    fmt::print("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:g}</text>\n", axes.left - 6,
               axes.y(u) + 4, std::round(u * 100.0) / 100.0);
  }
  for (int n = 0; n <= 10000; n += 2000)
    fmt::print("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", axes.x(n),
               axes.bottom + 18, n);
  fmt::print("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", axes.left,
             axes.bottom - axes.height - 8, title);
}

}  // namespace

int main() {
  const bearing::Arrangement set = spindle();
  const auto computed = [&](double n) {
    return solve_arrangement(set, {.speed = n * rpm}).position / um;
  };
  const auto published = [](double n) {
    return shaft::kinematic_displacement_um(n, 1.28e-3, 0.697, 5.3e-4);
  };
  std::vector<shaft::DisplacementPoint> curve;
  for (int n = 250; n <= 10000; n += 250) curve.push_back({n * rpm, computed(n) * um});
  const shaft::KinematicLaw law = shaft::fit_kinematic_law(curve).law;
  const auto fitted = [&](double n) {
    return shaft::kinematic_displacement_um(n, law.A, law.B, law.C);
  };

  constexpr std::string_view black = "stroke=\"#222\" stroke-width=\"2\"";
  constexpr std::string_view blue = "stroke=\"#06c\" stroke-width=\"2\"";
  constexpr std::string_view red = "stroke=\"#c30\" stroke-width=\"2\" stroke-dasharray=\"7 5\"";
  fmt::print(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 520\" "
      "font-family=\"sans-serif\" "
      "font-size=\"13\">\n<rect width=\"640\" height=\"520\" fill=\"white\"/>\n");
  const Axes displacement{60, 290, 560, 250, 13.0, 0.0};
  frame(displacement, 2.0, "axial displacement [um] against speed [rpm]");
  line(displacement, black, computed);
  line(displacement, blue, published);
  line(displacement, red, fitted);
  const Axes difference{60, 480, 560, 120, 0.4, -0.2};
  frame(difference, 0.2, "difference from the computed spindle [um]");
  line(difference, blue, [&](double n) { return published(n) - computed(n); });
  line(difference, red, [&](double n) { return fitted(n) - computed(n); });
  double y = 70;
  for (const auto& [style, words] : {std::pair{black, "computed: two bearings against one, 1500 N"},
                                     {blue, "the published law"},
                                     {red, "the law fitted to the computed spindle"}}) {
    fmt::print("<path {} d=\"M 80 {} h 36\"/><text x=\"124\" y=\"{}\">{}</text>\n", style, y - 4, y,
               words);
    y += 20;
  }
  fmt::print("</svg>\n");
  return 0;
}
