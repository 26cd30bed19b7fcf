#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Mean of neighbouring readings that was held out of a fit.
struct HeldOutReading {
  std::size_t channel = 0;  ///< index in Subject::measured()
  std::size_t row = 0;      ///< row of the reading in the middle of the averaged readings
  int part = 0;             ///< index of the held-out block that contains the reading
  double residual = unset;  ///< prediction minus reading [SI]
};

/// Fitted spindle model or correction (Subject::approximates()), with the held-out readings.
struct Refit {
  std::shared_ptr<const Subject> subject{};
  std::vector<HeldOutReading> held_out{};
};

}  // namespace raceway::fit
