#include "correction/alignment.h"

#include <algorithm>
#include <cmath>

#include "correction/series.h"
#include "fit/separable.h"
#include "record/median.h"

namespace raceway::correction {
namespace {

constexpr double an_hour = 3600.0;
constexpr double far_beyond = 20.0;  // of the usual time between readings

/// The record with no reading behind the first long gap of its readings.
record::Record before_first_gap(const record::Record& record, const Channel& displacement) {
  record::Record result = record;
  std::vector<double>& read = result.find(displacement)->values;
  const std::span<const double> time = record.values(record::time);
  std::vector<double> steps;
  double last = unset;
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (std::isnan(read[k])) continue;
    if (!std::isnan(last)) steps.push_back(time[k] - last);
    last = time[k];
  }
  const double longest = std::max(an_hour, far_beyond * record::median(steps));
  last = unset;
  bool behind = false;
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (std::isnan(read[k])) continue;
    behind = behind || time[k] - last > longest;
    last = time[k];
    if (behind) read[k] = unset;
  }
  return result;
}

std::unique_ptr<fit::Subject> fitted(const fit::Subject& subject, const record::Record& record,
                                     const std::vector<std::string>& names) {
  const fit::Means rows = fit::means_of(subject, record, 0.0);
  if (rows.size() == 0 || names.empty()) return subject.with_values({});
  const fit::Separable problem(subject, record, nullptr, rows, names);
  Eigen::VectorXd start(problem.parameters().size());
  for (std::size_t k = 0; k < names.size(); ++k)
    start[static_cast<Eigen::Index>(k)] = problem.parameters()[k].start;
  const fit::SeparableFit fit = problem.at(start, -1, 0.0);
  std::vector<fit::NamedValue> values;
  for (std::size_t k = 0; k < names.size(); ++k)
    values.push_back({names[k], fit.values[static_cast<Eigen::Index>(k)]});
  return subject.with_values(values);
}

bool is_of(const fit::Parameter& p, std::string_view kind) { return p.name.starts_with(kind); }

}  // namespace

std::shared_ptr<const CorrectionSubject> aligned(const Model& model, const record::Record& record,
                                                 Zero zero) {
  std::unique_ptr<fit::Subject> subject = CorrectionSubject(model).informed_by(record);
  static_cast<CorrectionSubject&>(*subject).keep_range(model);
  const auto names = [&](bool states, bool zeros, bool offset) {
    std::vector<std::string> list;
    for (const fit::Parameter& p : subject->parameters())
      if ((states && is_of(p, "initial.")) || (zeros && is_of(p, "zero.")) ||
          (offset && p.name == "offset"))
        list.push_back(p.name);
    return list;
  };
  // What a warm machine's inputs stood at before they count is one constant more.
  if (model.initial_state == InitialState::free && record.has(*model.displacement))
    subject =
        fitted(*subject, before_first_gap(record, *model.displacement), names(true, false, true));
  if (zero == Zero::mean) subject = fitted(*subject, record, names(false, true, true));
  if (zero == Zero::first) {
    // Of every zero the first reading alone.
    record::Record first = record;
    std::vector<double>& read = first.find(*model.displacement)->values;
    const Series series(record);
    std::vector<bool> seen(static_cast<std::size_t>(series.zeros()), false);
    for (std::size_t k = 0; k < read.size(); ++k) {
      if (std::isnan(read[k])) continue;
      const auto z = static_cast<std::size_t>(series.zero()[k]);
      if (seen[z]) read[k] = unset;
      seen[z] = true;
    }
    subject = fitted(*subject, first, names(false, true, true));
  }
  return std::shared_ptr<const CorrectionSubject>(
      static_cast<const CorrectionSubject*>(subject.release()));
}

}  // namespace raceway::correction
