#include "results/superposition.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/correction_file.h"
#include "files/series_file.h"
#include "results/step_correction.h"
#include "shaft/fit_kinematic_law.h"
#include "tests/places.h"
#include "tests/spindle/base_spindle.h"

namespace raceway::spindle {
namespace {

/// Step responses to 1000 to 10 000 rpm as a correction, and that over a day.
results::Superposition over_a_day(bool coolant_on, bool two_lags) {
  const model::Model model = base_spindle();
  StepOptions options;
  options.inputs.coolant_on = coolant_on;
  std::vector<double> speeds;
  for (int n = 1000; n <= 10000; n += 1000) speeds.push_back(n * rpm);
  const StepResponses responses = step_responses(model, speeds, options);
  std::vector<shaft::DisplacementPoint> curve;
  results::StepCorrectionParts parts{.name = "base spindle", .two_lags = two_lags};
  for (const StepResponse& step : responses.steps) {
    EXPECT_TRUE(step.converged());
    parts.power.push_back({step.speed, step.power_end});
    curve.push_back({.speed = step.speed, .displacement = step.kinematic});
  }
  parts.kinematic = shaft::fit_kinematic_law(curve).law;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("raceway_day_" + std::to_string(static_cast<int>(coolant_on)) +
       std::to_string(static_cast<int>(two_lags)));
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "correction.toml").string();
  results::write_step_correction(
      results::step_correction(results::step_model(responses, parts), path), path, true);
  const files::CorrectionFile written = files::read_correction(path);
  std::filesystem::remove_all(folder);
  const record::Record day = files::read_series(tests::source_dir() + "/data/spindles/day.csv", {},
                                                {&record::time, &record::speed});
  return results::superposition(model, written.models.front(), day, options.inputs);
}

// What the simplification costs: K and T of the power at the end of a step, and none of the way
// there. A bound, not a reference: no other program has run it.
TEST(Superposition, OfStepResponsesFollowsACooledSpindleOverADay) {
  const results::Superposition s = over_a_day(true, false);
  ASSERT_TRUE(s.report.converged());
  EXPECT_GT(s.highest - s.lowest, 45 * um);
  EXPECT_LT(s.rms, 1.5 * um);
  RecordProperty("rms_um", std::to_string(s.rms / um));
}

// The fast lag of a cold start is half the power that falls as the oil thins: a warm spindle does
// not have it again. So two lags fit each step twenty times closer and a day less well than one.
TEST(Superposition, OfOneLagFollowsADayWithoutCoolantCloserThanOfTwo) {
  const results::Superposition one = over_a_day(false, false), two = over_a_day(false, true);
  ASSERT_TRUE(two.report.converged());
  EXPECT_LT(two.rms, 3.0 * um);
  EXPECT_LT(one.rms, 1.5 * um);
  EXPECT_GT(two.rms, one.rms);
}

}  // namespace
}  // namespace raceway::spindle
