#include "fit/noise.h"

#include <gtest/gtest.h>

#include "fit/noise_model.h"
#include "record/repeats.h"
#include "tests/support/rows.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

TEST(Repeats, AreFoundWhereverTheyStandInTheFile) {
  const DataSet data = factorial_plan({1000, 5000}, {300, 600}, {40}, 3);
  const std::vector<record::RepeatGroup> groups = record::find_repeats(data);
  ASSERT_EQ(groups.size(), 4U);
  for (const record::RepeatGroup& group : groups) {
    ASSERT_EQ(group.size(), 3U);
    for (const std::size_t i : group) {
      EXPECT_EQ(data.rows[i].point.speed, data.rows[group[0]].point.speed);
      EXPECT_EQ(data.rows[i].point.axial_load, data.rows[group[0]].point.axial_load);
    }
  }
}

TEST(Repeats, AllowForTheScatterOfASetValueOnly) {
  DataSet data = factorial_plan({5000, 5002, 5050}, {300, 310}, {40});
  EXPECT_EQ(record::find_repeats(data).size(), 2U);  // 5000 and 5002 at either load
  data.rows[1].point.temperature += 1.0;
  EXPECT_EQ(record::find_repeats(data).size(), 1U);
  data.rows[4].inner_ring_temperature = kelvin(45.0);
  EXPECT_TRUE(record::find_repeats(data).empty());
}

TEST(Noise, OfRepeatsIsTheirScatter) {
  std::mt19937 random(3);
  DataSet data = factorial_plan({1000, 2000, 5000, 8000, 10000}, {300, 600, 900}, {30, 50}, 10);
  measure(synthetic_model(), 2.0 * N_mm, random, data);
  const Noise noise = estimate_noise(data, data.measured());
  EXPECT_EQ(noise.source, NoiseSource::repeats);
  EXPECT_EQ(noise.degrees_of_freedom, 270);
  EXPECT_NEAR(noise.rms, 2.0 * N_mm, 0.2 * N_mm);  // 2.3 standard deviations at 270 degrees
}

TEST(Noise, ThatIsDeclaredComesFirst) {
  std::mt19937 random(4);
  DataSet data = factorial_plan({1000, 5000}, {300, 600}, {40}, 3);
  measure(synthetic_model(), 2.0 * N_mm, random, data);
  declare_noise(1.5 * N_mm, data);
  EXPECT_EQ(estimate_noise(data, data.measured()).source, NoiseSource::declared);
  EXPECT_DOUBLE_EQ(estimate_noise(data, data.measured()).rms, 1.5 * N_mm);
  data.noise = NoiseSource::regression;
  EXPECT_EQ(name(estimate_noise(data, data.measured()).source), "regression");
  data.rows[0].std = unset;  // one row without: the declared values do not cover the set
  EXPECT_EQ(estimate_noise(data, data.measured()).source, NoiseSource::repeats);
}

TEST(Noise, IsUnknownWithoutStdAndRepeats) {
  std::mt19937 random(5);
  DataSet data = factorial_plan({1000, 3000, 5000}, {300}, {40});
  measure(synthetic_model(), 2.0 * N_mm, random, data);
  const Noise noise = estimate_noise(data, data.measured());
  EXPECT_EQ(noise.source, NoiseSource::none);
  EXPECT_TRUE(std::isnan(noise.rms));
}

TEST(Noise, CountsTheCoarsenessOfAModel) {
  std::mt19937 random(6);
  DataSet data = factorial_plan({1000, 3000, 5000}, {300}, {40});
  measure(synthetic_model(), 0.0, random, data);
  declare_noise(3.0 * N_mm, data);
  const Record record = data;
  const std::vector<Measured> channels{{.channel = &data.measured()}};
  const ChannelReadings readings =
      readings_of(record, observe(channels, record, record.values(data.measured())), 0);
  NoiseModel noise = known_noise_model(readings);
  add_model_error(noise, readings, 4.0 * N_mm);
  EXPECT_NEAR(noise.rms, 5.0 * N_mm, 1e-12);
  EXPECT_NEAR(noise.whitening.std()[1], 5.0 * N_mm, 1e-12);
}

}  // namespace
}  // namespace raceway::fit
