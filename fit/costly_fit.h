#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "fit/separable.h"

/// Fits of subjects of which a prediction costs much (Subject::is_costly()).
namespace raceway::fit {

/// What a fit ends with, and the derivatives of all means by the values there.
struct CostlyFit {
  SeparableFit fit{};
  Eigen::MatrixXd slope{};
};

/// Minimises the weighted sum of squares of means over the parameters of some names, all alike, by
/// the method of Levenberg and Marquardt on a scale of logarithms where bounds span more than a
/// decade. Derivatives are differences over a hundredth of that scale, so that neither the
/// tolerance of a simulation nor the steps that it chooses show in them; between two sets of
/// differences they are kept up by the update of rank one [Broyden1965]. Takes about three
/// predictions for each parameter and six more.
class CostlyProblem {
 public:
  /// As of Separable.
  CostlyProblem(const Subject& subject, const Record& record,
                const std::shared_ptr<const void>& prepared, const Means& means,
                const std::vector<std::string>& names);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// From the best of some starts; `settled`: the relative fall of the misfit that is none.
  [[nodiscard]] CostlyFit from(const std::vector<Eigen::VectorXd>& starts, double settled) const;
  /// A value moved by a share of its scale: of the range, or of a factor e.
  [[nodiscard]] double moved(std::size_t parameter, double value, double by) const;

 private:
  [[nodiscard]] SeparableFit at(const Eigen::VectorXd& values) const;
  [[nodiscard]] Eigen::MatrixXd differences(const SeparableFit& here) const;
  [[nodiscard]] double to_scale(std::size_t parameter, double value) const;
  [[nodiscard]] double from_scale(std::size_t parameter, double at) const;

  std::vector<Parameter> parameters_;
  const Means& means_;
  std::unique_ptr<Predictor> predictor_;
  Eigen::VectorXd measured_, weight_;
  mutable std::vector<double> all_;  // readings by row
};

/// What of the means of one block stays where all others alone decide, by the derivatives: the
/// readings are not predicted again. Parameters stay within their bounds.
[[nodiscard]] Eigen::VectorXd left_of_block(const CostlyFit& fit,
                                            const std::vector<Parameter>& parameters,
                                            const Means& means, int block);

}  // namespace raceway::fit
