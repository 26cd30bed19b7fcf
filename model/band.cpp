#include "model/band.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/parameters.h"

namespace raceway::model {
namespace {

constexpr double step_share = 0.1;            // of a standard error
constexpr double two_sided = 1.959963984540;  // of a normal law, 95 %

}  // namespace

Band::Band(const Model& model) : model_(model) {
  if (!model.covariance)
    throw std::invalid_argument(
        "the model has no covariance of fitted parameters; raceway calibrate -o writes a model "
        "with the covariance");
  const std::vector<record::Parameter> known = parameters(model);
  for (std::size_t k = 0; k < model.covariance->names.size(); ++k) {
    const std::string& name = model.covariance->names[k];
    const auto p = std::find_if(known.begin(), known.end(),
                                [&](const record::Parameter& one) { return one.name == name; });
    if (p == known.end()) throw std::invalid_argument(name + ": the model has no such parameter");
    const ParameterPlace place(model, *p);
    const auto moved = [&](double by) {
      Side side{.model = model};
      const double value = std::clamp(p->value + by, p->lower, p->upper);
      try {
        place.set(side.model, value);
        side.step = value - p->value;
      } catch (const std::invalid_argument&) {
        side.model = model;  // no bearing or arrangement takes it
      }
      return side;
    };
    const double step = step_share * model.covariance->std(k);
    below_.push_back(moved(-step));
    above_.push_back(moved(step));
  }
}

std::vector<double> Band::operator()(const Outputs& outputs) const {
  const fit::Covariance& covariance = *model_.covariance;
  const std::vector<double> here = outputs(model_);
  const std::size_t count = here.size();
  Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(below_.size()),
                                                static_cast<Eigen::Index>(count));
  for (std::size_t k = 0; k < below_.size(); ++k) {
    if (!(covariance.std(k) > 0.0)) continue;
    const auto at = [&](const Side& side) {
      return side.step != 0.0 ? outputs(side.model) : std::vector<double>(count, unset);
    };
    const std::vector<double> low = at(below_[k]), high = at(above_[k]);
    for (std::size_t i = 0; i < count; ++i) {
      const bool from_low = std::isfinite(low[i]), to_high = std::isfinite(high[i]);
      const double begin = from_low ? below_[k].step : 0.0, end = to_high ? above_[k].step : 0.0;
      slope(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(i)) =
          ((to_high ? high[i] : here[i]) - (from_low ? low[i] : here[i])) /
          (end > begin ? end - begin : unset);
    }
  }
  std::vector<double> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto g = slope.col(static_cast<Eigen::Index>(i));
    // Rounding of what cancels may leave less than nothing.
    const double variance = g.dot(covariance.matrix * g);
    result[i] = std::isnan(variance) || std::isnan(here[i])
                    ? unset
                    : two_sided * std::sqrt(std::max(0.0, variance));
  }
  return result;
}

}  // namespace raceway::model
