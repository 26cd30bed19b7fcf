#include "fit/several_records.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "fit/row_order.h"
#include "tests/support/loop.h"
#include "tests/support/synthetic.h"

// Records made by formulas written out here: [Palmgren1959] at 40 C, where the oil of
// synthetic_model() has 22 mm2/s, and what the rig has beside.
namespace raceway::fit {
namespace {

using testing::HasSubstr;

constexpr double pitch_diameter_mm = 90.0, static_load_rating_N = 43000.0, angle_deg = 25.0;

/// What a rig really is on one day.
struct Day {
  std::string name;
  double f0 = 1.5, z = 0.001;
  double windage_Nmm = 0.0;  ///< at 10 000 rpm, with the power 1.8
  double further_load_N = 0.0;
};

/// [N mm]
double torque(const Day& day, double speed_rpm, double load_N) {
  const double load = load_N + day.further_load_N;
  const double equivalent = 0.38 * load;  // Y0 of 25 deg
  const double cotangent = 1.0 / std::tan(angle_deg * std::acos(-1.0) / 180.0);
  const double drag = std::max(160.0, std::pow(22.0 * speed_rpm, 2.0 / 3.0));
  return 1e-7 * day.f0 * drag * std::pow(pitch_diameter_mm, 3) +
         day.z * std::pow(equivalent / static_load_rating_N, 0.33) * 0.9 * load * cotangent *
             pitch_diameter_mm +
         day.windage_Nmm * std::pow(speed_rpm / 1e4, 1.8);
}

constexpr double noise_Nmm = 2.0;

Record record_of(const Day& day, const std::vector<double>& three_loads, unsigned seed,
                 int repeats = 2, double noise = noise_Nmm) {
  std::mt19937 random(seed);
  std::normal_distribution<double> gauss;
  DataSet data = factorial_plan({600, 1500, 3000, 5000, 7500, 10000, 13000, 16000}, three_loads,
                                {40}, repeats);
  data.source = "rig/" + day.name + ".csv";
  for (Row& row : data.rows)
    row.measured =
        (torque(day, row.point.speed / rpm, row.point.axial_load) + noise * gauss(random)) * N_mm;
  return data;
}

SeveralRecords several(const Record& record, std::vector<std::string> own,
                       const std::vector<std::string>& free = {"f0", "z"}) {
  Model model = synthetic_model();
  model.law_values = {2.0, 0.0008, 0.33};
  model.free = free;
  return {std::shared_ptr<const Subject>(subject_of(model)), record, std::move(own)};
}

const Parameter& find(const std::vector<Parameter>& parameters, const std::string& name) {
  const auto at = std::find_if(parameters.begin(), parameters.end(),
                               [&](const Parameter& p) { return p.name == name; });
  if (at == parameters.end()) throw std::out_of_range(name);
  return *at;
}

const std::vector<double> three_loads{100, 400, 1200};

Record two_days(double windage = 60.0) {
  return record::joined(
      {record_of({.name = "monday", .f0 = 1.5, .windage_Nmm = windage}, three_loads, 1),
       record_of({.name = "friday", .f0 = 2.1, .windage_Nmm = windage}, three_loads, 2)});
}

TEST(SeveralRecords, GiveEachRecordItsOwnAndOneValueOfWhatIsShared) {
  const Record record = two_days(0.0);
  const verdict::Calibration fit = calibrate(several(record, {"f0"}), record);
  ASSERT_TRUE(fit.converged());
  ASSERT_EQ(fit.parameters.size(), 3U);
  for (const auto& [name, truth] :
       {std::pair{"f0@friday", 2.1}, {"f0@monday", 1.5}, {"z", 0.001}}) {
    const Parameter& p = find(fit.parameters, name);
    EXPECT_NEAR(p.value, truth, 3.5 * p.std) << name;
    EXPECT_LT(p.std, 0.02 * truth);
  }
  const auto& fitted = dynamic_cast<const SeveralRecords&>(*fit.subject);
  EXPECT_EQ(fitted.records(), (std::vector<std::string>{"friday", "monday"}));
  EXPECT_EQ(model::model_of(*fitted.model_of(0)).law_values[0], fit.parameters[0].value);
  EXPECT_EQ(model::model_of(*fitted.model_of(1)).law_values[0], fit.parameters[1].value);
}

TEST(SeveralRecords, FindAHiddenEffectTheyShareWithinItsError) {
  const Record record = two_days();
  const verdict::Diagnosis d = diagnose(several(record, {"f0"}), record);
  ASSERT_EQ(d.verdict, verdict::Verdict::effect) << d.sentence;
  EXPECT_EQ(d.effects.front().id, "windage");
  const Parameter& size = d.effects.front().parameters.front();
  EXPECT_NEAR(size.value, 60.0, 3.5 * size.std);
  EXPECT_LT(size.std, 3.0);
  const verdict::AddResult added =
      add(several(record, {"f0"}), std::vector<std::string>{"windage"}, record);
  EXPECT_FALSE(added.refused) << added.reason;
  const std::vector<Parameter>& found = added.calibration.parameters;
  EXPECT_NEAR(find(found, "windage.torque_at_10000_rpm_Nmm").value, size.value, 1e-9 * size.value);
  for (const auto& [name, truth] : {std::pair{"f0@friday", 2.1}, {"f0@monday", 1.5}})
    EXPECT_NEAR(find(found, name).value, truth, 3.5 * find(found, name).std) << name;
}

TEST(SeveralRecords, ShowAMisfitWhereAllIsShared) {
  const Record record = two_days(0.0);
  EXPECT_EQ(diagnose(several(record, {"f0"}), record).verdict, verdict::Verdict::nothing_missing);
  const verdict::Diagnosis d = diagnose(several(record, {}), record);
  EXPECT_NE(d.verdict, verdict::Verdict::nothing_missing);
  EXPECT_LT(d.p_value, 1e-6);
  const verdict::Calibration fit = calibrate(several(record, {}), record);
  const verdict::Comparison c = compare(*fit.subject, record).at(0);
  ASSERT_EQ(c.records.size(), 2U);
  EXPECT_EQ(c.records[0].run, "friday");
  EXPECT_EQ(c.records[0].rows + c.records[1].rows, c.rows);
  EXPECT_LT(c.records[0].bias, -20.0 * N_mm);  // more friction than the model has
  EXPECT_GT(c.records[1].bias, 20.0 * N_mm);
  EXPECT_EQ(c.judgement, verdict::Judgement::structure);  // against repeats within each record
}

// Days and sensors differ: with one size of noise for both the quiet record would look like a
// misfit.
TEST(SeveralRecords, MayScatterDifferently) {
  int alarms = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Record record =
        record::joined({record_of({.name = "quiet"}, three_loads, 100 + seed, 2, 0.5),
                        record_of({.name = "rough", .f0 = 2.1}, three_loads, 200 + seed, 2, 5.0)});
    const verdict::Diagnosis d = diagnose(several(record, {"f0", "z"}), record);
    if (d.verdict != verdict::Verdict::nothing_missing) ++alarms;
    ASSERT_EQ(d.channels[0].noise.records.size(), 2U);
    EXPECT_NEAR(d.channels[0].noise.records[1] / d.channels[0].noise.records[0], 10.0, 5.0);
  }
  EXPECT_LE(alarms, 1);
  const Record alike = two_days(0.0);
  EXPECT_TRUE(diagnose(several(alike, {"f0", "z"}), alike).channels[0].noise.records.empty());
}

TEST(SeveralRecords, AreTakenByNameWhateverTheirOrder) {
  const Record monday = record_of({.name = "monday", .windage_Nmm = 60}, three_loads, 1);
  const Record friday = record_of({.name = "friday", .f0 = 2.1, .windage_Nmm = 60}, three_loads, 2);
  const Record one = record::joined({monday, friday}), other = record::joined({friday, monday});
  const verdict::Diagnosis a = diagnose(several(one, {"f0", "z"}), one);
  const verdict::Diagnosis b = diagnose(several(other, {"f0", "z"}), other);
  EXPECT_EQ(a.sentence, b.sentence);
  EXPECT_EQ(a.p_value, b.p_value);
  const verdict::Calibration x = calibrate(several(one, {"f0"}), one);
  const verdict::Calibration y = calibrate(several(other, {"f0"}), other);
  for (std::size_t k = 0; k < x.parameters.size(); ++k) {
    EXPECT_EQ(x.parameters[k].name, y.parameters[k].name);
    EXPECT_EQ(x.parameters[k].value, y.parameters[k].value);
  }
}

// Each at one load of its own: z takes up what a further load does, until the other record says
// that z is something else.
TEST(SeveralRecords, TellTogetherWhatNoneOfThemTellsAlone) {
  const Day light{.name = "light", .f0 = 1.5, .further_load_N = 150};
  const Day heavy{.name = "heavy", .f0 = 2.1, .further_load_N = 150};
  const Record a = record_of(light, {300}, 3, 6), b = record_of(heavy, {2500}, 4, 6);
  Model model = synthetic_model();
  for (const Record* alone : {&a, &b}) {
    const auto subject = subject_of(model);
    EXPECT_EQ(diagnose(*subject, *alone).verdict, verdict::Verdict::nothing_missing);
    EXPECT_THROW((void)add(*subject, std::vector<std::string>{"load-offset"}, *alone),
                 std::invalid_argument);
  }
  const Record record = record::joined({a, b});
  const verdict::Diagnosis d = diagnose(several(record, {"f0"}), record);
  EXPECT_NE(d.verdict, verdict::Verdict::nothing_missing) << d.sentence;
  EXPECT_LT(d.p_value, 1e-6);
  EXPECT_TRUE(std::any_of(d.sets.begin(), d.sets.end(), [](const auto& set) {
    return set == std::vector<std::string>{"load-offset"};
  })) << d.sentence;
  const verdict::AddResult added =
      add(several(record, {"f0"}), std::vector<std::string>{"load-offset"}, record);
  const Parameter& size = find(added.calibration.parameters, "load-offset.force_N");
  EXPECT_NEAR(size.value, 150.0, 3.5 * size.std);
  EXPECT_LT(size.std, 30.0);
}

TEST(SeveralRecords, PredictEachRecordByItself) {
  const Record monday = record_of({.name = "monday"}, three_loads, 1);
  const Record friday = record_of({.name = "friday", .f0 = 2.1}, three_loads, 2);
  const Record both = record::joined({monday, friday});
  const SeveralRecords subject = several(both, {"f0"});
  const NamedValue values[] = {{"f0@friday", 3.0}, {"z", 0.002}};
  const std::vector<double> together = predict(*subject.with_values(values), both);
  const auto alone = [&](const Record& record, double f0) {
    Model model = synthetic_model();
    model.law_values = {f0, 0.002, 0.33};
    return predict(*subject_of(model), record);
  };
  std::vector<double> expected = alone(friday, 3.0);
  const std::vector<double> second = alone(monday, 2.0);
  expected.insert(expected.end(), second.begin(), second.end());
  EXPECT_EQ(together, expected);
  // A predictor that is asked again with one value changed.
  const auto predictor = subject.predictor(both, {"f0@monday", "z"}, subject.prepare(both));
  std::vector<double> first(both.rows()), again(both.rows());
  predictor->readings(std::vector{1.0, 0.002}, again);
  predictor->readings(std::vector{2.0, 0.002}, first);
  for (std::size_t i = friday.rows(); i < both.rows(); ++i) EXPECT_EQ(first[i], expected[i]);
  for (std::size_t i = 0; i < friday.rows(); ++i) EXPECT_EQ(first[i], again[i]);
}

constexpr Channel drive{.name = "drive_V"};
constexpr Channel level{.name = "level_m", .role = record::Role::measured};

/// A tank that keeps what runs into it: y = gain * sum of all rows so far.
struct Tank : Subject, Predictor {
  double gain = 1.0;
  const Record* rows = nullptr;
  std::vector<Measured> measured() const override { return {{&level}}; }
  void require(const Record&) const override {}
  bool has_memory() const override { return true; }
  std::vector<std::string> free() const override { return {"gain"}; }
  std::vector<Parameter> parameters() const override {
    return {{.name = "gain", .unit = "1", .start = gain, .value = gain, .lower = 0, .upper = 9}};
  }
  std::vector<Candidate> candidates() const override { return {}; }
  std::unique_ptr<Subject> with_values(std::span<const NamedValue> values) const override {
    auto copy = std::make_unique<Tank>(*this);
    for (const NamedValue& v : values) copy->gain = v.value;
    return copy;
  }
  std::unique_ptr<Subject> with_candidates(std::span<const std::string>) const override {
    return with_values({});
  }
  std::unique_ptr<Predictor> predictor(const Record& record, const std::vector<std::string>&,
                                       const std::shared_ptr<const void>&) const override {
    auto copy = std::make_unique<Tank>(*this);
    copy->rows = &record;
    return copy;
  }
  void readings(std::span<const double> values, std::span<double> out) override {
    if (!values.empty()) gain = values[0];
    double sum = 0.0;
    for (std::size_t i = 0; i < rows->rows(); ++i) out[i] = gain * (sum += rows->value(drive, i));
  }
};

TEST(SeveralRecords, StartAnewWhereRowsRememberThoseBefore) {
  std::mt19937 random(5);
  std::normal_distribution<double> gauss(0.0, 0.05);
  const auto filled = [&](const std::string& name, double gain) {
    Record record{.source = name};
    std::vector<double> in, out;
    double sum = 0.0;
    for (int i = 0; i < 30; ++i) {
      in.push_back(i % 3 + 0.5);
      out.push_back(gain * (sum += in.back()) + gauss(random));
    }
    record.set(drive, in);
    record.set(level, out);
    return record;
  };
  const Record record = record::joined({filled("a", 2.0), filled("b", 3.0)});
  const SeveralRecords subject(std::make_shared<Tank>(), record, {"gain"});
  const verdict::Calibration fit = calibrate(subject, record);
  ASSERT_TRUE(fit.converged());
  EXPECT_NEAR(find(fit.parameters, "gain@a").value, 2.0, 0.01);
  EXPECT_NEAR(find(fit.parameters, "gain@b").value, 3.0, 0.01);
  EXPECT_LT(fit.channels[0].rmse_after, 0.08);
}

TEST(SeveralRecords, KeepClockRunsAndLinesApart) {
  const auto timed = [](const std::string& name, std::vector<double> time) {
    Record record{.source = name + ".csv"};
    record.set(record::speed, {1.0, 2.0, 3.0});
    record.set(record::time, std::move(time));
    record.lines = {2, 3, 4};
    return record;
  };
  const Record record = record::joined({timed("b", {0, 2, 4}), timed("a", {1, 3, 5})});
  EXPECT_EQ(record.place(4), "line 3 of b");
  EXPECT_EQ(order_of_rows(record), (std::vector<std::size_t>{0, 1, 2, 3, 4, 5}));
  const std::size_t rows[] = {0, 1, 2, 3, 4, 5};
  const RowOrder order = row_order(record, rows);
  EXPECT_TRUE(std::isinf(order.step[3]));
  EXPECT_TRUE(order.new_run[3]);
  EXPECT_FALSE(order.has_runs);  // a record is no run: what differs is its own
}

TEST(SeveralRecords, HoldOutNoBlockThatIsAllOfARecordWithValuesOfItsOwn) {
  const Record record = record::joined(
      {record_of({.name = "light"}, {300}, 3), record_of({.name = "heavy"}, {2500}, 4)});
  const auto variables = [&](std::vector<std::string> own) {
    std::vector<std::string> list;
    for (const Blocking& b : several(record, std::move(own)).blockings(record))
      list.push_back(b.variable);
    return list;
  };
  EXPECT_EQ(variables({"f0"}), std::vector<std::string>{"speed"});
  EXPECT_EQ(variables({}), (std::vector<std::string>{"speed", "axial_load"}));
}

TEST(SeveralRecords, RefuseAnUnknownName) {
  const Record record = two_days();
  try {
    (void)several(record, {"f00"});
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_THAT(e.what(), HasSubstr("nearest: f0"));
  }
  EXPECT_THROW((void)several(record, {"f0", "f0"}), std::invalid_argument);
  const NamedValue shared[] = {{"f0", 1.0}};
  EXPECT_THROW((void)several(record, {"f0"}).with_values(shared), std::invalid_argument);
}

}  // namespace
}  // namespace raceway::fit
