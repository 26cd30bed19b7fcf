#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// A mean of readings, predicted by a fit to the other parts of its record.
struct HeldOutReading {
  std::size_t channel = 0;  ///< of Subject::measured()
  std::size_t row = 0;      ///< of the record, in its middle
  int part = 0;             ///< held-out part
  double residual = unset;  ///< prediction minus reading [SI]
};

/// A subject that only approximates, as a fit left it.
struct Refit {
  std::shared_ptr<const Subject> subject{};
  std::vector<HeldOutReading> held_out{};
};

}  // namespace raceway::fit
