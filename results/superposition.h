#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "correction/model.h"
#include "model/model.h"
#include "record/record.h"
#include "spindle/spindle.h"

namespace raceway::results {

/// Difference between a correction and the full simulation that its step responses come from.
struct Superposition {
  std::size_t rows = 0;
  double rms = unset;                      ///< of correction less simulation [m]
  double largest = unset;                  ///< by amount [m]
  double time_of_largest = unset;          ///< [s]
  double lowest = unset, highest = unset;  ///< displacement of the simulation [m]
  spindle::Report report = {};
  /// Row by row: [s], [rad/s], [m].
  std::vector<double> time = {}, speed = {}, simulated = {}, corrected = {};
};

/// Runs both over a programme: a record with time, speed and maybe axial and radial load, which
/// hold for both as the record says; without a column there is no such load. `inputs`: all else of
/// the simulation. Both begin at rest at the ambient temperature. Throws std::invalid_argument for
/// a model that is no spindle, and a record that lacks a column, fit::Cancelled where `cancelled`
/// is set meanwhile.
[[nodiscard]] Superposition superposition(const model::Model& model,
                                          const correction::Model& correction,
                                          const record::Record& programme,
                                          const spindle::Inputs& inputs = {},
                                          const std::atomic<bool>* cancelled = nullptr);

/// Half hours at shares of the fastest speed [rad/s], with rests: a course that no step response
/// contains.
[[nodiscard]] record::Record trial_programme(double fastest);

/// "0.42 um rms, 1.9 um at most (after 3.20 h), of a travel of 57.3 um".
[[nodiscard]] std::string superposition_text(const Superposition& s);

}  // namespace raceway::results
