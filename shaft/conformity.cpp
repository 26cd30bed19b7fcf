#include "shaft/conformity.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "bearing/bearing_equilibrium.h"

namespace raceway::shaft {
namespace {

using fit::FitStatus;
using record::Bound;

constexpr double conformity_tolerance = 1e-6;  // [1], of the conformity
constexpr double difference_step = 1e-4;       // [1], of the conformity

bearing::Bearing with_conformity(const bearing::Bearing& bearing, double conformity) {
  bearing::BearingGeometry geometry = bearing.geometry();
  geometry.inner_conformity = geometry.outer_conformity = conformity;
  return {geometry, bearing.balls(), bearing.rings()};
}

double log_rigidity(const bearing::Bearing& bearing, double conformity, double preload) {
  return std::log(pair_rigidity(with_conformity(bearing, conformity), preload));
}

}  // namespace

double pair_rigidity(const bearing::Bearing& bearing, double preload) {
  const auto solved = solve_bearing_equilibrium(bearing, {.axial_load = preload});
  return solved.report.converged() ? 2.0 * solved.stiffness(0, 0) : unset;
}

ConformityFit fit_conformity(const bearing::Bearing& bearing,
                             std::span<const PairRigidity> classes) {
  if (classes.empty())
    throw std::invalid_argument("no preload class has a rigidity, so there is nothing to fit");
  for (const PairRigidity& c : classes)
    if (!(c.preload > 0.0 && c.printed > 0.0 && std::isfinite(c.preload + c.printed)))
      throw std::invalid_argument(
          fmt::format("preload class {}: preload = {} N, rigidity = {} N/um: both must be positive",
                      c.preload_class, c.preload, c.printed / N_per_um));

  const auto misfit = [&](double conformity) {
    double sum = 0.0;
    for (const PairRigidity& c : classes) {
      const double d = log_rigidity(bearing, conformity, c.preload) - std::log(c.printed);
      sum += d * d;
    }
    return std::isnan(sum) ? std::numeric_limits<double>::infinity() : sum;
  };
  ConformityFit fit;
  // ln(rigidity) falls steadily with the conformity, and alike for all classes: one minimum.
  const auto [best, cost] =
      boost::math::tools::brent_find_minima(misfit, lowest_conformity, highest_conformity, 30);
  if (!std::isfinite(cost)) {
    fit.status = FitStatus::failed;
    return fit;
  }
  fit.status = FitStatus::converged;
  fit.conformity = best;
  if (misfit(lowest_conformity) <= cost || best - lowest_conformity < conformity_tolerance) {
    fit.at_bound = Bound::lower;
    fit.conformity = lowest_conformity;
  } else if (misfit(highest_conformity) <= cost ||
             highest_conformity - best < conformity_tolerance) {
    fit.at_bound = Bound::upper;
    fit.conformity = highest_conformity;
  }
  double squares = 0.0, slopes = 0.0;
  for (const PairRigidity& c : classes) {
    PairRigidity& done = fit.classes.emplace_back(c);
    done.computed = pair_rigidity(with_conformity(bearing, fit.conformity), c.preload);
    const double left = std::log(done.computed / done.printed);
    const double slope = (log_rigidity(bearing, fit.conformity + difference_step, c.preload) -
                          log_rigidity(bearing, fit.conformity - difference_step, c.preload)) /
                         (2.0 * difference_step);
    squares += left * left;
    slopes += slope * slope;
  }
  const auto count = static_cast<double>(classes.size());
  fit.rms = std::sqrt(squares / count);
  if (classes.size() > 1 && fit.at_bound == Bound::none)
    fit.std = std::sqrt(squares / (count - 1.0) / slopes);
  return fit;
}

}  // namespace raceway::shaft
