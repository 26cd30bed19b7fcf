#include "spindle/bearing_coupling.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "spindle/expansion_rows.h"

namespace raceway::spindle {
namespace {

/// Numbers felt of one bearing: inner ring, outer ring, cells at both raceways; of one with rollers
/// shaft and housing too.
constexpr Eigen::Index per_bearing = 4, per_rollers = 6;
/// Steps of differences: ring temperatures [K], elongation [um].
constexpr double temperature_step = 1e-3, elongation_step = 1e-3;

struct Raceway {
  Shares cells;
  double conductance = 0.0;
};

Raceway raceway_of(const Joints& joints) {
  Raceway r;
  for (const Joint& j : joints) {
    r.cells.push_back({j.first, 1.0 / j.half});
    r.conductance += 1.0 / j.half;
  }
  for (Share& s : r.cells) s.share /= r.conductance;
  return r;
}

}  // namespace

BearingCoupling::BearingCoupling(const model::Model& model,
                                 const effects::SpindleCondition& condition,
                                 const ThermalSystem& system)
    : sets_(model, condition), factor_(condition.bearing_conductance_factor) {
  const Layout& layout = system.layout();
  const Eigen::Index nodes = system.paths().size();
  const std::size_t count = layout.bearings.size();
  for (const model::RollerOnShaft& r : model.spindle->rollers)
    rollers_.emplace_back(model, r, layout, layout.bearings[sets_.bearings() + rollers_.size()]);
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](Eigen::Index row, const Shares& shares) {
    for (const Share& s : shares) entries.emplace_back(row, s.cell, s.share);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const BearingPlace& bearing = layout.bearings[k];
    const Raceway inner = raceway_of(bearing.inner_raceway);
    const Raceway outer = raceway_of(bearing.outer_raceway);
    const Eigen::Index at = place(k);
    add(at, bearing.inner_ring);
    add(at + 1, bearing.outer_ring);
    add(at + 2, inner.cells);
    add(at + 3, outer.cells);
    double lubricant = model.spindle->lubricant_conductance;
    if (k >= sets_.bearings()) {
      add(at + 4, bearing.shaft_below);
      add(at + 5, bearing.housing_above);
      const double own = model.spindle->rollers[k - sets_.bearings()].lubricant_conductance;
      if (std::isfinite(own)) lubricant = own;
    }
    given_rows_.insert(given_rows_.end(), {at + 2, at + 3});
    given_.insert(given_.end(), {inner.cells, outer.cells});
    inner_raceway_.push_back(inner.conductance);
    outer_raceway_.push_back(outer.conductance);
    lubricant_.push_back(lubricant);
  }
  const Eigen::Index last = place(count);
  offset_.setZero(last + 1);
  if (std::isfinite(layout.rear_centre)) {
    const Vector row =
        (expansion_row(layout.mesh, Body::shaft, layout.front_centre, layout.rear_centre, nodes) -
         expansion_row(layout.mesh, Body::housing, layout.front_centre, layout.rear_centre,
                       nodes)) /
        um;
    for (Eigen::Index k = 0; k < nodes; ++k)
      if (row[k] != 0.0) entries.emplace_back(last, k, row[k]);
    offset_[last] = -row.sum() * sets_.arrangement().design().mounting_temperature;
  }
  felt_.resize(last + 1, nodes);
  felt_.setFromTriplets(entries.begin(), entries.end());
  if (!model.spindle->belt) return;
  Vector cold = Vector::Constant(last + 1, sets_.arrangement().design().mounting_temperature);
  cold[last] = 0.0;
  if (!set_inputs({}) || !bear(cold))
    throw std::invalid_argument(
        "at standstill, the bearing sets have no equilibrium with the belt force: reduce the belt "
        "force or increase the preload");
  bent_rest_ = sets_.position() - sets_.sets().position;
}

void BearingCoupling::add_given(const Vector& given, Vector& inflow) const {
  for (std::size_t k = 0; k < given_.size(); ++k)
    for (const Share& s : given_[k])
      inflow[s.cell] += s.share * given[static_cast<Eigen::Index>(k)];
}

/// Where the numbers of a bearing begin in s; the elongation stands behind the last one.
Eigen::Index BearingCoupling::place(std::size_t bearing) const {
  const std::size_t balls = std::min(bearing, sets_.bearings());
  return per_bearing * static_cast<Eigen::Index>(balls) +
         per_rollers * static_cast<Eigen::Index>(bearing - balls);
}

BearingHeat BearingCoupling::heat(std::size_t k, const Vector& felt) const {
  if (k < sets_.bearings()) return sets_.heat()[k];
  return rollers_[k - sets_.bearings()].heat(rollers_at(k, felt));
}

RollersAsked BearingCoupling::rollers_at(std::size_t k, const Vector& felt) const {
  const auto at = felt.segment<per_rollers>(place(k));
  return {.inner_ring = at[0], .outer_ring = at[1], .shaft = at[4], .housing = at[5]};
}

BearingState BearingCoupling::state(std::size_t k, const Vector& felt) const {
  const BearingHeat now = heat(k, felt);
  return {.inner_ring_temperature = felt[place(k)],
          .outer_ring_temperature = felt[place(k) + 1],
          .force = now.force,
          .radial_force = now.radial_force,
          .clearance = now.clearance,
          .power = now.power(),
          .power_band = now.band};
}

Vector BearingCoupling::flows(const Vector& felt) const {
  Vector given(given_count());
  for (std::size_t k = 0; k < bearings(); ++k) {
    const auto b = static_cast<Eigen::Index>(k);
    const Eigen::Index at = place(k);
    const BearingHeat now = heat(k, felt);
    const double si = inner_raceway_[k], so = outer_raceway_[k];
    const double g = factor_ * (now.conductance + lubricant_[k]);
    const double through = g / (1.0 + g * (1.0 / si + 1.0 / so)) *
                           (felt[at + 2] - felt[at + 3] + now.inner / si - now.outer / so);
    given[2 * b] = now.inner - through;
    given[2 * b + 1] = now.outer + through;
  }
  return given;
}

bool BearingCoupling::solve_sets(const Vector& felt) {
  SetsAsked asked;
  for (std::size_t k = 0; k < sets_.bearings(); ++k) {
    asked.inner_ring.push_back(felt[place(k)]);
    asked.outer_ring.push_back(felt[place(k) + 1]);
  }
  asked.elongation = felt[felt.size() - 1] * um;
  return felt.allFinite() && sets_.solve(asked);
}

bool BearingCoupling::evaluate(const Vector& felt, Vector& given) {
  if (!solve_sets(felt)) return false;
  given = flows(felt);
  return given.allFinite();
}

bool BearingCoupling::differentiate(const Vector& felt, const Vector& given, Matrix& jacobian) {
  jacobian.setZero(given_count(), felt_count());
  Vector near = felt, other(given_count());
  bool balanced = true;
  const Eigen::Index of_balls = place(sets_.bearings()), last = felt_count() - 1;
  for (Eigen::Index k = 0; k < felt_count() && balanced; ++k) {
    const bool of_sets = k == last || (k < of_balls && k % per_bearing < 2);
    const double step = k < last ? temperature_step : elongation_step;
    near[k] = felt[k] + step;
    if (of_sets)
      balanced = evaluate(near, other);
    else
      other = flows(near);  // the sets do not feel it
    if (balanced) jacobian.col(k) = (other - given) / step;
    near[k] = felt[k];
    // The sets are left as they are at `felt`, from where raceways are linear.
    if (of_sets && balanced && k % per_bearing == 1) balanced = evaluate(felt, other);
  }
  return evaluate(felt, other) && balanced;
}

bool BearingCoupling::set_inputs(const Inputs& inputs) {
  if (!sets_.set_inputs(inputs)) return false;
  for (WarmRollers& r : rollers_) r.set_speed(inputs.speed);
  const model::Spindle& spindle = *sets_.model().spindle;
  loads_ = shaft_loads(spindle, inputs);
  const bool bends =
      !rollers_.empty() || std::any_of(loads_.begin(), loads_.end(),
                                       [](const ShaftLoad& l) { return l.pushes_across(); });
  if (!bends) {
    const bool was_bent = bent_.has_value();
    shaft_.reset();
    bent_.reset();
    return !was_bent || sets_.bear(nullptr);
  }
  if (!shaft_)
    shaft_.emplace(Beam(spindle.shaft, beam_places(spindle)),
                   bearings_of_shaft(spindle, sets_.arrangement()), load_places(spindle));
  return true;
}

bool BearingCoupling::bear(const Vector& felt) {
  if (!shaft_) return true;
  if (!solve_sets(felt)) return false;
  std::vector<double> clearances;
  for (std::size_t k = sets_.bearings(); k < bearings(); ++k)
    clearances.push_back(rollers_[k - sets_.bearings()].clearance(rollers_at(k, felt)));
  const std::vector<bearing::GivenRotation> rotations = sets_.sets().rotations();
  bearing::EquilibriumOptions options = sets_.model().solver;
  options.rotations = rotations;
  bent_ = shaft_->solve(sets_.asked(), clearances, loads_, options, &sets_.sets());
  if (!bent_->report.converged()) return false;
  for (std::size_t k = 0; k < rollers_.size(); ++k) rollers_[k].take(bent_->rollers[k]);
  return sets_.bear(&*bent_);
}

}  // namespace raceway::spindle
