#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bearing/solve_many.h"
#include "effects/effect.h"
#include "fit/data_set.h"
#include "fit/model.h"

namespace raceway::fit {

/// Friction of one bearing at one operating point, and what the rig reads of it. All numbers are
/// NaN where an input is not known, or where the point has no balance and an effect needs it;
/// `report` then says why. A model that needs no balls has its torque also without balance.
struct FrictionPrediction {
  double load = unset;  ///< load moment of the base law, at the load the bearing really sees [N m]
  double viscous =
      unset;  ///< viscous moment of the base law, with what the film leaves of it [N m]
  /// Added moment of each effect, in the order of the model [N m]; 0 for one that acts on
  /// condition, lubricant or reading, and shows in the other terms.
  std::vector<double> effects;
  double torque = unset;      ///< sum of all these [N m]
  double power_loss = unset;  ///< torque times speed [W]
  double reading = unset;  ///< of the rig: torque of all its bearings, then the reading steps [N m]
  effects::Condition condition;        ///< what effects change of the entered condition
  double kinematic_viscosity = unset;  ///< of the film [m²/s]
  /// The bearing as the condition makes it; null where that is the one entered.
  std::shared_ptr<const bearing::Bearing> bearing;
  /// Balls in balance; null where there is none, and where nobody asked for it and nothing needed
  /// it.
  std::shared_ptr<const bearing::BearingEquilibrium> equilibrium;
  bearing::SolveReport report;  ///< not_run where no equilibrium was needed

  [[nodiscard]] bool predicted() const;  ///< torque is a number
};

/// What was recorded with a row, as effects see it.
[[nodiscard]] effects::Record record_of(const Row& row);

/// True if an effect of the model uses ball loads or angles. The base laws do not, so a bearing
/// whose load is only assumed can be compared without a solve.
[[nodiscard]] bool needs_equilibrium(const Model& model);

/// Friction of one bearing [N m] on its way through four steps, at each of which effects may act:
///
///   condition    extra load, tilt, growth of rings, ball material: changes add up
///   -> ball equilibrium, where an effect needs it or `with_equilibrium` asks for it
///   lubricant    viscosity of the film and share of the viscous moment, in the order of the
///                catalogue
///   -> base law at the real load and the film's viscosity; Palmgren's with the entered bearing
///   moment       added moments, each from the base moments before this step
///   -> torque of all bearings of the rig
///   reading      added torques, each from the torque before this step
///
/// so the order of effects in the model changes nothing.
[[nodiscard]] FrictionPrediction predict_friction(const Model& model,
                                                  const bearing::OperatingPoint& point,
                                                  bool with_equilibrium = false,
                                                  const effects::Record& record = {});

/// The same for many points, solved side by side and shared among threads: neither the number of
/// threads nor the other points change a digit. `records` may be empty. Throws
/// std::invalid_argument if the sizes differ.
void predict_sweep(const Model& model, std::span<const bearing::OperatingPoint> points,
                   std::span<FrictionPrediction> predictions, bool with_equilibrium = false,
                   std::span<const effects::Record> records = {});

/// Friction of one bearing at every row of a data set, in its order.
[[nodiscard]] std::vector<FrictionPrediction> predict_rows(const Model& model, const DataSet& data);

/// Torque of all bearings of a rig, which turn on one shaft, M = bearings * M_bearing [N m]; the
/// steps of reading not included.
[[nodiscard]] double rig_torque(const Rig& rig, double bearing_torque);

/// The bearing with grown rings and other balls; null where it has no free contact angle left.
/// Growth u of the inner raceway moves its groove centres outwards: cos α0 -> cos α0 + u/(B D).
[[nodiscard]] std::shared_ptr<const bearing::Bearing> changed_bearing(
    const bearing::Bearing& entered, const effects::Condition& condition);

/// The state of one bearing that friction laws and effects look at, as entered; `equilibrium` may
/// be null.
[[nodiscard]] friction::BearingState<double> bearing_state(
    const Model& model, const bearing::OperatingPoint& point,
    const bearing::BearingEquilibrium* equilibrium);

/// Which effects of a model act where; found once for many predictions.
struct Steps {
  /// Indices into Model::effects.
  std::vector<std::size_t> condition, lubricant, moment, reading, displacement;
  bool equilibrium = false;  ///< to be solved
  bool needs_balls = false;  ///< without it there is no prediction
  explicit Steps(const Model& model, bool with_equilibrium = false);
};

/// What the effects of a model change of the condition of a bearing in the state `entered`, beside
/// what is `given`; not finite where an input is not known. The bearing may be another one than the
/// model's.
[[nodiscard]] effects::Condition condition_of(const Model& model, const Steps& steps,
                                              const friction::BearingState<double>& entered,
                                              const bearing::OperatingPoint& point,
                                              const effects::Record& record,
                                              const effects::Condition& given = {});

/// The first thing that a changed parameter can change.
enum class Stage { condition, lubricant, base, moment, reading };

/// The stage that a parameter of the base law (`effect` < 0) or of an effect acts on first.
[[nodiscard]] Stage first_stage(const Model& model, const Steps& steps, int effect);

/// Balls in balance, shared by all that look at them.
using Balance = std::shared_ptr<const bearing::BearingEquilibrium>;

/// One row that is predicted again and again with other parameter values of the same model. It
/// remembers the equilibrium, solved again only when the condition moved, and what else a parameter
/// leaves alone.
class RowPredictor {
 public:
  /// `entered`: the balance under the condition as entered, where it is known already. `given` is a
  /// condition beside that of the effects in `steps`: what a shaft makes of it.
  RowPredictor(const Model& model, const Steps& steps, const bearing::OperatingPoint& point,
               const effects::Record& record, Balance entered = nullptr,
               const effects::Condition& given = {});

  /// Reading of the rig [N m], NaN without a prediction. What is computed is remembered; values of
  /// the model that act before `from` must be those of the last call.
  double predict(const Model& model, const Steps& steps, Stage from = Stage::condition);
  /// The same for values that differ from the remembered ones from `stage` on; remembers nothing.
  [[nodiscard]] double vary(const Model& model, const Steps& steps, Stage stage) const;

  /// The balance that predict() will need, for callers that solve many at once and answer() before
  /// they call it; nothing where it needs none, remembers it, or needs one at an imposed tilt.
  [[nodiscard]] std::optional<bearing::BearingCase> ask(const Model& model, const Steps& steps);
  void answer(bearing::BearingEquilibrium&& equilibrium);

  /// All that the last predict() found.
  [[nodiscard]] FrictionPrediction prediction(const Model& model) const;
  [[nodiscard]] const Balance& equilibrium() const { return now_.equilibrium; }

 private:
  /// Everything on the way of one prediction.
  struct Way {
    effects::Condition condition;
    std::shared_ptr<const bearing::Bearing> bearing;  // null: as entered
    Balance equilibrium;
    bearing::SolveReport report;
    effects::Film film;
    friction::BaseMoments<double> base{unset, unset};
    std::vector<double> units;  // unit moments of Steps::moment, NaN where it has none
    double torque = unset, reading = unset;
  };
  void run(const Model& model, const Steps& steps, Stage stage, Way& way) const;
  bool find_condition(const Model& model, const Steps& steps, effects::Condition& condition) const;
  std::optional<bearing::BearingCase> question(const Model& model, Way& way) const;
  void solve(const Model& model, Way& way) const;
  [[nodiscard]] friction::BearingState<double> state(const Model& model, const Way& way) const;

  bearing::OperatingPoint point_;
  effects::Record record_;
  effects::Condition given_;
  double entered_viscosity_, radial_load_;
  Way now_;
  mutable Way varied_;  // memory kept between calls of vary()
};

/// predict() for all rows, the balances they need solved side by side.
void predict_all(const Model& model, const Steps& steps, std::span<RowPredictor> rows,
                 std::span<double> readings, Stage from = Stage::condition);

/// Balances of all rows under the condition as entered.
[[nodiscard]] std::vector<Balance> entered_balances(const Model& model, const DataSet& data);

}  // namespace raceway::fit
