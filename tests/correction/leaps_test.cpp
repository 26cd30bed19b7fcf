#include "correction/leaps.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

/// A body of 40 um that warms up and cools down over hours, read with a noise of 0.3 um, with a
/// leap of `size` at 31 000 s.
MadeRecord slow_machine(double size, double sampling) {
  MadeRecord made(80000, sampling);
  std::mt19937_64 engine(3);
  std::normal_distribution<double> noise(0.0, 0.3);
  made.with("speed_rpm", [](double t) { return t < 40000 ? 6000.0 : 0.0; })
      .with("displacement_z_um", [&](double t) {
        const double body =
            t < 40000 ? 40 * (1 - std::exp(-t / 5000)) : 40 * std::exp(-(t - 40000) / 5000);
        return body + noise(engine) + (t >= 31000 ? size : 0.0);
      });
  return made;
}

const record::Channel& leaping_z() { return *record::series_channel("displacement_z_um"); }

TEST(Leaps, SlowStructureIsNone) {
  EXPECT_THAT(leaps(slow_machine(0.0, 30).record, leaping_z()), testing::SizeIs(testing::Le(2U)));
}

TEST(Leaps, AreFoundWhereTheyAre) {
  for (const double size : {2.5, -4.0}) {
    const std::vector<double> found = leaps(slow_machine(size, 30).record, leaping_z());
    ASSERT_FALSE(found.empty()) << size;
    EXPECT_THAT(found, testing::Contains(testing::DoubleNear(31000, 60))) << size;
  }
}

TEST(Leaps, OfSparseReadingsTheyHaveToBeLarger) {
  EXPECT_THAT(leaps(slow_machine(6.0, 300).record, leaping_z()),
              testing::Contains(testing::DoubleNear(31000, 300)));
}

TEST(Leaps, AChangeOfTheSpeedIsNone) {
  for (const double t : leaps(slow_machine(0.0, 30).record, leaping_z()))
    EXPECT_GT(std::abs(t - 40000), 600);
}

TEST(Leaps, AFewReadingsHaveNone) {
  EXPECT_TRUE(leaps(slow_machine(5.0, 20000).record, leaping_z()).empty());
}

}  // namespace
}  // namespace raceway::correction
