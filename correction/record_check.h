#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/transfer_function.h"
#include "fit/noise.h"
#include "record/record.h"

namespace raceway::correction {

/// Properties of a time record that matter for a correction model.
struct RecordCheck {
  struct Quantum {
    const Channel* column = nullptr;
    double step = unset;  ///< [SI]; all values are the smallest value plus multiples of it
  };
  struct Printed {
    std::string channel;
    double factor = 1.0;  ///< one unit of the input's column in SI
    /// Resolution of the input in the record, if visible, else 0.1 of its unit [SI].
    double quantum = unset;
    TransferFunctionCheck check;
  };
  const Channel* displacement = nullptr;
  double sampling = unset;             ///< median time between rows [s]
  double duration = unset;             ///< duration of the longest run [s]
  std::size_t readings = 0;            ///< number of readings of the displacement
  fit::Repeatability repeatability{};  ///< from repeated readings within stops
  /// Upper bound of the noise if readings are more than 120 s apart [m].
  double noise_at_most = unset;
  double reading_interval = unset;  ///< median time between two readings [s]
  /// Range of time constants that the record can determine [s].
  double shortest = unset, longest = unset;
  std::vector<Quantum> quanta{};
  std::vector<Printed> printed{};  ///< printed transfer functions of the model
  std::vector<record::Note> warnings{};
  /// The warnings that concern sensors of the model's inputs.
  std::vector<record::Note> of_its_inputs{};
};

/// Describes in one sentence the first row in which an input leaves the range of its delay element.
/// The text is empty if there is no such row.
[[nodiscard]] std::string beyond_element(const Model& model, const record::Record& record);

[[nodiscard]] RecordCheck check_record(const Model& model, const record::Record& record);

}  // namespace raceway::correction
