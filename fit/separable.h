#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fit/subject.h"

namespace raceway::fit {

/// Readings as means over neighbouring rows, which is all that a slow model needs of them.
struct Means {
  struct Mean {
    std::vector<Eigen::Index> places{};  ///< in the readings of a predictor
    double measured = unset;             ///< SI
    std::size_t channel = 0;             ///< of Subject::measured()
    double weight = 1.0;                 ///< relative to others: 1/tolerance of its channel
    double time = unset;                 ///< middle of its rows [s]
    int block = -1;                      ///< in which it is held out; -1: none
  };
  std::vector<Mean> list{};
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(list.size()); }
};

/// Tolerance of a channel [SI]: as given, else the model's declared coarseness together with the
/// noise of a reading. NaN where neither is given.
[[nodiscard]] double tolerance_of(const Measured& measured, const Record& record);

/// Means over `width` [s], each within one run and one block; single rows where that is 0.
[[nodiscard]] Means means_of(const Subject& subject, const Record& record, double width);

/// Parameters of which readings are in proportion, and others that bend them.
struct SeparableFit {
  bool converged = false;
  int iterations = 0;
  Eigen::VectorXd values{};  ///< of all parameters, in the units of the files
  std::vector<bool> at_bound{};
  Eigen::VectorXd
      residual{};  ///< reading minus prediction of every mean [SI], also of those left out
  /// Weighted sum of squares of those that were fitted, and what the priors add.
  double misfit = unset;
};

/// Minimises the weighted sum of squares of means over the parameters of some names: those in
/// proportion by linear least squares within each step (variable projection [GolubPereyra1973]),
/// the others by the method of Levenberg and Marquardt, on a scale of logarithms where bounds span
/// more than a decade.
///
/// A ridge of 1e-6 on columns of unit length keeps two lags of nearly one time constant from
/// growing against each other. A prior adds w (v - value)²/std² for its parameter v, where w is the
/// variance of a weighted mean: a number that the means tell better than the prior follows them,
/// the others stay. What a bending parameter does not change (Predictor::bends()) is kept from one
/// look to the next. Not for several threads at once: they share what is kept.
class Separable {
 public:
  /// `record` and `prepared` as of Subject::predictor(); all of them outlive this. `prior_weight`:
  /// the w above; with 0 priors do not count.
  Separable(const Subject& subject, const Record& record,
            const std::shared_ptr<const void>& prepared, const Means& means,
            const std::vector<std::string>& names, double prior_weight = 0.0);

  [[nodiscard]] const std::vector<Parameter>& parameters() const { return parameters_; }
  /// Indices of parameters() that bend.
  [[nodiscard]] const std::vector<std::size_t>& bending() const { return bending_; }

  /// The least misfit with the bending parameters as they are.
  [[nodiscard]] SeparableFit at(const Eigen::VectorXd& values, int left_out = -1,
                                double ridge = usual_ridge) const;
  /// From one start; `held` parameters stay as they are. Means of the block `left_out` do not
  /// count.
  [[nodiscard]] SeparableFit from(const Eigen::VectorXd& start, int left_out = -1,
                                  const std::vector<bool>& held = {},
                                  double ridge = usual_ridge) const;
  /// Fall of the misfit if the parameter `size` is freed and `place`, which acts only through it,
  /// takes each of these values. Proportional parameters follow; bending ones stay.
  [[nodiscard]] std::vector<double> falls(Eigen::VectorXd values, std::size_t size,
                                          std::size_t place,
                                          const std::vector<double>& tried) const;
  /// Derivatives of all means by all parameters.
  [[nodiscard]] Eigen::MatrixXd jacobian(const Eigen::VectorXd& values) const;

  static constexpr double usual_ridge = 1e-6;

 private:
  /// Readings at zero of all parameters in proportion, and per unit of each. Holds: where `values`
  /// is not empty, everything is as it would be made anew at these values and without this block.
  struct Basis {
    Eigen::VectorXd values;
    Eigen::VectorXd constant;
    Eigen::MatrixXd columns;  // of the parameters in proportion
    int left_out = -1;
    Eigen::VectorXd weights;           // 0 in that block
    Eigen::MatrixXd weighted, normal;  // columns by weight, of length 1; their products
    Eigen::VectorXd length;
  };
  /// A prior as one reading more, of the value over its std.
  struct PriorReading {
    Eigen::Index parameter = 0;
    double per_unit = unset;
  };
  /// Returns the readings of all means, then of the priors.
  [[nodiscard]] Eigen::VectorXd readings(const Eigen::VectorXd& values) const;
  void read_priors(const Eigen::VectorXd& values, Eigen::VectorXd& readings) const;
  [[nodiscard]] SeparableFit without_priors(SeparableFit fit) const;
  /// at(), with the residuals of the priors after the residuals of the means.
  [[nodiscard]] SeparableFit with_priors(const Eigen::VectorXd& values, int left_out,
                                         double ridge) const;
  /// The kept basis, brought up to these values and weights.
  const Basis& basis(Eigen::VectorXd values, int left_out) const;
  [[nodiscard]] double to_scale(std::size_t parameter, double value) const;
  [[nodiscard]] double from_scale(std::size_t parameter, double at) const;

  std::vector<Parameter> parameters_;
  std::vector<std::size_t> bending_, straight_;
  const Means& means_;
  std::unique_ptr<Predictor> predictor_;
  std::vector<PriorReading> priors_;
  Eigen::VectorXd measured_, weight_;
  std::vector<std::vector<std::size_t>> bent_by_;  // by parameter in proportion; last: the constant
  mutable std::vector<double> all_;                // readings by row
  mutable Basis kept_;
};

}  // namespace raceway::fit
