// Identification on records with a known answer: data/reference/correction_reference.json.
#include <cmath>
#include <string>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

const std::string golden_folder = tests::source_dir() + "/data/corrections/";

json reference(const std::string& row) {
  return json::parse(
      file_text(tests::source_dir() + "/data/reference/correction_reference.json"))[row];
}

json found_on(const std::string& record) {
  return parsed(run("identify " + golden_folder + record + "/correction.toml " + golden_folder +
                    record + "/train.csv --json --quiet"));
}

const json& channel_of(const json& found, const std::string& input) {
  for (const json& c : found["channels"])
    if (c["input"] == input) return c;
  throw std::runtime_error("no channel of " + input);
}

TEST(CorrectionGolden, WithoutNoiseTheLagsAreFoundToAMillionth) {
  const json known = reference("identify_exact-01"), found = found_on("noise_free");
  for (const auto& [input, sections] : known["true"].items()) {
    const json& c = channel_of(found, input);
    ASSERT_EQ(c["sections"].size(), sections.size());
    for (std::size_t k = 0; k < sections.size(); ++k) {
      EXPECT_NEAR(
          c["sections"][k]["gain"]["value"].get<double>() / sections[k]["gain_um_K"].get<double>(),
          1.0, 1e-6);
      EXPECT_NEAR(c["sections"][k]["time_constant_s"]["value"].get<double>() /
                      sections[k]["time_constant_s"].get<double>(),
                  1.0, 1e-6);
    }
  }
  EXPECT_LT(found["metrics"]["rmse_um"], known["reference_train_rms_um"]);
}

/// As near the truth as four standard errors of a fit on the measured clock.
TEST(CorrectionGolden, WithNoiseOnAnUnevenClockTheyAreFoundWithinFourStandardErrors) {
  const json known = reference("identify_exact-02"), found = found_on("exact");
  std::map<std::string, std::size_t> next;
  for (const json& exact : known["exact_clock"]) {
    const std::string input = exact["input"];
    const std::size_t k = next[input]++;
    const json& section = channel_of(found, input)["sections"].at(k);
    const json& truth = known["true"][input].at(k);
    EXPECT_NEAR(section["gain"]["value"].get<double>(), truth["gain_um_K"].get<double>(),
                4.0 * exact["gain_std"].get<double>());
    EXPECT_NEAR(section["time_constant_s"]["value"].get<double>(),
                truth["time_constant_s"].get<double>(),
                4.0 * exact["time_constant_std_s"].get<double>());
  }
  EXPECT_EQ(next.size(), found["channels"].size());
}

}  // namespace
}  // namespace raceway::tests
