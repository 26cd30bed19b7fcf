#pragma once

#include <algorithm>
#include <string>

#include "cli/text_table.h"
#include "correction/baseline.h"
#include "correction/identify.h"
#include "correction/trust.h"
#include "record/record.h"

namespace raceway::cli {

/// Unit of a table with results of several displacements: above its columns where all have one
/// unit, else behind each number.
class CommonUnit {
 public:
  /// `results`: each with its `displacement`.
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

/// The line of trust.
void print_trust(const record::Channel& displacement, const correction::Trust& trust);

/// Errors that papers state in addition to RMS and fit: mean absolute, peak to peak, reduction of
/// the largest; nothing where nothing was read.
void print_more_errors(const record::Channel& displacement, const correction::Metrics& m);

/// The text of an identification: lags, gains, and the error they leave.
void print_identification(const correction::Identification& found, const record::Record& record);
/// Prints a baseline that is shown and not written.
void print_baseline(const record::Channel& displacement, const correction::ArxBaseline& found,
                    const record::Record& record);

}  // namespace raceway::cli
