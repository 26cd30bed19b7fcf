#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "correction/model.h"
#include "model/model.h"
#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::results {

/// Comparison of the displacements from a correction and from the simulation of the spindle. The
/// correction was made from step responses of the simulated spindle.
struct Superposition {
  std::size_t rows = 0;
  double rms = unset;                      ///< RMS of correction minus simulation [m]
  double largest = unset;                  ///< largest |correction - simulation| [m]
  double time_of_largest = unset;          ///< [s]
  double lowest = unset, highest = unset;  ///< extremes of the simulated displacement [m]
  spindle::Report report = {};
  /// Time [s], speed [rad/s], and simulated and corrected displacement [m] in each row.
  std::vector<double> time = {}, speed = {}, simulated = {}, corrected = {};
};

/// Computes correction and simulation for `programme`, a record with time, speed and optional axial
/// and radial loads. A load without a column in `programme` is zero. All inputs of the simulation
/// except speed and these loads come from `inputs`. Correction and simulation start at rest, at
/// ambient temperature. If the simulation does not converge, only `report` of the result is valid.
/// Throws std::invalid_argument if the model is not a spindle, or if `programme` lacks time or
/// speed. Throws fit::Cancelled if `cancelled` is set during the calculation.
[[nodiscard]] Superposition superposition(const model::Model& model,
                                          const correction::Model& correction,
                                          const record::Record& programme,
                                          const spindle::Inputs& inputs = {},
                                          const std::atomic<bool>* cancelled = nullptr);

/// Returns a record with a speed programme of four hours, to test a correction that was made from
/// step responses. The speed changes every half hour. All speeds are between 0 and `fastest`
/// [rad/s].
[[nodiscard]] record::Record trial_programme(double fastest);

/// Returns text such as "RMS 0.42 um, largest 1.9 um (after 3.20 h); the displacement varies by
/// 57.3 um".
[[nodiscard]] std::string superposition_text(const Superposition& s);

}  // namespace raceway::results
