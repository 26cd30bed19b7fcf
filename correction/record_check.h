#pragma once

#include <string>
#include <vector>

#include "correction/model.h"
#include "correction/transfer_function.h"
#include "record/record.h"

namespace raceway::correction {

/// What a record over time is worth for a model.
struct RecordCheck {
  struct Quantum {
    const Channel* column = nullptr;
    double step = unset;  ///< [SI]: every value is a multiple of it from the least
  };
  struct Printed {
    std::string channel;
    TransferFunctionCheck check;
  };
  double sampling = unset;                   ///< median time between rows [s]
  double duration = unset;                   ///< of the longest run [s]
  std::size_t readings = 0;                  ///< of the displacement
  double reading_interval = unset;           ///< median [s]
  double shortest = unset, longest = unset;  ///< time constants that it can tell [s]
  std::vector<Quantum> quanta{};
  std::vector<Printed> printed{};       ///< polynomials of the model
  std::vector<std::string> warnings{};  ///< for people, a sentence each
};

[[nodiscard]] RecordCheck check_record(const Model& model, const record::Record& record);

}  // namespace raceway::correction
