#include "correction/metrics.h"

#include <algorithm>
#include <cmath>

namespace raceway::correction {

Metrics metrics(std::span<const double> measured, std::span<const double> simulated) {
  Metrics m;
  double sum = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (std::isnan(measured[k]) || std::isnan(simulated[k])) continue;
    ++m.readings;
    sum += measured[k];
    largest = std::max(largest, std::abs(measured[k]));
  }
  if (m.readings == 0) return m;
  const double n = static_cast<double>(m.readings), mean = sum / n;
  double squares = 0.0, about_mean = 0.0, absolute = 0.0;
  m.residue_min = std::numeric_limits<double>::infinity();
  m.residue_max = -m.residue_min;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (std::isnan(measured[k]) || std::isnan(simulated[k])) continue;
    const double residue = measured[k] - simulated[k];
    squares += residue * residue;
    absolute += std::abs(residue);
    about_mean += (measured[k] - mean) * (measured[k] - mean);
    m.residue_min = std::min(m.residue_min, residue);
    m.residue_max = std::max(m.residue_max, residue);
  }
  m.rms = std::sqrt(squares / n);
  m.mean_abs = absolute / n;
  m.max_abs = std::max(std::abs(m.residue_min), std::abs(m.residue_max));
  m.peak_to_peak = std::abs(m.residue_max) + std::abs(m.residue_min);
  if (about_mean > 0.0) m.fit_percent = 100.0 * (1.0 - std::sqrt(squares / about_mean));
  if (largest > 0.0) m.reduction_of_max_percent = 100.0 * (1.0 - m.max_abs / largest);
  return m;
}

}  // namespace raceway::correction
