#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/add.h"
#include "fit/calibrate.h"
#include "fit/compare.h"
#include "fit/diagnose.h"
#include "tests/support/rows.h"
#include "tests/support/subject_of.h"

/// The loop on a model and its one measured channel.
namespace raceway::fit {

inline Comparison compare(const Model& model, const DataSet& data, int fitted_parameters = 0) {
  return compare(*subject_of(model), data, fitted_parameters).at(0);
}

inline Comparison compare(const std::vector<double>& predicted, const DataSet& data,
                          int fitted_parameters = 0) {
  return compare(predicted, data, Measured{.channel = &data.measured()}, fitted_parameters);
}

inline Calibration calibrate(const Model& model, const DataSet& data,
                             const CalibrateOptions& options = {}) {
  return calibrate(*subject_of(model), data, options);
}

inline const Model& model_of(const Calibration& calibration) {
  return model::model_of(*calibration.subject);
}

inline Diagnosis diagnose(const Model& model, const DataSet& data,
                          const DiagnoseOptions& options = {}) {
  return diagnose(*subject_of(model), data, options);
}

inline AddResult add(const Model& model, std::span<const std::string> ids, const DataSet& data) {
  return add(*subject_of(model), ids, data);
}

}  // namespace raceway::fit
