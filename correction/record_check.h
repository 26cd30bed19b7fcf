#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/transfer_function.h"
#include "fit/noise.h"
#include "record/record.h"

namespace raceway::correction {

/// Properties of a record over time that matter for a model.
struct RecordCheck {
  struct Quantum {
    const Channel* column = nullptr;
    double step = unset;  ///< [SI]: every value is a multiple of it from the least
  };
  struct Printed {
    std::string channel;
    double factor = 1.0;     ///< SI over the unit of the input's column
    double quantum = unset;  ///< of the input, as the record shows it, or 0.1 of its unit [SI]
    TransferFunctionCheck check;
  };
  const Channel* displacement = nullptr;
  double sampling = unset;                   ///< median time between rows [s]
  double duration = unset;                   ///< of the longest run [s]
  std::size_t readings = 0;                  ///< of the displacement
  fit::Repeatability repeatability{};        ///< of readings that were repeated in stops
  double noise_at_most = unset;              ///< of readings that stand far apart [m]
  double reading_interval = unset;           ///< median [s]
  double shortest = unset, longest = unset;  ///< time constants that it can tell [s]
  std::vector<Quantum> quanta{};
  std::vector<Printed> printed{};  ///< polynomials of the model
  std::vector<record::Note> warnings{};
  /// Warnings that concern the sensors of the model's inputs.
  std::vector<record::Note> of_its_inputs{};
};

/// Describes where an input leaves the range of its delay element, in a sentence; empty where it
/// never does.
[[nodiscard]] std::string beyond_element(const Model& model, const record::Record& record);

[[nodiscard]] RecordCheck check_record(const Model& model, const record::Record& record);

}  // namespace raceway::correction
