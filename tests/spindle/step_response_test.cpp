#include "spindle/step_response.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/spindle/base_spindle.h"
#include "tests/spindle/reference.h"

namespace raceway::spindle {
namespace {

/// The steps of a case, simulated once for all tests.
const StepResponses& responses_of(const nlohmann::json& c) {
  static std::map<std::string, StepResponses> known;
  const auto found = known.find(c.at("id"));
  if (found != known.end()) return found->second;
  std::vector<double> speeds;
  for (const nlohmann::json& row : c["outputs"]["rows"])
    speeds.push_back(row["rpm"].get<double>() * rpm);
  StepOptions options;
  options.duration = 3600.0 * c["inputs"].value("hours", 4.0);
  options.inputs.coolant_on = c["inputs"].value("coolant_on", true);
  return known[c.at("id")] = step_responses(base_spindle(), speeds, options);
}

const StepResponses& cooled_responses() { return responses_of(reference("step_responses_cooled")); }

/// A ratio to a number of the reference.
double ratio(double value, const nlohmann::json& expected) {
  return value / expected.get<double>();
}

// Another program, on another mesh; the tolerance is that of the case.
TEST(StepResponses, OfACooledSpindleAreThoseOfAnotherProgram) {
  for (const nlohmann::json& c : references("step_responses_")) {
    const double tolerance = c["tolerance_rel"];
    const nlohmann::json rows = c["outputs"]["rows"];
    ASSERT_EQ(responses_of(c).steps.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const StepResponse& step = responses_of(c).steps[k];
      const nlohmann::json& row = rows[k];
      ASSERT_TRUE(step.converged()) << row["rpm"];
      EXPECT_NEAR(ratio(step.power_end, row["P_end_W"]), 1.0, tolerance) << row["rpm"];
      EXPECT_NEAR(ratio(step.kinematic / um, row["kinematic_um"]), 1.0, tolerance) << row["rpm"];
      EXPECT_NEAR(ratio(step.fit.one.gain / um, row["K_um"]), 1.0, tolerance) << row["rpm"];
      EXPECT_NEAR(ratio(step.fit.one.time_constant / one_minute, row["T_min"]), 1.0, tolerance)
          << row["rpm"];
      EXPECT_NEAR(ratio(step.end / um, row["end_um"]), 1.0, tolerance) << row["rpm"];
      const nlohmann::json& force = row["front_force_N"];
      EXPECT_NEAR(ratio(step.front_force, force["cold"]), 1.0, tolerance) << row["rpm"];
      // The worst moment is that after some minutes, not the steady one.
      EXPECT_GT(step.highest_force, (1.0 - tolerance) * force["10 min"].get<double>());
      if (force["10 min"] > force["end"]) {
        EXPECT_GT(step.highest_force, 1.02 * (1.0 - tolerance) * force["end"].get<double>());
      }
      EXPECT_GT(step.power_start, step.power_end) << "the oil thins";
    }
    const StepResponse& fastest = responses_of(c).steps.back();
    EXPECT_GT(fastest.power_start, 1.3 * fastest.power_end);
  }
}

TEST(StepResponses, HaveTheLawsOfAnotherProgram) {
  const nlohmann::json c = reference("step_responses_cooled");
  const double tolerance = c["tolerance_rel"];
  const PowerLaws laws = fit_power_laws(at_powers(cooled_responses().steps));
  const nlohmann::json out = c["outputs"];
  EXPECT_NEAR(ratio(laws.gain_line.slope / um, out["K_of_P"]["slope_um_W"]), 1.0, tolerance);
  EXPECT_NEAR(ratio(laws.time_line.offset / one_minute, out["T_of_P"]["offset_min"]), 1.0,
              tolerance);
  EXPECT_NEAR(laws.gain_power.exponent, 0.82, 0.03);
  EXPECT_NEAR(laws.time_power.exponent, -0.23, 0.03);
}

// A hot spindle at rest loses what it has gained: K of the way back is that of the way out.
TEST(StepResponses, CoolDownFromTheFastestOne) {
  const StepResponse& fastest = cooled_responses().steps.back();
  const StepFit& down = cooled_responses().cool_down.fit;
  EXPECT_NEAR(down.one.gain / fastest.end, 1.0, 0.05);
  EXPECT_GT(down.one.time_constant, fastest.fit.one.time_constant);
  EXPECT_TRUE(down.settled);
}

TEST(StepResponses, LeaveMoreToOneLagWithoutCoolant) {
  StepOptions options;
  options.inputs.coolant_on = false;
  const std::vector<double> speeds{6000 * rpm};
  const StepResponses uncooled = step_responses(base_spindle(), speeds, options);
  ASSERT_TRUE(uncooled.steps.front().converged());
  const StepFit& fit = uncooled.steps.front().fit;
  EXPECT_GT(fit.rms, 3.0 * cooled_responses().steps[2].fit.rms);
  EXPECT_LT(fit.rms_of_two, 0.5 * fit.rms);
  EXPECT_TRUE(need_two(uncooled.steps));
  // At rest nothing stirs the air at the shaft: both lags of the step fall slower than they rose.
  EXPECT_GT(uncooled.cool_down.fast, fit.fast.time_constant);
  EXPECT_GT(uncooled.cool_down.slow, fit.slow.time_constant);
}

TEST(StepResponses, DoNotDependOnTheirNumberOrOrder) {
  const std::vector<double> turned{10000 * rpm, 2000 * rpm};
  StepOptions options;
  options.cool_down = false;
  const StepResponses two = step_responses(base_spindle(), turned, options);
  EXPECT_EQ(two.steps[1].fit.one.gain, cooled_responses().steps.front().fit.one.gain);
  EXPECT_EQ(two.steps[0].fit.one.gain, cooled_responses().steps.back().fit.one.gain);
  EXPECT_FALSE(two.cool_down.known());
}

/// What a load does at once and what follows lead from one steady state to the other.
TEST(LoadSteps, LeadFromOneSteadyStateToTheOther) {
  StepOptions options;
  options.duration = 2 * 3600.0;
  const std::vector<double> speeds{3000 * rpm, 8000 * rpm};
  for (const auto& [stepped, loads] :
       {std::pair{Stepped::axial_load, std::vector<double>{-400, 600}},
        std::pair{Stepped::radial_load, std::vector<double>{800}}}) {
    const std::vector<LoadSteps> groups =
        load_step_responses(base_spindle(), stepped, speeds, loads, options);
    ASSERT_EQ(groups.size(), 2U);
    Simulator simulator(base_spindle());
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      Report report;
      const double before = simulator.steady({.speed = speeds[k]}, report).displacement;
      ASSERT_EQ(groups[k].steps.size(), loads.size());
      for (std::size_t j = 0; j < loads.size(); ++j) {
        const StepResponse& step = groups[k].steps[j];
        ASSERT_TRUE(step.converged());
        Inputs loaded{.speed = speeds[k]};
        (stepped == Stepped::axial_load ? loaded.axial_load : loaded.radial_load) = loads[j];
        const double way = simulator.steady(loaded, report).displacement - before;
        EXPECT_NEAR((step.kinematic + step.end) / um, way / um, 0.03 + 0.02 * std::abs(way / um));
        EXPECT_NEAR(step.fit.one.gain / um, step.end / um, 0.03 + 0.1 * std::abs(step.end / um));
        EXPECT_EQ(step.load, loads[j]);
      }
      // The axial load changes the heat of the balls, which leaves them within minutes.
      if (stepped == Stepped::axial_load) {
        EXPECT_GT(groups[k].unloaded, 30.0);
        EXPECT_LT(groups[k].unloaded, 1800.0);
      }
    }
  }
}

TEST(LoadSteps, NeedLoadsThatRise) {
  const std::vector<double> speeds{3000 * rpm};
  for (const std::vector<double>& loads : {std::vector<double>{0.0}, {300.0, -300.0}})
    EXPECT_THROW((void)load_step_responses(base_spindle(), Stepped::axial_load, speeds, loads),
                 std::invalid_argument);
}

TEST(StepResponses, NeedASpeedAndThreeRows) {
  const auto refusal = [](double speed, double duration) -> std::string {
    try {
      StepOptions options;
      options.duration = duration;
      (void)step_responses(base_spindle(), std::vector<double>{speed}, options);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_THAT(refusal(0.0, 14400.0), testing::HasSubstr("above 0 rpm"));
  EXPECT_THAT(refusal(100.0, 300.0), testing::HasSubstr("three rows"));
}

}  // namespace
}  // namespace raceway::spindle
