#include "spindle/bearing_coupling.h"

#include "spindle/expansion_rows.h"

namespace raceway::spindle {
namespace {

/// Numbers felt of one bearing: inner ring, outer ring, cells at both raceways.
constexpr Eigen::Index per_bearing = 4;
/// λ of silicon nitride balls [W/(m K)].
constexpr double ceramic_conductivity = 30.0;
/// Balls lighter than this are no steel [kg/m³].
constexpr double lightest_steel = 6000.0;
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
    : sets_(model, condition),
      lubricant_(model.spindle->lubricant_conductance),
      factor_(condition.bearing_conductance_factor) {
  const Layout& layout = system.layout();
  const Eigen::Index nodes = system.paths().size();
  const auto bearings = static_cast<Eigen::Index>(layout.bearings.size());
  const Eigen::Index count = per_bearing * bearings + 1;
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](Eigen::Index row, const Shares& shares) {
    for (const Share& s : shares) entries.emplace_back(row, s.cell, s.share);
  };
  given_.setZero(nodes, 2 * bearings);
  for (Eigen::Index b = 0; b < bearings; ++b) {
    const BearingPlace& place = layout.bearings[static_cast<std::size_t>(b)];
    const Raceway inner = raceway_of(place.inner_raceway), outer = raceway_of(place.outer_raceway);
    add(per_bearing * b, place.inner_ring);
    add(per_bearing * b + 1, place.outer_ring);
    add(per_bearing * b + 2, inner.cells);
    add(per_bearing * b + 3, outer.cells);
    for (const Share& s : inner.cells) given_(s.cell, 2 * b) = s.share;
    for (const Share& s : outer.cells) given_(s.cell, 2 * b + 1) = s.share;
    inner_raceway_.push_back(inner.conductance);
    outer_raceway_.push_back(outer.conductance);
    const bearing::Bearing& bearing =
        *sets_.arrangement().bearings()[static_cast<std::size_t>(b)].bearing;
    const double rings = model::steel_of_rings.conductivity;
    balls_.emplace_back(
        bearing, bearing.balls().density < lightest_steel ? ceramic_conductivity : rings, rings);
  }
  offset_.setZero(count);
  if (std::isfinite(layout.rear_centre)) {
    const Vector row =
        (expansion_row(layout.mesh, Body::shaft, layout.front_centre, layout.rear_centre, nodes) -
         expansion_row(layout.mesh, Body::housing, layout.front_centre, layout.rear_centre,
                       nodes)) /
        um;
    for (Eigen::Index k = 0; k < nodes; ++k)
      if (row[k] != 0.0) entries.emplace_back(count - 1, k, row[k]);
    offset_[count - 1] = -row.sum() * sets_.arrangement().design().mounting_temperature;
  }
  felt_.resize(count, nodes);
  felt_.setFromTriplets(entries.begin(), entries.end());
}

Vector BearingCoupling::flows(const Vector& felt) const {
  Vector given(given_count());
  for (std::size_t k = 0; k < balls_.size(); ++k) {
    const auto b = static_cast<Eigen::Index>(k);
    const BearingHeat& heat = sets_.heat()[k];
    const double si = inner_raceway_[k], so = outer_raceway_[k];
    const double g =
        factor_ * (balls_[k].conductance(heat.inner_contact, heat.outer_contact) + lubricant_);
    const double through =
        g / (1.0 + g * (1.0 / si + 1.0 / so)) *
        (felt[per_bearing * b + 2] - felt[per_bearing * b + 3] + heat.inner / si - heat.outer / so);
    given[2 * b] = heat.inner - through;
    given[2 * b + 1] = heat.outer + through;
  }
  return given;
}

bool BearingCoupling::evaluate(const Vector& felt, Vector& given) {
  SetsAsked asked;
  const auto bearings = static_cast<Eigen::Index>(balls_.size());
  for (Eigen::Index b = 0; b < bearings; ++b) {
    asked.inner_ring.push_back(felt[per_bearing * b]);
    asked.outer_ring.push_back(felt[per_bearing * b + 1]);
  }
  asked.elongation = felt[felt.size() - 1] * um;
  if (!felt.allFinite() || !sets_.solve(asked)) return false;
  given = flows(felt);
  return given.allFinite();
}

bool BearingCoupling::differentiate(const Vector& felt, const Vector& given, Matrix& jacobian) {
  jacobian.setZero(given_count(), felt_count());
  Vector near = felt, other(given_count());
  bool balanced = true;
  for (Eigen::Index k = 0; k < felt_count() && balanced; ++k) {
    const bool raceway = k + 1 < felt_count() && k % per_bearing >= 2;
    const double step = k + 1 < felt_count() ? temperature_step : elongation_step;
    near[k] = felt[k] + step;
    if (raceway)
      other = flows(near);  // linear, and the sets do not feel it
    else
      balanced = evaluate(near, other);
    if (balanced) jacobian.col(k) = (other - given) / step;
    near[k] = felt[k];
    // The sets are left as they are at `felt`, from where raceways are linear.
    if (!raceway && balanced && k % per_bearing == 1) balanced = evaluate(felt, other);
  }
  return evaluate(felt, other) && balanced;
}

}  // namespace raceway::spindle
