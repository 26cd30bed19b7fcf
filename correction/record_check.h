#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/transfer_function.h"
#include "fit/noise.h"
#include "record/record.h"

namespace raceway::correction {

/// Properties of a time record that limit the identification of a correction model.
struct RecordCheck {
  struct Quantum {
    const Channel* column = nullptr;
    double step = unset;  ///< resolution [SI]; see quantum_of()
  };
  struct Printed {
    std::string channel;
    double factor = 1.0;  ///< SI value of the unit of the input column
    /// Resolution of the input in the record [SI]. If quantum_of() finds no resolution, 0.1 of the
    /// unit of the column is assumed.
    double quantum = unset;
    TransferFunctionCheck check;
  };
  const Channel* displacement = nullptr;
  double sampling = unset;   ///< median time between rows [s]
  double duration = unset;   ///< duration of the longest run [s]
  std::size_t readings = 0;  ///< number of readings of the displacement
  /// Scatter of repeated readings. A group of readings counts as repeated if they are close in
  /// time, with a long break before and after the group.
  fit::Repeatability repeatability{};
  /// Upper bound of the standard deviation of the noise [m]. The check computes the bound only if
  /// `reading_interval` exceeds 120 s and `repeatability` is unknown; otherwise the value is NaN.
  double noise_at_most = unset;
  double reading_interval = unset;  ///< median time between two readings [s]
  /// Limits of the time constants that a fit can determine from the record [s]; see
  /// time_constants_of().
  double shortest = unset, longest = unset;
  std::vector<Quantum> quanta{};
  std::vector<Printed> printed{};  ///< one check for each published transfer function of the model
  std::vector<record::Note> warnings{};
  /// Warnings about sensors that are inputs of the model. `warnings` contains these warnings too.
  std::vector<record::Note> of_its_inputs{};
};

/// Returns a sentence about the first row in which the input of a delay element is outside
/// DelayElement::domain(). The text is empty if there is no such row.
[[nodiscard]] std::string beyond_element(const Model& model, const record::Record& record);

[[nodiscard]] RecordCheck check_record(const Model& model, const record::Record& record);

}  // namespace raceway::correction
