#include "life/roller_life.h"

#include <cmath>
#include <cstdlib>

namespace raceway::life {
namespace {

constexpr double weibull = 4.5, turning_ring = 4.0;
constexpr double line_contact_factor = 0.83;  // λ or ν of ISO/TS 16281
constexpr auto laminae = static_cast<double>(bearing::lamina_count);

/// ((1-γ)/(1+γ))^(143/108), inner race over outer race.
double race_ratio(double gamma) { return std::pow((1.0 - gamma) / (1.0 + gamma), 143.0 / 108.0); }

double mean(const bearing::RollerEquilibrium& e, std::size_t lamina, bool inner, double exponent) {
  double sum = 0.0;
  for (const bearing::LoadedRoller& r : e.rollers)
    sum += std::pow((inner ? r.inner_laminae : r.outer_laminae)[lamina], exponent);
  return std::pow(sum / static_cast<double>(e.rollers.size()), 1.0 / exponent);
}

}  // namespace

double roller_rating_factor(double gamma) {
  return 207.9 * line_contact_factor * std::pow(gamma, 2.0 / 9.0) *
         std::pow(1.0 - gamma, 29.0 / 27.0) / std::pow(1.0 + gamma, 0.25) *
         std::pow(1.0 + std::pow(1.04 * race_ratio(gamma), weibull), -2.0 / 9.0);
}

double dynamic_load_rating(const bearing::RollerGeometry& g) {
  return 1.1 * roller_rating_factor(g.diameter_ratio()) *
         std::pow(g.roller_length / mm, 7.0 / 9.0) * std::pow(g.roller_count, 0.75) *
         std::pow(g.roller_diameter / mm, 29.0 / 27.0);
}

double static_load_rating(const bearing::RollerGeometry& g) {
  if (!std::isnan(g.static_load_rating)) return g.static_load_rating;
  return 44.0 * (1.0 - g.diameter_ratio()) * g.roller_count * (g.roller_length / mm) *
         (g.roller_diameter / mm);
}

double fatigue_load(const bearing::RollerGeometry& g) {
  constexpr double reference_diameter = 100 * mm;
  const double size = g.pitch_diameter > reference_diameter
                          ? std::pow(reference_diameter / g.pitch_diameter, 0.3)
                          : 1.0;
  return static_load_rating(g) / 8.2 * size;
}

RollerRatings race_ratings(const bearing::RollerGeometry& g, double load_rating) {
  const double T = std::pow(1.038 * race_ratio(g.diameter_ratio()), weibull);
  const double share = load_rating / (line_contact_factor * g.roller_count);
  return {.inner = share / 0.378 * std::pow(1.0 + T, 2.0 / 9.0),
          .outer = share / 0.364 * std::pow(1.0 + 1.0 / T, 2.0 / 9.0)};
}

double edge_factor(std::size_t lamina) {
  const double distance = std::abs(2.0 * (static_cast<double>(lamina) + 1.0) - laminae - 1.0);
  if (distance == 0.0) return 1.0;
  return 1.0 - 0.01 / std::log(1.985 * distance / (2.0 * laminae - 2.0));
}

double reference_life(const RollerRatings& ratings, const bearing::RollerEquilibrium& e,
                      bool edges) {
  if (!e.report.converged()) return unset;
  const double slice = std::pow(laminae, -7.0 / 9.0);
  double sum = 0.0;
  for (std::size_t k = 0; k < bearing::lamina_count; ++k) {
    const double f = edges ? edge_factor(k) : 1.0;
    sum += std::pow(f * mean(e, k, true, turning_ring) / (slice * ratings.inner), weibull) +
           std::pow(f * mean(e, k, false, weibull) / (slice * ratings.outer), weibull);
  }
  return std::pow(sum, -8.0 / 9.0);
}

double roller_reference_load(double load_rating, double life) {
  return load_rating / std::pow(life, 0.3);
}

double roller_rating_life(double load_rating, double load) {
  return std::pow(load_rating / load, 10.0 / 3.0);
}

double roller_static_safety(double peak_pressure) {
  const double ratio = bearing::static_limit_pressure_of_lines / peak_pressure;
  return ratio * ratio;
}

}  // namespace raceway::life
