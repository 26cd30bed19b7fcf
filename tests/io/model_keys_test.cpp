#include "io/model_keys.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "io/error.h"
#include "io/key_meanings.h"
#include "io/model_file.h"

namespace raceway::io {
namespace {

using testing::HasSubstr;

const ModelKey& key_of(const std::vector<ModelKey>& keys, std::string_view table,
                       std::string_view name) {
  return *std::find_if(keys.begin(), keys.end(),
                       [&](const ModelKey& key) { return key.table == table && key.name == name; });
}

TEST(ModelKeys, EveryKeyThatAReaderAsksForHasAMeaning) {
  const auto keys = model_keys();
  EXPECT_GT(keys.size(), 250u);
  for (const ModelKey& key : keys)
    EXPECT_NE(key.meaning, "") << "[" << key.table << "] " << key.name;
}

TEST(ModelKeys, EveryMeaningIsOfAKeyThatAReaderAsksFor) {
  std::set<std::pair<std::string_view, std::string_view>> asked, told;
  const auto keys = model_keys();
  for (const ModelKey& key : keys) asked.emplace(key.table, key.name);
  EXPECT_EQ(asked.size(), keys.size()) << "a key stands twice";
  for (const KeyMeaning& one : key_meanings()) {
    EXPECT_TRUE(told.emplace(one.table, one.name).second) << one.table << " " << one.name;
    EXPECT_TRUE(asked.contains({one.table, one.name})) << "[" << one.table << "] " << one.name;
  }
}

TEST(ModelKeys, SayUnitRangeDefaultAndWordsAsTheReaderHasThem) {
  const auto keys = model_keys();
  const ModelKey& diameter = key_of(keys, "bearing", "ball_diameter_mm");
  EXPECT_EQ(diameter.unit, "mm");
  EXPECT_EQ(diameter.lower, 0.1);
  EXPECT_EQ(diameter.upper, 300);
  EXPECT_TRUE(key_of(keys, "bearing", "ball_count").whole);
  EXPECT_TRUE(key_of(keys, "lubricant", "viscosity_40C_mm2_s").required);
  EXPECT_EQ(key_of(keys, "solver", "tilt").fallback, "\"locked\"");
  EXPECT_THAT(key_of(keys, "solver", "tilt").choices, testing::ElementsAre("locked", "free"));
  EXPECT_TRUE(std::isnan(key_of(keys, "bearing", "name").lower));
}

TEST(ModelKeys, RangesAreThoseThatErrorsName) {
  const auto keys = model_keys();
  int tried = 0;
  for (const char* table : {"rig", "life"})
    for (const ModelKey& key : keys) {
      if (key.table != table || !std::isfinite(key.upper) || key.name.starts_with("model_floor"))
        continue;
      const std::string text =
          "[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\n"
          "viscosity_40C_mm2_s = 22\nviscosity_100C_mm2_s = 4.8\n[" +
          key.table + "]\n" + key.name + " = 1e20\n";
      ++tried;
      try {
        (void)parse_model(text, "m.toml");
        ADD_FAILURE() << key.name << " has no upper bound";
      } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr(key.name + " = 1e+20"));
        EXPECT_THAT(error.what(), HasSubstr("must be"));
      }
    }
  EXPECT_GE(tried, 10);
}

TEST(ModelKeys, ReadingAModelAfterwardsIsNotWritten) {
  const std::size_t count = model_keys().size();
  (void)parse_model(
      "[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\nviscosity_40C_mm2_s = 22\n"
      "viscosity_100C_mm2_s = 4.8\n",
      "m.toml");
  EXPECT_EQ(model_keys().size(), count);
}

}  // namespace
}  // namespace raceway::io
