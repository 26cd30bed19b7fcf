#include "fit/smooth_columns.h"

#include <algorithm>
#include <optional>

#include "record/levels.h"

namespace raceway::fit {

namespace {

constexpr std::size_t most_indicators = 12, fewest_indicators = 3;

/// A variable centred and scaled to [-1, 1]; nothing where it does not vary by more than `least`.
std::optional<Eigen::ArrayXd> standardised(const Eigen::VectorXd& values, double least) {
  const double low = values.minCoeff(), high = values.maxCoeff();
  if (!(high - low > least)) return std::nullopt;
  return (values.array() - 0.5 * (low + high)) / (0.5 * (high - low));
}

/// Where levels begin that are no wider than `width`: a dense sweep has too many of them to be any.
std::vector<double> narrow_levels(std::vector<double> values, double width) {
  std::sort(values.begin(), values.end());
  std::vector<double> starts;
  for (const double v : values)
    if (starts.empty() || v > starts.back() + width) starts.push_back(v);
  return starts;
}

Eigen::MatrixXd matrix_of(const std::vector<Eigen::VectorXd>& columns, Eigen::Index rows) {
  Eigen::MatrixXd result(rows, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    result.col(static_cast<Eigen::Index>(k)) = columns[k];
  return result;
}

}  // namespace

Eigen::MatrixXd surface_columns(const Surface& surface, const Observations& observed,
                                const Eigen::VectorXd& size) {
  std::vector<std::optional<Eigen::ArrayXd>> inputs;
  for (const Surface::Input& input : surface.inputs)
    inputs.push_back(standardised(observed.at(input.values), input.least));
  std::vector<Eigen::VectorXd> columns;
  for (const std::vector<int>& exponents : surface.terms) {
    Eigen::ArrayXd column = Eigen::ArrayXd::Ones(size.size());
    bool varies = true;
    for (std::size_t k = 0; k < exponents.size() && varies; ++k)
      for (int power = 0; power < exponents[k] && varies; ++power) {
        varies = inputs[k].has_value();
        if (varies) column *= *inputs[k];
      }
    if (varies) columns.emplace_back(size.cwiseProduct(column.matrix()));
  }
  return matrix_of(columns, size.size());
}

Eigen::MatrixXd level_columns(const std::vector<const Channel*>& channels, const Record& record,
                              const Observations& observed, const Eigen::VectorXd& size) {
  std::vector<Eigen::VectorXd> columns;
  for (const Channel* channel : channels) {
    const Eigen::VectorXd values = observed.at(record.values(*channel));
    if (!values.allFinite()) continue;
    const std::span<const double> all(values.data(), static_cast<std::size_t>(values.size()));
    const std::vector<double> starts =
        narrow_levels({all.begin(), all.end()}, record::step_of(*channel, all));
    if (starts.size() > most_indicators || starts.size() < fewest_indicators) continue;
    const std::size_t first = columns.size();
    columns.resize(first + starts.size(), Eigen::VectorXd::Zero(size.size()));
    for (Eigen::Index i = 0; i < size.size(); ++i)
      columns[first + record::level_of(values[i], starts)][i] = size[i];
  }
  return matrix_of(columns, size.size());
}

}  // namespace raceway::fit
