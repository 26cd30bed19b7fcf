// Coast-downs through the program, as a user has them.
#include <fmt/format.h>

#include <array>
#include <sstream>
#include <vector>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

const std::string shipped = tests::source_dir() + "/data/measurements/";
const std::string flywheel = shipped + "flywheel.toml ";

/// A shipped record with four seconds at its first speed before it.
std::string with_plateau(const std::string& record) {
  std::istringstream in(file_text(shipped + record));
  std::string text, line;
  bool begun = false;
  while (std::getline(in, line)) {
    if (!begun && text.find("run_id") != text.npos) {
      begun = true;
      const std::size_t comma = line.find(','), second = line.find(',', comma + 1);
      for (int k = 0; k < 4; ++k)
        text += fmt::format("{},{}{}\n", line.substr(0, comma), k - 3.5, line.substr(second));
    }
    text += line + "\n";
  }
  return text;
}

/// Share of the misfit that the nearest effect takes away.
double best_share(const json& diagnosis) {
  double least = diagnosis["rmse_before"];
  for (const json& e : diagnosis["effects"])
    if (!e["rmse"].is_null()) least = std::min(least, e["rmse"].get<double>());
  const double before = diagnosis["rmse_before"];
  return 1.0 - least * least / (before * before);
}

TEST(CoastDownRecords, OfShippedOnesNothingIsLeftOutBeforeTheRelease) {
  for (const auto& [name, torques] :
       {std::pair{"flywheel_unloaded.csv", "41 torques from 819"},
        std::pair{"flywheel_unloaded_5_28.csv", "41 torques from 939"},
        std::pair{"flywheel_motor.csv", "40 torques from 566"}}) {
    const Result r = run("check " + flywheel + shipped + name);
    EXPECT_EQ(r.status, 0);
    EXPECT_THAT(r.err, testing::Not(testing::HasSubstr("release")));
    EXPECT_THAT(r.err, testing::HasSubstr(torques));
  }
}

TEST(CoastDownRecords, FourSecondsOfPlateauChangeNoVerdict) {
  const ScratchFolder folder;
  for (const std::string name : {"flywheel_unloaded.csv", "flywheel_motor.csv"}) {
    const std::string path = folder.write(name, with_plateau(name));
    const Result with = run("diagnose --json " + flywheel + path);
    const Result without = run("diagnose --json " + flywheel + shipped + name);
    EXPECT_THAT(with.err,
                testing::HasSubstr("samples before the release of the shaft are not used"));
    const json a = parsed(with), b = parsed(without);
    EXPECT_EQ(a["verdict"], b["verdict"]);
    // Two seconds more are left out, at the top, where the misfit is largest.
    EXPECT_NEAR(a["rmse_before"], b["rmse_before"], 0.05 * b["rmse_before"].get<double>());
    EXPECT_NEAR(best_share(a), best_share(b), 0.02) << name;
  }
}

TEST(CoastDownRecords, AnUnknownInertiaChangesSizesAndNothingElse) {
  const ScratchFolder folder;
  const std::string unknown =
      folder.write("unknown.toml", replaced(file_text(shipped + "flywheel.toml"),
                                            "inertia_kgm2 = 0.8489", "inertia_kgm2 = \"unknown\""));
  const std::string record = " " + shipped + "flywheel_unloaded.csv";
  const Result r = run("diagnose --json " + unknown + record);
  const std::string said =
      "the inertia is unknown, so all torques, f0, z and effect sizes in N mm have an";
  EXPECT_THAT(r.err,
              testing::HasSubstr("inertia_kgm2 = \"unknown\": the program assumes 0.4782 kg m2"));
  EXPECT_THAT(r.err, testing::HasSubstr(said));
  const json a = parsed(r), b = parsed(run("diagnose --json " + flywheel + record));
  EXPECT_THAT(a["messages"].dump(), testing::HasSubstr(said));
  EXPECT_THAT(b["messages"].dump(), testing::Not(testing::HasSubstr("inertia")));
  EXPECT_EQ(a["verdict"], b["verdict"]);
  EXPECT_NEAR(best_share(a), best_share(b), 1e-4);
  const double factor = a["rmse_before"].get<double>() / b["rmse_before"].get<double>();
  const auto windage = [](const json& d) {
    for (const json& e : d["effects"])
      if (e["id"] == "windage") return e;
    return json();
  };
  EXPECT_NEAR(windage(a)["gain"], windage(b)["gain"], 1e-3 * windage(b)["gain"].get<double>());
  const std::string size = "torque_at_10000_rpm_Nmm";
  EXPECT_NEAR(windage(a)["parameters"][size]["value"].get<double>(),
              factor * windage(b)["parameters"][size]["value"].get<double>(), 1.0);
  for (const char* command : {"calibrate --json ", "calibrate "})
    EXPECT_THAT(run(command + unknown + record).err, testing::HasSubstr(said));
  EXPECT_THAT(run("add " + unknown + " windage --data" + record).err, testing::HasSubstr(said));
  const Result two =
      run("calibrate " + unknown + record + " " + shipped + "flywheel_unloaded_5_28.csv");
  EXPECT_EQ(two.status, 1);
  EXPECT_THAT(two.err, testing::HasSubstr("have an unknown common factor"));
}

TEST(CoastDownRecords, CheckNamesTimesBetweenTwoSpeeds) {
  const ScratchFolder folder;
  const std::string good = folder.write(
      "falls.csv",
      "\xef\xbb\xbfspeed_from_rpm;speed_to_rpm;time_s\r\n1000,5;900;41,2\r\n900;800;46,9\r\n"
      "800;700;53,5\r\n700;600;61,8\r\n");
  const Result r = run("check " + flywheel + good);
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.err, testing::HasSubstr("note: 4 torques from the times between two speeds"));
  EXPECT_THAT(r.out, testing::HasSubstr("4 rows of friction torque"));
  const std::string bad =
      folder.write("bad.csv", "speed_from_rpm,speed_to_rpm,time_s\n900,800,40\n800,900,44\n");
  expect_refused(run("check " + flywheel + bad),
                 "bad.csv:3: speed_to_rpm = 900: must be below speed_from_rpm = 800 rpm");
}

}  // namespace
}  // namespace raceway::tests
