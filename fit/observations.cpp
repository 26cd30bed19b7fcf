#include "fit/observations.h"

#include <cmath>

namespace raceway::fit {

std::span<const std::size_t> Observations::rows(std::size_t channel) const {
  return std::span(row).subspan(static_cast<std::size_t>(first[channel]),
                                static_cast<std::size_t>(size(channel)));
}

Eigen::VectorXd Observations::at(std::span<const double> column) const {
  Eigen::VectorXd values(size());
  for (Eigen::Index i = 0; i < size(); ++i) values[i] = column[row[static_cast<std::size_t>(i)]];
  return values;
}

Observations Observations::only(std::span<const std::size_t> wanted) const {
  Observations result;
  Eigen::Index count = 0;
  for (const std::size_t c : wanted) count += size(c);
  result.measured.resize(count);
  for (const std::size_t c : wanted) {
    result.channels.push_back(channels[c]);
    result.place.push_back(place[c]);
    result.measured.segment(result.first.back(), size(c)) = of(c, measured);
    const std::span<const std::size_t> own = rows(c);
    result.row.insert(result.row.end(), own.begin(), own.end());
    result.first.push_back(result.first.back() + size(c));
  }
  return result;
}

std::vector<std::size_t> Observations::places(std::size_t rows) const {
  std::vector<std::size_t> result;
  result.reserve(row.size());
  for (std::size_t c = 0; c < channels.size(); ++c)
    for (const std::size_t r : this->rows(c)) result.push_back(place[c] * rows + r);
  return result;
}

Observations observe(const std::vector<Measured>& channels, const Record& record,
                     std::span<const double> predicted) {
  Observations result{.channels = channels};
  std::vector<double> measured;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::span<const double> column = record.values(*channels[c].channel);
    result.place.push_back(c);
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (!std::isfinite(column[i]) || !std::isfinite(predicted[c * record.rows() + i])) continue;
      result.row.push_back(i);
      measured.push_back(column[i]);
    }
    result.first.push_back(static_cast<Eigen::Index>(measured.size()));
  }
  result.measured = Eigen::Map<const Eigen::VectorXd>(measured.data(),
                                                      static_cast<Eigen::Index>(measured.size()));
  return result;
}

Eigen::VectorXd floored(const Observations& observed, const Eigen::VectorXd& readings,
                        double share) {
  Eigen::VectorXd size = readings.cwiseAbs();
  for (std::size_t c = 0; c < observed.channels.size(); ++c) {
    const double floor =
        share * observed.channels[c].floor * rms(observed.of(c, observed.measured));
    for (Eigen::Index i = observed.first[c]; i < observed.first[c + 1]; ++i)
      size[i] = std::max(size[i], floor);
  }
  return size;
}

double rms(const Eigen::VectorXd& v) { return v.norm() / std::sqrt(static_cast<double>(v.size())); }

}  // namespace raceway::fit
