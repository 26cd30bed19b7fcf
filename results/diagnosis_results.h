#pragma once

#include <string>

#include "fit/add.h"
#include "fit/diagnosis.h"

/// What diagnose and add found, as JSON documents (docs/files.md); see results.h.
namespace raceway::results {

[[nodiscard]] std::string diagnosis_json(const std::string& model_file,
                                         const record::Record& record,
                                         const fit::Diagnosis& diagnosis);

[[nodiscard]] std::string add_json(const std::string& model_file, const record::Record& record,
                                   const fit::AddResult& result);

}  // namespace raceway::results
