#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/period_flag.h"
#include "io/model_file.h"

namespace raceway::cli {

/// `--columns map.toml` and `--drop-nan` of a command that reads measurements.
struct DataFlag {
  std::string columns;
  bool drop_nan = false;
  PeriodFlag period{};  ///< declared where records over time are read

  /// Declares the flags.
  void declare(CLI::App& command);
  /// How measurements are read: by the map of the flag, else by [columns] of the model. Throws
  /// io::InputError for a period: rows of a friction rig are no course in time.
  [[nodiscard]] io::ReadOptions options(const io::ModelFile& model) const;
  [[nodiscard]] io::ReadOptions options(const io::ColumnMap& of_model) const;
  /// The same without a model.
  [[nodiscard]] io::ReadOptions options() const;
};

}  // namespace raceway::cli
