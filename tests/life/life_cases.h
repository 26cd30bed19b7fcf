#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bearing/bearing.h"
#include "tests/friction_contact/contact_cases.h"

namespace raceway::life {

/// Cases of data/reference/contact_reference.json whose ids begin so, whatever their number.
inline std::vector<nlohmann::json> life_cases(std::string_view beginning) {
  return friction::contact::contact_cases(beginning);
}

/// `value` is that of `expected` within a share of it.
inline void expect_share(double value, double expected, double tolerance,
                         const std::string& where) {
  EXPECT_NEAR(value, expected, tolerance * std::abs(expected)) << where;
}

/// A spindle bearing of 7014 size.
inline bearing::BearingGeometry spindle_geometry() {
  return {.ball_count = 18,
          .ball_diameter = 12.7 * mm,
          .pitch_diameter = 90 * mm,
          .contact_angle = 25 * degree,
          .inner_conformity = 0.525,
          .outer_conformity = 0.515};
}

}  // namespace raceway::life
