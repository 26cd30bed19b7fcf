#include "bearing/validation.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace raceway::bearing {

void refuse(std::string_view name, double value, double lower, double upper, double unit,
            std::string_view unit_name) {
  const std::string suffix = unit_name.empty() ? "" : " " + std::string(unit_name);
  std::ostringstream text;
  if (std::isnan(value)) {
    text << name << " is missing";
  } else {
    text << name << " = " << value / unit << suffix;
  }
  text << ": must be from " << lower / unit << " to " << upper / unit << suffix;
  throw std::invalid_argument(text.str());
}

}  // namespace raceway::bearing
