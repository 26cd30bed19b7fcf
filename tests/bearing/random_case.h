#pragma once

#include <string>
#include <vector>

#include "bench/robustness_domain.h"
#include "tests/reference_table.h"

namespace raceway::tests {

/// The sizes of data/reference/gmn_sizes.csv.
inline std::vector<robustness::Size> catalogue_sizes() {
  std::vector<robustness::Size> sizes;
  for (const auto& row : reference_table("gmn_sizes.csv"))
    sizes.push_back({.ball_count = static_cast<int>(row["ball_count"]),
                     .ball_diameter = row["ball_diameter_mm"] * mm,
                     .pitch_diameter = row["pitch_diameter_mm"] * mm,
                     .static_load_rating = row["static_load_rating_N"]});
  return sizes;
}

/// A case of the robustness domain, ready to be solved, and what the solver makes of it.
struct SolvedCase {
  bearing::Bearing bearing;
  bearing::OperatingPoint point;
  bearing::EquilibriumOptions options;
  bearing::BearingEquilibrium solved;

  [[nodiscard]] bearing::BearingEquilibrium solve_at(const bearing::OperatingPoint& other) const {
    return solve_bearing_equilibrium(bearing, other, options);
  }
};

/// `count` converged cases under outer control, in which every ball keeps the inner race.
inline std::vector<SolvedCase> random_cases(std::size_t count, std::uint64_t seed) {
  const auto sizes = catalogue_sizes();
  std::vector<SolvedCase> cases;
  for (std::uint64_t index = 0; cases.size() < count && index < 100 * count; ++index) {
    const auto c = robustness::make_case(sizes, bearing::RaceControl::outer, seed, index);
    const bearing::Material balls = index % 3 == 0 ? bearing::silicon_nitride() : bearing::steel();
    SolvedCase made{bearing::Bearing(c.geometry, balls, bearing::steel()), c.point, c.options, {}};
    made.solved = made.solve_at(made.point);
    if (made.solved.report.converged() && made.solved.lost_balls() == 0)
      cases.push_back(std::move(made));
  }
  if (cases.size() < count) throw std::runtime_error("too few cases of the domain converge");
  return cases;
}

}  // namespace raceway::tests
