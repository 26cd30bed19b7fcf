// raceway deflection and modes.

#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/files/spindle_text.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;

/// The shortest one with a bearing of its own, whose numbers are known.
const std::string beam_spindle =
    replaced(replaced(shortest_spindle, "catalogue = \"S 6014 C\"\n", R"(bore_mm = 70
outer_diameter_mm = 110
width_mm = 20
ball_count = 20
ball_diameter_mm = 11.9
pitch_diameter_mm = 90
contact_angle_deg = 15
inner_conformity = 0.52
outer_conformity = 0.52
static_load_rating_N = 45000
)"),
             "[arrangement]\n", "[friction]\nf0 = 0.6\nz = 0.0007\ny = 0.33\n[arrangement]\n");

class BeamCommands : public testing::Test {
 protected:
  [[nodiscard]] Result raceway(const std::string& command, const std::string& flags,
                               const std::string& model = beam_spindle) const {
    return run(command + " " + scratch_.write("my.toml", model) + " " + flags);
  }
  ScratchFolder scratch_;
};

TEST_F(BeamCommands, DeflectionTellsPreloadStiffnessAndWhatEachBearingCarries) {
  const json d = parsed(raceway("deflection", "--force 1000 --speed 8000 --json"));
  EXPECT_EQ(d["report"]["status"], "converged");
  EXPECT_GT(d["unloaded_front_force_N"].get<double>(), 300.0);
  EXPECT_NEAR(d["stiffness_N_um"].get<double>() * d["displacement_um"].get<double>(), 1000.0, 1e-6);
  EXPECT_EQ(d["displacement_um"], d["nose_displacement_um"]);
  ASSERT_EQ(d["bearings"].size(), 3u);
  // The front set carries more than the force, the rear one the rest, the other way.
  const auto load = [&](std::size_t i) { return d["bearings"][i]["radial_load_N"].get<double>(); };
  EXPECT_NEAR(load(0) + load(1) - load(2), 1000.0, 1e-4);
  for (const json& b : d["bearings"]) {
    EXPECT_LT(b["least_inner_load_N"].get<double>(), b["largest_inner_load_N"].get<double>());
    EXPECT_EQ(b["balls"].size(), 20u);
  }
}

// A force at the nose is the same force 40 mm behind it, still in front of all bearings, and the
// moment of 40 mm.
TEST_F(BeamCommands, AForceInFrontIsAForceAndAMoment) {
  const json at_nose = parsed(raceway("deflection", "--force 1000 --speed 8000 --json"));
  const json behind =
      parsed(raceway("deflection", "--force 1000 --at 40 --moment 40 --speed 8000 --json"));
  for (std::size_t i = 0; i < 3; ++i)
    for (const char* key : {"radial_load_N", "moment_Nm", "largest_inner_load_N"})
      EXPECT_NEAR(behind["bearings"][i][key].get<double>(),
                  at_nose["bearings"][i][key].get<double>(), 1e-4)
          << key;
  EXPECT_TRUE(behind["stiffness_N_um"].is_null());
}

TEST_F(BeamCommands, ACuttingForceHasAnAxialPart) {
  const json d = parsed(raceway("deflection", "--force 500 --axial-force -200 --json"));
  EXPECT_EQ(d["report"]["status"], "converged");
  EXPECT_NEAR(d["front_force_N"].get<double>() - d["rear_force_N"].get<double>(), 200.0, 1e-3)
      << "what pushes the shaft rearwards lies on the front set of an O";
  const Result axial = raceway("deflection", "--force 100 --direction axial --moment 5");
  EXPECT_EQ(axial.status, 1);
  EXPECT_THAT(axial.err, HasSubstr("--moment needs a radial --force"));
}

// --force is the load here.
TEST_F(BeamCommands, DeflectionNamesTheFlagThatReplacesAFile) {
  const std::string taken = scratch_.write("line.csv", "kept");
  const Result refused = raceway("deflection", "--force 100 -o " + taken);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("--replace replaces it"));
  EXPECT_EQ(file_text(taken), "kept");
  EXPECT_EQ(raceway("deflection", "--force 100 --replace -o " + taken).status, 0);
}

TEST_F(BeamCommands, AxialDeflectionIsThatOfTheSets) {
  const json with = parsed(raceway("displacement", "--speed 4000 --axial-load 100 --json"));
  const json without = parsed(raceway("displacement", "--speed 4000 --json"));
  const json d = parsed(raceway("deflection", "--force 100 --direction axial --speed 4000 --json"));
  const auto position = [](const json& j) {
    return j["rows"][0]["axial_position_um"].get<double>();
  };
  EXPECT_NEAR(d["displacement_um"].get<double>(), position(with) - position(without), 1e-6);
}

TEST_F(BeamCommands, ASupportAtTheRearStiffensTheShaft) {
  const std::string support = "[[shaft.support]]\nposition_mm = 360\nradial_N_um = 300\n";
  std::string model = beam_spindle;
  model.insert(model.find("[housing]"), support);
  const json with = parsed(raceway("deflection", "--force 500 --at 375 --json", model));
  const json without = parsed(raceway("deflection", "--force 500 --at 375 --json"));
  EXPECT_LT(with["displacement_um"].get<double>(), 0.8 * without["displacement_um"].get<double>());
}

TEST_F(BeamCommands, CampbellHasARowForEachModeAndThePreloadBesideIt) {
  const std::string file = scratch_.file("campbell.csv"), shapes = scratch_.file("shapes.csv");
  const Result r = raceway("modes", "--speed 0:20000:10000 -o " + file + " --shapes " + shapes);
  EXPECT_EQ(r.status, 0);
  std::istringstream in(file_text(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with("#")) lines.push_back(line);
  ASSERT_EQ(lines.size(), 19u);
  EXPECT_TRUE(lines[0].starts_with(
      "speed_rpm,mode,frequency_Hz,whirl,damping_ratio,front_force_N,rear_force_N,"
      "front_radial_N_um,"));
  EXPECT_THAT(lines[1], HasSubstr(",standing,,"));
  EXPECT_THAT(lines[7], HasSubstr("10000,1,"));
  EXPECT_THAT(lines[7], HasSubstr(",backward,,"));
  EXPECT_THAT(lines[8], HasSubstr(",forward,,"));
  EXPECT_THAT(file_text(shapes), HasSubstr("position_mm,y_amplitude,z_amplitude\n0,1,"));
}

TEST_F(BeamCommands, BearingsPassTheirFrequenciesAndMeetModes) {
  const json d = parsed(raceway("modes", "--speed 0:40000:2000 --json"));
  const json& row = d["rows"][5];
  const double turns = row["speed_rpm"].get<double>() / 60.0;
  const double cage = row["front_1_cage_Hz"], outer = row["front_1_outer_race_Hz"],
               inner = row["front_1_inner_race_Hz"];
  // Z balls pass both races: BPFO + BPFI = Z n, BPFO = Z FTF.
  EXPECT_NEAR((outer + inner) / turns, std::round((outer + inner) / turns), 1e-9);
  EXPECT_NEAR(outer / cage, std::round(outer / cage), 1e-9);
  EXPECT_GT(cage, 0.3 * turns);
  EXPECT_LT(cage, 0.5 * turns);
  std::set<std::string> excitations;
  double before = 0.0;
  for (const json& c : d["crossings"]) {
    excitations.insert(c["excitation"].get<std::string>());
    EXPECT_GE(c["speed_rpm"].get<double>(), before);
    before = c["speed_rpm"];
    if (c["excitation"] == "1x") {
      EXPECT_NEAR(c["frequency_Hz"].get<double>(), before / 60.0, 1e-6 * before);
    }
  }
  EXPECT_TRUE(excitations.contains("front_1 outer race"));
  EXPECT_TRUE(excitations.contains("2x"));
  const Result text = raceway("modes", "--speed 0:40000:2000");
  EXPECT_THAT(text.out,
              HasSubstr("\nspeeds at which an excitation has the frequency of a mode\n\n"));
}

TEST_F(BeamCommands, AnUnbalanceMovesTheNoseByTheStatedDamping) {
  const json d = parsed(
      raceway("modes", "--speed 2000,4000 --unbalance 10 --unbalance-at 20 --damping 0.03 --json"));
  const double slow = d["rows"][0]["nose_amplitude_um"], fast = d["rows"][1]["nose_amplitude_um"];
  EXPECT_GT(slow, 0.0);
  // Far below the first mode it grows with the square of the speed, and as the bearings soften.
  const auto first = [&](int row) {
    return d["rows"][row]["modes"][0]["frequency_Hz"].get<double>();
  };
  const double softer = std::pow(first(0) / first(1), 2);
  EXPECT_NEAR(fast / slow, 4.0 * softer, 0.1 * 4.0 * softer);
  EXPECT_EQ(d["rows"][0]["modes"][0]["damping_ratio"], 0.03);
  const Result undamped = raceway("modes", "--speed 2000 --unbalance 10");
  EXPECT_EQ(undamped.status, 1);
  EXPECT_THAT(undamped.err, HasSubstr("unbalance: give a damping ratio as well; without damping, "
                                      "the amplitude is infinite at a resonance"));
  const Result outside =
      raceway("modes", "--speed 2000 --unbalance 10 --unbalance-at 900 --damping 0.03");
  EXPECT_EQ(outside.status, 1);
  EXPECT_THAT(
      outside.err,
      HasSubstr(
          "mm: the unbalance must be above 0, and its position must be on the shaft, from 0 to"));
}

TEST_F(BeamCommands, TheWarmSpindleHasAnotherPreloadThanTheColdOne) {
  const json cold = parsed(raceway("modes", "--speed 6000 --json"));
  const json warm = parsed(raceway("modes", "--speed 6000 --warm --json"));
  const auto& c = cold["rows"][0];
  const auto& w = warm["rows"][0];
  EXPECT_EQ(w["report"]["status"], "converged");
  EXPECT_GT(std::abs(w["front_force_N"].get<double>() - c["front_force_N"].get<double>()), 20.0);
  EXPECT_GT(w["front_1_inner_ring_temperature_C"].get<double>(), 25.0);
  EXPECT_NE(w["modes"][0]["frequency_Hz"], c["modes"][0]["frequency_Hz"]);
}

TEST_F(BeamCommands, AModelWithoutShaftIsRefusedAndSoIsAPlaceBeyondItsEnd) {
  std::string sets = beam_spindle.substr(0, beam_spindle.find("front_position_mm"));
  sets = replaced(sets, "width_mm = 20\n", "");
  const Result none = raceway("modes", "--speed 0", sets);
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.err, HasSubstr("[shaft]"));
  const Result beyond = raceway("deflection", "--force 1 --at 400");
  EXPECT_EQ(beyond.status, 1);
  EXPECT_THAT(beyond.err, HasSubstr("= 400 mm: must be from 0 to 375 mm"));
  EXPECT_EQ(raceway("deflection", "--force 0").status, 1);
}

}  // namespace
}  // namespace raceway::tests
