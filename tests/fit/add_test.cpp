#include "verdict/add.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "effects/catalogue.h"
#include "effects/formula.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

namespace raceway::fit {
namespace {

using testing::HasSubstr;

DataSet measured_with_drag(double lubricant_drag) {
  Model truth = synthetic_model();
  effects::Effect effect;
  effect.description = effects::find("lubricant-drag");
  effect.values = {lubricant_drag};
  truth.effects.push_back(effect);
  std::mt19937 random(1);
  DataSet data = factorial_plan({600, 1500, 3500, 7000, 11000, 16000}, {250, 600, 1400, 3000},
                                {25, 35, 45, 55, 65});
  measure(truth, 0.0, random, data);
  std::normal_distribution<double> gauss;
  for (Row& row : data.rows) row.measured *= 1.0 + 0.02 * gauss(random);
  return data;
}

const std::vector<std::string> lubricant_drag{"lubricant-drag"};

TEST(Add, CalibratesTheEffectTogetherWithTheBase) {
  const verdict::AddResult result =
      add(synthetic_model(), lubricant_drag, measured_with_drag(40.0));
  ASSERT_TRUE(result.calibration.converged());
  EXPECT_FALSE(result.refused) << result.reason;
  const Model& model = model_of(result.calibration);
  ASSERT_EQ(model.effects.size(), 1U);
  EXPECT_NEAR(model.effects[0].values[0], 40.0, 3.0);
  EXPECT_NEAR(model.law_values[0], 1.5, 0.03);
  EXPECT_LT(result.channels[0].after.rmse, 0.7 * result.channels[0].before.rmse);
  EXPECT_LT(result.channels[0].rmse_held_out_after, 0.7 * result.channels[0].rmse_held_out_before);
  EXPECT_GE(result.hold_out.size(), 3U);
}

TEST(Add, RefusesAnEffectThatIsNotThere) {
  const verdict::AddResult result = add(synthetic_model(), lubricant_drag, measured_with_drag(0.0));
  EXPECT_TRUE(result.refused);
  EXPECT_THAT(result.reason, HasSubstr("not better"));
}

TEST(Add, RefusesAnEffectWhereAnotherOneExplainsTheData) {
  // Gyroscopic slip rises with speed as drag does and takes most of the misfit.
  const std::vector<std::string> slip{"gyroscopic-slip"};
  const verdict::AddResult result = add(synthetic_model(), slip, measured_with_drag(40.0));
  EXPECT_TRUE(result.refused);
  EXPECT_LT(result.channels[0].rmse_held_out_after, result.channels[0].rmse_held_out_before);
  EXPECT_THAT(result.reason, HasSubstr("explains these data down to the noise"));
}

TEST(Add, TakesAnEffectOfTheUsersOwnThatStandsInTheModel) {
  Model model = synthetic_model();
  model.effects.push_back(effects::make_effect(
      {.id = "my-drag",
       .title = "",
       .torque_Nmm = "c * (speed_rpm/10000)^2",
       .parameters = {{.name = "c", .unit = "N mm", .value = 0.0, .lower = 0.0}}}));
  const std::vector<std::string> mine{"my-drag"};
  const verdict::AddResult result = add(model, mine, measured_with_drag(40.0));
  EXPECT_FALSE(result.refused) << result.reason;
  ASSERT_EQ(model_of(result.calibration).effects.size(), 1U);
  EXPECT_NEAR(model_of(result.calibration).effects[0].values[0], 40.0, 3.0);
}

TEST(Add, SaysWhatIsWrongWithTheRequest) {
  const DataSet data = measured_with_drag(40.0);
  const auto message = [&](const Model& model, const std::vector<std::string>& ids) {
    try {
      (void)add(model, ids, data);
    } catch (const std::invalid_argument& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(message(synthetic_model(), {"lubricant-drug"}), HasSubstr("lubricant-drag"));
  EXPECT_THAT(message(synthetic_model(), {"torque-gain"}), HasSubstr("torque"));
  EXPECT_THAT(message(synthetic_model(), {"torque-time-drift"}), HasSubstr("time"));
  EXPECT_THAT(
      message(model_of(add(synthetic_model(), lubricant_drag, data).calibration), lubricant_drag),
      HasSubstr("already"));
  EXPECT_THAT(message(synthetic_model(), {}), HasSubstr("no effect"));
  Model oil_air = synthetic_model();
  oil_air.supply = friction::Supply::oil_air;
  EXPECT_EQ(message(oil_air, lubricant_drag),
            "lubricant-drag: the bearing is lubricated by oil-air, but this effect needs an oil "
            "jet or an oil bath");
}

}  // namespace
}  // namespace raceway::fit
