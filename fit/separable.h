#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Means of readings over neighbouring rows. Fits of spindle models and corrections use such means,
/// because temperatures and displacements change slowly.
struct Means {
  struct Mean {
    /// Indices of the averaged readings in the result of Predictor::readings().
    std::vector<Eigen::Index> places{};
    double measured = unset;  ///< mean of the readings [SI]
    std::size_t channel = 0;  ///< index in Subject::measured()
    double weight = 1.0;      ///< 1/tolerance of the channel [1/SI], or 1 without a tolerance
    double time = unset;      ///< mean time of the rows [s]
    int block = -1;           ///< index of the block that is held out together; -1: never held out
  };
  std::vector<Mean> list{};
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(list.size()); }
};

/// Returns the tolerance of a channel [SI]: Measured::tolerance, if the user has given it. Without
/// a given tolerance, the tolerance of a spindle model or a correction (Subject::approximates()) is
///
///   sqrt(e² + n²)
///
/// e is the declared error of the model (Measured::model_error). n is the standard deviation of a
/// reading; n is 0 if the standard deviation is unknown. Without a given tolerance, the result is
/// NaN if the model is neither a spindle model nor a correction, or if it declares no error e.
[[nodiscard]] double tolerance_of(const Measured& measured, const Record& record);

/// Returns the means of readings over time intervals of `width` [s]. All rows of a mean belong to
/// one run and one block. With a width of 0, each mean consists of a single row.
[[nodiscard]] Means means_of(const Subject& subject, const Record& record, double width);

/// Result of a fit to means of readings (Means).
struct SeparableFit {
  bool converged = false;
  int iterations = 0;
  Eigen::VectorXd values{};  ///< values of all parameters, in the units of the model files
  std::vector<bool> at_bound{};
  /// Reading minus prediction of every mean [SI], including the held-out means.
  Eigen::VectorXd residual{};
  /// Sum of the squared weighted residuals of the fitted means, plus the terms of the priors [1];
  /// in the squared SI unit of the readings if the channels have no tolerance.
  double misfit = unset;
};

/// Fits the named parameters: minimises the sum of the squared weighted residuals of means. The
/// predictions are linear in some of the parameters (Parameter::proportional). Each step solves for
/// these linear parameters by linear least squares (variable projection [GolubPereyra1973]). The
/// method of Levenberg and Marquardt finds the nonlinear parameters, which are all other
/// parameters. A nonlinear parameter whose bounds span more than a decade has a logarithmic scale.
///
/// The linear fit is a ridge regression: 1e-6 is added to the diagonal of the normal equations,
/// with columns scaled to length 1. Without this term, the gains of two lags with nearly equal time
/// constants could become very large with opposite signs.
///
/// A prior (value ± std) of a parameter v adds w (v - value)²/std² to the minimised sum. w is the
/// variance of the weighted residuals, corrected for the correlation of the residuals. The fitted v
/// is therefore near the prior value, unless the means of readings determine v better than the
/// prior does.
///
/// Several threads must not use one object at the same time, because the object stores predictions.
class Separable {
 public:
  /// `record` and `prepared` have the same meaning as in Subject::predictor(). All arguments must
  /// live longer than this object. `prior_weight` is the factor w of the priors; if it is 0, the
  /// priors are not used.
  Separable(const Subject& subject, const Record& record,
            const std::shared_ptr<const void>& prepared, const Means& means,
            const std::vector<std::string>& names, double prior_weight = 0.0);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// Returns the indices of the nonlinear parameters in parameters().
  [[nodiscard]] const std::vector<std::size_t>& bending() const { return bending_; }

  /// Fits the linear parameters, with the nonlinear parameters fixed at `values`. The fit does not
  /// use the means of the block with the index `left_out`; if `left_out` is -1, the fit uses all
  /// means.
  [[nodiscard]] SeparableFit at(const Eigen::VectorXd& values, int left_out = -1,
                                double ridge = usual_ridge) const;
  /// Fits all parameters, starting from `start`. `held` is empty or has one entry for each
  /// parameter. A nonlinear parameter stays at its start value if its entry is true. `left_out` has
  /// the same meaning as in at().
  [[nodiscard]] SeparableFit from(const Eigen::VectorXd& start, int left_out = -1,
                                  const std::vector<bool>& held = {},
                                  double ridge = usual_ridge) const;
  /// Tries several values of the nonlinear parameter with the index `place`, for example the time
  /// of a jump. This parameter changes the predictions only if the linear parameter with the index
  /// `size`, for example the size of the jump, is not zero. Returns, for each value in `tried`, the
  /// decrease of the misfit when all linear parameters are fitted, compared with a fit in which the
  /// parameter `size` is zero. All other nonlinear parameters keep the values in `values`.
  [[nodiscard]] std::vector<double> falls(Eigen::VectorXd values, std::size_t size,
                                          std::size_t place,
                                          const std::vector<double>& tried) const;
  /// Returns the derivatives of the predicted means with respect to the parameters (means x
  /// parameters).
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& values) const;

  static constexpr double usual_ridge = 1e-6;

 private:
  /// The predicted means are `constant` plus the sum of each linear parameter times its column in
  /// `columns`.
  struct Basis {
    Eigen::VectorXd values;
    Eigen::VectorXd constant;
    Eigen::MatrixXd columns;  // one column for each linear parameter
    int left_out = -1;
    Eigen::VectorXd weights;           // 0 in the held-out block
    Eigen::MatrixXd weighted, normal;  // weighted columns of length 1, and their products
    Eigen::VectorXd length;
  };
  /// A prior, which the fit treats as a reading. The prediction of this reading is the value of the
  /// parameter times sqrt(w)/std.
  struct PriorReading {
    Eigen::Index parameter = 0;
    double per_unit = unset;  ///< sqrt(w)/std
  };
  /// Returns the predictions of all means, followed by the predictions of all prior readings.
  [[nodiscard]] Eigen::VectorXd readings(const Eigen::VectorXd& values) const;
  void read_priors(const Eigen::VectorXd& values, Eigen::VectorXd& readings) const;
  [[nodiscard]] SeparableFit without_priors(SeparableFit fit) const;
  /// Returns the same fit as at(), with the residuals of the priors after the residuals of the
  /// means.
  [[nodiscard]] SeparableFit with_priors(const Eigen::VectorXd& values, int left_out,
                                         double ridge) const;
  /// Returns the basis for these parameter values and this held-out block. Parts of the last basis
  /// that are still valid are not calculated again.
  const Basis& basis(Eigen::VectorXd values, int left_out) const;
  [[nodiscard]] double to_scale(std::size_t parameter, double value) const;
  [[nodiscard]] double from_scale(std::size_t parameter, double at) const;

  std::vector<Parameter> parameters_;
  std::vector<std::size_t> bending_, straight_;
  const Means& means_;
  std::unique_ptr<Predictor> predictor_;
  std::vector<PriorReading> priors_;
  Eigen::VectorXd measured_, weight_;
  // For each linear parameter: nonlinear parameters that affect its column of Basis::columns. The
  // last entry is for Basis::constant.
  std::vector<std::vector<std::size_t>> bent_by_;
  mutable std::vector<double> all_;  // output of Predictor::readings()
  mutable Basis kept_;
};

}  // namespace raceway::fit
