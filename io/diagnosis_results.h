#pragma once

#include <string>

#include "fit/add.h"
#include "fit/diagnose.h"

/// What diagnose and add found, as JSON documents (DESIGN.md, Commands); see results.h.
namespace raceway::io {

[[nodiscard]] std::string diagnosis_json(const std::string& model_file, const fit::DataSet& data,
                                         const fit::Diagnosis& diagnosis);

[[nodiscard]] std::string add_json(const std::string& model_file, const fit::DataSet& data,
                                   const fit::AddResult& result);

}  // namespace raceway::io
