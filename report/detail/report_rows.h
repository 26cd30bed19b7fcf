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

/// Rows of a record as columns of a report: settings, readings of one channel, their noise,
/// predictions. Names of columns end with the unit; readings are in the unit of the channel.
class ReportRows {
 public:
  /// `rows` of the record, in increasing order.
  ReportRows(const record::Record& record, const record::Channel& channel,
             std::vector<std::size_t> rows);

  [[nodiscard]] const std::vector<std::size_t>& rows() const { return rows_; }
  /// Places numbers in the order of the errors of a comparison by row of the page; NaN elsewhere.
  [[nodiscard]] std::vector<double> by_row(const verdict::Comparison& comparison,
                                           std::span<const double> values) const;

  /// Adds a column of readings by row of the page [SI]. Returns its name: `name` and the unit.
  std::string add_readings(const std::string& name, std::vector<double> values);
  /// Adds the standard deviation of each reading [SI], NaN if not known.
  void add_std(std::vector<double> std);
  /// Adds the predictions of a model as the next of the columns `predicted_0_UNIT`, ..., and its
  /// errors on the plan. Call it after add_std().
  void add_model(const std::string& name, const verdict::Comparison& comparison);

  void finish(Document& document) const;

 private:
  void add_inputs();
  /// Returns true for several records. They replace runs unless there are more runs than records.
  [[nodiscard]] bool by_record() const {
    return !record_.parts.empty() && record_.runs.size() <= record_.parts.size();
  }
  [[nodiscard]] bool shows(const record::Column& input) const;
  [[nodiscard]] std::vector<double> picked(std::span<const double> values) const;

  const record::Record& record_;
  const record::Channel& channel_;
  std::vector<std::size_t> rows_, place_;  // row of the record by row of the page, and the inverse
  std::vector<double> std_;
  std::vector<std::string> inputs_;
  text::json models_ = text::json::array();
  ReportColumns columns_;
};

/// Returns the rows of a record with a reading of the channel.
[[nodiscard]] std::vector<std::size_t> rows_read(const record::Record& record,
                                                 const record::Channel& channel);

/// Returns the rows of a record used in a comparison, in increasing order.
[[nodiscard]] std::vector<std::size_t> rows_compared(const verdict::Comparison& comparison);

}  // namespace raceway::report
