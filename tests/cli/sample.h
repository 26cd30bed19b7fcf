#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/cli/run_program.h"
#include "tests/support/model_text.h"

namespace raceway::tests {

using json = nlohmann::json;

inline const std::string spin_effect = "\n[[effect]]\nid = \"spin-friction\"\n";
inline const std::string inner_control = "\n[solver]\nrace_control = \"inner\"\n";

/// Rows near the model, over speed and load.
inline const std::string data_text =
    "speed_rpm,axial_load_N,friction_torque_Nmm\n"
    "1000,100,92\n2000,100,140\n4000,100,221\n8000,100,347\n"
    "1000,900,140\n2000,900,190\n4000,900,269\n8000,900,397\n";

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

inline json parsed(const Result& result) {
  const json document = json::parse(result.out, nullptr, false);
  EXPECT_FALSE(document.is_discarded()) << result.out << result.err;
  return document;
}

inline std::set<std::string> keys(const json& object) {
  std::set<std::string> names;
  for (const auto& [name, value] : object.items()) names.insert(name);
  return names;
}

/// False in a program built with -DRACEWAY_REPORT=OFF.
inline bool has_reports() {
  return run("compare --help").out.find("RACEWAY_REPORT=OFF") == std::string::npos;
}

/// What a page of --report is made of.
inline json page_document(const std::string& page) {
  const std::string text = file_text(page), mark = "id=\"document\">";
  const std::size_t begin = text.find(mark), end = text.find("</script>", begin);
  EXPECT_TRUE(begin != text.npos && end != text.npos) << "no page";
  if (end == text.npos) return {};
  const json document =
      json::parse(text.substr(begin + mark.size(), end - begin - mark.size()), nullptr, false);
  EXPECT_FALSE(document.is_discarded());
  return document;
}

/// One message with this text, exit status 1, nothing on stdout but the error as JSON where that
/// was asked for.
inline void expect_refused(const Result& result, const std::string& message) {
  EXPECT_EQ(result.status, 1) << result.err;
  if (!result.out.empty()) {
    EXPECT_EQ(keys(parsed(result)), (std::set<std::string>{"format", "error"}));
  }
  EXPECT_THAT(result.err, testing::HasSubstr(message));
}

}  // namespace raceway::tests
