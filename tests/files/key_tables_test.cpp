#include "files/key_tables.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "files/correction_file.h"
#include "files/model_file.h"
#include "record/channel.h"
#include "text/error.h"
#include "text/number_text.h"

namespace raceway::files {
namespace {

using testing::HasSubstr;

const ListedKey& listed_key(const std::vector<ListedKey>& keys, std::string_view table,
                            std::string_view name) {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const ListedKey& one) {
    return one.table == table && one.key.name == name;
  });
  if (found == keys.end()) throw std::out_of_range(std::string(table) + "." + std::string(name));
  return *found;
}

constexpr const char* oil_text =
    "[lubricant]\nviscosity_40C_mm2_s = 22\nviscosity_100C_mm2_s = 4.8\n";
const std::string short_rig_text = std::string("[bearing]\ncatalogue = \"S 6014 C\"\n") + oil_text;
const std::string whole_spindle_text = short_rig_text + R"(
[arrangement]
layout = "O"
front = 2
rear = 1
preload_N = 300
front_position_mm = [60, 90]
rear_position_mm = [290]
[shaft]
segment = [{ length_mm = 355, diameter_mm = 70 }]
[housing]
start_mm = 40
length_mm = 275
outer_diameter_mm = 180
flange_mm = 120
)";
const std::string correction_text = R"([correction]
displacement = "displacement_z_um"
[[correction.channel]]
input = "front_temperature_C"
sections = [{ gain_um_K = 5, time_constant_s = 3600 }]
)";

std::string reading_error(const std::string& text) {
  try {
    if (text.starts_with("[correction]"))
      (void)parse_correction(text, "m.toml");
    else
      (void)parse_model(text, "m.toml");
  } catch (const text::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(KeyTables, EveryKeyHasAMeaningAndStandsOnce) {
  const auto keys = model_keys();
  EXPECT_GT(keys.size(), 250u);
  std::set<std::tuple<std::string_view, std::string_view, std::string_view>> seen;
  for (const ListedKey& one : keys) {
    EXPECT_NE(one.key.meaning, "") << "[" << one.table << "] " << one.key.name;
    EXPECT_TRUE(seen.emplace(one.table, one.only, one.key.name).second)
        << "[" << one.table << "] " << one.key.name << " stands twice";
  }
}

TEST(KeyTables, ATableStandsInOnePiece) {
  std::set<std::string_view> seen;
  std::string_view table;
  for (const ListedKey& one : model_keys()) {
    if (one.table != table) {
      EXPECT_TRUE(seen.insert(one.table).second) << one.table;
    }
    table = one.table;
  }
}

TEST(KeyTables, DefaultsMayStandInTheFile) {
  for (const ListedKey& one : model_keys()) {
    const auto& [value, words, required] = one.key.fallback;
    if (std::isnan(value)) continue;
    EXPECT_EQ(one.key.form.kind, "number") << one.key.name;
    EXPECT_GE(value, one.key.form.lower) << "[" << one.table << "] " << one.key.name;
    EXPECT_LE(value, one.key.form.upper) << "[" << one.table << "] " << one.key.name;
  }
}

TEST(KeyTables, SayUnitRangeDefaultAndWordsAsTheReaderHasThem) {
  const auto keys = model_keys();
  const Key diameter = listed_key(keys, "bearing", "ball_diameter_mm").key;
  EXPECT_EQ(diameter.form.unit, "mm");
  EXPECT_EQ(diameter.form.lower, 0.1);
  EXPECT_EQ(diameter.form.upper, 300);
  EXPECT_TRUE(listed_key(keys, "bearing", "ball_count").key.form.whole);
  EXPECT_TRUE(listed_key(keys, "lubricant", "viscosity_40C_mm2_s").key.fallback.required);
  const ListedKey& tilt = listed_key(keys, "solver", "tilt");
  EXPECT_EQ(tilt.fallback(), "\"locked\"");
  EXPECT_THAT(tilt.key.form.choices(), testing::ElementsAre("locked", "free"));
  EXPECT_TRUE(std::isnan(listed_key(keys, "bearing", "name").key.form.lower));
  EXPECT_EQ(listed_key(keys, "bearing", "width_mm").meaning(), "spindle: width of the rings");
}

// K_rs is off in one law and on in the other.
TEST(KeyTables, ANumberOfTwoLawsHasTheDefaultOfEach) {
  std::vector<std::string> defaults;
  for (const ListedKey& one : model_keys())
    if (one.key.name == "K_rs") defaults.push_back(one.meaning().substr(0, 6) + one.fallback());
  EXPECT_THAT(defaults, testing::ElementsAre("law sk6e-08", "law co0", "cylind6e-08"));
}

// What a reader takes and what the table of keys says is the same default.
TEST(KeyTables, DefaultsAreThoseThatAModelIsReadWith) {
  const auto keys = model_keys();
  int compared = 0;
  for (const std::string& text :
       {short_rig_text, short_rig_text + "[friction]\nlaw = \"skf\"\n",
        short_rig_text + "[friction]\nlaw = \"contact\"\n", whole_spindle_text})
    for (const UsedDefault& used : parse_model(text, "m.toml").defaults) {
      if (used.origin != UsedDefault::Origin::key || used.table.starts_with("effect")) continue;
      const auto said = [&](const ListedKey& one) {
        return one.table == used.table && one.key.name == used.key &&
               (one.fallback() == used.value || !std::isfinite(one.key.fallback.value));
      };
      EXPECT_TRUE(std::any_of(keys.begin(), keys.end(), said)) << used.line();
      ++compared;
    }
  EXPECT_GT(compared, 60);
}

TEST(KeyTables, RangesAreThoseThatErrorsName) {
  int tried = 0;
  for (const ListedKey& one : model_keys()) {
    if ((one.table != "rig" && one.table != "life") || !one.only.empty()) continue;
    ++tried;
    const std::string error =
        reading_error(short_rig_text + fmt::format("[{}]\n{} = 1e20\n", one.table, one.key.name));
    EXPECT_THAT(error, HasSubstr(fmt::format("{} = 1e+20", one.key.name)));
    EXPECT_THAT(error, HasSubstr(fmt::format("must be from {} to {}", one.key.form.lower,
                                             one.key.form.upper)));
  }
  EXPECT_GE(tried, 10);
}

TEST(KeyTables, KeysThatMustStandThereAreMissed) {
  int tried = 0;
  const auto keys = model_keys();
  for (const ListedKey& left_out : keys) {
    if (left_out.table != "coolant" || !left_out.key.fallback.required) continue;
    std::string text = whole_spindle_text + "[coolant]\n";
    for (const ListedKey& one : keys)
      if (one.table == "coolant" && one.key.fallback.required && &one != &left_out)
        text += fmt::format("{} = {}\n", one.key.name, one.key.name == "pitch_mm" ? 20 : 10);
    EXPECT_THAT(
        reading_error(text),
        HasSubstr(fmt::format("[coolant] {} is missing: must be from {} to {}", left_out.key.name,
                              left_out.key.form.lower, left_out.key.form.upper)));
    ++tried;
  }
  EXPECT_GE(tried, 7);
}

// Its message asked for a number "from 0 to 0".
TEST(KeyTables, AMissingTextAsksForNoNumber) {
  EXPECT_EQ(reading_error("[correction]\nname = \"z\"\n"),
            "m.toml:1: [correction] displacement is missing, the column that the correction "
            "predicts, such as \"displacement_z_um\"");
}

// They were read without a word beside a [correction].
TEST(KeyTables, OtherKeysBesideACorrectionAreRefused) {
  EXPECT_EQ(reading_error(correction_text), "no error");
  EXPECT_THAT(reading_error(correction_text + "[loop]\ntolerance_mum = 1\n"),
              HasSubstr("m.toml:7: tolerance_mum = 1: unknown key in [loop]"));
  EXPECT_THAT(reading_error(correction_text + "[calibration]\nfre = [\"gains\"]\n"),
              HasSubstr("unknown key in [calibration]; did you mean free?"));
}

TEST(KeyTables, EveryMeasuredQuantityHasATolerance) {
  const auto keys = model_keys();
  for (const record::Channel& channel : record::channels)
    if (channel.role == record::Role::measured) {
      EXPECT_NO_THROW((void)listed_key(keys, "loop", text::tolerance_key(channel)));
    }
}

}  // namespace
}  // namespace raceway::files
