#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "effects/catalogue.h"
#include "files/model_file.h"
#include "model/prediction.h"
#include "tests/hidden_effect/generator.h"
#include "tests/hidden_effect/judge.h"
#include "tests/places.h"

namespace hidden_effect {
namespace {

/// A rig made by another program: its files as they are.
struct GivenRig {
  std::string name;
  nlohmann::json truth;
  std::string model, train;
  std::vector<Point> points[2];  // of train and test
};

std::string read_all(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(file.good()) << path;
  return text.str();
}

std::vector<Point> points_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);
  std::vector<Point> points;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::vector<double> values;
    while (std::getline(cells, cell, ',')) values.push_back(std::stod(cell));
    points.push_back({values[2], values[3], values[5], values[1]});
  }
  return points;
}

GivenRig given(int number) {
  const std::string name = "dev-0" + std::to_string(number);
  const std::string folder = tests::source_dir() + "/tests/hidden_effect/rigs/" + name + "/";
  GivenRig rig{.name = name,
               .truth = nlohmann::json::parse(read_all(folder + "truth.json")),
               .model = read_all(folder + "model.toml"),
               .train = read_all(folder + "train.csv"),
               .points = {}};
  rig.points[0] = points_of(rig.train);
  rig.points[1] = points_of(read_all(folder + "test.csv"));
  return rig;
}

// Their files round temperatures to 0.01 K, which is 1.5e-4 of the torque of a cold oil.
constexpr double rounding = 2e-4;

TEST(GivenRigs, TheGeneratorHasTheirTorqueToRounding) {
  for (int number = 1; number <= 8; ++number) {
    const GivenRig rig = given(number);
    const bool small = rig.model.find("\"7010\"") != std::string::npos;
    const Bearing bearing(machines()[small ? 1 : 0]);
    std::vector<Hidden> hidden;
    for (const auto& [id, size] : rig.truth["size"].items())
      hidden.push_back({&effect(id), {size.get<double>(), effect(id).shape}});
    for (int part = 0; part < 2; ++part) {
      const auto& torques = rig.truth[part == 0 ? "train" : "test"]["torque"];
      ASSERT_EQ(torques.size(), rig.points[part].size());
      for (std::size_t i = 0; i < torques.size(); ++i) {
        const double theirs = torques[i].get<double>();
        EXPECT_NEAR(torque(bearing, {}, rig.points[part][i], hidden), theirs, rounding * theirs)
            << rig.name << " row " << i;
      }
    }
  }
}

// Two ways to one number: curvatures, ellipses, balance and rolling of the generator's own.
TEST(GeneratorPhysics, HasTheHysteresisOfTheLibrary) {
  const Effect& hysteresis = effect("elastic-hysteresis");
  bool hybrid = false;
  for (const Machine& m : machines()) {
    hybrid = hybrid || m.ceramic_balls;
    const Rig rig = make_rig({.machine = &m, .hidden = {}, .seed = 1});
    auto model = raceway::files::parse_model(model_text(rig), "rig.toml").model;
    model.effects.push_back({raceway::effects::find("elastic-hysteresis"), {1.0}, nullptr});
    for (const double speed : {500.0, 9000.0})
      for (const double load : {150.0, 1000.0}) {
        const Point point{speed, load, 40.0};
        const Hidden one[] = {{&hysteresis, {1.0, 0.0}}};
        const double theirs =
            torque(rig.bearing, {}, point, one) - torque(rig.bearing, {}, point, {});
        const auto ours = raceway::model::predict_friction(
            model, {.speed = speed * raceway::rpm, .axial_load = load});
        EXPECT_NEAR(ours.effects.back() / raceway::N_mm, theirs, 1e-6 * theirs) << m.name;
      }
  }
  EXPECT_TRUE(hybrid);
}

TEST(GivenRigs, GetTheirVerdictsAndNames) {
  for (int number = 1; number <= 8; ++number) {
    const GivenRig rig = given(number);
    const Answer answer = ask(rig.model, rig.train);
    const auto& verdicts = rig.truth["verdicts"];
    EXPECT_NE(std::find(verdicts.begin(), verdicts.end(), answer.verdict), verdicts.end())
        << rig.name << ": " << answer.verdict << ' ' << answer.message;
    if (rig.truth["accept"].empty()) continue;
    const auto accepted = rig.truth["accept"].get<std::vector<std::string>>();
    EXPECT_THAT(accepted, testing::Contains(answer.first)) << rig.name;
  }
}

// Rigs with plans, noise and mistakes of real laboratories, by the same other program.
TEST(GivenRigs, AreJudgedRightlyAsPeopleBuildThem) {
  for (int number = 1; number <= 9; ++number) {
    const std::string folder =
        tests::source_dir() + "/tests/hidden_effect/rigs/real-0" + std::to_string(number) + "/";
    const auto truth = nlohmann::json::parse(read_all(folder + "truth.json"));
    const Answer answer = ask(read_all(folder + "model.toml"), read_all(folder + "train.csv"));
    EXPECT_THAT(truth["verdicts"].get<std::vector<std::string>>(),
                testing::Contains(answer.verdict))
        << folder << ": " << answer.sentence << answer.message;
    const auto accepted = truth["accept"].get<std::vector<std::string>>();
    if (!accepted.empty()) {
      EXPECT_THAT(answer.names, testing::Contains(testing::AnyOfArray(accepted))) << folder;
    }
    // What is missing there goes with the radial load.
    if (number == 7) {
      EXPECT_THAT(answer.shape, testing::HasSubstr("radial_load_N"));
    }
  }
}

}  // namespace
}  // namespace hidden_effect
