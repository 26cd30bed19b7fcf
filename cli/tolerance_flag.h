#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "io/model_file.h"

namespace raceway::cli {

/// `--tolerance 2um,0.5K` of a command: errors that do not matter to whoever uses the model.
struct ToleranceFlag {
  std::string text;

  /// Declares the flag.
  void declare(CLI::App& command);
  /// Gives them to the model, for this run. The unit says which measured channels are meant.
  /// Throws io::InputError: no number with a unit, a unit in which nothing is measured, a channel
  /// that has a tolerance already.
  void set(io::ModelFile& file) const;
};

}  // namespace raceway::cli
