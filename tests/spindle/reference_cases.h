#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/spindle/reference.h"

namespace raceway::spindle {

/// A case of data/reference/spindle_reference.json, whose numbers are in the units of its keys.
struct ReferenceCase {
  std::string id;
  nlohmann::json inputs, outputs;
  double tolerance = 0.0;  ///< relative

  explicit ReferenceCase(const nlohmann::json& c)
      : id(c.at("id")),
        inputs(c.at("inputs")),
        outputs(c.at("outputs")),
        tolerance(c.value("tolerance_rel", 0.0)) {}

  [[nodiscard]] double in(const std::string& key) const { return inputs.at(key).get<double>(); }
  [[nodiscard]] double in(const std::string& key, double otherwise) const {
    return inputs.value(key, otherwise);
  }
  [[nodiscard]] double out(const std::string& key) const { return outputs.at(key).get<double>(); }
  /// `value`, in the unit of the key, is that of the case within its tolerance; of one that is 0
  /// absolutely. How far it is off stands in the XML of the tests.
  void holds(const std::string& key, double value) const {
    const double expected = out(key);
    const double size = expected == 0.0 ? 1.0 : std::abs(expected);
    std::ostringstream off;
    off << (value - expected) / size;
    testing::Test::RecordProperty(id + "." + key, off.str());
    EXPECT_NEAR(value, expected, tolerance * size) << id << ", " << key;
  }
};

/// Throws where there is no such case.
inline ReferenceCase reference_case(const std::string& id) { return ReferenceCase(reference(id)); }

/// All of one kind, for the test that holds them.
inline std::vector<ReferenceCase> reference_cases(std::string_view beginning) {
  std::vector<ReferenceCase> found;
  for (const nlohmann::json& c : references(beginning)) found.emplace_back(c);
  return found;
}

}  // namespace raceway::spindle
