#include "tests/spindle_study/rig.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace spindle_study {
namespace {

using testing::HasSubstr;

std::string text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST(SpindleStudyRig, ItsFilesSayWhatIsBelievedAndWhatIsTrue) {
  const Rig rig = make_rig(find_class("seat-conductance"), 1, {.train = 0.5, .test = 0.25});
  EXPECT_LT(rig.balance, 1e-6);
  EXPECT_NEAR(rig.believed.f0 / rig.truth.f0, 1.0, 0.151);
  EXPECT_LT(rig.hidden.outer_seat, 1.0);
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "spindle_study_rig";
  std::filesystem::remove_all(folder);
  write_rig(rig, folder.string());
  const std::filesystem::path own = folder / "seat-conductance-1";
  EXPECT_THAT(text(own / "model.toml"), HasSubstr("layout = \"O\""));
  EXPECT_EQ(lines(text(own / "train.csv")), 31u);
  EXPECT_EQ(lines(text(own / "test.csv")), 16u);
  const auto truth = nlohmann::json::parse(text(own / "truth.json"));
  EXPECT_EQ(truth["accept"][0], "seat-conductance");
  EXPECT_NEAR(truth["hidden"]["seat-conductance"].get<double>(), rig.size, 1e-12);
  EXPECT_EQ(truth["train"]["displacement_um"].size(), 30u);
  std::filesystem::remove_all(folder);
}

TEST(SpindleStudyRig, UnknownClassesAreRefusedByTheNamesOfAll) {
  try {
    (void)find_class("sleeve");
    FAIL();
  } catch (const std::invalid_argument& e) {
    EXPECT_THAT(e.what(), HasSubstr("flange-conductance"));
  }
}

}  // namespace
}  // namespace spindle_study
