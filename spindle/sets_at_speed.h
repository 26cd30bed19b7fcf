#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bearing/displaced_bearing.h"
#include "model/model.h"
#include "spindle/beam.h"
#include "spindle/shaft_loads.h"

namespace raceway::spindle {

/// Bearing sets of a spindle at one speed, as supports of the shaft beam.
struct SetsAtSpeed {
  Status status = Status::not_run;  ///< no_equilibrium if the sets or a bearing have no equilibrium
  std::string message = {};
  /// Speed, axial load, elongation and ring growth of the sets. For warm sets, the ring growth
  /// includes the thermal expansion.
  bearing::ArrangementCondition condition = {};
  bearing::ArrangementEquilibrium equilibrium = {};
  /// Equilibrium of each bearing with its 5x5 stiffness matrix, front set first.
  std::vector<bearing::BearingEquilibrium> bearings = {};
  std::vector<double> clearances = {};  ///< diametral clearances of the roller bearings [m]
  std::optional<Moment> moment = {};    ///< steady state of the spindle; empty for cold sets
  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// Preload and stiffness of the bearing sets of a spindle at any speed. Cold sets have the mounting
/// temperature. Warm sets have the steady-state temperatures of the spindle. Several threads must
/// not use one object simultaneously.
class SetsOfSpindle {
 public:
  /// The model must be a spindle with bearing sets. Throws std::invalid_argument if the sets cannot
  /// be mounted.
  explicit SetsOfSpindle(const model::Model& model);
  SetsOfSpindle(SetsOfSpindle&&) noexcept;
  ~SetsOfSpindle();

  /// Stores a pointer to a flag that cancels at(); see Simulator::stop_on().
  void stop_on(const std::atomic<bool>* cancelled);
  /// Returns the arrangement of the bearing sets as mounted, with the effects of the model.
  [[nodiscard]] const bearing::Arrangement& arrangement() const;
  /// Solves the equilibrium of the bearing sets for these inputs. If `warm` is false, the sets are
  /// cold.
  [[nodiscard]] SetsAtSpeed at(const Inputs& inputs, bool warm);

 private:
  [[nodiscard]] bool heat(const Inputs& inputs, SetsAtSpeed& sets);
  [[nodiscard]] std::vector<double> clearances(double speed,
                                               const std::optional<Moment>& warm) const;

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace raceway::spindle
