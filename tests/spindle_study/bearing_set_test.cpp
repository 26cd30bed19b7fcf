#include "tests/spindle_study/bearing_set.h"

#include <gmock/gmock.h>

#include "tests/spindle_study/base_spindle.h"

namespace spindle_study {
namespace {

constexpr double um = 1e-6;

// data/reference/spindle_reference.json: set_warm_25deg_0, _8000; tolerance 1e-5 as there.
TEST(SpindleStudySet, WarmSetsOfTheReferenceAreMet) {
  BearingData bearing = base_spindle().bearing;
  bearing.contact_angle = 25.0 * pi / 180.0;
  const BearingSet set(bearing, 2, 1, 400.0);
  const std::vector<RingState> rings(3, {.inner = 15.0, .outer = 10.0});
  const double elongation = 0.21 * steel_expansion * (13.0 - 7.0);
  const SetState still = balance(set, 0.0, rings, elongation);
  EXPECT_NEAR(still.position / um / 6.89383921, 1.0, 1e-5);
  EXPECT_NEAR(still.front_force / 202.452484, 1.0, 1e-5);
  const SetState turning = balance(set, 8000.0 * rpm, rings, elongation);
  EXPECT_NEAR(turning.position / um / 12.208586, 1.0, 1e-5);
  EXPECT_NEAR(turning.front_force / 1294.65978, 1.0, 1e-5);
}

// set_warm_each_bearing_6000
TEST(SpindleStudySet, EachBearingHasItsOwnTemperatures) {
  const BearingSet set(base_spindle().bearing, 2, 1, 300.0);
  const SetState s = balance(set, 6000.0 * rpm, {{14.0, 4.0}, {16.0, 4.0}, {18.0, 5.0}}, 20.0 * um);
  EXPECT_NEAR(s.position / um / 11.5588733, 1.0, 1e-5);
  EXPECT_NEAR(s.bearings[0].force / 492.100813, 1.0, 1e-5);
  EXPECT_NEAR(s.bearings[1].force / 646.779484, 1.0, 1e-5);
  EXPECT_NEAR(s.bearings[2].force / 1138.8803, 1.0, 1e-5);
}

// bearing_conduction_50_46
TEST(SpindleStudySet, BallsConductAsTheReferenceHasIt) {
  const BallBearing bearing(base_spindle().bearing);
  EXPECT_NEAR(contact_conductance(bearing, {.inner_contact = 50.0, .outer_contact = 50.0}, 46.0),
              0.225454689, 1e-5 * 0.2254);
}

TEST(SpindleStudySet, LostPreloadCarriesNothing) {
  const BearingSet set(base_spindle().bearing, 2, 1, 300.0);
  const SetState s = balance(set, 0.0, std::vector<RingState>(3), 100.0 * um);
  EXPECT_NEAR(s.front_force, 0.0, 1e-6);
}

}  // namespace
}  // namespace spindle_study
