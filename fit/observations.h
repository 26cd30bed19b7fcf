#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Readings that a model predicts, in sequence: channel by channel, each channel in the order of
/// the rows.
struct Observations {
  std::vector<Measured> channels{};
  std::vector<std::size_t> place{};  ///< index of each channel in Subject::measured()
  /// First observation of each channel; the last entry is the total.
  std::vector<Eigen::Index> first{0};
  std::vector<std::size_t> row{};  ///< row of each observation in the record
  Eigen::VectorXd measured{};      ///< SI

  [[nodiscard]] Eigen::Index size() const { return measured.size(); }
  [[nodiscard]] Eigen::Index size(std::size_t channel) const {
    return first[channel + 1] - first[channel];
  }
  /// Returns the rows of one channel.
  [[nodiscard]] std::span<const std::size_t> rows(std::size_t channel) const;
  /// Returns the part of a vector of observations that belongs to a channel.
  [[nodiscard]] auto of(std::size_t channel, const Eigen::VectorXd& all) const {
    return all.segment(first[channel], size(channel));
  }
  /// Returns the column value at every observation.
  [[nodiscard]] Eigen::VectorXd at(std::span<const double> column) const;
  /// Returns only the observations of the channels in `wanted`.
  [[nodiscard]] Observations only(std::span<const std::size_t> wanted) const;
  /// Returns the index of each observation in the readings that a Predictor writes for a record of
  /// `rows` rows.
  [[nodiscard]] std::vector<std::size_t> places(std::size_t rows) const;
};

/// Returns the readings of a record that have a prediction. `predicted` is the result of predict().
[[nodiscard]] Observations observe(const std::vector<Measured>& channels, const Record& record,
                                   std::span<const double> predicted);

/// Returns a typical size of each reading: the absolute value of the reading, but at least `share`
/// times the floor of the channel (Measured::floor times the rms).
[[nodiscard]] Eigen::VectorXd floored(const Observations& observed, const Eigen::VectorXd& readings,
                                      double share);

/// Returns the root mean square; NaN for an empty vector.
[[nodiscard]] double rms(const Eigen::VectorXd& values);

}  // namespace raceway::fit
