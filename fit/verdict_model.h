#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/data_set.h"
#include "fit/diagnose.h"
#include "fit/model.h"

namespace raceway::fit {

/// What one effect adds to the readings [N m] or [m], by row of the data; NaN where a row is not
/// predicted.
struct EffectShare {
  std::string id;
  std::vector<double> readings;
};

/// The readings that a set of effects predicts, and what they are made of.
struct EffectModel {
  Model model;                       ///< effects of the set on, base parameters refitted with them
  std::vector<double> readings;      ///< by row of the data [N m] or [m]
  std::vector<double> base;          ///< the same with the set's effects off again
  std::vector<EffectShare> effects;  ///< full readings less those without this one effect
};

/// Puts the numbers of a diagnosis into the model that was diagnosed: those of the best set of its
/// verdict. Nothing where the verdict names no effect, and where it rests on a bent law, which no
/// model of the catalogue predicts: the readings are checked against the error that the diagnosis
/// found.
[[nodiscard]] std::optional<EffectModel> verdict_model(const Model& model, const DataSet& data,
                                                       const Diagnosis& diagnosis);

/// The same with one effect of the ranking alone. Nothing where its numbers are those of a set or
/// of a bent law.
[[nodiscard]] std::optional<EffectModel> model_with(const RankedEffect& effect, const Model& model,
                                                    const DataSet& data,
                                                    const Diagnosis& diagnosis);

/// Root mean square errors over all rows of a data set of which a diagnosis used some [N m] or [m].
struct AllRows {
  int rows = 0;  ///< that can be predicted
  double before = unset, after = unset;
};

/// The base model and the verdict's best set, with the numbers that the diagnosis found, held
/// against every row. Nothing where verdict_model() has none.
[[nodiscard]] std::optional<AllRows> errors_on_all_rows(const Model& model, const DataSet& data,
                                                        const Diagnosis& diagnosis);

}  // namespace raceway::fit
