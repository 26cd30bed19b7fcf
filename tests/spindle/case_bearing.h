#pragma once

#include <memory>
#include <regex>
#include <stdexcept>
#include <string>

#include "bearing/bearing.h"
#include "record/units.h"

namespace raceway::spindle {

/// The bearing that a case describes in words: "D 11.9 mm, d_m 90 mm, Z 20, 15 deg, f 0.52", of
/// steel. Friction asks for a static load rating, which no case has to do with.
inline std::shared_ptr<const bearing::Bearing> case_bearing(const std::string& words) {
  const auto number = [&](const char* pattern) {
    std::smatch found;
    if (!std::regex_search(words, found, std::regex(pattern)))
      throw std::invalid_argument("bearing of a case: no " + std::string(pattern) + " in " + words);
    return std::stod(found[1]);
  };
  const double conformity = number(R"(f (\d[\d.]*))");
  return std::make_shared<const bearing::Bearing>(
      bearing::BearingGeometry{.ball_count = static_cast<int>(number(R"(Z (\d+))")),
                               .ball_diameter = number(R"(D (\d[\d.]*))") * mm,
                               .pitch_diameter = number(R"(d_m (\d[\d.]*))") * mm,
                               .contact_angle = number(R"((\d[\d.]*) deg)") * degree,
                               .inner_conformity = conformity,
                               .outer_conformity = conformity,
                               .static_load_rating = 45000.0},
      bearing::steel(), bearing::steel());
}

}  // namespace raceway::spindle
