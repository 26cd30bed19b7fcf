#include "tests/correction_study/rig.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "correction/catalogue.h"
#include "tests/correction_study/recording.h"

namespace correction_study {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

double largest_gap(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

std::size_t columns(const std::string& line) {
  return 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
}

TEST(Machine, StandsStillInAQuietRoom) {
  correction_study::Setup s = draw_setup(find_class("nothing-missing"), 4, 1.0);
  s.plain.room = {};
  for (PlannedRow& row : s.train) row.setting = {};
  const Course course = follow(s.plain, s.train);
  EXPECT_LT(*std::max_element(course.displacement.begin(), course.displacement.end()), 1e-6);
}

TEST(Machine, HalfTheStepChangesNoReadingByATenthOfItsNoise) {
  for (const Class& c : classes()) {
    // Timers switch within a step; all else is smooth there.
    if (c.id == "hydraulics" || c.id == "door" || c.id == "chips") continue;
    const correction_study::Setup s = draw_setup(c, 2, 1.0);
    const auto begin = s.train.begin();
    const std::vector<PlannedRow> day(begin, begin + 700);
    // A slide lets go a row earlier or later.
    Machine machine = s.machine;
    machine.stick = 0.0;
    EXPECT_LT(
        largest_gap(follow(machine, day, 4.0).displacement, follow(machine, day, 2.0).displacement),
        0.1 * s.noise)
        << c.id;
  }
}

TEST(Machine, FrictionAndMotorHeatOnlyWhatTurns) {
  const correction_study::Setup s = draw_setup(find_class("motor-heat"), 3, 1.0);
  const Eigen::VectorXd T = Eigen::VectorXd::Constant(body_count, 30.0);
  EXPECT_EQ(s.machine.flows({}, 0.0, T).heat_from_within(), 0.0);
  EXPECT_GT(s.machine.flows({.speed = 500.0}, 0.0, T).heat_from_within(), 100.0);
}

TEST(Machine, HeatFlowsBackToTheBearingThroughItsOwnConductance) {
  Machine m = draw_setup(find_class("thermal-asymmetry"), 3, 1.0).plain;
  m.back_flow = 0.25;
  Eigen::VectorXd T = Eigen::VectorXd::Constant(body_count, 20.0);
  const auto joint = [&] { return -m.flows({}, 0.0, T).conductance()(front_bearing, quill); };
  T[front_bearing] = 30.0;
  const double there = joint();
  T[front_bearing] = 10.0;
  EXPECT_NEAR(joint(), 0.25 * there, 1e-6 * there);
}

TEST(Plan, HoldsWhatWasWished) {
  Random random(3);
  const auto rows = make_plan({.hours = 24.0, .uneven = true, .stops = true, .runs = 2}, random);
  std::size_t read = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].read) {
      ++read;
      EXPECT_EQ(rows[i].setting.speed, 0.0);
    }
    if (i == 0) continue;
    const double gap = rows[i].time - rows[i - 1].time;
    if (rows[i].run == rows[i - 1].run) {
      EXPECT_GE(gap, 17.9);
      EXPECT_LE(gap, 42.1);
    } else {
      EXPECT_GT(gap, 8.0 * hour);
    }
  }
  EXPECT_EQ(rows.back().run, 2);
  EXPECT_NEAR(static_cast<double>(read), 24.0 * 12.0, 6.0);
}

TEST(Floors, FindASumOfBodiesThatFollow) {
  // Two bodies that follow a square wave, by the exponential: a record of the base class itself.
  Signals s;
  double fast = 0.0, slow = 0.0;
  for (int i = 0; i < 2880; ++i) {
    s.time.push_back(30.0 * i);
    s.run.push_back(1);
    s.speed.push_back((i / 120) % 2 == 0 ? 8000.0 : 0.0);
    s.spindle.push_back((i / 120) % 2 == 0 ? 150.0 : 0.0);
    s.displacement.push_back(0.1 * fast + 0.2 * slow + (i % 2 == 0 ? 0.2 : -0.2));
    fast += (s.spindle.back() - fast) * (1.0 - std::exp(-30.0 / 800.0));
    slow += (s.spindle.back() - slow) * (1.0 - std::exp(-30.0 / 9000.0));
  }
  const Fit two = Floors({.power = true, .sections = 2}, s, s).base();
  const Fit one = Floors({.power = true, .sections = 1}, s, s).base();
  EXPECT_NEAR(two.train, 0.2, 0.02);       // the noise
  EXPECT_NEAR(two.test, two.train, 1e-4);  // a ridge holds the gains
  EXPECT_GT(one.train, 4.0 * two.train);
}

TEST(Rig, TheSameSeedGivesTheSameFilesAndAnotherOneOthers) {
  const Class& wished = find_class("nothing-missing");
  const Rig one = make_rig(wished, 5), same = make_rig(wished, 5), other = make_rig(wished, 6);
  EXPECT_EQ(one.record_csv, same.record_csv);
  EXPECT_EQ(one.test_csv, same.test_csv);
  EXPECT_EQ(one.model_toml, same.model_toml);
  EXPECT_EQ(truth_json(one), truth_json(same));
  EXPECT_NE(one.record_csv, other.record_csv);
}

class EveryClass : public testing::TestWithParam<Class> {};

TEST_P(EveryClass, HidesWhatMattersAndNothingElseComesNear) {
  const Class& c = GetParam();
  const Truth t = make_rig(c, 1).truth;
  EXPECT_LT(std::max(t.right.train, t.right.test), 0.715 * t.tolerance);
  if (c.hidden.empty()) return;
  EXPECT_GE(std::min(t.base.train, t.base.test), 2.0 * t.tolerance);
  for (const auto& [rival, error] : t.rivals) {
    if (c.hidden.size() == 1) {
      EXPECT_THAT(t.accept, testing::Not(Contains(rival)));
    }
    const bool pair = rival.find('+') != rival.npos;
    if (c.outside) {
      EXPECT_GE(error, pair ? 1.2 * t.tolerance : 0.6 * t.base.train) << rival;
    } else if (c.hidden.size() > 1) {
      EXPECT_GE(error, (pair ? 1.25 : 1.4) * t.right.train) << rival;
    } else {
      EXPECT_GE(error, 1.35 * t.right.train) << rival;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryClass, testing::ValuesIn(classes()), [](const auto& test) {
  std::string name(test.param.id);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '+'; }, '_');
  return name;
});

TEST(Rig, FilesAreWhole) {
  for (const char* id : {"cooling-switch", "feed-axis-heat+ambient-drift", "stick-slip"}) {
    const Rig rig = make_rig(find_class(id), 2);
    EXPECT_THAT(rig.model_toml, HasSubstr("tolerance_um = "));
    EXPECT_EQ(rig.friction_table_csv.empty(), !rig.setup.base.power);
    std::istringstream lines(rig.test_csv);
    std::string line;
    std::getline(lines, line);
    const std::size_t wide = columns(line);
    std::size_t rows = 0;
    for (; std::getline(lines, line); ++rows) ASSERT_EQ(columns(line), wide);
    write_rig(rig, testing::TempDir());
    const auto in_file = [&](const char* name) {
      std::ifstream file(testing::TempDir() + "/" + rig.truth.id + "/" + name);
      return std::string(std::istreambuf_iterator<char>(file), {});
    };
    EXPECT_EQ(in_file("model.toml"), rig.model_toml);
    EXPECT_EQ(in_file("train.csv"), rig.record_csv);
    EXPECT_EQ(in_file("test.csv"), rig.test_csv);
    EXPECT_EQ(in_file("friction_table.csv"), rig.friction_table_csv);
    const auto truth = nlohmann::json::parse(truth_json(rig));
    EXPECT_EQ(truth["test"]["clean_displacement_z_um"].size(), rows);
    EXPECT_EQ(truth["hidden"].size(), rig.truth.hidden.size());
  }
}

TEST(Rig, ARecordReadInStopsHasEmptyCellsElsewhere) {
  for (unsigned seed = 1; seed < 40; ++seed) {
    const correction_study::Setup s = draw_setup(find_class("ambient-drift"), seed, 1.0);
    if (!s.train_wish.stops) continue;
    const Recording r = record(s, false, 1);
    const auto& read = r.column("displacement_z_um");
    const auto count = static_cast<double>(
        std::count_if(read.begin(), read.end(), [](double u) { return !std::isnan(u); }));
    EXPECT_NEAR(count, s.train_wish.hours * 12.0, 0.05 * s.train_wish.hours * 12.0);
    EXPECT_THAT(r.csv(), HasSubstr(",\n"));
    return;
  }
  FAIL() << "no seed gives stops";
}

TEST(Rig, WhatOnlyAReadingSuffersIsNotInTheSecondRecord) {
  for (const char* id : {"slow-drift", "offset-jump"}) {
    const correction_study::Setup s = draw_setup(find_class(id), 3, 1.0);
    EXPECT_GT(
        largest_gap(follow(s.machine, s.train).displacement, follow(s.plain, s.train).displacement),
        2.0);
    const Machine later = s.machine_later();
    EXPECT_LT(largest_gap(follow(later, s.test).displacement, follow(s.plain, s.test).displacement),
              1e-6)
        << id;
  }
}

TEST(Classes, CoverTheCatalogueOnceEach) {
  std::vector<std::string_view> alone;
  for (const Class& c : classes())
    if (c.hidden.size() == 1 && !c.outside) alone.push_back(c.hidden[0]);
  std::vector<std::string_view> catalogue;
  for (const raceway::correction::EffectCard& card : raceway::correction::catalogue())
    catalogue.push_back(card.id);
  EXPECT_THAT(alone, UnorderedElementsAreArray(catalogue));
  EXPECT_THROW((void)find_class("no-such-class"), std::invalid_argument);
}

}  // namespace
}  // namespace correction_study
