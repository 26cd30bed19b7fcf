#pragma once

#include <string>

#include "verdict/add.h"
#include "verdict/diagnosis.h"

/// Writes results of diagnose and add as JSON documents (docs/files.md); see results.h.
namespace raceway::results {

[[nodiscard]] std::string diagnosis_json(const std::string& model_file,
                                         const record::Record& record,
                                         const verdict::Diagnosis& diagnosis);

[[nodiscard]] std::string add_json(const std::string& model_file, const record::Record& record,
                                   const verdict::AddResult& result);

}  // namespace raceway::results
