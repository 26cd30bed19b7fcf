#pragma once

#include <string>

#include "verdict/add.h"
#include "verdict/diagnosis.h"

/// Writes results of `raceway diagnose` and `raceway add` as JSON documents (docs/files.md).
namespace raceway::results {

[[nodiscard]] std::string diagnosis_json(const std::string& model_file,
                                         const record::Record& record,
                                         const verdict::Diagnosis& diagnosis);

[[nodiscard]] std::string add_json(const std::string& model_file, const record::Record& record,
                                   const verdict::AddResult& result);

}  // namespace raceway::results
