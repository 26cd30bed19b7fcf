#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

/// Machines of which all is known: bodies that hold heat, what heats them, what they move. Nothing
/// of the library is used, so what it says of the library's answers is worth something.
namespace correction_study {

/// What flows at one moment: conductances between bodies and to surroundings, and heat from within.
///
///   C_i dT_i/dt = Q_i + sum_j G_ij (T_j - T_i) + sum_s G_is (T_s - T_i)
///
/// Temperatures are in degrees Celsius, all else is SI.
class Flows {
 public:
  struct Surroundings {
    int body;
    double conductance;  ///< [W/K]
    double temperature;  ///< [C]
  };

  explicit Flows(int bodies);

  void join(int a, int b, double conductance);
  void expose(int body, double conductance, double temperature);
  void heat(int body, double power);

  /// Net power into every body [W].
  [[nodiscard]] Eigen::VectorXd net(const Eigen::VectorXd& temperature) const;
  /// Temperatures at which nothing changes. Throws where a body is held by nothing.
  [[nodiscard]] Eigen::VectorXd steady() const;

  [[nodiscard]] const Eigen::MatrixXd& conductance() const { return conductance_; }
  [[nodiscard]] const Eigen::VectorXd& inflow() const { return inflow_; }
  [[nodiscard]] double heat_from_within() const { return from_within_; }
  [[nodiscard]] const std::vector<Surroundings>& surroundings() const { return surroundings_; }

 private:
  Eigen::MatrixXd conductance_;  ///< symmetric, surroundings on its diagonal
  Eigen::VectorXd inflow_;       ///< heat from within and G T of the surroundings
  double from_within_ = 0.0;
  std::vector<Surroundings> surroundings_;
};

/// Flows at a time [s] and state; within a step they may change smoothly with both.
using FlowsAt = std::function<Flows(double time, const Eigen::VectorXd& temperature)>;

/// One step by the implicit trapezoidal rule, flows at its end by iteration: second order, and the
/// heat that is stored is the heat that came in, to rounding.
[[nodiscard]] Eigen::VectorXd step(const Eigen::VectorXd& capacity, const FlowsAt& flows,
                                   double time, double length, const Eigen::VectorXd& temperature);

/// Steps of equal length, none longer than `longest`, from `time` to `time + length`.
[[nodiscard]] Eigen::VectorXd advance(const Eigen::VectorXd& capacity, const FlowsAt& flows,
                                      double time, double length, double longest,
                                      Eigen::VectorXd temperature);

/// Temperatures at which flows that depend on them change nothing.
[[nodiscard]] Eigen::VectorXd rest(const FlowsAt& flows, double time, Eigen::VectorXd start);

}  // namespace correction_study
