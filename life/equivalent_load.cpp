#include "life/equivalent_load.h"

#include <array>
#include <cmath>

#include "life/detail/interpolation.h"
#include "life/load_rating.h"

namespace raceway::life {
namespace {

constexpr std::array relative_loads{0.172, 0.345, 0.689, 1.03, 1.38, 2.07, 3.45, 5.17, 6.89};

struct LoadRow {
  double X;
  std::array<double, 9> Y, e;
};

constexpr LoadRow deep_groove{0.56,
                              {2.30, 1.99, 1.71, 1.55, 1.45, 1.31, 1.15, 1.04, 1.00},
                              {0.19, 0.22, 0.26, 0.28, 0.30, 0.34, 0.38, 0.42, 0.44}};
constexpr LoadRow ten_degrees{0.46,
                              {1.88, 1.71, 1.52, 1.41, 1.34, 1.23, 1.10, 1.01, 1.00},
                              {0.29, 0.32, 0.36, 0.38, 0.40, 0.44, 0.49, 0.54, 0.54}};
constexpr LoadRow fifteen_degrees{0.44,
                                  {1.47, 1.40, 1.30, 1.23, 1.19, 1.12, 1.02, 1.00, 1.00},
                                  {0.38, 0.40, 0.43, 0.46, 0.47, 0.50, 0.55, 0.56, 0.56}};

// From 20 deg on.
constexpr std::array steep_angles{20.0, 25.0, 30.0, 35.0, 40.0, 45.0};
constexpr std::array steep_X{0.43, 0.41, 0.39, 0.37, 0.35, 0.33};
constexpr std::array steep_Y{1.00, 0.87, 0.76, 0.66, 0.57, 0.50};
constexpr std::array steep_e{0.57, 0.68, 0.80, 0.95, 1.14, 1.34};

LoadFactors of_row(const LoadRow& row, double relative_load) {
  return {row.X, between(relative_loads, row.Y, relative_load),
          between(relative_loads, row.e, relative_load)};
}

LoadFactors mixed(const LoadFactors& a, const LoadFactors& b, double share) {
  return {std::lerp(a.X, b.X, share), std::lerp(a.Y, b.Y, share), std::lerp(a.e, b.e, share)};
}

}  // namespace

LoadFactors load_factors(const bearing::BearingGeometry& g, double axial_load) {
  const double angle = g.contact_angle / degree;
  if (!(g.contact_angle <= steepest_radial_angle + 1e-9)) return {unset, unset, unset};
  if (angle >= 20.0)
    return {between(steep_angles, steep_X, angle), between(steep_angles, steep_Y, angle),
            between(steep_angles, steep_e, angle)};
  const double diameter = g.ball_diameter / mm;
  const double relative = std::abs(axial_load) / (g.ball_count * diameter * diameter);
  const LoadFactors deep = of_row(deep_groove, relative), ten = of_row(ten_degrees, relative);
  const LoadFactors fifteen = of_row(fifteen_degrees, relative);
  if (angle <= 5.0) return deep;
  if (angle <= 10.0) return mixed(deep, ten, (angle - 5.0) / 5.0);
  if (angle <= 15.0) return mixed(ten, fifteen, (angle - 10.0) / 5.0);
  return mixed(fifteen, {steep_X[0], steep_Y[0], steep_e[0]}, (angle - 15.0) / 5.0);
}

double equivalent_load(const LoadFactors& factors, double radial_load, double axial_load) {
  const double radial = std::abs(radial_load), axial = std::abs(axial_load);
  return axial > factors.e * radial ? factors.X * radial + factors.Y * axial
                                    : radial + 0.0 * factors.e;  // no number stays none
}

double basic_rating_life(double load_rating, double load) {
  const double ratio = load_rating / load;
  return ratio * ratio * ratio;
}

}  // namespace raceway::life
