#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "fit/separable.h"

/// Fits of subjects with costly predictions (Subject::is_costly()).
namespace raceway::fit {

/// Result of a fit, and the derivatives of all means by its values.
struct CostlyFit {
  SeparableFit fit{};
  Eigen::MatrixXd slope{};
  std::shared_ptr<const CostlyFit> begin{};  ///< where the fit began
};

/// Depth of a fit.
struct CostlyEnd {
  double settled = 1e-4;  ///< the relative fall of the misfit that is none
  /// A misfit that stays above needs no exact derivatives.
  double hopeless = std::numeric_limits<double>::infinity();
  /// Ends where derivatives, exact or not, expect a relative fall below `settled`, and takes that
  /// step without a prediction: shows how far a fit gets.
  bool rough = false;
};

/// Minimises the weighted sum of squares of means over the parameters of some names, all alike, by
/// the method of Levenberg and Marquardt on a scale of logarithms where bounds span more than a
/// decade, otherwise of typical sizes. Derivatives are differences over a fiftieth or a fifth of
/// that, so that neither the tolerance of a simulation nor the steps that it chooses show in them;
/// between two sets of differences they are kept up by an update of rank one (Broyden 1965). Takes
/// two predictions for each parameter and four more. Not for several threads at once: they share
/// room for readings.
class CostlyProblem {
 public:
  /// As of Separable.
  CostlyProblem(const Subject& subject, const Record& record,
                const std::shared_ptr<const void>& prepared, const Means& means,
                const std::vector<std::string>& names);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  [[nodiscard]] CostlyFit from(const Eigen::VectorXd& start, const CostlyEnd& end) const;
  /// From the end of a fit of the first of these parameters. The others belong to candidates;
  /// `sizes` are the places among them of what is neutral where it ended; `initial`: values away
  /// from there. A fit that gets stuck at a bound or takes nothing begins again where the other fit
  /// began, if that is far away: parameters that were bent to hide a candidate leave it no room.
  [[nodiscard]] CostlyFit beyond(const CostlyFit& base, const Eigen::VectorXd& initial,
                                 const std::vector<std::size_t>& sizes, const CostlyEnd& end) const;
  /// Goes on with a fit of these parameters.
  [[nodiscard]] CostlyFit onwards(const CostlyFit& fit, const CostlyEnd& end) const;

 private:
  [[nodiscard]] SeparableFit at(const Eigen::VectorXd& values) const;
  /// Derivatives of the means by the parameters on their scales.
  [[nodiscard]] Eigen::MatrixXd differences(const SeparableFit& here) const;
  /// `better`, where given, becomes what was predicted if that fits better than it does.
  [[nodiscard]] Eigen::VectorXd difference(const SeparableFit& here, std::size_t parameter,
                                           double by, SeparableFit* better = nullptr) const;
  /// `slope`: on the scales. `is_fresh`: made of differences at `best`.
  [[nodiscard]] CostlyFit descend(SeparableFit best, Eigen::MatrixXd slope, bool is_fresh,
                                  const CostlyEnd& end) const;
  /// The end of another fit with the candidates switched on, from where this gets better.
  [[nodiscard]] CostlyFit with_candidates(const CostlyFit& base, const Eigen::VectorXd& initial,
                                          const std::vector<std::size_t>& sizes) const;
  [[nodiscard]] bool is_far(const CostlyFit& base) const;
  void find_bounds(SeparableFit& fit) const;
  [[nodiscard]] Eigen::MatrixXd on_scales(Eigen::MatrixXd slope, const Eigen::VectorXd& at) const;
  /// One of the scale, in the unit of a parameter.
  [[nodiscard]] double unit_of(std::size_t parameter, double value) const;
  [[nodiscard]] double to_scale(std::size_t parameter, double value) const;
  [[nodiscard]] double from_scale(std::size_t parameter, double at) const;

  std::vector<Parameter> parameters_;
  const Means& means_;
  std::unique_ptr<Predictor> predictor_;
  Eigen::VectorXd measured_, weight_;
  mutable std::vector<double> all_;  // readings by row
};

/// Residuals of all means after a refit without one block, linearised: the readings are not
/// predicted again. Parameters stay within their bounds.
[[nodiscard]] Eigen::VectorXd left_of_block(const CostlyFit& fit,
                                            const std::vector<Parameter>& parameters,
                                            const Means& means, int block);

}  // namespace raceway::fit
