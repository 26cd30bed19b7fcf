#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/spindle/reference.h"

namespace raceway::spindle {

/// A case of data/reference/spindle_reference.json, whose numbers are in the units of its keys.
struct ReferenceCase {
  std::string id;
  nlohmann::json inputs, outputs;
  double tolerance = 0.0;  ///< relative

  [[nodiscard]] double in(const std::string& key) const { return inputs.at(key).get<double>(); }
  [[nodiscard]] double out(const std::string& key) const { return outputs.at(key).get<double>(); }
  /// `value`, in the unit of the key, is that of the case within its tolerance.
  void holds(const std::string& key, double value) const {
    EXPECT_NEAR(value, out(key), tolerance * std::abs(out(key))) << id << ", " << key;
  }
};

inline const std::vector<ReferenceCase>& reference_cases() {
  static const std::vector<ReferenceCase> cases = [] {
    std::vector<ReferenceCase> list;
    for (const auto& c : references())
      list.push_back({c.at("id"), c.at("inputs"), c.at("outputs"), c.value("tolerance_rel", 0.0)});
    return list;
  }();
  return cases;
}

/// Throws where there is no such case.
inline const ReferenceCase& reference_case(const std::string& id) {
  for (const ReferenceCase& c : reference_cases())
    if (c.id == id) return c;
  throw std::invalid_argument("data/reference/spindle_reference.json has no case " + id);
}

/// All whose id begins so; none is a failure.
inline std::vector<ReferenceCase> reference_cases(const std::string& beginning) {
  std::vector<ReferenceCase> found;
  for (const ReferenceCase& c : reference_cases())
    if (c.id.starts_with(beginning)) found.push_back(c);
  EXPECT_FALSE(found.empty()) << beginning;
  return found;
}

}  // namespace raceway::spindle
