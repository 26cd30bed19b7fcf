#include "correction/own_effect.h"

#include <gmock/gmock.h>

#include "correction/correction_subject.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

MadeRecord day_of_steps() {
  MadeRecord made(20000, 10);
  made.with("speed_rpm", [](double t) { return stepped_speed(t, 2500); })
      .with("front_temperature_C", [](double t) { return 21 + t / 2000; })
      .with("displacement_z_um", [](double) { return 0.0; });
  return made;
}

Effect made_effect(OwnEffect::Given given, std::vector<double> values) {
  Effect e{.id = given.id, .values = std::move(values)};
  e.own = std::make_shared<const OwnEffect>(std::move(given));
  e.off = e.values.front() == 0.0;
  return e;
}

Model model_of_effect(Effect e) {
  Model m{.name = "z", .displacement = record::series_channel("displacement_z_um")};
  m.effects.push_back(std::move(e));
  return m;
}

std::vector<double> displacement_of(const Model& m, const record::Record& record) {
  const Series series(record);
  std::vector<double> y(record.rows());
  simulate(m, series, y);
  return y;
}

TEST(OwnEffect, AtOnceIsItsGainTimesItsFormula) {
  const MadeRecord made = day_of_steps();
  const Model m =
      model_of_effect(made_effect({.id = "mine",
                                   .formula = "(speed_rpm/1000)^p",
                                   .parameters = {{.name = "p", .unit = "1", .value = 1.5}}},
                                  {0.25, 1.5}));
  const std::vector<double> y = displacement_of(m, made.record);
  for (const std::size_t k : {10U, 400U, 1300U}) {
    const double n = stepped_speed(made.time[k], 2500);
    EXPECT_NEAR(y[k], 0.25e-6 * std::pow(n / 1000, 1.5), 1e-15) << k;
  }
}

/// Of a column alone it is what a channel of that column is.
TEST(OwnEffect, WithATimeConstantItLagsAsAChannelDoes) {
  const MadeRecord made = day_of_steps();
  const Model own = model_of_effect(
      made_effect({.id = "mine", .formula = "front_temperature_C", .lags = true}, {3.0, 900.0}));
  Model plain{.name = "z", .displacement = own.displacement};
  plain.channels.push_back({.name = "front",
                            .input = {.columns = {record::series_channel("front_temperature_C")}},
                            .sections = {{3e-6, 900.0}}});
  const std::vector<double> a = displacement_of(own, made.record),
                            b = displacement_of(plain, made.record);
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-16) << k;
}

TEST(OwnEffect, WaitsAsACandidateUntilItIsSwitchedOn) {
  const MadeRecord made = day_of_steps();
  const CorrectionSubject plain(model_of_effect(
      made_effect({.id = "mine", .formula = "speed_rpm", .lags = true}, {0.0, 900.0})));
  EXPECT_THAT(plain.free(), testing::ElementsAre("offset"));
  const auto informed = plain.informed_by(made.record);
  const std::vector<fit::Candidate> all = informed->candidates();
  const auto mine =
      std::find_if(all.begin(), all.end(), [](const fit::Candidate& c) { return c.id == "mine"; });
  ASSERT_NE(mine, all.end());
  EXPECT_EQ(mine->parameters.at(0).name, "mine.gain");
  EXPECT_EQ(mine->parameters.at(0).neutral, 0.0);
  const std::vector<std::string> ids{"mine"};
  EXPECT_THAT(informed->with_candidates(ids)->free(),
              testing::ElementsAre("offset", "mine.gain", "mine.time_constant_s"));
}

TEST(OwnEffect, SaysWhatIsWrongWithItsFormula) {
  const auto wrong = [](const std::string& formula) {
    try {
      const OwnEffect effect({.id = "mine", .formula = formula});
      return std::string();
    } catch (const record::FormulaError& e) {
      return std::string(e.what());
    }
  };
  EXPECT_EQ(wrong("speed_rpm * a_temperature_C + 2e-3"), "");
  EXPECT_THAT(wrong("speed_rpm * c"), testing::HasSubstr("\"c\" is not known"));
  EXPECT_THAT(wrong("speed_rpm ** 2"), testing::HasSubstr("x^2"));
  EXPECT_THAT(wrong("speed_rpm; 2"),
              testing::HasSubstr("a formula is a single expression; remove the ;"));
}

/// A root of what may be negative, say.
TEST(OwnEffect, ARowWithoutANumberIsNamed) {
  const MadeRecord made = day_of_steps();
  const CorrectionSubject subject(
      model_of_effect(made_effect({.id = "mine", .formula = "sqrt(2000 - speed_rpm)"}, {1.0})));
  try {
    subject.require(made.record);
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_THAT(e.what(),
                testing::HasSubstr("the formula of effect mine gives no finite value in"));
  }
}

}  // namespace
}  // namespace raceway::correction
