#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "record/units.h"

namespace raceway::verdict {

/// Simulates the distribution of the largest score (see Gate) for the case that no effect is
/// missing. The simulation uses standard normal random numbers, which are identical for all
/// diagnoses with the same number of scores. The first call of p_value() draws the numbers, so
/// several threads must not call p_value() of one object at the same time.
class NullDraws {
 public:
  explicit NullDraws(Eigen::Index scores, int draws = 10000) : scores_(scores), draws_(draws) {}
  /// Returns the probability that the largest score reaches `observed` if no effect is missing. In
  /// each simulation, the scores are drawn from a normal distribution with the correlation matrix
  /// `correlation`. The scores are then divided by a random estimate of the noise with
  /// `degrees_of_freedom` degrees of freedom. If the probability is very small or very large, the
  /// result is a bound from Student's distribution.
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

/// Result of the test for a missing effect. The test combines an F test and a score test. The F
/// test fits a smooth function of the inputs to the residuals. The score test uses the largest
/// score of all candidates. A score is the size that the residuals suggest for a candidate, divided
/// by the standard error of this size.
struct Gate {
  double surface_statistic = unset;
  double surface_p_value = 1.0;
  int surface_terms = 0;
  double largest_score = unset;  ///< largest score [1]
  /// Index of the largest score in `scores`; -1 if the visibility of all columns is below
  /// `invisible`.
  int largest = -1;
  double score_p_value = 1.0;
  /// Largest p-value with other noise models that also agree with the readings (Evidence::allowed);
  /// 0 if no other noise model was tested.
  double allowed_p_value = 0.0;
  Eigen::VectorXd scores;  ///< one score for each column of the candidates, see open_gate(); 0 if
                           ///< the visibility of the column is below `invisible`
  /// Share of each column that the free parameters of the model cannot compensate [1]: norm of the
  /// column in `projected`, divided by its norm before the compensated part is subtracted.
  Eigen::VectorXd visibility;
  /// Whitened changes of the readings that the candidates cause, minus the part that the free
  /// parameters compensate. Each candidate has one or more columns.
  Eigen::MatrixXd projected;

  /// Returns the p-value of both tests together (Bonferroni). If several noise models are tested,
  /// returns the largest of their p-values.
  [[nodiscard]] double p_value() const;
  [[nodiscard]] bool alarm() const { return p_value() < alarm_level; }
};

/// Smallest visibility of a column whose score is tested [1]. Below this visibility, the free
/// parameters of the model compensate the effect.
constexpr double invisible = 0.02;

/// Tests whitened residuals for a missing effect. `tangent` contains the derivatives of the
/// readings with respect to the free parameters, `surface` the terms of a smooth function, and
/// `scores` the changes of the readings by the candidates, in one or more columns for each
/// candidate. All matrices and the residuals are whitened (fit::Whitening). `one_sided` marks the
/// columns of candidates whose size can differ from its neutral value in one direction only. Such a
/// column contains the change of the readings for a change of the size in this direction.
[[nodiscard]] Gate open_gate(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& residual,
                             const Eigen::MatrixXd& surface, const Eigen::MatrixXd& scores,
                             const std::vector<bool>& one_sided, double degrees_of_freedom,
                             const NullDraws& draws);

}  // namespace raceway::verdict
