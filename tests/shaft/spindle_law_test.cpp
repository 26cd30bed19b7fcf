// The law fitted to computed spindles: bearing, arrangement and fit together.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "shaft/fit_kinematic_law.h"
#include "tests/reference_table.h"

namespace raceway::shaft {
namespace {

TEST(SpindleLaw, AgreesWithTheIndependentFitsAndThePublishedCurve) {
  using namespace bearing;
  for (const auto& row : tests::reference_table("kinematic_law.csv")) {
    SCOPED_TRACE(row.place());
    const auto one = std::make_shared<const Bearing>(
        BearingGeometry{.ball_count = static_cast<int>(row["ball_count"]),
                        .ball_diameter = row["ball_diameter_mm"] * mm,
                        .pitch_diameter = row["pitch_diameter_mm"] * mm,
                        .contact_angle = row["contact_angle_deg"] * degree,
                        .inner_conformity = row["conformity"],
                        .outer_conformity = row["conformity"]},
        steel(), steel());
    const Arrangement spindle(
        {.front = {{one}, {one}}, .rear = {{one}}, .preload = PreloadForce{row["preload_N"]}});
    std::vector<DisplacementPoint> curve;
    double from_published = 0.0;  // [um]
    for (double n = row["step_rpm"]; n < 10000.5; n += row["step_rpm"]) {
      const auto solved = solve_arrangement(spindle, {.speed = n * rpm});
      ASSERT_TRUE(solved.report.converged());
      curve.push_back({n * rpm, solved.position});
      from_published +=
          std::abs(solved.position / um - kinematic_displacement_um(n, 1.28e-3, 0.697, 5.3e-4));
    }
    const KinematicLawFit fit = fit_kinematic_law(curve);
    ASSERT_TRUE(fit.converged());
    EXPECT_NEAR(fit.law.A, row["A"], row["A_tolerance"]);
    EXPECT_NEAR(fit.law.B, row["B"], row["B_tolerance"]);
    EXPECT_NEAR(fit.law.C, row["C"], row["C_tolerance"]);
    if (!row.text("mae_um").empty()) {
      EXPECT_NEAR(fit.mae / um, row["mae_um"], row["mae_tolerance_um"]);
    }
    if (!row.text("published_um").empty()) {
      EXPECT_NEAR(from_published / static_cast<double>(curve.size()), row["published_um"],
                  row["published_tolerance_um"]);
    }
  }
}

}  // namespace
}  // namespace raceway::shaft
