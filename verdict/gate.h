#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "record/units.h"

namespace raceway::verdict {

/// Standard normal numbers for the null distribution of the largest score. The numbers are drawn at
/// first use. The numbers are identical for all gates of a diagnosis, and for all diagnoses with
/// the same number of scores. The first call of p_value() draws the numbers, so several threads
/// must not call p_value() at the same time.
class NullDraws {
 public:
  explicit NullDraws(Eigen::Index scores, int draws = 10000) : scores_(scores), draws_(draws) {}
  /// Returns the share of draws from N(0, C) whose largest score reaches `observed`. The scores of
  /// each draw are divided by a random scale with the χ distribution. If the share is very small or
  /// very large, the result is a bound from Student's distribution.
  [[nodiscard]] double p_value(const Eigen::MatrixXd& correlation,
                               const std::vector<bool>& one_sided, double degrees_of_freedom,
                               double observed) const;

 private:
  struct Normals;
  [[nodiscard]] static std::shared_ptr<const Normals> draw(Eigen::Index scores, int draws);
  Eigen::Index scores_;
  int draws_;
  mutable std::shared_ptr<const Normals> normals_;
};

constexpr double alarm_level = 0.01;

/// Test whether the model misses an effect. The gate combines an F test on a smooth surface with
/// the largest score of a catalogue.
struct Gate {
  double surface_statistic = unset;
  double surface_p_value = 1.0;
  int surface_terms = 0;
  double largest_score = unset;  ///< largest score in standard deviations
  int largest = -1;              ///< column of the largest score; -1 if no column is visible
  double score_p_value = 1.0;
  /// Largest p over the other noise shapes that the readings allow; 0 if these shapes were not
  /// tested.
  double allowed_p_value = 0.0;
  Eigen::VectorXd scores;  ///< score of each column; 0 if the column is not visible
  /// Share of a column that remains after the tangent (the derivatives by the base parameters) is
  /// projected off [1].
  Eigen::VectorXd visibility;
  Eigen::MatrixXd projected;  ///< columns after the tangent is projected off, not normalised

  /// Returns p of both tests together (Bonferroni); the largest value over all noise shapes.
  [[nodiscard]] double p_value() const;
  [[nodiscard]] bool alarm() const { return p_value() < alarm_level; }
};

/// Smallest visibility of a column whose score is tested [1]. Below this visibility, the base
/// parameters absorb the effect.
constexpr double invisible = 0.02;

/// Applies the gate. All arguments are whitened. `one_sided` marks columns for which only a
/// positive amount is physical.
[[nodiscard]] Gate open_gate(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& residual,
                             const Eigen::MatrixXd& surface, const Eigen::MatrixXd& scores,
                             const std::vector<bool>& one_sided, double degrees_of_freedom,
                             const NullDraws& draws);

}  // namespace raceway::verdict
