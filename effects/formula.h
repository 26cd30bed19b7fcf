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

/// A user-made friction moment. Several threads may call it at once.
class OwnMoment {
 public:
  virtual ~OwnMoment() = default;
  /// [N m]
  [[nodiscard]] virtual double moment(const MomentInputs& inputs,
                                      std::span<const double> values) const = 0;
  /// True if a model file can store it: true for a formula, false for a function of a program.
  [[nodiscard]] virtual bool stands_in_files() const { return true; }
};

/// A user-made friction moment as a formula in the units of the files: "c * (speed_rpm/1000)^2" in
/// N mm. Names come from variables() and its own parameters; muParser provides operators and
/// functions. Several threads may evaluate it at once.
class Formula : public OwnMoment {
 public:
  /// Throws FormulaError: no formula, or a name that is neither variable nor parameter.
  Formula(std::string text, std::vector<std::string> parameters);

  [[nodiscard]] double moment(const MomentInputs& inputs,
                              std::span<const double> values) const override;
  /// True if the moment is zero everywhere when this parameter is zero, and nonzero somewhere
  /// otherwise.
  [[nodiscard]] bool is_size(std::size_t parameter, std::span<const double> values) const;
  /// True if the formula uses that variable.
  [[nodiscard]] bool uses(std::string_view variable) const;

  struct Variable {
    std::string_view name;
    std::string_view meaning;
    double (*computed)(const MomentInputs&) = nullptr;
    const record::Channel* channel = nullptr;  ///< otherwise: as recorded with the row, in its unit
    [[nodiscard]] double value(const MomentInputs& inputs) const;
  };
  /// Returns the variables of a formula in addition to its parameters, with every input of the
  /// channel table.
  [[nodiscard]] static std::span<const Variable> variables();

 private:
  record::Expression expression_;
};

/// User-made effect as written in a model file.
struct UserMadeEffect {
  struct Number {
    std::string name, unit;
    double value = 0.0;
    double lower = unset, upper = unset;  ///< NaN: no bound
  };
  std::string id;
  std::string title;
  std::string torque_Nmm;  ///< the formula
  std::vector<Number> parameters;
};

/// Makes an effect like an effect of the catalogue. Throws FormulaError.
[[nodiscard]] Effect make_effect(const UserMadeEffect& given);
/// Makes an effect from a moment that is not a formula; `torque_Nmm` describes it in words. The
/// effect is off when the first parameter that may be zero is zero.
[[nodiscard]] Effect make_effect(const UserMadeEffect& given, std::unique_ptr<OwnMoment> moment);

}  // namespace raceway::effects
