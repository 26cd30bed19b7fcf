#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Readings that were taken and that a subject predicts, one after the other: channel by channel,
/// each in the order of the rows.
struct Observations {
  std::vector<Measured> channels{};
  std::vector<std::size_t> place{};    ///< of each channel in Subject::measured()
  std::vector<Eigen::Index> first{0};  ///< of each channel; one more behind the last
  std::vector<std::size_t> row{};      ///< of the record
  Eigen::VectorXd measured{};          ///< SI

  [[nodiscard]] Eigen::Index size() const { return measured.size(); }
  [[nodiscard]] Eigen::Index size(std::size_t channel) const {
    return first[channel + 1] - first[channel];
  }
  /// Rows of one channel.
  [[nodiscard]] std::span<const std::size_t> rows(std::size_t channel) const;
  /// Part of a vector by observation that belongs to a channel.
  [[nodiscard]] auto of(std::size_t channel, const Eigen::VectorXd& all) const {
    return all.segment(first[channel], size(channel));
  }
  /// The column of a record at every observation.
  [[nodiscard]] Eigen::VectorXd at(std::span<const double> column) const;
  /// Observations of some channels only.
  [[nodiscard]] Observations only(std::span<const std::size_t> wanted) const;
  /// Indices of the observations among the readings of a predictor.
  [[nodiscard]] std::vector<std::size_t> places(std::size_t rows) const;
};

/// Readings of a record that have a prediction, `predicted` as predict() gives it.
[[nodiscard]] Observations observe(const std::vector<Measured>& channels, const Record& record,
                                   std::span<const double> predicted);

/// A typical size of each reading: its magnitude, not below `share` of the floor of its channel.
[[nodiscard]] Eigen::VectorXd floored(const Observations& observed, const Eigen::VectorXd& readings,
                                      double share);

/// Root mean square; NaN of nothing.
[[nodiscard]] double rms(const Eigen::VectorXd& values);

}  // namespace raceway::fit
