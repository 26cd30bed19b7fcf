#include "tolerance/thinned_record.h"

#include <gmock/gmock.h>

#include "correction/series.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

MadeRecord at_1_Hz() {
  MadeRecord made(34 * 3600, 1);
  made.with("speed_rpm", [](double t) { return stepped_speed(t, 3700); })
      .with("front_temperature_C", [](double t) { return 25 + 8 * std::sin(t / 5000); })
      .with("displacement_z_um", [](double t) { return std::cos(t / 9000); });
  return made;
}

TEST(ThinnedRecord, AFewRowsStayAsTheyAre) {
  MadeRecord made(34 * 3600, 30);
  made.with("displacement_z_um", [](double t) { return t; });
  const auto record = std::make_shared<const record::Record>(made.record);
  EXPECT_EQ(tolerance::for_search(record), record);
}

/// Temperatures in straight lines, speeds held: what a lag makes of them is what it made of all.
TEST(ThinnedRecord, ALagAnswersAsItDidToAllRows) {
  const MadeRecord made = at_1_Hz();
  const auto thin = tolerance::for_search(std::make_shared<const record::Record>(made.record));
  EXPECT_GT(thin->rows(), 7000U);
  EXPECT_LT(thin->rows(), 9000U);
  const Series all(made.record), some(*thin);
  for (const char* name : {"speed_rpm", "front_temperature_C"}) {
    const Input input{.name = name, .columns = {record::series_channel(name)}};
    const Series::Values a = all.lag(input, 1800.0, {}), b = some.lag(input, 1800.0, {});
    const double range = *std::max_element(a->begin(), a->end());
    const std::span<const double> time = thin->values(record::time);
    for (std::size_t k = 0; k < time.size(); k += 37) {
      const auto row = static_cast<std::size_t>(std::lround(time[k]));
      EXPECT_NEAR((*b)[k], (*a)[row], 5e-3 * range) << name << " at " << time[k];
    }
  }
  const std::span<const double> read = thin->values(*record::series_channel("displacement_z_um"));
  EXPECT_NEAR(read[4000] / um, std::cos(thin->value(record::time, 4000) / 9000), 1e-6);
}

TEST(ThinnedRecord, NoMeanIsOverTwoRuns) {
  MadeRecord made = at_1_Hz();
  std::vector<double> run(made.time.size(), 0.0);
  for (std::size_t k = 50000; k < run.size(); ++k) run[k] = 1.0;
  made.record.runs = {"a", "b"};
  made.record.set(record::run, run);
  const auto thin = tolerance::for_search(std::make_shared<const record::Record>(made.record));
  for (std::size_t k = 0; k < thin->rows(); ++k)
    EXPECT_EQ(thin->run_of(k), thin->value(record::time, k) < 50000.0 ? 0 : 1) << k;
}

}  // namespace
}  // namespace raceway::correction
