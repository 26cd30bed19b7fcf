#include "correction/baseline.h"

#include <gmock/gmock.h>

#include <random>

#include "correction/range.h"
#include "correction/simulation.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

Model bare_model(const std::vector<std::string>& columns) {
  Model m{.name = "z", .displacement = record::series_channel("displacement_z_um")};
  for (const std::string& name : columns)
    m.channels.push_back({.name = name.substr(0, name.find('_')),
                          .input = {.name = name, .columns = {record::series_channel(name)}},
                          .sections = {{1e-6, 900.0}}});
  return m;
}

double slow_wave(double t) { return 5.0 * std::sin(t / 3000.0); }
double slow_rise(double t) { return t / 4000.0; }

TEST(RegressionBaseline, FindsTheCombinationThatMadeARecord) {
  MadeRecord made(40000, 20);
  made.with("a_temperature_C", [](double t) { return 20 + slow_wave(t); })
      .with("b_temperature_C", [](double t) { return 22 + slow_rise(t); })
      .with("displacement_z_um",
            [](double t) { return 4.0 + 3.0 * slow_wave(t) - 2.0 * slow_rise(t); });
  const Identification found =
      regression_baseline(bare_model({"a_temperature_C", "b_temperature_C"}), {}, made.record);
  ASSERT_EQ(found.model.channels.size(), 2U);
  EXPECT_NEAR(found.model.channels[0].feedthrough, 3e-6, 1e-14);
  EXPECT_NEAR(found.model.channels[1].feedthrough, -2e-6, 1e-14);
  EXPECT_NEAR(found.model.offset, 4e-6, 1e-13);
  EXPECT_TRUE(found.model.channels[0].sections.empty());
  EXPECT_TRUE(is_regression(found.model));
  EXPECT_NEAR(found.rms_held_out, 0.0, 1e-12);
  EXPECT_EQ(found.model.range.size(), 2U);
}

TEST(RegressionBaseline, LeavesOutWhatSaysNothingMore) {
  MadeRecord made(40000, 20);
  made.with("a_temperature_C", [](double t) { return 20 + slow_wave(t); })
      .with("twin_temperature_C", [](double t) { return 25 + 2.0 * slow_wave(t); })
      .with("still_temperature_C", [](double) { return 20.0; })
      .with("displacement_z_um", [](double t) { return 3.0 * slow_wave(t); });
  const Identification found = regression_baseline(
      bare_model({"a_temperature_C", "twin_temperature_C", "still_temperature_C"}), {},
      made.record);
  ASSERT_EQ(found.model.channels.size(), 1U);
  EXPECT_THAT(texts(found.messages), testing::Contains(testing::HasSubstr(
                                         "channel twin is left out: its input is constant or a")));
  EXPECT_THAT(texts(found.messages), testing::Contains(testing::HasSubstr(
                                         "channel still is left out: its input is constant or a")));
}

/// 2 um/K, 8 K colder than at any time before.
TEST(RegressionBaseline, TellsHowMuchComesFromWhereNobodyMeasured) {
  MadeRecord made(40000, 20), colder(40000, 20);
  made.with("a_temperature_C", [](double t) { return 20 + slow_wave(t); })
      .with("displacement_z_um", [](double t) { return 2.0 * slow_wave(t); });
  colder.with("a_temperature_C",
              [](double t) { return 20 + slow_wave(t) - (t == 20000 ? 8.0 : 0.0); });
  const Identification found =
      regression_baseline(bare_model({"a_temperature_C"}), {}, made.record);
  const auto share = [&](const record::Record& record) {
    const Series series(record);
    return extrapolated(found.model, series, beyond_range(found.model, series));
  };
  for (const double within : share(made.record)) EXPECT_EQ(within, 0.0);
  const std::vector<double> beyond = share(colder.record);
  const double least = found.model.range.front().lower;
  const double value =
      record::series_channel("a_temperature_C")->to_SI(20 + slow_wave(20000) - 8.0);
  EXPECT_NEAR(beyond[1000], 2e-6 * (least - value), 1e-12);
  EXPECT_EQ(beyond[999], 0.0);
}

/// Readings of a lag of 1800 s every 10 s, rounded to 0.5 um: from one step to the next nearly
/// nothing happens, so that the step is predicted well by poles that are not those of the machine.
TEST(ArxBaseline, AGoodStepIsNoGoodSimulation) {
  MadeRecord made(80000, 10);
  std::vector<double> driving, y{0.0};
  for (const double t : made.time) driving.push_back(stepped_speed(t, 5000) / 500.0);
  for (std::size_t k = 1; k < driving.size(); ++k)
    y.push_back(y.back() + (driving[k - 1] - y.back()) * -std::expm1(-10.0 / 1800.0));
  std::size_t row = 0;
  made.with("a_feed_m_min", [&](double) { return driving[row++]; });
  row = 0;
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, 0.5);
  made.with("displacement_z_um",
            [&](double) { return 0.5 * std::round((y[row++] + noise(random)) / 0.5); });
  const ArxBaseline arx = arx_baseline(bare_model({"a_feed_m_min"}), {}, made.record, 1, 2);
  EXPECT_EQ(arx.sampling, 10.0);
  ASSERT_EQ(arx.fits.size(), 2U);
  const ArxFit& first = arx.fits.front();
  EXPECT_LT(first.one_step.rms, 0.8e-6);
  EXPECT_GT(first.simulated.rms, 1.5 * first.one_step.rms);
  // Noise of the readings pulls the pole towards 0.
  EXPECT_LT(first.time_constants.front(), 1200.0);
  EXPECT_TRUE(first.stable);
  EXPECT_TRUE(std::isnan(arx.fits[1].time_constants.back()));  // a pole that is no decay
}

/// Without noise and rounding it is the machine.
TEST(ArxBaseline, FindsAnExactLag) {
  MadeRecord made(80000, 10);
  std::vector<double> driving, y{0.0};
  for (const double t : made.time) driving.push_back(stepped_speed(t, 5000) / 500.0);
  for (std::size_t k = 1; k < driving.size(); ++k)
    y.push_back(y.back() + (driving[k - 1] - y.back()) * -std::expm1(-10.0 / 1800.0));
  std::size_t row = 0;
  made.with("a_feed_m_min", [&](double) { return driving[row++]; });
  row = 0;
  made.with("displacement_z_um", [&](double) { return y[row++]; });
  const ArxBaseline arx = arx_baseline(bare_model({"a_feed_m_min"}), {}, made.record, 1, 1);
  EXPECT_NEAR(arx.fits[0].time_constants.front(), 1800.0, 1e-3);
  EXPECT_LT(arx.fits[0].simulated.rms, 1e-12);
  EXPECT_LT(arx.fits[0].second_half.rms, 1e-12);
  // As a model of transfer functions it is the machine, too.
  ASSERT_EQ(arx.best(), &arx.fits[0]);
  const Model model = with_arx(bare_model({"a_feed_m_min"}), arx, arx.fits[0]);
  EXPECT_EQ(model.sampling, 10.0);
  std::vector<double> simulated(made.time.size());
  simulate(model, Series(made.record), simulated);
  for (std::size_t k = 0; k < y.size(); ++k) EXPECT_NEAR(simulated[k] / um, y[k], 1e-6) << k;
}

TEST(ArxBaseline, AnUnstableOrderIsNeverTheBest) {
  ArxBaseline arx;
  arx.fits = {ArxFit{.order = 1, .second_half = {.rms = 2e-6}, .stable = true},
              ArxFit{.order = 2, .second_half = {.rms = 1e-6}, .stable = false}};
  EXPECT_EQ(arx.best()->order, 1);
  arx.fits[0].stable = false;
  EXPECT_EQ(arx.best(), nullptr);
}

}  // namespace
}  // namespace raceway::correction
