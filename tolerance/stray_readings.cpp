#include "tolerance/stray_readings.h"

#include <algorithm>
#include <span>
#include <utility>

#include "fit/isolated_readings.h"
#include "tolerance/approximation.h"
#include "tolerance/thinned_record.h"

namespace raceway::tolerance {
namespace {

constexpr int most_rounds = 3;

/// What the subject predicts of each row after a fit to them all; empty where there is none.
std::vector<double> refitted(const std::shared_ptr<const fit::Subject>& subject,
                             const std::shared_ptr<const record::Record>& record) {
  const Recorded on = recorded(*subject, for_search(record), usual_width(*record));
  if (on.means.size() == 0) return {};
  const Approximation fit = approximate(subject, on, subject->free());
  return fit.fit.values.size() > 0 ? fit::predict(*fitted(fit), *record) : std::vector<double>();
}

}  // namespace

WithoutStrays without_strays(const fit::Subject& subject, const record::Record& record) {
  WithoutStrays result{.record = std::make_shared<const record::Record>(record)};
  if (subject.is_costly()) return result;
  subject.require(record);
  std::unique_ptr<fit::Subject> knows = subject.informed_by(record);
  const std::shared_ptr<const fit::Subject> informed =
      knows ? std::move(knows) : subject.with_values({});
  const std::vector<fit::Measured> channels = subject.measured();
  std::vector<fit::Isolated> strays(channels.size());
  bool more = true;
  for (int round = 0; round < most_rounds && more; ++round) {
    more = false;
    const std::vector<double> predicted = refitted(informed, result.record);
    for (std::size_t c = 0; c < channels.size() && !predicted.empty(); ++c) {
      fit::Isolated found = fit::without_isolated_readings(
          *result.record, *channels[c].channel, {},
          std::span(predicted).subspan(c * record.rows(), record.rows()));
      if (!found.any()) continue;
      more = true;
      found.rows.insert(found.rows.end(), strays[c].rows.begin(), strays[c].rows.end());
      std::sort(found.rows.begin(), found.rows.end());
      result.record = std::make_shared<const record::Record>(found.record);
      strays[c] = std::move(found);
    }
  }
  for (const fit::Isolated& of : strays)
    if (of.any())
      result.notes.push_back(record::note::left_out(of.statement(), {.file = record.source}));
  return result;
}

}  // namespace raceway::tolerance
