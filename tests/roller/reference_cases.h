#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bearing/roller_equilibrium.h"
#include "tests/places.h"

namespace raceway::roller {

/// A case of data/reference/roller_reference.json, whose numbers are in the units of its keys.
class ReferenceCase {
 public:
  explicit ReferenceCase(nlohmann::json c)
      : json_(std::move(c)), tolerance_(json_.at("tolerance").get<double>()) {
    largest(json_.at("outputs"));
  }

  [[nodiscard]] std::string id() const { return json_.at("id"); }
  [[nodiscard]] const nlohmann::json& inputs() const { return json_.at("inputs"); }
  [[nodiscard]] const nlohmann::json& outputs() const { return json_.at("outputs"); }
  [[nodiscard]] double in(const std::string& key, double otherwise = 0.0) const {
    const auto found = inputs().find(key);
    return found == inputs().end() || !found->is_number() ? otherwise : found->get<double>();
  }

  /// `value`, in the unit of the key, is that of `row` within the tolerance of the case, relative
  /// to the largest number of that name in it.
  void holds(const nlohmann::json& row, const std::string& key, double value) const {
    near(row.at(key).get<double>(), value, key);
  }
  void holds(const nlohmann::json& row, const std::string& key,
             const std::vector<double>& values) const {
    const auto expected = row.at(key).get<std::vector<double>>();
    ASSERT_EQ(values.size(), expected.size()) << id() << ", " << key;
    for (std::size_t i = 0; i < values.size(); ++i) near(expected[i], values[i], key);
  }

 private:
  void largest(const nlohmann::json& part) {
    if (part.is_object())
      for (const auto& [key, value] : part.items()) {
        if (value.is_array() || value.is_object()) largest(value);
        note(key, value);
      }
    if (part.is_array())
      for (const auto& value : part)
        if (value.is_object()) largest(value);
  }
  void note(const std::string& key, const nlohmann::json& value) {
    if (value.is_array())
      for (const auto& v : value) note(key, v);
    if (!value.is_number()) return;
    auto found =
        std::find_if(sizes_.begin(), sizes_.end(), [&](const auto& s) { return s.first == key; });
    if (found == sizes_.end()) found = sizes_.insert(sizes_.end(), {key, 0.0});
    found->second = std::max(found->second, std::abs(value.get<double>()));
  }
  void near(double expected, double value, const std::string& key) const {
    const auto found =
        std::find_if(sizes_.begin(), sizes_.end(), [&](const auto& s) { return s.first == key; });
    // Zeros of the reference are its own rounding, some 1e-13 N; 1e-9 of any load here is more.
    const double size = found->second > 1e-9 ? found->second : 1e-9 / tolerance_;
    EXPECT_NEAR(value, expected, tolerance_ * size) << id() << ", " << key;
  }

  nlohmann::json json_;
  double tolerance_;
  std::vector<std::pair<std::string, double>> sizes_;
};

/// All cases of one group.
inline std::vector<ReferenceCase> reference_cases(std::string_view group) {
  std::ifstream file(tests::source_dir() + "/data/reference/roller_reference.json");
  const nlohmann::json all = nlohmann::json::parse(file);
  std::vector<ReferenceCase> found;
  for (const nlohmann::json& c : all.at("cases"))
    if (c.at("group") == group) found.emplace_back(c);
  return found;
}

/// The one of that name.
inline ReferenceCase reference_case(std::string_view group, std::string_view id) {
  for (ReferenceCase& c : reference_cases(group))
    if (c.id() == id) return c;
  throw std::out_of_range(std::string(id));
}

/// The geometry of the inputs, with `row` in place of those that it has.
inline bearing::RollerGeometry geometry(const ReferenceCase& c, const nlohmann::json& row = {}) {
  const auto number = [&](const char* key) {
    if (row.is_object() && row.contains(key) && row.at(key).is_number())
      return row.at(key).get<double>();
    return c.in(key, unset);
  };
  const auto text = [&](const char* key) {
    if (row.is_object() && row.contains(key) && row.at(key).is_string())
      return row.at(key).get<std::string>();
    return c.inputs().contains(key) && c.inputs().at(key).is_string()
               ? c.inputs().at(key).get<std::string>()
               : std::string();
  };
  bearing::RollerGeometry g{.roller_count = static_cast<int>(number("roller_count")),
                            .roller_diameter = number("roller_diameter_mm") * mm,
                            .roller_length = number("roller_length_mm") * mm,
                            .pitch_diameter = number("pitch_diameter_mm") * mm};
  if (const double s = number("radial_clearance_um"); !std::isnan(s)) g.radial_clearance = s * um;
  if (text("profile") == "none") g.profile = bearing::RollerProfile::none;
  g.bore = number("bore_mm") * mm;
  g.outer_diameter = number("outer_diameter_mm") * mm;
  return g;
}

inline bearing::RollerBearing steel_bearing(const bearing::RollerGeometry& geometry) {
  return {geometry, bearing::steel(), bearing::steel()};
}

/// N1012 with assumed rollers: 20 of 8 x 8 mm on a pitch circle of 77.5 mm.
inline bearing::RollerGeometry n1012() {
  return {.roller_count = 20,
          .roller_diameter = 8 * mm,
          .roller_length = 8 * mm,
          .pitch_diameter = 77.5 * mm,
          .bore = 60 * mm,
          .outer_diameter = 95 * mm,
          .width = 18 * mm};
}

}  // namespace raceway::roller
