#include "bearing/contact_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/bearing/random_case.h"

namespace raceway::bearing {
namespace {

robustness::Case inner_case(std::uint64_t index) {
  static const auto sizes = tests::catalogue_sizes();
  return robustness::make_case(sizes, RaceControl::inner, 1, index);
}

std::vector<ScannedSet> scanned(const RingSystem& system, const OperatingPoint& point) {
  return scan_contacts(system, std::atan2(point.radial_load_z, point.radial_load));
}

// Balances that statics and the paths miss: three balls kept along the load with a pair beyond a
// right angle, and two pairs kept 130 and 144 deg from it.
TEST(ContactScan, LeadsToTheBalanceOfPointsThatNothingElseFinds) {
  for (const std::uint64_t index : {1590, 17080}) {
    const auto c = inner_case(index);
    const Bearing bearing(c.geometry, steel(), steel());
    const auto solved = solve_bearing_equilibrium(bearing, c.point, c.options);
    ASSERT_TRUE(solved.report.converged()) << "case " << index;
    std::vector<InnerContact> answer;
    for (const BallEquilibrium& ball : solved.balls.distinct())
      answer.push_back(ball.inner_load > 0.0 ? InnerContact::kept : InnerContact::lost);

    RingWorkspace workspace;
    RingSystem system(bearing, c.point, c.options, workspace);
    std::vector<ScannedSet> sets = scanned(system, c.point);
    const auto found = std::find_if(sets.begin(), sets.end(),
                                    [&](const ScannedSet& set) { return set.contacts == answer; });
    ASSERT_NE(found, sets.end()) << "case " << index;
    // Among the first of a hundred, and near enough for Newton's method.
    EXPECT_LT(found - sets.begin(), 10) << "case " << index;
    system.contacts = found->contacts;
    ASSERT_TRUE(system.newton(found->state)) << "case " << index;
    EXPECT_NEAR(found->state.ring[0] / solved.displacement[0], 1.0, 1e-9) << "case " << index;
    EXPECT_NEAR(found->state.ring[1] / solved.displacement[1], 1.0, 1e-9) << "case " << index;
  }
}

TEST(ContactScan, ReturnsSetsByImbalanceWithOneContactAndOnePlaceForEachBall) {
  for (const std::uint64_t index : {0, 623, 1590, 3463}) {
    const auto c = inner_case(index);
    const Bearing bearing(c.geometry, steel(), steel());
    RingWorkspace workspace;
    const RingSystem system(bearing, c.point, c.options, workspace);
    const std::vector<ScannedSet> sets = scanned(system, c.point);
    ASSERT_GT(sets.size(), 10u) << "case " << index;
    EXPECT_TRUE(std::is_sorted(
        sets.begin(), sets.end(),
        [](const ScannedSet& a, const ScannedSet& b) { return a.imbalance < b.imbalance; }));
    for (const ScannedSet& set : sets) {
      EXPECT_TRUE(std::isfinite(set.imbalance) && set.imbalance >= 0.0);
      ASSERT_EQ(set.contacts.size(), system.balls_used());
      ASSERT_EQ(set.state.balls.size(), system.balls_used());
      EXPECT_TRUE(set.state.ring.allFinite());
      EXPECT_EQ(std::count(set.contacts.begin(), set.contacts.end(), InnerContact::automatic), 0);
      for (const Plane& ball : set.state.balls)
        EXPECT_GT(std::hypot(ball.axial, ball.radial), system.constants().outer_radius);
    }
  }
}

// Starts of one set are worth returning twice only where the later one came much nearer.
TEST(ContactScan, ReturnsNoSetAgainThatIsNotMuchNearerToBalance) {
  const auto c = inner_case(1590);
  const Bearing bearing(c.geometry, steel(), steel());
  RingWorkspace workspace;
  const RingSystem system(bearing, c.point, c.options, workspace);
  const std::vector<ScannedSet> sets = scanned(system, c.point);
  for (std::size_t i = 0; i < sets.size(); ++i)
    for (std::size_t j = i + 1; j < sets.size(); ++j) {
      if (sets[i].contacts != sets[j].contacts) continue;
      EXPECT_LE(sets[i].imbalance, 0.7 * sets[j].imbalance * (1.0 + 1e-12)) << i << " and " << j;
    }
}

// A load turned by one ball gives the same sets, turned by one ball. Both loads are between the
// balls, so that all of them are unknowns.
TEST(ContactScan, TurnsWithTheLoad) {
  auto c = inner_case(1590);
  const Bearing bearing(c.geometry, steel(), steel());
  const double radial = c.point.radial_load;
  const int balls = c.geometry.ball_count;
  std::vector<std::vector<ScannedSet>> of_load;
  for (const double direction : {0.1, 0.1 + azimuth_of_ball(1, balls)}) {
    c.point.radial_load = radial * std::cos(direction);
    c.point.radial_load_z = radial * std::sin(direction);
    RingWorkspace workspace;
    const RingSystem system(bearing, c.point, c.options, workspace);
    of_load.push_back(scan_contacts(system, direction));
  }
  ASSERT_FALSE(of_load[0].empty());
  ASSERT_FALSE(of_load[1].empty());
  const ScannedSet &first = of_load[0].front(), &turned = of_load[1].front();
  EXPECT_NEAR(turned.imbalance / first.imbalance, 1.0, 1e-6);
  std::vector<InnerContact> expected = first.contacts;
  std::rotate(expected.begin(), expected.end() - 1, expected.end());
  EXPECT_EQ(turned.contacts, expected);
}

}  // namespace
}  // namespace raceway::bearing
