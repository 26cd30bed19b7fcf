#pragma once

#include <cctype>
#include <memory>
#include <stdexcept>
#include <string>

#include "bearing/bearing.h"
#include "record/units.h"

namespace raceway::spindle {

/// The bearing that a case describes in words: "D 11.9 mm, d_m 90 mm, Z 20, 15 deg, f 0.52", of
/// steel. Friction asks for a static load rating, which no case has to do with.
inline std::shared_ptr<const bearing::Bearing> case_bearing(const std::string& words) {
  const auto digit = [&](std::size_t at) {
    return at < words.size() && std::isdigit(static_cast<unsigned char>(words[at])) != 0;
  };
  // The number behind a name, a word of its own.
  const auto number = [&](const std::string& name) {
    for (std::size_t at = words.find(name); at != words.npos; at = words.find(name, at + 1))
      if ((at == 0 || words[at - 1] == ' ') && digit(at + name.size()))
        return std::stod(words.substr(at + name.size()));
    throw std::invalid_argument("bearing of a case: no " + name + "in " + words);
  };
  const std::size_t degrees = words.find(" deg");
  const std::size_t angle = degrees == words.npos ? words.npos : words.rfind(' ', degrees - 1);
  if (angle == words.npos || !digit(angle + 1))
    throw std::invalid_argument("bearing of a case: no angle in " + words);
  const double conformity = number("f ");
  return std::make_shared<const bearing::Bearing>(
      bearing::BearingGeometry{.ball_count = static_cast<int>(number("Z ")),
                               .ball_diameter = number("D ") * mm,
                               .pitch_diameter = number("d_m ") * mm,
                               .contact_angle = std::stod(words.substr(angle + 1)) * degree,
                               .inner_conformity = conformity,
                               .outer_conformity = conformity,
                               .static_load_rating = 45000.0},
      bearing::steel(), bearing::steel());
}

}  // namespace raceway::spindle
