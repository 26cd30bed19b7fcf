#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/places.h"

namespace raceway::friction::contact {

/// Cases of data/reference/contact_reference.json whose ids begin so: all of one kind, whatever
/// their number. Throws where there is none.
inline std::vector<nlohmann::json> contact_cases(std::string_view beginning) {
  static const nlohmann::json file = [] {
    std::ifstream in(tests::source_dir() + "/data/reference/contact_reference.json");
    return nlohmann::json::parse(in);
  }();
  std::vector<nlohmann::json> found;
  for (const nlohmann::json& c : file.at("cases"))
    if (c.at("id").get<std::string>().starts_with(beginning)) found.push_back(c);
  if (found.empty()) throw std::runtime_error("no case begins with " + std::string(beginning));
  return found;
}

/// Largest relative distance of a kind of case, put into the XML of the tests.
class Distance {
 public:
  explicit Distance(std::string name) : name_(std::move(name)) {}
  ~Distance() { testing::Test::RecordProperty(name_, std::to_string(largest_ * 1e9) + "e-9"); }
  Distance(const Distance&) = delete;
  Distance& operator=(const Distance&) = delete;

  /// Fails where `value` is off `expected` by more than `tolerance` of it, or of `floor`.
  void holds(double value, double expected, double tolerance, const std::string& where,
             double floor = 0.0) {
    const double size = std::max(std::abs(expected), floor);
    const double off = size > 0.0 ? std::abs(value - expected) / size : std::abs(value - expected);
    largest_ = std::max(largest_, off);
    EXPECT_LE(off, tolerance) << where << ": " << value << " against " << expected;
  }

 private:
  std::string name_;
  double largest_ = 0.0;
};

}  // namespace raceway::friction::contact
