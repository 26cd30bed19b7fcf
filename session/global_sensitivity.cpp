#include "session/detail/global_sensitivity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <stdexcept>

#include "text/error.h"

namespace raceway::session::varied {

using results::Sensitivity;
using results::VariedDatum;

namespace {

constexpr std::size_t most_numbers = 100000000;

/// Lines on what the samples leave open of one prediction.
std::vector<std::string> cannot_tell(const Sensitivity& s, const fit::SobolIndices& found) {
  std::vector<std::string> lines;
  if (2 * found.complete < s.samples)
    return {fmt::format(
        "only {} of {} samples have a prediction, so the indices describe only these samples",
        found.complete, s.samples)};
  std::vector<std::size_t> order(found.inputs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return found.inputs[a].total > found.inputs[b].total;
  });
  if (order.empty() || std::isnan(found.inputs[order[0]].total)) return lines;
  const auto name = [&](std::size_t i) { return s.data[s.sampled[i]].name; };
  double widest = 0.0;
  for (const fit::SobolIndex& one : found.inputs)
    widest = std::fmax(widest, std::fmax(one.first_error, one.total_error));
  if (order.size() > 1) {
    const fit::SobolIndex &a = found.inputs[order[0]], &b = found.inputs[order[1]];
    if (a.total - a.total_error < b.total + b.total_error)
      lines.push_back(fmt::format(
          "these samples do not show whether {} or {} has more influence; use more samples",
          name(order[0]), name(order[1])));
  }
  if (widest > 0.1)
    lines.push_back(
        fmt::format("the 95 % confidence intervals of the indices are up to +-{:.2g}; four times "
                    "as many samples halve the intervals",
                    widest));
  return lines;
}

fit::SobolDesign design_of(const SensitivityQuestion& q, const Sensitivity& s) {
  if (s.sampled.empty())
    throw text::InputError(
        "no number with a spread influences the prediction, so no indices can be calculated");
  if ((s.sampled.size() + 2) * s.predictions.size() > most_numbers / q.samples)
    throw text::InputError(fmt::format(
        "{} samples of {} numbers and {} predictions give more than {:.0g} values: use fewer "
        "samples",
        q.samples, s.sampled.size(), s.predictions.size(), static_cast<double>(most_numbers)));
  try {
    return {s.sampled.size(), q.samples, q.seed};
  } catch (const std::invalid_argument& e) {
    throw text::InputError(e.what(), {.key = "samples"});
  }
}

}  // namespace

void sample(const Data& data, const Predictor& predictor, const SensitivityQuestion& q,
            const std::vector<std::size_t>& places, Sensitivity& s) {
  const fit::SobolDesign design = design_of(q, s);
  s.evaluations = design.evaluations();
  const std::size_t outputs = s.predictions.size();
  std::vector<double> values(outputs * s.evaluations, unset);
  const auto data_at = [&](std::size_t e) {
    std::vector<double> point(design.inputs());
    design.point(e, point);
    for (std::size_t i = 0; i < point.size(); ++i) {
      const VariedDatum& d = s.data[s.sampled[i]];
      point[i] = d.whole ? std::floor(d.value - d.spread + point[i] * (2.0 * d.spread + 1.0))
                         : d.value + (2.0 * point[i] - 1.0) * d.spread;
    }
    return point;
  };
  std::mutex mutex;
  std::size_t first = s.evaluations;
  for_all(s.evaluations, q, 0.1, 1.0, [&](std::size_t e) {
    const std::vector<double> point = data_at(e);
    std::vector<std::pair<std::size_t, double>> changes;
    for (std::size_t i = 0; i < point.size(); ++i)
      changes.emplace_back(places[s.sampled[i]], point[i]);
    const Outcome one = data.predict(predictor, changes);
    for (std::size_t p = 0; p < one.values.size(); ++p)
      values[p * s.evaluations + e] = one.values[p];
    if (one.has_all()) return;
    const std::lock_guard lock(mutex);
    ++s.failed;
    if (e > first) return;
    first = e;
    s.why_failed = one.refused.empty() ? "no equilibrium was found" : one.refused;
  });
  if (s.failed > 0) s.first_failed = data_at(first);
  for (std::size_t p = 0; p < outputs; ++p) {
    s.predictions[p].global = fit::sobol_indices(
        design, std::span(values).subspan(p * s.evaluations, s.evaluations), q.seed);
    s.predictions[p].cannot_tell = cannot_tell(s, *s.predictions[p].global);
  }
}

}  // namespace raceway::session::varied
