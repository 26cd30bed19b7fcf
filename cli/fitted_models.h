#pragma once

#include <string>
#include <vector>

#include "session/loop.h"
#include "text/output_file.h"
#include "verdict/calibrate.h"

namespace raceway::cli {

/// Model files that a fit writes: one, or where records have values of their own one for each,
/// FILE-RECORD.toml of FILE.toml.
class FittedModels {
 public:
  /// `output` may be empty: then nothing is written.
  FittedModels(std::string output, text::IfExists if_exists)
      : output_(std::move(output)), if_exists_(if_exists) {}

  /// Throws text::InputError where a file that will be written cannot be.
  void require_writable(const fit::Subject& subject) const;
  /// Writes the models that `calibration` found, and says so.
  void write(const session::LoopQuestion& asked, const verdict::Calibration& calibration) const;
  /// "a.toml" or "a-monday.toml and a-friday.toml", for messages.
  [[nodiscard]] std::string names(const fit::Subject& subject) const;

 private:
  [[nodiscard]] std::vector<std::string> files(const fit::Subject& subject) const;

  std::string output_;
  text::IfExists if_exists_;
};

}  // namespace raceway::cli
