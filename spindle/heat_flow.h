#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "spindle/coupled_newton.h"
#include "spindle/spindle.h"

namespace raceway::spindle {

/// Thermal state of a spindle, which advances in time steps or settles to a steady state.
///
/// The model is a mesh of cells together with the sets, or a network of bodies without sets.
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
    double error = 0.0;              ///< estimated error of the worst body [K]; 0 if not requested
    double energy_error = unset;     ///< stored minus supplied heat, relative to all heat flows [1]
    std::array<double, reservoirs> out_before{}, out_after{};  ///< [W]
  };

  /// Sets all bodies to one temperature.
  void start(double temperature);
  void start(const Vector& temperatures) { temperatures_ = temperatures; }
  /// Sets the inputs of the sets. Returns false if the sets have no equilibrium.
  [[nodiscard]] bool set_inputs(const Inputs& inputs);
  /// Advances by dt [s] under `inputs`, whose speed and loads must equal the values of the last
  /// set_inputs(). Heat transfer coefficients, seats, and the bearing loads from radial loads on
  /// the shaft are computed at the temperatures in `films`. The state changes only if the status is
  /// `converged`.
  [[nodiscard]] Step advance(const Inputs& inputs, double machine_rise, double dt,
                             const Vector& films, bool asks_for_error);
  /// Finds the steady state under these inputs. `iterations` counts the updates of heat transfer
  /// coefficients and seats.
  [[nodiscard]] Status settle(const Inputs& inputs, double machine_rise, int& iterations);
  /// Returns the long-term gain of the loop heat -> temperature -> preload -> heat at this state
  /// [1].
  [[nodiscard]] double gain();

  [[nodiscard]] const Vector& temperatures() const { return temperatures_; }
  [[nodiscard]] const Vector& felt() const { return felt_; }
  /// Returns the heat of the raceways in the order of BearingCoupling [W].
  [[nodiscard]] const Vector& given() const { return given_; }
  [[nodiscard]] const HeatPaths& paths() const { return system_ ? system_->paths() : network_; }
  [[nodiscard]] const ThermalSystem* system() const { return system_.get(); }
  [[nodiscard]] BearingCoupling* coupling() { return coupling_.get(); }
  [[nodiscard]] const BearingCoupling* coupling() const { return coupling_.get(); }
  [[nodiscard]] double driven_heat() const {
    return system_ ? system_->driven_heat() : network_.source.sum();
  }
  /// Limit of ring temperatures [K]. Above this limit, the simulation stops with the status
  /// `thermal_runaway`.
  static constexpr double hottest_ring = kelvin(300.0);

 private:
  [[nodiscard]] bool prepare(const Inputs& inputs, double machine_rise, const Vector& films);
  [[nodiscard]] Vector inflow(const Vector& temperatures, const Vector& given) const;
  [[nodiscard]] Status failed(NewtonStatus status);

  std::unique_ptr<ThermalSystem> system_;
  HeatPaths network_;
  std::vector<double> held_;  // fixed temperatures of a network's nodes; NaN: free
  std::unique_ptr<BearingCoupling> coupling_;
  std::unique_ptr<CoupledNewton> newton_;
  Vector temperatures_, given_, felt_;
};

}  // namespace raceway::spindle
