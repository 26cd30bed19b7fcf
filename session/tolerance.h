#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "correction/model.h"
#include "files/model_file.h"
#include "fit/subject.h"

namespace raceway::session {

/// `--tolerance 2um,0.5K` of a command: errors that do not matter to the user of the model.
struct Tolerance {
  std::string text;

  /// Gives them to the model, for this run. The unit says which measured channels are meant.
  /// Throws text::InputError: no number with a unit, a unit in which nothing is measured, a channel
  /// that has a tolerance already.
  void set(files::ModelFile& file) const;
  void set(correction::Model& model, const std::string& source) const;

 private:
  using Set = std::function<void(const record::Channel&, double)>;
  /// `table`: where the file has its own.
  void set(const std::vector<fit::Measured>& measured, const std::string& source,
           std::string_view table, const Set& take) const;
};

}  // namespace raceway::session
