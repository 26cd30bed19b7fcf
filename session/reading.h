#pragma once

#include <string>

#include "io/model_file.h"
#include "session/period.h"

namespace raceway::session {

/// `--columns map.toml` and `--drop-nan` of a command that reads measurements.
struct Reading {
  std::string columns{};
  std::string columns_text{};  ///< the map itself, in place of its file
  bool drop_nan = false;
  Period period{};  ///< declared where records over time are read

  /// How measurements are read: by the map of the flag, else by [columns] of the model. Throws
  /// io::InputError for a period: rows of a friction rig are no course in time.
  [[nodiscard]] io::ReadOptions options(const io::ModelFile& model) const;
  [[nodiscard]] io::ReadOptions options(const io::ColumnMap& of_model) const;
  /// The same without a model.
  [[nodiscard]] io::ReadOptions options() const;
};

}  // namespace raceway::session
