#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Observations: readings for which the model has a prediction. The observations are sorted by
/// channel, and by row within a channel.
struct Observations {
  std::vector<Measured> channels{};
  std::vector<std::size_t> place{};  ///< index of each channel in Subject::measured()
  /// Index of the first observation of each channel; the last entry is the number of observations.
  std::vector<Eigen::Index> first{0};
  std::vector<std::size_t> row{};  ///< row index of each observation in the record
  Eigen::VectorXd measured{};      ///< readings [SI]

  [[nodiscard]] Eigen::Index size() const { return measured.size(); }
  [[nodiscard]] Eigen::Index size(std::size_t channel) const {
    return first[channel + 1] - first[channel];
  }
  /// Returns the row indices of the observations of one channel.
  [[nodiscard]] std::span<const std::size_t> rows(std::size_t channel) const;
  /// Returns the part of `all` for one channel. `all` has one entry for each observation.
  [[nodiscard]] auto of(std::size_t channel, const Eigen::VectorXd& all) const {
    return all.segment(first[channel], size(channel));
  }
  /// Returns the values of a record column at the rows of the observations.
  [[nodiscard]] Eigen::VectorXd at(std::span<const double> column) const;
  /// Returns only the observations of the channels with the indices `wanted`.
  [[nodiscard]] Observations only(std::span<const std::size_t> wanted) const;
  /// Returns the index of each observation in the output of Predictor::readings(), for a record
  /// with `rows` rows.
  [[nodiscard]] std::vector<std::size_t> places(std::size_t rows) const;
};

/// Returns the finite readings of a record that have a finite prediction. `predicted` is the result
/// of predict().
[[nodiscard]] Observations observe(const std::vector<Measured>& channels, const Record& record,
                                   std::span<const double> predicted);

/// Returns a typical size of each entry of `readings` [SI]: its absolute value, or a limit if the
/// absolute value is smaller. The limit is `share` times Measured::floor times the RMS of the
/// measured readings of the channel.
[[nodiscard]] Eigen::VectorXd floored(const Observations& observed, const Eigen::VectorXd& readings,
                                      double share);

/// Returns the root mean square of `values`; NaN for an empty vector.
[[nodiscard]] double rms(const Eigen::VectorXd& values);

}  // namespace raceway::fit
