#pragma once

#include <span>
#include <string>
#include <vector>

#include "loop/loop.h"
#include "tests/support/rows.h"
#include "tests/support/subject_of.h"
#include "verdict/add.h"
#include "verdict/calibrate.h"
#include "verdict/compare.h"
#include "verdict/diagnose.h"

/// The loop on a model and its one measured channel.
namespace raceway::fit {

using loop::add;
using loop::calibrate;
using loop::diagnose;
using verdict::compare;

inline verdict::Comparison compare(const Model& model, const DataSet& data,
                                   int fitted_parameters = 0) {
  return compare(*subject_of(model), data, fitted_parameters).at(0);
}

inline verdict::Comparison compare(const std::vector<double>& predicted, const DataSet& data,
                                   int fitted_parameters = 0) {
  return compare(predicted, data, Measured{.channel = &data.measured()}, fitted_parameters);
}

inline verdict::Calibration calibrate(const Model& model, const DataSet& data,
                                      const verdict::CalibrateOptions& options = {}) {
  return calibrate(*subject_of(model), data, options);
}

inline const Model& model_of(const verdict::Calibration& calibration) {
  return model::model_of(*calibration.subject);
}

inline verdict::Diagnosis diagnose(const Model& model, const DataSet& data,
                                   const verdict::DiagnoseOptions& options = {}) {
  return diagnose(*subject_of(model), data, options);
}

inline verdict::AddResult add(const Model& model, std::span<const std::string> ids,
                              const DataSet& data) {
  return add(*subject_of(model), ids, data);
}

}  // namespace raceway::fit
