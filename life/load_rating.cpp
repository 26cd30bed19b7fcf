#include "life/load_rating.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace raceway::life {
namespace {

// At γ = 0.01, 0.02, ... 0.40.
constexpr std::array rating_factors{29.1, 35.8, 40.3, 43.8, 46.7, 49.1, 51.1, 52.8, 54.3, 55.5,
                                    56.6, 57.5, 58.2, 58.8, 59.3, 59.6, 59.8, 59.9, 60.0, 59.9,
                                    59.8, 59.6, 59.3, 59.0, 58.6, 58.2, 57.7, 57.1, 56.6, 56.0,
                                    55.3, 54.6, 53.9, 53.2, 52.4, 51.7, 50.9, 50.0, 49.2, 48.4};

constexpr double rounding = 1e-9;  // of an angle or a ratio at the end of its range

}  // namespace

double rating_factor(double gamma) {
  const double at = 100.0 * gamma - 1.0;
  constexpr double last = rating_factors.size() - 1;
  if (!(at >= -rounding && at <= last + rounding)) return unset;
  const double inside = std::fmin(std::fmax(at, 0.0), last);
  const auto k = static_cast<std::size_t>(std::fmin(inside, last - 1.0));
  return rating_factors[k] +
         (inside - static_cast<double>(k)) * (rating_factors[k + 1] - rating_factors[k]);
}

double dynamic_load_rating(const bearing::BearingGeometry& g) {
  if (g.contact_angle > steepest_radial_angle + rounding) return unset;
  const double cosine = std::cos(g.contact_angle), diameter = g.ball_diameter / mm;
  const double size = diameter <= 25.4 ? std::pow(diameter, 1.8) : 3.647 * std::pow(diameter, 1.4);
  return 1.3 * rating_factor(g.diameter_ratio() * cosine) * std::pow(cosine, 0.7) *
         std::pow(g.ball_count, 2.0 / 3.0) * size;
}

}  // namespace raceway::life
