#pragma once

#include <Eigen/Core>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "tests/hidden_effect/generator.h"

namespace hidden_effect {

/// A datum of the files that may be wrong by one free size.
struct Datum {
  std::string_view id;  ///< in the catalogue
  double largest;       ///< size beyond which nothing is searched
  /// Changes the point to the real one. Returns what the sensor adds to the torque [N mm].
  double (*correct)(double size, Point& point);
};
[[nodiscard]] std::span<const Datum> data_of_the_files();

/// Causes that act beside the base law, each with a free size.
struct Hypothesis {
  std::vector<const Effect*> effects{};
  const Datum* datum = nullptr;

  /// Free numbers beside those of the base law.
  [[nodiscard]] int numbers() const;
};

/// Covariance of the noise that the generator adds to these rows [(N mm)^2]. Outliers get a
/// standard deviation of 1000 times that of their row. Not for a logger.
[[nodiscard]] Eigen::MatrixXd covariance_of_noise(const Rig& rig, std::span<const Reading> rows);

/// Likelihood of readings under a hypothesis with known noise. The numbers of the base law are free
/// for each record; its formula is that of the rig.
class Likelihood {
 public:
  Likelihood(const Rig& rig, std::span<const Reading> rows, Eigen::VectorXd torques,
             const Eigen::MatrixXd& covariance);

  /// Returns the least -2 ln L without its constant, r' C^-1 r, by a Levenberg-Marquardt method.
  [[nodiscard]] double least(const Hypothesis& hypothesis) const;
  /// Free numbers of the base law, of all records.
  [[nodiscard]] Eigen::Index base_numbers() const;
  /// Returns ln det C.
  [[nodiscard]] double log_determinant() const;

 private:
  [[nodiscard]] Eigen::VectorXd residuals(const Hypothesis& hypothesis,
                                          const Eigen::VectorXd& x) const;
  [[nodiscard]] double least_from(const Hypothesis& hypothesis, Eigen::VectorXd x,
                                  const Eigen::VectorXd& step, const Eigen::VectorXd& lower,
                                  const Eigen::VectorXd& upper) const;
  /// Returns the size that changes the torque by at most 5 % of the noise-free rms.
  [[nodiscard]] double scale_of(const Hypothesis& one, double largest,
                                const Eigen::VectorXd& start) const;

  const Rig& rig_;
  std::span<const Reading> rows_;
  Eigen::VectorXd torques_;
  Eigen::MatrixXd lower_;          // Cholesky factor of the covariance
  bool independent_;               // the factor is diagonal
  std::vector<Bearing> bearings_;  // of each record
  mutable std::map<std::string_view, double> scales_;
};

}  // namespace hidden_effect
