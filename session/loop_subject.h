#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fit/subject.h"
#include "model/model.h"
#include "record/record.h"

namespace raceway::session {

/// `--per-record f0,z` of a command: what every one of several records has for itself.
struct PerRecord {
  std::vector<std::string> names;

  /// A model as the loop sees it: of one record, or of several that were joined. What is named is
  /// free, whether or not it is in the model. Throws io::InputError: names where there is one
  /// record, a name that is no parameter of the model, one given twice.
  [[nodiscard]] std::shared_ptr<const fit::Subject> subject(const model::Model& model,
                                                            const record::Record& data) const;
};

}  // namespace raceway::session
