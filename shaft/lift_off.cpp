#include "shaft/lift_off.h"

#include <algorithm>
#include <cmath>

namespace raceway::shaft {
namespace {

constexpr double close_enough = 0.5 * rpm;

bool is(Unloaded what, const bearing::BearingInSet& b) {
  return what == Unloaded::no_contact ? b.lost() : !b.lost() && b.below_minimum();
}

bool same_end(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// The ranges of one kind.
class Search {
 public:
  Search(const Model& model, Unloaded what, std::span<const ShaftPoint> points,
         std::span<const ShaftPrediction> predictions)
      : model_(model), what_(what), points_(points), predictions_(predictions) {}

  void add_ranges_of(std::size_t bearing, std::vector<UnloadedRange>& found) const {
    for (std::size_t k = 0; k < points_.size(); ++k) {
      if (!happens(bearing, k)) continue;
      const ShaftPoint first = k > 0 && balanced(k - 1)
                                   ? change_between(bearing, points_[k - 1], points_[k], true)
                                   : points_[k];
      while (k + 1 < points_.size() && happens(bearing, k + 1)) ++k;
      add({.what = what_, .bearings = {bearing}, .first = first, .end = end_after(bearing, k)},
          found);
    }
  }

 private:
  [[nodiscard]] bool balanced(std::size_t k) const {
    return predictions_[k].equilibrium.report.converged();
  }
  [[nodiscard]] bool happens(std::size_t bearing, std::size_t k) const {
    return balanced(k) && is(what_, predictions_[k].equilibrium.bearings[bearing]);
  }

  /// Where it begins or ends, between `early`, where it does not yet, and `late`, where it does.
  [[nodiscard]] ShaftPoint change_between(std::size_t bearing, const ShaftPoint& early,
                                          ShaftPoint late, bool begins) const {
    double lower = early.speed;
    while (late.speed - lower > close_enough) {
      ShaftPoint middle = late;
      middle.speed = 0.5 * (lower + late.speed);
      const ShaftPrediction p = predict_shaft(model_, {&middle, 1}).front();
      const bool here =
          p.equilibrium.report.converged() && is(what_, p.equilibrium.bearings[bearing]);
      if (here == begins)
        late = middle;
      else
        lower = middle.speed;
    }
    return late;
  }

  /// The speed at which it is over that still happens at point k.
  [[nodiscard]] double end_after(std::size_t bearing, std::size_t k) const {
    if (k + 1 == points_.size()) return unset;
    return balanced(k + 1) ? change_between(bearing, points_[k], points_[k + 1], false).speed
                           : points_[k].speed;
  }

  void add(UnloadedRange range, std::vector<UnloadedRange>& found) const {
    const std::size_t bearing = range.bearings.front();
    const auto alike = std::find_if(found.begin(), found.end(), [&](const UnloadedRange& r) {
      return r.what == what_ && r.first.speed == range.first.speed && same_end(r.end, range.end);
    });
    if (alike != found.end()) {
      alike->bearings.push_back(bearing);
      return;
    }
    const ShaftPrediction p = predict_shaft(model_, {&range.first, 1}).front();
    if (p.equilibrium.report.converged()) {
      range.load = p.equilibrium.bearings[bearing].axial_load;
      range.minimum_load = p.equilibrium.bearings[bearing].minimum_load;
    }
    found.push_back(std::move(range));
  }

  const Model& model_;
  Unloaded what_;
  std::span<const ShaftPoint> points_;
  std::span<const ShaftPrediction> predictions_;
};

}  // namespace

std::vector<UnloadedRange> unloaded_ranges(const Model& model, std::span<const ShaftPoint> points,
                                           std::span<const ShaftPrediction> predictions) {
  std::vector<UnloadedRange> found;
  for (const Unloaded what : {Unloaded::no_contact, Unloaded::below_minimum}) {
    const Search search(model, what, points, predictions);
    for (std::size_t i = 0; i < model.shaft->arrangement.bearings().size(); ++i)
      search.add_ranges_of(i, found);
  }
  return found;
}

}  // namespace raceway::shaft
