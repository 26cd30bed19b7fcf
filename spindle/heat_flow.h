#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "spindle/coupled_newton.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Computes the temperatures of a spindle in time steps or at the steady state.
///
/// The model is a mesh of cells with bearing sets, or a network of thermal bodies without bearings.
class HeatFlow {
 public:
  HeatFlow(const model::Model& model, const effects::SpindleCondition& condition,
           model::Cells cells);
  HeatFlow(const HeatFlow&) = delete;
  HeatFlow& operator=(const HeatFlow&) = delete;

  /// Result of one time step.
  struct Step {
    Status status = Status::not_run;
    Vector rate_before, rate_after;  ///< dT/dt at the start and the end of the step [K/s]
    /// Largest estimated temperature error of a body [K]; 0 if the caller of advance() requested no
    /// error estimate.
    double error = 0.0;
    /// Error of the heat balance [1]: |stored heat - supplied heat|, divided by the sum of the heat
    /// that the spindle receives and the heat that the spindle gives off in the step. The divisor
    /// is at least 100 J.
    double energy_error = unset;
    /// Heat flow to each reservoir (air, machine, coolant) at the start and the end of the step
    /// [W].
    std::array<double, reservoirs> out_before{}, out_after{};
  };

  /// Sets all bodies to one temperature [K]. In a network of thermal bodies, a body with a fixed
  /// temperature keeps this temperature.
  void start(double temperature);
  void start(const Vector& temperatures) { temperatures_ = temperatures; }
  /// Sets speed and loads of the bearing sets. Returns false if the sets have no equilibrium.
  [[nodiscard]] bool set_inputs(const Inputs& inputs);
  /// Advances the temperatures by dt [s]. Speed and loads in `inputs` must equal the speed and
  /// loads of the last call of set_inputs(). `films` contains temperatures of all bodies [K]. At
  /// these temperatures, the function computes the heat transfer coefficients, the conductances of
  /// the ring seats, and the bearing loads due to radial loads on the shaft. `machine_rise` is
  /// added to the machine temperature of the inputs [K]. The temperatures change only if the status
  /// is `converged`.
  [[nodiscard]] Step advance(const Inputs& inputs, double machine_rise, double dt,
                             const Vector& films, bool asks_for_error);
  /// Finds the steady state for these inputs. `iterations` receives the number of updates of heat
  /// transfer coefficients and seat conductances.
  [[nodiscard]] Status settle(const Inputs& inputs, double machine_rise, int& iterations);
  /// Returns the steady-state gain of the feedback loop heat -> temperature -> preload -> heat at
  /// the present temperatures [1]. The result is NaN without bearings or without an equilibrium of
  /// the bearing sets.
  [[nodiscard]] double gain();

  [[nodiscard]] const Vector& temperatures() const { return temperatures_; }
  [[nodiscard]] const Vector& felt() const { return felt_; }
  /// Returns the heat into the raceways, the vector y of BearingCoupling [W].
  [[nodiscard]] const Vector& given() const { return given_; }
  [[nodiscard]] const HeatPaths& paths() const { return system_ ? system_->paths() : network_; }
  [[nodiscard]] const ThermalSystem* system() const { return system_.get(); }
  [[nodiscard]] BearingCoupling* coupling() { return coupling_.get(); }
  [[nodiscard]] const BearingCoupling* coupling() const { return coupling_.get(); }
  [[nodiscard]] double driven_heat() const {
    return system_ ? system_->driven_heat() : network_.source.sum();
  }
  /// Limit of ring temperatures [K]. If a ring is warmer, the simulation stops with the status
  /// `thermal_runaway`.
  static constexpr double hottest_ring = kelvin(300.0);

 private:
  [[nodiscard]] bool prepare(const Inputs& inputs, double machine_rise, const Vector& films);
  [[nodiscard]] Vector inflow(const Vector& temperatures, const Vector& given) const;
  [[nodiscard]] Status failed(NewtonStatus status);

  std::unique_ptr<ThermalSystem> system_;
  HeatPaths network_;
  std::vector<double> held_;  // fixed temperatures of the bodies of a network; NaN: not fixed
  std::unique_ptr<BearingCoupling> coupling_;
  std::unique_ptr<CoupledNewton> newton_;
  Vector temperatures_, given_, felt_;
};

}  // namespace raceway::spindle
