#include "fit/estimated_noise.h"

#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "effects/catalogue.h"
#include "fit/evidence.h"

namespace raceway::fit {

std::optional<EstimatedNoise> estimate_noise_as_diagnosis(const Model& model, const DataSet& data) {
  std::vector<const effects::Description*> all;
  for (const effects::Description& d : effects::catalogue()) all.push_back(&d);
  try {
    const Evidence evidence = gather_evidence(model, data, all, most_rows_of_a_fit);
    const Eigen::VectorXd& used = evidence.noise.whitening.std();
    std::unordered_map<int, double> by_line;
    for (std::size_t i = 0; i < evidence.problem.data.rows.size(); ++i)
      by_line[evidence.problem.data.rows[i].line] = used[static_cast<Eigen::Index>(i)];
    EstimatedNoise noise{.rms = evidence.noise.rms, .std = {}};
    for (const Row& row : data.rows) {
      const auto found = by_line.find(row.line);
      noise.std.push_back(
          found != by_line.end()
              ? found->second
              : std::hypot(evidence.noise.relative * row.measured, evidence.noise.absolute));
    }
    return noise;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace raceway::fit
