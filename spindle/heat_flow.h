#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "spindle/coupled_newton.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// The thermal state of a spindle and how it goes on: one time step, or where it ends.
///
/// A spindle of cells with its sets, or a network of bodies alone.
class HeatFlow {
 public:
  HeatFlow(const model::Model& model, const effects::SpindleCondition& condition,
           model::Cells cells);
  HeatFlow(const HeatFlow&) = delete;
  HeatFlow& operator=(const HeatFlow&) = delete;

  /// Result of a step.
  struct Step {
    Status status = Status::not_run;
    Vector rate_before, rate_after;  ///< dT/dt [K/s]
    double error = unset;            ///< of the embedded method, largest of all bodies [K]
    double energy_error = unset;     ///< stored less what came in, of the turnover [1]
    std::array<double, reservoirs> out_before{}, out_after{};  ///< [W]
  };

  /// All bodies at one temperature.
  void start(double temperature);
  void start(const Vector& temperatures) { temperatures_ = temperatures; }
  /// Puts the sets under these inputs; false where they have no balance.
  [[nodiscard]] bool set_inputs(const Inputs& inputs);
  /// Goes on by dt [s] under `inputs`, whose speed and loads must be as in set_inputs(). Films,
  /// seats and what loads across the shaft put on its bearings are those at `films`. Nothing
  /// changes unless the status is `converged`.
  [[nodiscard]] Step advance(const Inputs& inputs, double machine_rise, double dt,
                             const Vector& films);
  /// Steady state under these inputs; `iterations` are of films and seats.
  [[nodiscard]] Status settle(const Inputs& inputs, double machine_rise, int& iterations);
  /// Gain of the loop of heat and preload at this state in the long run [1].
  [[nodiscard]] double gain();

  [[nodiscard]] const Vector& temperatures() const { return temperatures_; }
  [[nodiscard]] const Vector& felt() const { return felt_; }
  [[nodiscard]] const HeatPaths& paths() const { return system_ ? system_->paths() : network_; }
  [[nodiscard]] const ThermalSystem* system() const { return system_.get(); }
  [[nodiscard]] BearingCoupling* coupling() { return coupling_.get(); }
  [[nodiscard]] const BearingCoupling* coupling() const { return coupling_.get(); }
  [[nodiscard]] double driven_heat() const {
    return system_ ? system_->driven_heat() : network_.source.sum();
  }
  /// Limit of a ring's temperature; above it the spindle has run away [K].
  static constexpr double hottest_ring = kelvin(300.0);

 private:
  [[nodiscard]] bool prepare(const Inputs& inputs, double machine_rise, const Vector& films);
  [[nodiscard]] Vector inflow(const Vector& temperatures, const Vector& given) const;
  [[nodiscard]] Status failed(NewtonStatus status);

  std::unique_ptr<ThermalSystem> system_;
  HeatPaths network_;
  std::vector<double> held_;  // temperatures of a network's nodes; NaN: free
  std::unique_ptr<BearingCoupling> coupling_;
  std::unique_ptr<CoupledNewton> newton_;
  Vector temperatures_, given_, felt_;
};

}  // namespace raceway::spindle
