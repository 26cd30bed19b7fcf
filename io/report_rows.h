#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fit/data_set.h"
#include "fit/quantity.h"
#include "io/report_columns.h"
#include "io/report_document.h"

namespace raceway::io {

/// What one model says of all rows.
struct Predicted {
  std::string name;
  std::vector<double> readings;  ///< SI, NaN where there is none
};

/// Rows of a data set as columns of a report: what was set, what was read, its noise, what models
/// say. Names of columns end with the unit; readings are in that of the measured quantity.
class ReportRows {
 public:
  /// `std` of each row in SI, NaN where not known.
  ReportRows(const fit::DataSet& data, std::vector<double> std);

  /// A column of readings, here in SI. Returns its name, which is `name` and the unit.
  std::string add_readings(const std::string& name, const std::vector<double>& values);

  /// Columns `predicted_0_UNIT`, ... and, for each, where the model errs on the plan.
  void add_models(const std::vector<Predicted>& models, Document& document);

  void finish(Document& document) const;

 private:
  template <typename Value>
  void add(const std::string& name, Value value) {
    std::vector<double> values;
    values.reserve(data_.rows.size());
    for (const fit::Row& r : data_.rows) values.push_back(static_cast<double>(value(r)));
    columns_.add(name, std::move(values));
  }
  /// What was set, and may explain an error.
  template <typename Value>
  void add_input(const std::string& name, Value value) {
    add(name, value);
    inputs_.push_back(name);
  }
  [[nodiscard]] bool known(double fit::Row::*member) const {
    return std::any_of(data_.rows.begin(), data_.rows.end(),
                       [&](const fit::Row& r) { return !std::isnan(r.*member); });
  }

  const fit::DataSet& data_;
  fit::QuantityText quantity_;
  std::vector<double> std_;
  std::vector<std::string> inputs_;
  ReportColumns columns_;
};

}  // namespace raceway::io
