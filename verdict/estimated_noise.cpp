#include "verdict/estimated_noise.h"

#include <cmath>
#include <stdexcept>

#include "verdict/evidence.h"

namespace raceway::verdict {

std::optional<std::vector<EstimatedNoise>> estimate_noise_as_diagnosis(
    const fit::Subject& subject, const record::Record& record) {
  if (subject.approximates()) return std::nullopt;  // no regression on its inputs knows the past
  try {
    const Evidence evidence = gather_evidence(subject, record, {.screened = false});
    const fit::Problem& problem = evidence.problem;
    std::vector<EstimatedNoise> result;
    for (std::size_t c = 0; c < evidence.noise.size(); ++c) {
      const fit::NoiseModel& noise = evidence.noise[c];
      EstimatedNoise& e = result.emplace_back(EstimatedNoise{
          .channel = problem.observed.channels[c].channel, .rms = noise.rms, .std = {}});
      const std::span<const double> readings = record.values(*problem.observed.channels[c].channel);
      for (std::size_t i = 0; i < readings.size(); ++i)
        e.std.push_back(
            std::hypot(noise.relative * readings[i] * noise.growth_at(record, i), noise.absolute));
      const std::span<const std::size_t> rows = problem.observed.rows(c);
      for (std::size_t i = 0; i < rows.size(); ++i)
        e.std[problem.rows[rows[i]]] = noise.whitening.std()[static_cast<Eigen::Index>(i)];
    }
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace raceway::verdict
