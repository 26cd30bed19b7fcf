#pragma once

#include <algorithm>
#include <string>

#include "cli/text_table.h"
#include "correction/baseline.h"
#include "correction/identify.h"
#include "correction/trust.h"
#include "record/record.h"

namespace raceway::cli {

/// Chooses where a table of several displacements shows the unit. If all displacements have the
/// same unit, the unit is printed above the columns. Otherwise the unit follows each number.
class CommonUnit {
 public:
  /// Each of the `results` has a member `displacement`.
  template <typename Results>
  explicit CommonUnit(const Results& results) {
    const auto unit_of = [](const auto& one) { return one.displacement->unit; };
    if (std::all_of(results.begin(), results.end(),
                    [&](const auto& one) { return unit_of(one) == unit_of(results.front()); }))
      head_ = unit_of(results.front());
  }
  [[nodiscard]] const std::string& head() const { return head_; }
  template <typename Result>
  [[nodiscard]] std::string text(const Result& one, double si, int digits) const {
    const record::Channel& c = *one.displacement;
    return number(c.in_unit(si), digits) + (head_.empty() ? " " + std::string(c.unit) : "");
  }

 private:
  std::string head_{};
};

/// Prints a line on the trust in a correction: whether the correction can be used, and in which
/// range.
void print_trust(const record::Channel& displacement, const correction::Trust& trust);

/// Prints the error measures that papers use in addition to the RMS error and Metrics::fit_percent:
/// mean absolute error, peak-to-peak error, and reduction of the largest error relative to the
/// largest displacement. Prints nothing if there are no readings.
void print_more_errors(const record::Channel& displacement, const correction::Metrics& m);

/// Prints the result of an identification: lags, gains and the error of the model.
void print_identification(const correction::Identification& found, const record::Record& record);
/// Prints the errors and the time constants of the ARX models, one row for each order.
void print_baseline(const record::Channel& displacement, const correction::ArxBaseline& found,
                    const record::Record& record);

}  // namespace raceway::cli
