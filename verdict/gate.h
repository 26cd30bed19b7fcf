#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "record/units.h"

namespace raceway::verdict {

/// Random numbers for the distribution that the largest score (see Gate) has if no effect is
/// missing. They are standard normal numbers, drawn at first use. The numbers are identical for all
/// gates of a diagnosis, and for all diagnoses with the same number of scores. The first call of
/// p_value() draws the numbers, so several threads must not call p_value() at the same time.
class NullDraws {
 public:
  explicit NullDraws(Eigen::Index scores, int draws = 10000) : scores_(scores), draws_(draws) {}
  /// Returns the probability that the largest score reaches `observed` if no effect is missing. In
  /// each draw, the scores are normal with the correlation `correlation`, divided by a random
  /// standard deviation with `degrees_of_freedom`. If the probability is very small or very large,
  /// the result is a bound from Student's distribution.
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

/// Result of the test whether the model misses an effect. The test combines an F test, in which a
/// smooth function of the inputs describes the residuals, with the largest score of all candidates.
/// A score is the size of a candidate that the residuals suggest, in standard errors.
struct Gate {
  double surface_statistic = unset;
  double surface_p_value = 1.0;
  int surface_terms = 0;
  double largest_score = unset;  ///< largest score, in standard errors
  int largest = -1;  ///< index of the largest score in `scores`; -1 if no column of a candidate is
                     ///< visible
  double score_p_value = 1.0;
  /// Largest p-value over the other noise models that the readings allow; 0 if they were not
  /// tested.
  double allowed_p_value = 0.0;
  Eigen::VectorXd scores;  ///< one score for each column of the candidates, see open_gate(); 0 if
                           ///< the visibility of the column is below `invisible`
  /// Share of the length of each column that the free parameters of the model cannot absorb, from 0
  /// to 1 [1].
  Eigen::VectorXd visibility;
  Eigen::MatrixXd projected;  ///< columns of the candidates minus the part that the free parameters
                              ///< absorb

  /// Returns the p-value of both tests together (Bonferroni): the largest value over all tested
  /// noise models.
  [[nodiscard]] double p_value() const;
  [[nodiscard]] bool alarm() const { return p_value() < alarm_level; }
};

/// Smallest visibility of a column whose score is tested [1]. Below this visibility, the free
/// parameters of the model absorb the effect.
constexpr double invisible = 0.02;

/// Tests whitened residuals for a missing effect. `tangent` contains the derivatives of the
/// readings with respect to the free parameters, `surface` the terms of a smooth function, and
/// `scores` the changes of the readings by the candidates, in one or more columns for each
/// candidate. All matrices and the residuals are whitened. `one_sided` marks the columns of
/// candidates whose size can differ from its neutral value in one direction only. These columns are
/// the changes for that direction.
[[nodiscard]] Gate open_gate(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& residual,
                             const Eigen::MatrixXd& surface, const Eigen::MatrixXd& scores,
                             const std::vector<bool>& one_sided, double degrees_of_freedom,
                             const NullDraws& draws);

}  // namespace raceway::verdict
