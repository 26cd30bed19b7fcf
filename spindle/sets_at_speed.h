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

/// The sets of a spindle at one speed, as the beam wants them.
struct SetsAtSpeed {
  Status status = Status::not_run;  ///< no_equilibrium where the sets or a bearing have none
  std::string message = {};
  bearing::ArrangementCondition condition = {};  ///< with growth by speed and, warm, by heat
  bearing::ArrangementEquilibrium equilibrium = {};
  std::vector<bearing::BearingEquilibrium> bearings = {};  ///< with 5x5 stiffness, front set first
  std::vector<double> clearances = {};                     ///< of the roller bearings [m]
  std::optional<Moment> moment = {};  ///< temperatures of the steady spindle; none where cold
  [[nodiscard]] bool converged() const { return status == Status::converged; }
};

/// The sets of a spindle at several speeds, with the preload and the stiffness that they have
/// there: cold, all at the temperature of mounting, or warm, each bearing with its own rings as the
/// steady spindle heats them. Not for several threads at once.
class SetsOfSpindle {
 public:
  /// Throws std::invalid_argument as Simulator and WarmSets do.
  explicit SetsOfSpindle(const model::Model& model);
  SetsOfSpindle(SetsOfSpindle&&) noexcept;
  ~SetsOfSpindle();

  /// As Simulator::stop_on().
  void stop_on(const std::atomic<bool>* cancelled);
  /// As mounted, with the effects of the model.
  [[nodiscard]] const bearing::Arrangement& arrangement() const;
  [[nodiscard]] SetsAtSpeed at(const Inputs& inputs, bool warm);

 private:
  [[nodiscard]] bool heat(const Inputs& inputs, SetsAtSpeed& sets);
  /// Radial clearances of the roller bearings [m].
  [[nodiscard]] std::vector<double> clearances(double speed,
                                               const std::optional<Moment>& warm) const;

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace raceway::spindle
