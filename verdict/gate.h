#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "record/units.h"

namespace raceway::verdict {

/// Standard normal numbers for the null distribution of the largest score, drawn when first needed:
/// the same for all gates of a diagnosis, and for all diagnoses with as many scores. The first
/// p_value() draws: not for several threads at once.
class NullDraws {
 public:
  explicit NullDraws(Eigen::Index scores, int draws = 10000) : scores_(scores), draws_(draws) {}
  /// Share of draws of N(0, C) whose largest score (over a χ scale) reaches `observed`.
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

/// Is anything missing? A surface F test and the largest score of a catalogue.
struct Gate {
  double surface_statistic = unset;
  double surface_p_value = 1.0;
  int surface_terms = 0;
  double largest_score = unset;  ///< in standard deviations
  int largest = -1;              ///< column of that score
  double score_p_value = 1.0;
  /// Largest p over the other shapes of noise that the readings allow; 0 where none was asked for.
  double allowed_p_value = 0.0;
  Eigen::VectorXd scores;      ///< of each column; 0 where not visible
  Eigen::VectorXd visibility;  ///< share of a column that the tangent leaves [1]
  Eigen::MatrixXd projected;   ///< columns without the tangent, not normalised

  /// p of both tests together, by Bonferroni; the largest of all shapes of the noise.
  [[nodiscard]] double p_value() const;
  [[nodiscard]] bool alarm() const { return p_value() < alarm_level; }
};

constexpr double invisible = 0.02;  ///< visibility below which a score is an alias of the tangent

/// All arguments whitened. `one_sided`: only a positive amount of the column is physical.
[[nodiscard]] Gate open_gate(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& residual,
                             const Eigen::MatrixXd& surface, const Eigen::MatrixXd& scores,
                             const std::vector<bool>& one_sided, double degrees_of_freedom,
                             const NullDraws& draws);

}  // namespace raceway::verdict
