#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Readings for which the model has a prediction (observations): channel by channel, and in a
/// channel in the order of the rows.
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
  /// Returns the entries of `all`, a vector over all observations, that belong to one channel.
  [[nodiscard]] auto of(std::size_t channel, const Eigen::VectorXd& all) const {
    return all.segment(first[channel], size(channel));
  }
  /// Returns the value of a column of the record at every observation.
  [[nodiscard]] Eigen::VectorXd at(std::span<const double> column) const;
  /// Returns only the observations of the channels with the indices `wanted`.
  [[nodiscard]] Observations only(std::span<const std::size_t> wanted) const;
  /// Returns the index of each observation in the output of Predictor::readings() for a record with
  /// `rows` rows.
  [[nodiscard]] std::vector<std::size_t> places(std::size_t rows) const;
};

/// Returns the finite readings of a record that have a finite prediction. `predicted` is the result
/// of predict().
[[nodiscard]] Observations observe(const std::vector<Measured>& channels, const Record& record,
                                   std::span<const double> predicted);

/// Returns a typical size of each reading [SI]: its absolute value, but at least `share` times
/// Measured::floor times the RMS of the measured readings of the channel.
[[nodiscard]] Eigen::VectorXd floored(const Observations& observed, const Eigen::VectorXd& readings,
                                      double share);

/// Returns the root mean square of `values`; NaN for an empty vector.
[[nodiscard]] double rms(const Eigen::VectorXd& values);

}  // namespace raceway::fit
