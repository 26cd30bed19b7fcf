#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Mean of neighbouring readings that a fit to the other parts of the record predicts.
struct HeldOutReading {
  std::size_t channel = 0;  ///< index in Subject::measured()
  std::size_t row = 0;      ///< row in the middle of the mean
  int part = 0;             ///< held-out part of the record
  double residual = unset;  ///< prediction minus reading [SI]
};

/// Fit of a model that only approximates the readings (Subject::approximates()).
struct Refit {
  std::shared_ptr<const Subject> subject{};
  std::vector<HeldOutReading> held_out{};
};

}  // namespace raceway::fit
