#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "record/record.h"
#include "report/detail/report_document.h"
#include "report/report_columns.h"
#include "verdict/compare.h"

namespace raceway::report {

/// Table of record rows on a report page. The columns are the inputs, the readings of one channel,
/// the standard deviations of the readings, and predictions. Column names end with the unit.
/// Readings are in the unit of the channel.
class ReportRows {
 public:
  /// `rows` contains the indices of the rows on the page, in increasing order.
  ReportRows(const record::Record& record, const record::Channel& channel,
             std::vector<std::size_t> rows);

  [[nodiscard]] const std::vector<std::size_t>& rows() const { return rows_; }
  /// Returns one value for each row of the page. `values` has the order of `comparison.errors`.
  /// Rows of the page without a value are NaN.
  [[nodiscard]] std::vector<double> by_row(const verdict::Comparison& comparison,
                                           std::span<const double> values) const;

  /// Adds a column with one reading for each row of the page [SI]. Returns the column name, which
  /// consists of `name` and the unit.
  std::string add_readings(const std::string& name, std::vector<double> values);
  /// Adds a column with the standard deviation of each reading [SI]; NaN means unknown.
  void add_std(std::vector<double> std);
  /// Adds a model: its predictions as the next column `predicted_0_UNIT`, `predicted_1_UNIT`, ...;
  /// its RMS error; and a map of its errors over the inputs. Call this function after add_std().
  void add_model(const std::string& name, const verdict::Comparison& comparison);

  void finish(Document& document) const;

 private:
  void add_inputs();
  /// Returns true if the page groups the rows by record, otherwise by run. The page groups by
  /// record if several records were joined and there are not more runs than records.
  [[nodiscard]] bool by_record() const {
    return !record_.parts.empty() && record_.runs.size() <= record_.parts.size();
  }
  [[nodiscard]] bool shows(const record::Column& input) const;
  [[nodiscard]] std::vector<double> picked(std::span<const double> values) const;

  const record::Record& record_;
  const record::Channel& channel_;
  std::vector<std::size_t> rows_, place_;  // rows_: record row of each page row; place_: inverse
  std::vector<double> std_;
  std::vector<std::string> inputs_;
  text::json models_ = text::json::array();
  ReportColumns columns_;
};

/// Returns the indices of the rows that have a reading of the channel.
[[nodiscard]] std::vector<std::size_t> rows_read(const record::Record& record,
                                                 const record::Channel& channel);

/// Returns the indices of the record rows that a comparison used, in increasing order.
[[nodiscard]] std::vector<std::size_t> rows_compared(const verdict::Comparison& comparison);

}  // namespace raceway::report
