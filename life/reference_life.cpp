#include "life/reference_life.h"

#include <cmath>
#include <cstddef>

#include "bearing/contact_pressure.h"
#include "life/load_rating.h"

namespace raceway::life {
namespace {

constexpr double turning = 3.0, standing = 10.0 / 3.0;

}  // namespace

RaceRatings race_ratings(const bearing::BearingGeometry& g, double load_rating) {
  if (!(g.contact_angle <= steepest_radial_angle + 1e-9)) return {};
  const double cosine = std::cos(g.contact_angle), gamma = g.diameter_ratio() * cosine;
  const double grooves = g.inner_conformity * (2.0 * g.outer_conformity - 1.0) /
                         (g.outer_conformity * (2.0 * g.inner_conformity - 1.0));
  const double T = 1.044 * std::pow((1.0 - gamma) / (1.0 + gamma), 1.72) * std::pow(grooves, 0.41);
  const double share = load_rating / (g.ball_count * cosine);
  return {.inner = share / 0.407 * std::pow(1.0 + std::pow(T, standing), 0.3),
          .outer = share / 0.389 * std::pow(1.0 + std::pow(T, -standing), 0.3)};
}

double reference_life(const RaceRatings& ratings, double inner_mean, double outer_mean) {
  return std::pow(std::pow(inner_mean / ratings.inner, standing) +
                      std::pow(outer_mean / ratings.outer, standing),
                  -0.9);
}

double reference_life(const RaceRatings& ratings, const bearing::Balls& balls) {
  double inner = 0.0, outer = 0.0;
  for (std::size_t k = 0; k < balls.distinct().size(); ++k) {
    const bearing::BallEquilibrium& ball = balls.distinct()[k];
    inner += balls.weight(k) * std::pow(ball.inner_load, turning);
    outer += balls.weight(k) * std::pow(ball.outer_load, standing);
  }
  const auto count = static_cast<double>(balls.size());
  return reference_life(ratings, std::cbrt(inner / count), std::pow(outer / count, 1.0 / standing));
}

double reference_load(double load_rating, double life) { return load_rating / std::cbrt(life); }

double static_safety(double peak_pressure) {
  const double ratio = bearing::static_limit_pressure / peak_pressure;
  return ratio * ratio * ratio;
}

}  // namespace raceway::life
