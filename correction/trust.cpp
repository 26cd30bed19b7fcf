#include "correction/trust.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "correction/alignment.h"
#include "record/series_channel.h"
#include "record/units.h"
#include "tolerance/approximation.h"
#include "tolerance/one_way.h"
#include "tolerance/thinned_record.h"

namespace raceway::correction {
namespace {

constexpr double half_of_the_square = 0.7071;  // of an RMS
constexpr double a_quarter = 0.25;
constexpr double three_of_them = 3.0;  // after which a lag has all but arrived

Model without_correction(const Model& model) {
  return {.name = model.name,
          .displacement = model.displacement,
          .tolerance = model.tolerance,
          .measured_std = model.measured_std};
}

/// From the first to the last reading of the run where that is longest [s].
double duration_of_readings(const Model& model, const record::Record& record) {
  const std::span<const double> time = record.values(record::time),
                                read = record.values(*model.displacement);
  double longest = 0.0, first = unset;
  for (std::size_t k = 0; k < read.size(); ++k) {
    if (k > 0 && record.run_of(k) != record.run_of(k - 1)) first = unset;
    if (!std::isfinite(read[k])) continue;
    if (std::isnan(first)) first = time[k];
    longest = std::max(longest, time[k] - first);
  }
  return longest;
}

struct Slowest {
  std::string channel{};
  double time_constant = 0.0;
};

Slowest slowest_of(const Model& model) {
  Slowest slowest;
  for (const DrivenChannel& c : model.channels)
    for (const Section& s : c.sections)
      if (s.time_constant > slowest.time_constant) slowest = {c.name, s.time_constant};
  return slowest;
}

std::string shown(const Model& model, double value) {
  return fmt::format("{:.3g} {}", value / um, unit_of(model));
}
std::string in_h(double value) { return fmt::format("{:.3g} h", value / 3600.0); }

std::string errs_by(const Model& model) {
  const Evidence& e = *model.evidence;
  return fmt::format("the RMS error {} is {}",
                     e.other_record ? "on another record" : "on held-out parts",
                     shown(model, e.error));
}

/// More of the mean square is left than is taken.
bool leaves_most(double error, double uncorrected) {
  return error > half_of_the_square * uncorrected;
}

}  // namespace

std::string_view name(TrustLevel level) {
  switch (level) {
    case TrustLevel::good:
      return "good";
    case TrustLevel::within_range:
      return "within-range";
    case TrustLevel::do_not_use:
      return "do-not-use";
    case TrustLevel::unknown:
      break;
  }
  return "unknown";
}

std::string line_of(const Trust& trust) {
  switch (trust.level) {
    case TrustLevel::good:
      return "good";
    case TrustLevel::within_range:
      return "only inside its range: " + trust.because;
    case TrustLevel::do_not_use:
      return "do not use, because " + trust.because;
    case TrustLevel::unknown:
      break;
  }
  return "not known: " + trust.because;
}

double uncorrected_rms(const Model& model, const record::Record& record) {
  const auto subject = aligned(without_correction(model), record, Zero::mean);
  return metrics(record.values(*model.displacement), fit::predict(*subject, record)).rms;
}

Evidence evidence_on(const Model& model, const record::Record& record, double error) {
  const auto subject = aligned(without_correction(model), record, Zero::none);
  const tolerance::Recorded recorded = tolerance::recorded(
      *subject, tolerance::for_search(std::make_shared<const record::Record>(record)),
      tolerance::usual_width(record));
  return {.error = error,
          .uncorrected = uncorrected_rms(model, record),
          .duration = duration_of_readings(model, record),
          .one_way = tolerance::goes_one_way(recorded.means, 0)};
}

Trust trust_of(const Model& model) {
  if (!model.evidence)
    return {TrustLevel::unknown,
            "the model file has no held-out error; identify, calibrate and add write it"};
  const Evidence& e = *model.evidence;
  const Slowest slowest = slowest_of(model);
  const auto refused = [](std::string because) {
    return Trust{TrustLevel::do_not_use, std::move(because)};
  };
  const auto limited = [](std::string because) {
    return Trust{TrustLevel::within_range, std::move(because)};
  };
  if (std::isnan(e.error))
    return refused("no part of the record of the fit could be held out for a test");
  if (!e.other_record && e.one_way)
    return refused(
        "in the record of the fit the displacement changes only once, in one direction, so no test "
        "shows the "
        "error on another day: record a cool-down as well, or test the model with another record "
        "(identify --validate)");
  if (!e.other_record && slowest.time_constant > e.duration)
    return refused(fmt::format("a time constant of {} is {}, longer than the record of {}",
                               slowest.channel, in_h(slowest.time_constant), in_h(e.duration)));
  if (leaves_most(e.error, e.uncorrected))
    return refused(fmt::format("{}; the RMS displacement without correction is {}", errs_by(model),
                               shown(model, e.uncorrected)));
  if (!e.other_record && three_of_them * slowest.time_constant > e.duration)
    return limited(fmt::format(
        "a time constant of {} is {}, and the record of {} is shorter than three time constants",
        slowest.channel, in_h(slowest.time_constant), in_h(e.duration)));
  if (std::isfinite(model.tolerance)) {
    if (e.error > model.tolerance)
      return limited(
          fmt::format("{} (tolerance {})", errs_by(model), shown(model, model.tolerance)));
  } else if (e.error > a_quarter * e.uncorrected) {
    return limited(fmt::format("{}; the RMS displacement without correction is {}", errs_by(model),
                               shown(model, e.uncorrected)));
  }
  return {TrustLevel::good, {}};
}

Trust trust_on(const Model& model, const Metrics& errors, double uncorrected,
               const Beyond& beyond) {
  if (leaves_most(errors.rms, uncorrected))
    return {TrustLevel::do_not_use,
            fmt::format(
                "the RMS error on this record is {}; the RMS displacement without correction is {}",
                shown(model, errors.rms), shown(model, uncorrected))};
  Trust trust = trust_of(model);
  if (trust.level == TrustLevel::good && beyond.rows() > 0)
    trust = {TrustLevel::within_range,
             fmt::format("{} of the {} rows of this record are outside the range of the model",
                         beyond.rows(), beyond.at_row.size())};
  return trust;
}

}  // namespace raceway::correction
