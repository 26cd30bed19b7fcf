#include "text/format_number.h"

#include <nlohmann/json.hpp>

#include "files/catalogue_file.h"
#include "files/correction_file.h"
#include "files/model_file.h"
#include "results/results.h"
#include "results/spindle_results.h"
#include "tests/support/message_of.h"

namespace raceway::text {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string correction =
    "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
    "name = \"spindle\"\ninput = \"front_temperature_C\"\n"
    "sections = [{ gain_um_K = 5.0, time_constant_s = 5400 }]\n";

TEST(FormatNumber, OfAModelIsOneWhereItIsMissing) {
  EXPECT_EQ(files::parse_correction(correction, "m.toml").models.size(), 1);
  EXPECT_EQ(files::parse_correction("format = 1\n" + correction, "m.toml").models.size(), 1);
}

TEST(FormatNumber, OfAnotherVersionIsRefusedWithAdvice) {
  for (const std::string other : {"2", "0", "\"1\""})
    EXPECT_EQ(tests::message_of([&] {
                (void)files::parse_correction("\nformat = " + other + "\n" + correction, "m.toml");
              }),
              "m.toml:2: format = " + other + ": " + std::string(other_format));
  EXPECT_THAT(
      tests::message_of([] { (void)files::parse_model("format = 7\n[bearing]\n", "m.toml"); }),
      StartsWith("m.toml:1: format = 7: must be 1"));
}

TEST(FormatNumber, OpensEveryDocumentAndNewModel) {
  const std::vector<files::CatalogueBearing> rows = files::read_catalogues();
  EXPECT_EQ(nlohmann::json::parse(results::bearings_json(rows)).at("format"), format_number);
  EXPECT_THAT(files::new_model_text(rows.front(), friction::FrictionLaw::palmgren),
              HasSubstr("\n" + std::string(format_line)));
}

TEST(FormatNumber, OfASpindleStateIsChecked) {
  const std::string state =
      R"("spindle_state": "s", "time_s": 1, "structure_time_s": 1, "temperatures_C": [20]})";
  EXPECT_EQ(results::parse_spindle_state("{" + state, "s.json").temperatures.size(), 1);
  EXPECT_EQ(results::parse_spindle_state(R"({"format": 1, )" + state, "s.json").temperatures.size(),
            1);
  EXPECT_EQ(tests::message_of(
                [&] { (void)results::parse_spindle_state(R"({"format": 2, )" + state, "s.json"); }),
            "s.json: format = 2: " + std::string(other_format));
}

}  // namespace
}  // namespace raceway::text
