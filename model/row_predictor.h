#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bearing/solve_many.h"
#include "model/balance.h"
#include "model/contact_memory.h"
#include "model/prediction.h"
#include "model/steps.h"
#include "model/tilted_equilibrium.h"

namespace raceway::model {

/// Predicts one row of a record repeatedly with different parameter values of one model. The
/// predictor stores its results and computes a result again only if a changed parameter affects
/// this result. See predict_friction() for the steps.
class RowPredictor {
 public:
  using Rollers = std::shared_ptr<const bearing::RollerEquilibrium>;

  /// `given` is the condition of the bearing before the effects in `steps` change it: extra load,
  /// tilt, ring growth and ball material. `known` is the ball equilibrium of the row under the
  /// condition `given`; null if it is not known. `bearing` is the bearing of this equilibrium; null
  /// if it is the bearing of the model. `rollers` is the equilibrium of the original cylindrical
  /// roller bearing; null if it is not known.
  RowPredictor(const Model& model, const Steps& steps, const bearing::OperatingPoint& point,
               const effects::Record& record, Balance known = nullptr,
               const effects::Condition& given = {},
               std::shared_ptr<const bearing::Bearing> bearing = nullptr,
               Rollers rollers = nullptr);

  /// Predicts the reading of the rig [N m]; NaN if no prediction is possible. The function computes
  /// only the stage `from` of the prediction and all later stages (see Stage). If the last call
  /// gave NaN, it computes all stages. Parameters that affect an earlier stage must have the same
  /// values as in the last call.
  double predict(const Model& model, const Steps& steps, Stage from = Stage::entry);

  /// Returns the bearing and the loads for which predict() needs an equilibrium. A caller can solve
  /// the equilibria of many rows together and pass each result to answer(). The result is empty if
  /// no equilibrium is needed, if the equilibrium is already stored, or if an input is unknown. The
  /// result is also empty if the shaft or an effect tilts the bearing, or if the oil traction
  /// determines the rotation of the balls. In these two cases, predict() solves the equilibrium.
  [[nodiscard]] std::optional<bearing::BearingCase> ask(const Model& model, const Steps& steps);
  void answer(bearing::BearingEquilibrium&& equilibrium);
  /// Solves the equilibrium that predict() needs, and computes nothing else.
  void balance(const Model& model, const Steps& steps);

  /// Solves the ball equilibrium and returns the inputs of the contact law. A caller can compute
  /// the contact friction of many rows together and pass each result to answer_contacts(). The
  /// result is empty if the law is not the contact law, if no equilibrium exists, if the oil
  /// traction determines the rotation of the balls, or if an effect changes the bearing or the
  /// film.
  [[nodiscard]] std::optional<friction::BearingState<double>> ask_contacts(const Model& model,
                                                                           const Steps& steps);
  void answer_contacts(const Model& model, const friction::contact::ContactResult& contacts);

  /// Returns all results of the last predict().
  [[nodiscard]] FrictionPrediction prediction(const Model& model) const;
  [[nodiscard]] const Balance& equilibrium() const { return equilibrium_; }
  [[nodiscard]] const Rollers& rollers() const { return rollers_; }

 private:
  [[nodiscard]] bool find_condition(const Model& model, const Steps& steps,
                                    effects::Condition& condition);
  double entered_power(const Model& model, const Steps& steps,
                       friction::BearingState<double> entered);
  [[nodiscard]] bool recall(const Model& model, const effects::Condition& condition);
  void remember();
  [[nodiscard]] friction::BearingState<double> state(const Model& model) const;
  std::optional<bearing::BearingCase> question(const Model& model);
  void solve(const Model& model);
  void solve_rollers(const Model& model);
  [[nodiscard]] const friction::Lubricant& oil(const Model& model) const {
    return oil_ ? *oil_ : model.lubricant;
  }
  void correct(const Model& model, const Steps& steps);
  // Steps of the prediction. Each step uses the results of earlier steps, stored in the members
  // below.
  [[nodiscard]] bool find_balance(const Model& model, const Steps& steps);
  [[nodiscard]] bool warm_by_tangents(const Model& model, const effects::Effect& effect,
                                      const effects::LubricantInputs& in);
  void find_film(const Model& model, const Steps& steps, friction::BearingState<double>& s);
  void find_base(const Model& model, friction::BearingState<double> s);
  void add_moments(const Model& model, const Steps& steps, Stage from,
                   const friction::BearingState<double>& s);
  void read(const Model& model, const Steps& steps);

  bearing::OperatingPoint point_;
  effects::Record record_;
  effects::Condition given_;
  double radial_load_;

  double temperature_, viscosity_;          // values of the row after corrections
  std::optional<friction::Lubricant> oil_;  // set if it differs from the oil of the model

  struct KnownBalance {
    effects::Condition condition;
    BallTurning turning;
    std::shared_ptr<const bearing::Bearing> bearing;
    Balance balls;
    bearing::SolveReport report;
    HoldingMoments held;
  };
  std::vector<KnownBalance> known_balances_;  // newest first
  Balance entered_;                           // balls at the original load; null if not needed
  BallTurning entered_turning_;

  effects::Condition condition_;
  std::shared_ptr<const bearing::Bearing> bearing_;  // null: original bearing
  Balance equilibrium_;
  Rollers rollers_;      // no fitted parameter changes this equilibrium
  BallTurning turning_;  // ball rotation inputs of `equilibrium_`
  bearing::SolveReport report_;
  HoldingMoments held_;  // moments that keep the tilt; NaN without tilt
  effects::Film film_;
  friction::BaseMoments<double> base_{unset, unset};
  std::optional<friction::contact::ContactResult> contacts_;
  ContactMemory known_contacts_;
  bool predicted_ = false;     // true once all members are valid
  std::vector<double> units_;  // unit moments of Steps::moment; NaN where undefined
  double torque_ = unset, reading_ = unset;
};

/// Solves the equilibria of several rows together. This is faster than solving the equilibria one
/// by one.
void solve_balances(const Model& model, const Steps& steps, std::span<RowPredictor> rows);

/// Computes the contact friction of several rows together (friction/contact/many_contacts.h). Call
/// solve_balances() before this function, because this function solves missing equilibria one by
/// one.
void solve_contacts(const Model& model, const Steps& steps, std::span<RowPredictor> rows);

/// Calls predict() for all rows. The rows are distributed over threads. The result is exactly the
/// same for any number of threads.
void predict_all(const Model& model, const Steps& steps, std::span<RowPredictor> rows,
                 std::span<double> readings, Stage from = Stage::entry);

/// Returns the ball equilibria at the operating points `points`, for the original bearing without
/// effects.
[[nodiscard]] std::vector<Balance> entered_balances(
    const Model& model, std::span<const bearing::OperatingPoint> points);
/// Returns the roller equilibria at the operating points `points`, for a cylindrical roller bearing
/// without effects.
[[nodiscard]] std::vector<RowPredictor::Rollers> entered_rollers(
    const Model& model, std::span<const bearing::OperatingPoint> points);

}  // namespace raceway::model
