#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "fit/data_set.h"

namespace raceway::fit {

/// Columns that a smooth misfit of unknown origin lies in, of the size `size` of the readings.
///
///   friction torque   times a polynomial of 15 terms, cubic in ln speed, ln axial load and
///                     temperature with interactions
///   displacement      times a polynomial of fourth degree in speed; for each other input that
///                     varies (external load, preload, temperatures) its square and its products
///                     with speed and speed squared
[[nodiscard]] Eigen::MatrixXd surface_columns(const DataSet& data, const Eigen::VectorXd& size);

/// `size` times an indicator of each level, for variables measured at few levels: what a
/// cubic is too smooth for.
[[nodiscard]] Eigen::MatrixXd level_columns(const DataSet& data, const Eigen::VectorXd& size);

/// A basis of `first`, then of what later blocks add to it, each column by its largest remainder:
/// a remainder below `tolerance` of the column is not counted. At most `most` columns, of which
/// `later[k]` get what earlier ones left.
[[nodiscard]] Eigen::MatrixXd independent_columns(const std::vector<Eigen::MatrixXd>& blocks,
                                                  const std::vector<double>& tolerance,
                                                  Eigen::Index most);

/// Columns without their part along `tangent`, which has any rank.
[[nodiscard]] Eigen::MatrixXd project_off(const Eigen::MatrixXd& tangent,
                                          const Eigen::MatrixXd& columns);

/// Standard normal numbers for the null distribution of the largest score, drawn when first needed:
/// the same for all gates of a diagnosis, and for all diagnoses with as many scores.
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

/// Is anything missing? A surface F test and the largest score of a catalogue.
struct Gate {
  double surface_statistic = unset;
  double surface_p_value = 1.0;
  int surface_terms = 0;
  double largest_score = unset;  ///< in standard deviations
  int largest = -1;              ///< column of that score
  double score_p_value = 1.0;
  Eigen::VectorXd scores;      ///< of each column; 0 where not visible
  Eigen::VectorXd visibility;  ///< share of a column that the tangent leaves [1]
  Eigen::MatrixXd projected;   ///< columns without the tangent, not normalised

  /// Of both together, by Bonferroni.
  [[nodiscard]] double p_value() const;
  [[nodiscard]] bool alarm() const { return p_value() < 0.01; }
};

constexpr double invisible = 0.02;  ///< visibility below which a score is an alias of the tangent

/// All arguments whitened. `one_sided`: only a positive amount of the column is physical.
[[nodiscard]] Gate open_gate(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& residual,
                             const Eigen::MatrixXd& surface, const Eigen::MatrixXd& scores,
                             const std::vector<bool>& one_sided, double degrees_of_freedom,
                             const NullDraws& draws);

}  // namespace raceway::fit
