#include "loop/check.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "fit/row_order.h"
#include "loop/loop.h"
#include "verdict/compare.h"
#include "verdict/estimated_noise.h"

namespace raceway::loop {

namespace {

Check::Column summary(const record::Column& column) {
  std::set<long long> levels;
  Check::Column c{.channel = column.channel};
  for (const double v : column.values) {
    if (std::isnan(v)) continue;
    c.lower = std::fmin(c.lower, v);
    c.upper = std::fmax(c.upper, v);
    levels.insert(std::llround(column.channel->in_unit(v) * 1e3));
  }
  c.levels = static_cast<int>(levels.size());
  return c;
}

}  // namespace

Check check(const fit::Subject& subject, const record::Record& record,
            const record::Record* judged) {
  if (!judged) judged = &record;
  Check result;
  result.rows = static_cast<int>(record.rows());
  result.runs = static_cast<int>(record.runs.size());
  const std::vector<fit::Measured> predicted = subject.measured();
  for (const record::Column& column : record.columns) {
    if (column.channel->role != record::Role::measured) continue;
    const auto read = std::count_if(column.values.begin(), column.values.end(),
                                    [](double v) { return std::isfinite(v); });
    const auto p = std::find_if(predicted.begin(), predicted.end(), [&](const fit::Measured& m) {
      return *m.channel == *column.channel;
    });
    result.measured.push_back({column.channel, static_cast<int>(read),
                               p != predicted.end()
                                   ? verdict::noise_of(record, *p)
                                   : fit::estimate_noise(record, *column.channel)});
  }
  std::stable_partition(result.measured.begin(), result.measured.end(), [&](const auto& m) {
    return std::any_of(predicted.begin(), predicted.end(),
                       [&](const fit::Measured& p) { return *p.channel == *m.channel; });
  });
  if (const auto found = verdict::estimate_noise_as_diagnosis(subject, *judged))
    for (const verdict::EstimatedNoise& noise : *found)
      for (Check::MeasuredChannel& m : result.measured)
        if (*m.channel == *noise.channel) m.found_noise = noise.rms;
  for (const record::Column& column : record.columns) {
    if (column.channel->role == record::Role::run || column.channel->role == record::Role::part)
      continue;
    if (const Check::Column c = summary(column); c.levels > 0) result.columns.push_back(c);
  }
  try {
    result.free = calibrate(subject, *judged).parameters;
  } catch (const std::invalid_argument& e) {
    result.problem = e.what();  // fewer rows than parameters, for example
    for (const std::string& name : subject.free()) {
      record::Parameter p{.name = name, .unit = {}};
      p.identifiable = false;
      result.free.push_back(std::move(p));
    }
  }
  result.runs_coincide_with = fit::nested_settings(record, true);
  for (const std::string& id : subject.catalogue())
    result.catalogue.push_back({.id = id,
                                .ruled_out = subject.rules_out(id),
                                .missing = subject.lacks(id, record),
                                .levels = subject.lacks_levels(id, record)});
  return result;
}

}  // namespace raceway::loop
