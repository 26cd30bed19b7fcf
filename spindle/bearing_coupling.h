#pragma once

#include <vector>

#include "spindle/bearing_conduction.h"
#include "spindle/thermal_system.h"
#include "spindle/warm_sets.h"

namespace raceway::spindle {

using Matrix = Eigen::MatrixXd;

/// What the bearings and the cells feel of each other, as few numbers:
///
///   felt s    of each bearing the means of inner and outer ring and of the cells at its two
///             raceways [K], then the elongation between the sets, in um
///   given y   heat into the cells at the inner and the outer raceway of each bearing [W]
///
/// Friction heat arises at the raceways. What the balls carry flows between the raceways, which are
/// warmer than the cells behind them by what half a cell resists:
///
///   T_s = a + w/S,   Q = G (T_si - T_so),   w_i = q_i - Q,   w_o = q_o + Q
///
/// with the conductance S from cells to raceway. The elongation is counted in um so that all of s
/// is of one size.
class BearingCoupling {
 public:
  BearingCoupling(const model::Model& model, const effects::SpindleCondition& condition,
                  const ThermalSystem& system);

  [[nodiscard]] Eigen::Index felt_count() const { return felt_.rows(); }
  [[nodiscard]] Eigen::Index given_count() const { return given_.cols(); }
  /// s of these temperatures.
  [[nodiscard]] Vector felt(const Vector& temperatures) const {
    return felt_ * temperatures + offset_;
  }
  [[nodiscard]] const SparseMatrix& felt_rows() const { return felt_; }
  /// Cells by given number [1].
  [[nodiscard]] const Matrix& given() const { return given_; }

  [[nodiscard]] WarmSets& sets() { return sets_; }
  [[nodiscard]] const WarmSets& sets() const { return sets_; }
  /// y of s; false where the sets have no balance.
  [[nodiscard]] bool evaluate(const Vector& felt, Vector& given);
  /// dy/ds by differences, about the s that was evaluated last; false where a neighbour of it has
  /// no balance.
  [[nodiscard]] bool differentiate(const Vector& felt, const Vector& given, Matrix& jacobian);

 private:
  [[nodiscard]] Vector flows(const Vector& felt) const;

  WarmSets sets_;
  SparseMatrix felt_;
  Vector offset_;
  Matrix given_;
  std::vector<double> inner_raceway_, outer_raceway_;  // S of each bearing [W/K]
  std::vector<BallConduction> balls_;
  double lubricant_, factor_;
};

}  // namespace raceway::spindle
