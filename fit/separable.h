#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Means of readings over neighbouring rows. They replace the single rows in the fit of a model of
/// slow changes.
struct Means {
  struct Mean {
    std::vector<Eigen::Index> places{};  ///< indices in the output of Predictor::readings()
    double measured = unset;             ///< mean of the readings [SI]
    std::size_t channel = 0;             ///< index in Subject::measured()
    double weight = 1.0;  ///< 1/tolerance of the channel [1/SI], or 1 without a tolerance
    double time = unset;  ///< mean time of the rows [s]
    int block = -1;       ///< index of the block with which the mean is held out; -1: no block
  };
  std::vector<Mean> list{};
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(list.size()); }
};

/// Returns the tolerance of a channel [SI]. If none is given, a model that only approximates the
/// readings has a calculated tolerance: the root of the sum of squares of its declared error and
/// the noise of a reading, or the declared error alone if the noise is unknown. If no tolerance is
/// given, the result is NaN for other models and for models without a declared error.
[[nodiscard]] double tolerance_of(const Measured& measured, const Record& record);

/// Returns the means of readings over time intervals of `width` [s]. A mean has rows of one run and
/// one block only. With a width of 0, each row is a mean.
[[nodiscard]] Means means_of(const Subject& subject, const Record& record, double width);

/// Result of a fit to means (Means). The predictions are linear in some of the parameters.
struct SeparableFit {
  bool converged = false;
  int iterations = 0;
  Eigen::VectorXd values{};  ///< values of all parameters, in the units of the files
  std::vector<bool> at_bound{};
  Eigen::VectorXd
      residual{};  ///< reading minus prediction of every mean [SI], also of held-out means
  /// Sum of the squared weighted residuals of the fitted means, plus the terms of the priors [1].
  double misfit = unset;
};

/// Fits the named parameters: minimises the sum of the squared weighted residuals of means. Linear
/// parameters are solved by linear least squares within each step (variable projection
/// [GolubPereyra1973]). The other parameters, on which the predictions depend nonlinearly, are
/// called bending parameters. They are found by the method of Levenberg and Marquardt. A bending
/// parameter whose bounds span more than a decade has a logarithmic scale.
///
/// A ridge of 1e-6 on columns of unit length prevents the gains of two lags with nearly equal time
/// constants from becoming very large with opposite signs. A prior (value ± std) of a parameter v
/// adds w (v - value)²/std² to the sum, where w is the variance of the weighted residuals,
/// corrected for their correlation. The fitted v is therefore near the prior, unless the means
/// determine v better than the prior. The object stores the latest predictions and computes only
/// those again that a changed bending parameter affects (Predictor::bends()). Several threads must
/// therefore not use one object at the same time.
class Separable {
 public:
  /// `record` and `prepared` are the arguments of Subject::predictor(). All arguments must live
  /// longer than this object. `prior_weight` is w above; with 0, the priors are not used.
  Separable(const Subject& subject, const Record& record,
            const std::shared_ptr<const void>& prepared, const Means& means,
            const std::vector<std::string>& names, double prior_weight = 0.0);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// Returns the indices of the bending parameters in parameters().
  [[nodiscard]] const std::vector<std::size_t>& bending() const { return bending_; }

  /// Returns the fit of the linear parameters, with the bending parameters fixed at `values`. Means
  /// of the block `left_out` are not used; -1: all means are used.
  [[nodiscard]] SeparableFit at(const Eigen::VectorXd& values, int left_out = -1,
                                double ridge = usual_ridge) const;
  /// Fits all parameters, starting from `start`. A bending parameter whose entry in `held` is true
  /// keeps its start value. `left_out` is as in at().
  [[nodiscard]] SeparableFit from(const Eigen::VectorXd& start, int left_out = -1,
                                  const std::vector<bool>& held = {},
                                  double ridge = usual_ridge) const;
  /// Sets the bending parameter with the index `place` to each value in `tried`. Returns, for each
  /// of these values, the fall of the misfit when the linear parameter with the index `size` is
  /// fitted instead of zero. The bending parameter has an influence only if this linear parameter
  /// is not zero. The other linear parameters are refitted; the other bending parameters keep their
  /// values.
  [[nodiscard]] std::vector<double> falls(Eigen::VectorXd values, std::size_t size,
                                          std::size_t place,
                                          const std::vector<double>& tried) const;
  /// Returns the derivatives of the predicted means with respect to the parameters (means x
  /// parameters).
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& values) const;

  static constexpr double usual_ridge = 1e-6;

 private:
  /// Predicted means with all linear parameters at zero (`constant`), and the change of the
  /// predicted means per unit of each linear parameter (`columns`). If `values` is empty, the other
  /// members are not valid. Otherwise they are valid for these values and exclude the held-out
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
  /// A prior as an additional reading: the value of the parameter times sqrt(w)/std.
  struct PriorReading {
    Eigen::Index parameter = 0;
    double per_unit = unset;
  };
  /// Returns the predictions of all means, followed by the predictions of all prior readings.
  [[nodiscard]] Eigen::VectorXd readings(const Eigen::VectorXd& values) const;
  void read_priors(const Eigen::VectorXd& values, Eigen::VectorXd& readings) const;
  [[nodiscard]] SeparableFit without_priors(SeparableFit fit) const;
  /// Returns the result of at(), with the residuals of the priors added after the residuals of the
  /// means.
  [[nodiscard]] SeparableFit with_priors(const Eigen::VectorXd& values, int left_out,
                                         double ridge) const;
  /// Returns the stored basis after updating it for these values and this held-out block.
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
