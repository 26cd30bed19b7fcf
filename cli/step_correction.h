#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "results/superposition.h"
#include "session/spindle_steps.h"
#include "text/output_file.h"

namespace raceway::cli {

/// Flags `--correction FILE`, `--law`, `--lags` and `--programme`. With these flags, the command
/// makes a correction from step responses, and compares the displacements from the correction with
/// the displacements from the full simulation.
struct StepCorrectionFlags {
  std::string file, programme, law = "curve", lags = "auto";

  void declare(CLI::App& command);
  /// Throws text::InputError for `--programme` without `--correction` or without a model, and for
  /// `--correction -`. `has_model` is true if the command line names a model.
  void check(bool has_model) const;
  /// Throws text::InputError if the correction file or one of its CSV tables cannot be written.
  void require_writable(text::IfExists if_exists,
                        const std::vector<std::string>& load_channels) const;
  /// Writes the correction file and its CSV tables; does nothing without `--correction`.
  void write(const session::SpindleSteps& steps, bool replace) const;
  /// Compares, for the speed programme in the file `programme`, the displacements from the written
  /// correction with the displacements from the full simulation. Returns nothing if `programme` is
  /// empty.
  [[nodiscard]] std::optional<results::Superposition> superposition(
      const session::SpindleSteps& steps) const;
};

}  // namespace raceway::cli
