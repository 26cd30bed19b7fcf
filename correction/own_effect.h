#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "correction/effect_kind.h"
#include "record/expression.h"

namespace raceway::correction {

/// User-defined effect: a formula f of record columns, in the units of the columns. The effect adds
/// K/(1 + tau s) f(columns, parameters) to the displacement, with a gain K, a time constant tau and
/// the Laplace variable s. Without a time constant, the effect adds K f.
///
/// If the formula contains a temperature, the value of f in the first row of each run is subtracted
/// from f. The formula uses the recorded values, so speeds and feeds keep their sign.
class OwnEffect final : public EffectKind {
 public:
  struct Number {
    std::string name{}, unit{};
    double value = 0.0;
    double lower = unset, upper = unset;  ///< bounds for a fit; NaN: unbounded
    bool in_braces = false;  ///< true: the model file gives the number as { value, unit, bounds }
  };
  struct Given {
    std::string id{}, title{}, formula{};
    bool lags = false;  ///< true: the effect has a time constant
    std::vector<Number> parameters{};
  };

  /// Throws record::FormulaError for an invalid formula.
  explicit OwnEffect(Given given);

  [[nodiscard]] const Given& given() const { return given_; }
  /// Returns the description of the effect. The parameters are the gain [um], the time constant if
  /// the effect has one, and the parameters of the formula.
  [[nodiscard]] const EffectCard& card() const override { return card_; }
  [[nodiscard]] const std::vector<const Channel*>& columns() const { return columns_; }
  [[nodiscard]] bool follows_a_temperature() const;

  /// Returns the value of the formula for one row. `columns` has the values in the order of
  /// columns(), each in the unit of its column.
  [[nodiscard]] double value(std::span<const double> columns, std::span<const double> parameters,
                             std::vector<double>& scratch) const;

  [[nodiscard]] bool is_proportional(std::size_t number) const override { return number == 0; }
  /// Returns the key of a parameter in the model file, such as "gain_um" or "p.value".
  [[nodiscard]] std::string key(const Effect& effect, std::size_t number,
                                const Model& model) const override;
  [[nodiscard]] Input input(const Effect& effect, const Model& model) const override;
  [[nodiscard]] Share share(const Effect& effect, const Model& model) const override;

 private:
  struct Term {
    bool of_column = false;
    std::size_t index = 0;
  };

  [[nodiscard]] std::size_t first_parameter() const { return given_.lags ? 2 : 1; }

  Given given_;
  std::vector<const Channel*> columns_;
  std::unique_ptr<record::Expression> expression_;
  std::vector<Term> terms_;  // variables of the expression, in its order
  std::vector<record::NumberCard> numbers_;
  EffectCard card_;
};

/// Returns the record column that has this name in formulas; null if there is none.
[[nodiscard]] const Channel* column_of_formula(std::string_view name);

}  // namespace raceway::correction
