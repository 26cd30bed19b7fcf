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

/// One row that is predicted again and again with other numbers of the same model. It remembers the
/// equilibrium, solved again only where the condition has moved, and whatever else a number leaves
/// alone. See predict_friction() for the steps on the way.
class RowPredictor {
 public:
  using Rollers = std::shared_ptr<const bearing::RollerEquilibrium>;

  /// `known`: the balance under the condition `given`, if available: as entered, or for a bearing
  /// in its set on a shaft. `given`: a condition in addition to the changes by the effects in
  /// `steps`. `bearing`: the bearing of that balance, if not the model's. `rollers`: the balance as
  /// entered of a bearing with cylindrical rollers, if available.
  RowPredictor(const Model& model, const Steps& steps, const bearing::OperatingPoint& point,
               const effects::Record& record, Balance known = nullptr,
               const effects::Condition& given = {},
               std::shared_ptr<const bearing::Bearing> bearing = nullptr,
               Rollers rollers = nullptr);

  /// Reading of the rig [N m], NaN without a prediction. What is computed is remembered; values of
  /// the model that act before `from` must be unchanged since the last call.
  double predict(const Model& model, const Steps& steps, Stage from = Stage::entry);

  /// The balance that predict() will need, for callers that solve many at once and answer() before
  /// they call it; nothing where it needs none, remembers it, or needs one
  /// at an imposed tilt or with balls that no race holds.
  [[nodiscard]] std::optional<bearing::BearingCase> ask(const Model& model, const Steps& steps);
  void answer(bearing::BearingEquilibrium&& equilibrium);
  /// Finds the balance alone, as predict() would.
  void balance(const Model& model, const Steps& steps);

  /// State of the contacts in a known balance, for callers that then answer with their friction,
  /// which predict() reuses. Empty under other laws, without a balance, on a bearing that the
  /// condition has changed, or where effects act on the film.
  [[nodiscard]] std::optional<friction::BearingState<double>> ask_contacts(const Model& model,
                                                                           const Steps& steps);
  void answer_contacts(const Model& model, const friction::contact::ContactResult& contacts);

  /// All that the last predict() found.
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
  // The steps; each from what those before it have left in the members below.
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

  double temperature_, viscosity_;          // of the row, as corrected
  std::optional<friction::Lubricant> oil_;  // where it is not that of the model

  /// Balance solved under another condition: fits return to points where they took differences.
  struct KnownBalance {
    effects::Condition condition;
    BallTurning turning;
    std::shared_ptr<const bearing::Bearing> bearing;
    Balance balls;
    bearing::SolveReport report;
    HoldingMoments held;
  };
  std::vector<KnownBalance> known_balances_;  // the newest first
  Balance entered_;                           // balls at the load as entered, where a step asked
  BallTurning entered_turning_;

  effects::Condition condition_;
  std::shared_ptr<const bearing::Bearing> bearing_;  // null: as entered
  Balance equilibrium_;
  Rollers rollers_;      // no number of a model moves it
  BallTurning turning_;  // of that balance
  bearing::SolveReport report_;
  HoldingMoments held_;  // of a tilt that is imposed; no numbers without
  effects::Film film_;
  friction::BaseMoments<double> base_{unset, unset};
  std::optional<friction::contact::ContactResult> contacts_;
  ContactMemory known_contacts_;
  bool predicted_ = false;     // once, without anything from before
  std::vector<double> units_;  // unit moments of Steps::moment, NaN where it has none
  double torque_ = unset, reading_ = unset;
};

/// Solves the balances that rows ask for side by side.
void solve_balances(const Model& model, const Steps& steps, std::span<RowPredictor> rows);

/// Finds the friction of the contacts that rows ask for side by side (friction/contact/
/// many_contacts.h), after their balances.
void solve_contacts(const Model& model, const Steps& steps, std::span<RowPredictor> rows);

/// predict() for all rows, the balances they need solved side by side and the rows shared among
/// threads: each row is predicted by itself, so that the number of threads changes no digit.
void predict_all(const Model& model, const Steps& steps, std::span<RowPredictor> rows,
                 std::span<double> readings, Stage from = Stage::entry);

/// Balances of points as entered, without any effect.
[[nodiscard]] std::vector<Balance> entered_balances(
    const Model& model, std::span<const bearing::OperatingPoint> points);
/// Balances of a bearing with cylindrical rollers, as entered, without any effect.
[[nodiscard]] std::vector<RowPredictor::Rollers> entered_rollers(
    const Model& model, std::span<const bearing::OperatingPoint> points);

}  // namespace raceway::model
