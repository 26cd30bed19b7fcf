#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/model.h"
#include "files/model_file.h"
#include "fit/subject.h"

namespace raceway::session {

/// Tolerances of the option `--tolerance 2um,0.5K`: the largest RMS errors that the user accepts.
struct Tolerance {
  std::string text;

  /// Sets the tolerances in the model for this calculation. The unit selects the measured channels.
  /// Throws text::InputError for a number without a unit or not above 0, for two numbers with
  /// the same unit, for a unit without a measured channel, and for a channel that already has a
  /// tolerance.
  void set(files::ModelFile& file) const;
  void set(correction::Model& model, const std::string& source) const;

 private:
  using Set = std::function<void(const record::Channel&, double)>;
  /// Sets the tolerances of the measured channels. `table` is the table in which the file may give
  /// a tolerance.
  void set(const std::vector<fit::Measured>& measured, const std::string& source,
           std::string_view table, const Set& take) const;
};

}  // namespace raceway::session
