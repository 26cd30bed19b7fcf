#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "fit/separable.h"

/// Fits models with slow predictions (Subject::is_costly()).
namespace raceway::fit {

/// Result of a fit, with the derivatives of all means (Means) with respect to the parameters (means
/// x parameters).
struct CostlyFit {
  SeparableFit fit{};
  Eigen::MatrixXd slope{};
  /// Point at which this fit started; null for a fit that continues another fit.
  std::shared_ptr<const CostlyFit> begin{};
};

/// Rules that end a fit.
struct CostlyEnd {
  double settled = 1e-4;  ///< relative fall of the misfit below which a step is no progress [1]
  /// If a step is no progress and the misfit is above this value, the fit ends without computing
  /// new derivatives for another step.
  double hopeless = std::numeric_limits<double>::infinity();
  /// True if the fit stops as soon as the derivatives predict a relative fall below `settled`. The
  /// last step is then an extrapolation without a prediction, and the misfit is approximate.
  bool rough = false;
};

/// Fits the named parameters: minimises the sum of the squared weighted residuals of means by the
/// method of Levenberg and Marquardt. A parameter has a logarithmic scale if its bounds span more
/// than a decade; otherwise it is divided by its typical size. Derivatives are difference quotients
/// with a step of 0.02 on the logarithmic scale, or of 0.2 typical sizes. These steps are so large
/// that neither the tolerance of a simulation nor its step sizes disturb the derivatives. After
/// each step, a rank-one update corrects the derivatives (Broyden 1965). A typical fit needs two
/// predictions for each parameter, plus four. Several threads must not use one object at the same
/// time.
class CostlyProblem {
 public:
  /// The arguments are as in the constructor of Separable.
  CostlyProblem(const Subject& subject, const Record& record,
                const std::shared_ptr<const void>& prepared, const Means& means,
                const std::vector<std::string>& names);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  [[nodiscard]] CostlyFit from(const Eigen::VectorXd& start, const CostlyEnd& end) const;
  /// Fits a model with candidates, starting from `base`, the fit without them. The parameters of
  /// `base` come first, then the parameters of the candidates. `sizes` are the indices of the
  /// parameters that give the candidates their sizes. `initial` contains start values of all
  /// parameters, with sizes that differ from their neutral values. If a size ends at a bound, or
  /// the misfit falls by less than 10 %, a second fit begins at the values at which `base` started,
  /// because the fitted values of `base` may compensate for the missing effect. The second fit runs
  /// only if these two sets of values are far apart and the derivatives predict a smaller misfit.
  [[nodiscard]] CostlyFit beyond(const CostlyFit& base, const Eigen::VectorXd& initial,
                                 const std::vector<std::size_t>& sizes, const CostlyEnd& end) const;
  /// Continues `fit`, a fit of all parameters, until `end`.
  [[nodiscard]] CostlyFit onwards(const CostlyFit& fit, const CostlyEnd& end) const;

 private:
  [[nodiscard]] SeparableFit at(const Eigen::VectorXd& values) const;
  /// Returns the derivatives of the means with respect to the scaled parameters.
  [[nodiscard]] Eigen::MatrixXd differences(const SeparableFit& here) const;
  /// Returns the derivative of the means with respect to a scaled parameter, from a step of `by`,
  /// or of -`by` if a bound prevents the step. If `better` is given, it receives the fit after
  /// the step if this fit has a smaller misfit than `*better`.
  [[nodiscard]] Eigen::VectorXd difference(const SeparableFit& here, std::size_t parameter,
                                           double by, SeparableFit* better = nullptr) const;
  /// Continues the fit from `best` until `end`. `slope` contains derivatives with respect to scaled
  /// parameters. `is_fresh` is true if these derivatives are difference quotients at `best`.
  [[nodiscard]] CostlyFit descend(SeparableFit best, Eigen::MatrixXd slope, bool is_fresh,
                                  const CostlyEnd& end) const;
  /// Switches the candidates on at the fitted values of `base`, a fit without them, and computes
  /// the derivatives with respect to their sizes. For each candidate, the function predicts the
  /// readings with a changed size. The result contains the parameter values with the smallest
  /// misfit among these predictions and the prediction without candidates.
  [[nodiscard]] CostlyFit with_candidates(const CostlyFit& base, const Eigen::VectorXd& initial,
                                          const std::vector<std::size_t>& sizes) const;
  [[nodiscard]] bool is_far(const CostlyFit& base) const;
  /// Returns true if the candidates lower the misfit of a linearised fit by more than 5 %. The fit
  /// starts at `from`, a fit without candidates. The derivatives with respect to the candidates are
  /// taken from `first`, so no prediction is needed.
  [[nodiscard]] bool gains(const CostlyFit& from, const CostlyFit& first,
                           const std::vector<std::size_t>& sizes) const;
  /// Scaled values of the parameters, and the limits of their next steps.
  struct Range {
    Eigen::VectorXd here, lower, upper;
  };
  [[nodiscard]] Range range_of(const Eigen::VectorXd& values) const;
  void find_bounds(SeparableFit& fit) const;
  [[nodiscard]] Eigen::MatrixXd on_scales(Eigen::MatrixXd slope, const Eigen::VectorXd& at) const;
  /// Returns the change of the parameter per unit of its scaled value, in the unit of the
  /// parameter.
  [[nodiscard]] double unit_of(std::size_t parameter, double value) const;
  [[nodiscard]] double to_scale(std::size_t parameter, double value) const;
  [[nodiscard]] double from_scale(std::size_t parameter, double at) const;

  std::vector<Parameter> parameters_;
  const Means& means_;
  std::unique_ptr<Predictor> predictor_;
  Eigen::VectorXd measured_, weight_;
  mutable std::vector<double> all_;  // readings by row
};

/// Returns the residuals of all means [SI], reading minus prediction, after a refit without the
/// means of one block. The refit uses the derivatives in `fit` and needs no new prediction.
/// Parameters stay within their bounds.
[[nodiscard]] Eigen::VectorXd left_of_block(const CostlyFit& fit,
                                            const std::vector<Parameter>& parameters,
                                            const Means& means, int block);

}  // namespace raceway::fit
