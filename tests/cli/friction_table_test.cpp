// [friction] law = "table": from `raceway table` to the spindle, and in the loop of a rig.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "tests/cli/sample.h"
#include "tests/files/spindle_text.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string law_of_table = "\n[friction]\nlaw = \"table\"\nfile = \"torque.csv\"\n";
const std::string law_of_rig = "\n[friction]\nf0 = 1.5\nz = 0.001\ny = 0.33\n";

class FrictionTable : public testing::Test {
 protected:
  /// torque.csv of a model, as `raceway table` writes it.
  std::string write_table(const std::string& model, const std::string& axes) {
    const std::string path = scratch_.file("torque.csv");
    const Result r =
        run("table " + scratch_.write("made.toml", model) + " " + axes + " -o " + path);
    EXPECT_EQ(r.status, 0) << r.err;
    return path;
  }
  /// A record of the rig with noise of 1 %, its torque times `factor` plus `more` [N mm].
  std::string record(double factor, double more) {
    const json rows = parsed(run("table " + scratch_.write("truth.toml", model_text) +
                                 " --speed 1000,2500,4000,6000,8000 --axial-load 150,350,800 "
                                 "--temperature 25,45,60 --json"));
    std::mt19937 random(7);
    std::normal_distribution<double> noise;
    std::string text = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
    for (const json& p : rows["rows"]) {
      const double torque = factor * p["friction_torque_Nmm"].get<double>() + more;
      text += fmt::format("{},{},{},{:.3f}\n", p["speed_rpm"].get<double>(),
                          p["axial_load_N"].get<double>(), p["temperature_C"].get<double>(),
                          torque * (1.0 + 0.01 * noise(random)));
    }
    return scratch_.write("record.csv", text);
  }
  std::string tabled(const std::string& more = "") {
    return scratch_.write("tabled.toml", with(model_text, law_of_rig, law_of_table) + more);
  }
  ScratchFolder scratch_;
  const std::string whole_ = "--speed 0:10000:500 --axial-load 100:900:100 --temperature 20:70:5";
};

TEST_F(FrictionTable, HeatsASpindleAsTheLawThatMadeIt) {
  std::string bearing = base_spindle.substr(0, base_spindle.find("[arrangement]"));
  bearing = bearing.substr(bearing.find("[bearing]"));
  bearing =
      with(with(with(bearing, "width_mm = 20.0\n", ""), "inner_ring_shoulder_mm = 82.0\n", ""),
           "outer_ring_shoulder_mm = 98.0\n", "");
  bearing = with(bearing, "lubricant_conductance_W_K = 1.5\n", "");
  write_table(bearing +
                  "\n[lubricant]\nviscosity_40C_mm2_s = 20.0\nviscosity_100C_mm2_s = 4.4\n"
                  "[friction]\nf1_load = \"F_b\"\nf0 = 0.6\nz = 0.0007\ny = 0.33\n",
              "--speed 0:8000:500 --axial-load 100:1400:100 --temperature 15:75:5");
  const std::string coarse = "\n[solver]\ncells = \"coarse\"\n";
  // Without inner_heat_share the rings share the heat by the parts that the table has.
  const std::string by_law = with(base_spindle, "inner_heat_share = 0.5\n", "");
  const std::string by_table = with(by_law, "f1_load = \"F_b\"\nf0 = 0.6\nz = 0.0007\ny = 0.33\n",
                                    "law = \"table\"\nfile = \"torque.csv\"\n");
  const auto steady = [&](const std::string& text, const std::string& flags) {
    return run("spindle " + scratch_.write("s.toml", text + coarse) + " --steady " + flags);
  };
  const Result r = steady(by_table, "--speed 6200 --json");
  const json of_table = parsed(r)["steady"][0],
             of_law = parsed(steady(by_law, "--speed 6200 --json"))["steady"][0];
  EXPECT_THAT(r.err, Not(HasSubstr("outside the friction table")));
  for (const char* const name :
       {"front_1_inner_ring_temperature_C", "rear_1_outer_ring_temperature_C"}) {
    const double wanted = of_law[name];
    EXPECT_NEAR(of_table[name].get<double>(), wanted, 5e-4 * (wanted - 20.0)) << name;
  }
  // Above 8000 rpm the edge holds, which is said in text and JSON.
  const Result beyond = steady(by_table, "--speed 9000 --json");
  EXPECT_THAT(beyond.err, HasSubstr("outside the friction table torque.csv (0 to 8000 rpm, "));
  const json judged = parsed(beyond)["judgement"];
  EXPECT_TRUE(std::any_of(judged.begin(), judged.end(), [](const json& one) {
    return one["limit"] == "friction_table" && one["allowed"].is_null();
  })) << judged;
}

TEST_F(FrictionTable, IsComparedAndDiagnosedOnARig) {
  write_table(model_text, whole_);
  const std::string model = tabled(), data = record(1.0, 0.0);
  const json same = parsed(run("compare " + model + " " + data + " --json"));
  EXPECT_LT(same["rmse"].get<double>(), 5.0);
  const json found = parsed(run("diagnose " + model + " " + data + " --json"));
  EXPECT_EQ(found["verdict"], "nothing-missing") << found["sentence"];
}

TEST_F(FrictionTable, NamesADragThatTheTableDoesNotHave) {
  write_table(model_text, whole_);
  const json found = parsed(run("diagnose " + tabled() + " " + record(1.0, 40.0) + " --json"));
  // A drag in one direction is a seal or a zero of the sensor, whatever the law.
  EXPECT_THAT(found["explanations"], testing::Contains(json::parse(R"(["seal-friction"])")))
      << found["sentence"];
}

TEST_F(FrictionTable, ItsScaleIsFitted) {
  write_table(model_text, whole_);
  const std::string data = record(1.08, 0.0);
  const json fitted = parsed(run("calibrate " + tabled() + " " + data + " --json"));
  EXPECT_NEAR(fitted["parameters"]["scale"]["value"].get<double>(), 1.08, 0.005) << fitted;
}

/// A torque over speed that no law has.
double humped_torque(double rpm, double load, double temperature) {
  return (20.0 + 1.2 * std::sqrt(rpm) + 40.0 * std::exp(-std::pow((rpm - 4000.0) / 1500.0, 2.0))) *
         (1.0 + 8e-4 * load) * std::exp(-0.015 * (temperature - 40.0));
}

TEST_F(FrictionTable, IsABaseLawThatDiagnoseTriesWhereTheModelNamesIt) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  const auto measured = [&](const std::vector<double>& speeds, const std::vector<double>& loads,
                            const std::vector<double>& temperatures, double scatter) {
    std::string text = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm\n";
    for (const double n : speeds)
      for (const double f : loads)
        for (const double t : temperatures)
          text += fmt::format("{},{},{},{:.3f}\n", n, f, t,
                              humped_torque(n, f, t) * (1.0 + scatter * noise(random)));
    return text;
  };
  std::vector<double> speeds;
  for (int k = 1; k <= 36; ++k) speeds.push_back(250.0 * k);
  scratch_.write("torque.csv", measured(speeds, {100, 300, 500, 700, 900},
                                        {20, 25, 30, 35, 40, 45, 50, 55, 60, 65}, 0.0));
  const std::string data = scratch_.write(
      "hump.csv",
      measured({600, 1600, 2800, 3700, 4600, 6100, 8200}, {150, 350, 800}, {26, 42, 58}, 0.005));
  const std::string model = scratch_.write("named.toml", model_text + "file = \"torque.csv\"\n");
  const json found = parsed(run("diagnose " + model + " " + data + " --json"));
  const json bases = found.value("other_bases", json::array());
  ASSERT_FALSE(bases.empty()) << found["sentence"];
  EXPECT_EQ(bases[0]["id"], "law:table") << bases;
  EXPECT_TRUE(bases[0]["explains"].get<bool>()) << bases[0];
  const std::string out = scratch_.file("by_table.toml");
  const Result added = run("add " + model + " law:table --data " + data + " -o " + out);
  EXPECT_EQ(added.status, 0) << added.err;
  EXPECT_THAT(file_text(out), HasSubstr("law = \"table\""));
  EXPECT_EQ(run("check " + out).status, 0);
}

TEST_F(FrictionTable, TheBandOfItsReadingsIsToldBesideErrors) {
  write_table(model_text, whole_);
  std::string csv = "speed_rpm,axial_load_N,temperature_C,friction_torque_Nmm,std_Nmm\n";
  const json made =
      parsed(run("table " + scratch_.write("made.toml", model_text) + " " + whole_ + " --json"));
  for (const json& p : made["rows"])
    csv += fmt::format("{},{},{},{},6\n", p["speed_rpm"].get<double>(),
                       p["axial_load_N"].get<double>(), p["temperature_C"].get<double>(),
                       p["friction_torque_Nmm"].get<double>());
  scratch_.write("torque.csv", csv);
  const Result r = run("compare " + tabled() + " " + record(1.0, 0.0));
  EXPECT_THAT(r.err, HasSubstr("torque.csv has a 95 % band of +-11.8 N mm (RMS over these rows"));
  const json document = parsed(run("compare " + tabled() + " " + record(1.0, 0.0) + " --json"));
  EXPECT_THAT(document.dump(), HasSubstr("95 % band of +-11.8 N mm"));
}

TEST_F(FrictionTable, ARecordBeyondItIsWarnedOf) {
  write_table(model_text, "--speed 0:5000:500 --axial-load 100:900:100 --temperature 20:70:5");
  const Result r = run("compare " + tabled() + " " + record(1.0, 0.0));
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(
      r.err,
      HasSubstr(
          "18 of 45 calculated points with rotation are outside the friction table torque.csv "
          "(0 to 5000 rpm, 100 to 900 N axial, 0 N radial, 20 to 70 C)"));
}

TEST_F(FrictionTable, AModelInAnotherFolderStillFindsIt) {
  write_table(model_text, whole_);
  std::filesystem::create_directory(scratch_.path() / "other");
  const std::string out = scratch_.file("other/fitted.toml");
  const Result r = run("calibrate " + tabled() + " " + record(1.05, 0.0) + " -o " + out);
  EXPECT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(file_text(out), HasSubstr("file = \"../torque.csv\""));
  EXPECT_EQ(run("check " + out).status, 0);
}

}  // namespace
}  // namespace raceway::tests
