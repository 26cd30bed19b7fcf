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

  /// Copies the tolerances into the model. Each tolerance applies to the measured channels with the
  /// same unit. Throws text::InputError in these cases:
  ///   - A number has no unit or is not above 0, or two numbers have the same unit.
  ///   - A number has a unit in which the model predicts no measured channel.
  ///   - The model file already gives a tolerance for a channel with the unit of a number.
  void set(files::ModelFile& file) const;
  void set(correction::Model& model, const std::string& source) const;

 private:
  using Set = std::function<void(const record::Channel&, double)>;
  /// Sets the tolerances of the measured channels. `table` is the name of the table in the model
  /// file that may contain tolerances; an error message names this table.
  void set(const std::vector<fit::Measured>& measured, const std::string& source,
           std::string_view table, const Set& take) const;
};

}  // namespace raceway::session
