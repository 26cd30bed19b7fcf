#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Mean of neighbouring readings that was held out of a fit, and its residual.
struct HeldOutReading {
  std::size_t channel = 0;  ///< index in Subject::measured()
  std::size_t row = 0;      ///< index of the middle one of the averaged rows
  int part = 0;             ///< index of the block of rows that was held out
  double residual = unset;  ///< prediction minus reading [SI]
};

/// Fit of a model that only approximates the readings (Subject::approximates()).
struct Refit {
  std::shared_ptr<const Subject> subject{};
  std::vector<HeldOutReading> held_out{};
};

}  // namespace raceway::fit
