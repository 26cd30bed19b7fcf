#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "effects/effect.h"
#include "record/expression.h"

namespace raceway::effects {

using record::FormulaError;

/// User-defined friction moment. Several threads may call moment() at the same time.
class OwnMoment {
 public:
  virtual ~OwnMoment() = default;
  /// Returns the friction moment [N m].
  [[nodiscard]] virtual double moment(const MomentInputs& inputs,
                                      std::span<const double> values) const = 0;
  /// Returns true if a model file can store the moment. The result is true for a formula, and false
  /// for a function that a Python program passes.
  [[nodiscard]] virtual bool stands_in_files() const { return true; }
};

/// User-defined friction moment [N mm] as a formula, such as "c * (speed_rpm/1000)^2". The formula
/// may use the names in variables() and the parameters of the effect, with the operators and
/// functions of muParser. Several threads may evaluate the formula at the same time.
class Formula : public OwnMoment {
 public:
  /// Throws FormulaError for an invalid formula, and for a name that is neither a variable nor a
  /// parameter.
  Formula(std::string text, std::vector<std::string> parameters);

  [[nodiscard]] double moment(const MomentInputs& inputs,
                              std::span<const double> values) const override;
  /// Returns true if this parameter scales the effect: the moment is zero at every operating point
  /// when the parameter is 0, but not when the parameter is 1. `values` gives the other parameters.
  [[nodiscard]] bool is_size(std::size_t parameter, std::span<const double> values) const;
  /// Returns true if the formula contains the variable.
  [[nodiscard]] bool uses(std::string_view variable) const;

  struct Variable {
    std::string_view name;
    std::string_view meaning;
    double (*computed)(const MomentInputs&) = nullptr;
    /// Recorded channel that gives the value, in the unit of the channel. The pointer is null if
    /// the value comes from the bearing state.
    const record::Channel* channel = nullptr;
    [[nodiscard]] double value(const MomentInputs& inputs) const;
  };
  /// Returns the variables that a formula may contain in addition to its parameters. Every input
  /// channel of a record is a variable.
  [[nodiscard]] static std::span<const Variable> variables();

 private:
  record::Expression expression_;
};

/// User-defined effect in a model file.
struct UserMadeEffect {
  struct Number {
    std::string name, unit;
    double value = 0.0;
    double lower = unset, upper = unset;  ///< bounds for a fit; NaN means that there is no bound
  };
  std::string id;
  std::string title;
  std::string torque_Nmm;  ///< formula of the friction moment [N mm]
  std::vector<Number> parameters;
};

/// Creates an effect that can be used like an effect of the catalogue. Throws FormulaError for an
/// invalid formula.
[[nodiscard]] Effect make_effect(const UserMadeEffect& given);
/// Creates an effect from a moment that is not a formula. `torque_Nmm` describes the moment in
/// words. The first parameter whose bounds include 0 is the size of the effect: at 0, the effect is
/// off.
[[nodiscard]] Effect make_effect(const UserMadeEffect& given, std::unique_ptr<OwnMoment> moment);

}  // namespace raceway::effects
