#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "files/model_file.h"
#include "model/band.h"

namespace raceway::cli {

/// Flag `--band` of a command: uncertainty of its numbers from the fitted parameters.
struct BandFlag {
  bool on = false;

  /// Declares the flag.
  void declare(CLI::App& command);
  /// Returns nothing if no band was requested. Throws text::InputError if the model has no
  /// covariance of its values.
  [[nodiscard]] std::optional<model::Band> of(const files::ModelFile& file) const;
};

/// Returns a text such as "+- 0.23" for a half width [SI]. `unit` is the factor of the unit of the
/// text.
[[nodiscard]] std::string band_text(double half_width, double unit = 1.0);

}  // namespace raceway::cli
