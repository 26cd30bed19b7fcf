#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "fit/separable.h"

/// Fits models with slow predictions (Subject::is_costly()).
namespace raceway::fit {

/// Result of a fit to means of readings (Means).
struct CostlyFit {
  SeparableFit fit{};
  /// Derivatives of the predicted means with respect to the parameters (means x parameters).
  Eigen::MatrixXd slope{};
  /// Start of this fit: parameter values, residuals and derivatives. Null for the results of
  /// CostlyProblem::beyond() and CostlyProblem::onwards(), which start from another fit.
  std::shared_ptr<const CostlyFit> begin{};
};

/// Conditions under which a fit ends.
struct CostlyEnd {
  double settled = 1e-4;  ///< smallest relative decrease of the misfit that counts as progress [1]
  /// Misfit above which the fit ends at the first step without progress (see `settled`). Below this
  /// misfit, the fit first computes new derivatives and tries one more step.
  double hopeless = std::numeric_limits<double>::infinity();
  /// True if the fit stops as soon as the derivatives predict that the next step decreases the
  /// misfit by a share below `settled`. The fit takes this last step without a new prediction, so
  /// the final misfit is approximate.
  bool rough = false;
};

/// Fits the parameters with the names that the constructor receives. The method of Levenberg and
/// Marquardt minimises the sum of the squared weighted residuals of the means. A parameter has a
/// logarithmic scale if its bounds span more than a decade. Any other parameter is divided by its
/// typical size (Parameter::scale).
///
/// Derivatives are difference quotients with a step of 0.02 on the logarithmic scale, or of 0.2
/// typical sizes. The steps are large, so that numerical errors of the simulation have little
/// influence on the derivatives. After each step of the fit, a rank-one update corrects the
/// derivatives (Broyden 1965). A typical fit with n parameters needs 2 n + 4 predictions. Several
/// threads must not use one object at the same time.
class CostlyProblem {
 public:
  CostlyProblem(const Subject& subject, const Record& record,
                const std::shared_ptr<const void>& prepared, const Means& means,
                const std::vector<std::string>& names);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// Fits all parameters, starting from the values `start`.
  [[nodiscard]] CostlyFit from(const Eigen::VectorXd& start, const CostlyEnd& end) const;
  /// Fits a model with candidate effects. The fit starts from `base`, the fit without candidates.
  /// The parameters of `base` come first, then the parameters of the candidates. `sizes` contains
  /// the indices of the size parameters of the candidates. `initial` has an entry for each
  /// parameter, but the function uses only the start values of the candidates.
  ///
  /// If a fitted size lies at a bound, or if the misfit falls by less than 10 %, the fitted values
  /// of `base` may compensate for the missing effect. A second fit then starts from
  /// CostlyFit::begin, the start of `base`. The second fit is skipped if the start of `base` is
  /// close to the fitted values of `base`, or if the derivatives at this start predict that the
  /// candidates lower the misfit by less than 5 %. The result is the fit with the smaller misfit.
  [[nodiscard]] CostlyFit beyond(const CostlyFit& base, const Eigen::VectorXd& initial,
                                 const std::vector<std::size_t>& sizes, const CostlyEnd& end) const;
  /// Continues the iteration of an earlier fit of all parameters.
  [[nodiscard]] CostlyFit onwards(const CostlyFit& fit, const CostlyEnd& end) const;

 private:
  [[nodiscard]] SeparableFit at(const Eigen::VectorXd& values) const;
  /// Returns the derivatives of the means with respect to the scaled parameters.
  [[nodiscard]] Eigen::MatrixXd differences(const SeparableFit& here) const;
  /// Returns the derivative of the means with respect to a scaled parameter. The function changes
  /// the parameter by `by`, or by -`by` if a bound prevents the change by `by`. If the change gives
  /// a smaller misfit than `*better`, `*better` receives the changed fit. `better` may be null.
  [[nodiscard]] Eigen::VectorXd difference(const SeparableFit& here, std::size_t parameter,
                                           double by, SeparableFit* better = nullptr) const;
  /// Continues the fit from `best`. `slope` contains derivatives with respect to scaled parameters.
  /// `is_fresh` is true if these derivatives are difference quotients at `best`.
  [[nodiscard]] CostlyFit descend(SeparableFit best, Eigen::MatrixXd slope, bool is_fresh,
                                  const CostlyEnd& end) const;
  /// Starts a fit with candidates at the fitted values of `base`, the fit without candidates. For
  /// each candidate, the function changes the size, predicts the readings, and computes the
  /// derivative with respect to the size. The result has the parameter values of the prediction
  /// with the smallest misfit, or of `base` if no prediction has a smaller misfit.
  [[nodiscard]] CostlyFit with_candidates(const CostlyFit& base, const Eigen::VectorXd& initial,
                                          const std::vector<std::size_t>& sizes) const;
  [[nodiscard]] bool is_far(const CostlyFit& base) const;
  /// Returns true if the candidates lower the misfit of a linearised fit by more than 5 %. The
  /// linearised fit starts at `from`, a fit without candidates. The derivatives with respect to the
  /// parameters of the candidates come from `first`, the result of with_candidates().
  [[nodiscard]] bool gains(const CostlyFit& from, const CostlyFit& first,
                           const std::vector<std::size_t>& sizes) const;
  /// Scaled values of all parameters, and limits of the changes of these values in the next step.
  struct Range {
    Eigen::VectorXd here, lower, upper;
  };
  [[nodiscard]] Range range_of(const Eigen::VectorXd& values) const;
  void find_bounds(SeparableFit& fit) const;
  [[nodiscard]] Eigen::MatrixXd on_scales(Eigen::MatrixXd slope, const Eigen::VectorXd& at) const;
  /// Returns the derivative of a parameter with respect to its scaled value, at the parameter value
  /// `value`.
  [[nodiscard]] double unit_of(std::size_t parameter, double value) const;
  [[nodiscard]] double to_scale(std::size_t parameter, double value) const;
  [[nodiscard]] double from_scale(std::size_t parameter, double at) const;

  std::vector<Parameter> parameters_;
  const Means& means_;
  std::unique_ptr<Predictor> predictor_;
  Eigen::VectorXd measured_, weight_;
  mutable std::vector<double> all_;  // readings by row
};

/// Returns the residuals of all means [SI], reading minus prediction, after a linearised fit that
/// omits the means of the block `block`. This fit uses the derivatives in `fit` and needs no new
/// prediction. Parameters stay within their bounds.
[[nodiscard]] Eigen::VectorXd left_of_block(const CostlyFit& fit,
                                            const std::vector<Parameter>& parameters,
                                            const Means& means, int block);

}  // namespace raceway::fit
