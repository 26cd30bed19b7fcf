#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "files/model_file.h"
#include "model/band.h"

namespace raceway::cli {

/// Flag `--band` of a command. With this flag, the command calculates the 95 % confidence band of
/// its results from the uncertainty of the fitted parameters.
struct BandFlag {
  bool on = false;

  /// Declares the flag.
  void declare(CLI::App& command);
  /// Returns the confidence band of a model, or nothing if the flag is not set. Throws
  /// text::InputError if the model has no covariance of its parameters.
  [[nodiscard]] std::optional<model::Band> of(const files::ModelFile& file) const;
};

/// Returns a text such as "+- 0.23" for the half width of a confidence band [SI]. `unit` is the
/// unit in the text, expressed in SI: 1e-6 for um.
[[nodiscard]] std::string band_text(double half_width, double unit = 1.0);

}  // namespace raceway::cli
