#include "model/fitted_model.h"

#include <algorithm>
#include <utility>

namespace raceway::model {

FittedModel::FittedModel(Model model, const Steps& steps, std::vector<ParameterPlace> places)
    : model_(std::move(model)), places_(std::move(places)) {
  for (const ParameterPlace& place : places_)
    stages_.push_back(first_stage(model_, steps, place.effect()));
}

Stage FittedModel::set(std::span<const double> values) {
  Stage from = known_ ? Stage::reading : Stage::entry;
  known_ = false;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    if (from != Stage::entry && values[k] == last_[k]) continue;
    places_[k].set(model_, values[k]);
    from = std::min(from, stages_[k]);
  }
  return from;
}

void FittedModel::keep(std::span<const double> values) {
  last_.assign(values.begin(), values.end());
  known_ = true;
}

}  // namespace raceway::model
