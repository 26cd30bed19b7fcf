// Coast-downs through the program, as a user has them.
#include <fmt/format.h>

#include <array>
#include <sstream>
#include <vector>

#include "tests/cli/sample.h"

namespace raceway::tests {
namespace {

const std::string shipped = RACEWAY_SOURCE_DIR "/data/measurements/";
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
    EXPECT_THAT(with.err, testing::HasSubstr("samples before the release of the shaft left out"));
    const json a = parsed(with), b = parsed(without);
    EXPECT_EQ(a["verdict"], b["verdict"]);
    // Two seconds more are left out, at the top, where the misfit is largest.
    EXPECT_NEAR(a["rmse_before"], b["rmse_before"], 0.05 * b["rmse_before"].get<double>());
    EXPECT_NEAR(best_share(a), best_share(b), 0.02) << name;
  }
}

}  // namespace
}  // namespace raceway::tests
