#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "correction/model.h"
#include "model/model.h"
#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::results {

/// Difference between a correction from step responses and the full simulation that gave these step
/// responses.
struct Superposition {
  std::size_t rows = 0;
  double rms = unset;                      ///< rms of correction minus simulation [m]
  double largest = unset;                  ///< largest absolute difference [m]
  double time_of_largest = unset;          ///< [s]
  double lowest = unset, highest = unset;  ///< range of the simulated displacement [m]
  spindle::Report report = {};
  /// Values row by row: [s], [rad/s], [m].
  std::vector<double> time = {}, speed = {}, simulated = {}, corrected = {};
};

/// Runs correction and simulation over a programme: a record with time, speed and optional axial
/// and radial loads. If a load has no column, it is zero. `inputs` contains all other inputs of the
/// simulation. Correction and simulation both start at rest at ambient temperature. Throws
/// std::invalid_argument for a model that is not a spindle and for a record that lacks a column.
/// Throws fit::Cancelled if `cancelled` is set during the calculation.
[[nodiscard]] Superposition superposition(const model::Model& model,
                                          const correction::Model& correction,
                                          const record::Record& programme,
                                          const spindle::Inputs& inputs = {},
                                          const std::atomic<bool>* cancelled = nullptr);

/// Returns a programme with half-hour intervals at fractions of the highest speed [rad/s] and at
/// standstill. No step response contains this sequence.
[[nodiscard]] record::Record trial_programme(double fastest);

/// Returns "0.42 um rms, 1.9 um at most (after 3.20 h); the displacement varies by 57.3 um".
[[nodiscard]] std::string superposition_text(const Superposition& s);

}  // namespace raceway::results
