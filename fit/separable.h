#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Readings as means over neighbouring rows, which is enough detail for a slow model.
struct Means {
  struct Mean {
    std::vector<Eigen::Index> places{};  ///< indices in the readings of a predictor
    double measured = unset;             ///< SI
    std::size_t channel = 0;             ///< index in Subject::measured()
    double weight = 1.0;                 ///< relative weight: 1/tolerance of the channel
    double time = unset;                 ///< time in the middle of the rows [s]
    int block = -1;                      ///< block in which the mean is held out; -1: no block
  };
  std::vector<Mean> list{};
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(list.size()); }
};

/// Returns the tolerance of a channel [SI]. If no value is given, models that only approximate have
/// a calculated tolerance: the root of the sum of squares of the declared model error and the noise
/// of a reading. In all other cases, the result is NaN.
[[nodiscard]] double tolerance_of(const Measured& measured, const Record& record);

/// Returns means over `width` [s], each within one run and one block. A width of 0 keeps single
/// rows.
[[nodiscard]] Means means_of(const Subject& subject, const Record& record, double width);

/// Fit of linear and other parameters. The readings are linear functions of the linear parameters.
struct SeparableFit {
  bool converged = false;
  int iterations = 0;
  Eigen::VectorXd values{};  ///< all parameters, in the units of the files
  std::vector<bool> at_bound{};
  Eigen::VectorXd
      residual{};  ///< reading minus prediction of every mean [SI], including held-out means
  /// Weighted sum of the squared residuals of the fitted means, plus the contribution of the
  /// priors.
  double misfit = unset;
};

/// Minimises the weighted sum of the squared residuals of means over the named parameters. Linear
/// parameters are solved by linear least squares within each step (variable projection
/// [GolubPereyra1973]). All other parameters are called bending parameters. The method of Levenberg
/// and Marquardt finds the bending parameters, on a logarithmic scale if the bounds of a parameter
/// span more than a decade.
///
/// A ridge of 1e-6 on columns of unit length prevents the gains of two lags with nearly equal time
/// constants from becoming very large with opposite signs. A prior adds w (v - value)²/std² for its
/// parameter v, where w is the variance of a weighted mean. Parameters that the means determine
/// better than the prior follow the means; the others stay at the prior. Predictions that a bending
/// parameter does not change (Predictor::bends()) are stored between evaluations. Several threads
/// must not use one object at the same time, because they would share the stored results.
class Separable {
 public:
  /// `record` and `prepared` are the arguments of Subject::predictor(). All arguments must live
  /// longer than this object. `prior_weight` is w; 0 switches the priors off.
  Separable(const Subject& subject, const Record& record,
            const std::shared_ptr<const void>& prepared, const Means& means,
            const std::vector<std::string>& names, double prior_weight = 0.0);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// Returns the indices of the bending parameters in parameters().
  [[nodiscard]] const std::vector<std::size_t>& bending() const { return bending_; }

  /// Returns the fit with the least misfit for the given bending parameters.
  [[nodiscard]] SeparableFit at(const Eigen::VectorXd& values, int left_out = -1,
                                double ridge = usual_ridge) const;
  /// Fits from one start. Parameters in `held` keep their values. Means of the block `left_out` are
  /// not used.
  [[nodiscard]] SeparableFit from(const Eigen::VectorXd& start, int left_out = -1,
                                  const std::vector<bool>& held = {},
                                  double ridge = usual_ridge) const;
  /// Returns the fall of the misfit for each value in `tried` of the parameter `place`, if the
  /// parameter `size` is free. `place` has an influence only if `size` is not zero. Linear
  /// parameters are refitted; bending parameters keep their values.
  [[nodiscard]] std::vector<double> falls(Eigen::VectorXd values, std::size_t size,
                                          std::size_t place,
                                          const std::vector<double>& tried) const;
  /// Returns the derivatives of all means with respect to all parameters.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& values) const;

  static constexpr double usual_ridge = 1e-6;

 private:
  /// Readings with all linear parameters at zero, and readings per unit of each linear parameter.
  /// If `values` is not empty, all members are valid for these values and exclude the held-out
  /// block.
  struct Basis {
    Eigen::VectorXd values;
    Eigen::VectorXd constant;
    Eigen::MatrixXd columns;  // one column for each linear parameter
    int left_out = -1;
    Eigen::VectorXd weights;           // 0 in the held-out block
    Eigen::MatrixXd weighted, normal;  // weighted columns of length 1, and their products
    Eigen::VectorXd length;
  };
  /// A prior as an additional reading: the value divided by the std of the prior.
  struct PriorReading {
    Eigen::Index parameter = 0;
    double per_unit = unset;
  };
  /// Returns the readings of all means, then of the priors.
  [[nodiscard]] Eigen::VectorXd readings(const Eigen::VectorXd& values) const;
  void read_priors(const Eigen::VectorXd& values, Eigen::VectorXd& readings) const;
  [[nodiscard]] SeparableFit without_priors(SeparableFit fit) const;
  /// Returns at() with the residuals of the priors after the residuals of the means.
  [[nodiscard]] SeparableFit with_priors(const Eigen::VectorXd& values, int left_out,
                                         double ridge) const;
  /// Returns the stored basis after updating it to these values and weights.
  const Basis& basis(Eigen::VectorXd values, int left_out) const;
  [[nodiscard]] double to_scale(std::size_t parameter, double value) const;
  [[nodiscard]] double from_scale(std::size_t parameter, double at) const;

  std::vector<Parameter> parameters_;
  std::vector<std::size_t> bending_, straight_;
  const Means& means_;
  std::unique_ptr<Predictor> predictor_;
  std::vector<PriorReading> priors_;
  Eigen::VectorXd measured_, weight_;
  // for each linear parameter; the last entry is the constant
  std::vector<std::vector<std::size_t>> bent_by_;
  mutable std::vector<double> all_;  // readings by row
  mutable Basis kept_;
};

}  // namespace raceway::fit
