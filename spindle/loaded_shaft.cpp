#include "spindle/loaded_shaft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "algebra/detail/decompositions.h"

namespace raceway::spindle {
namespace {

using bearing::Matrix5;
using bearing::Side;
using bearing::SolveStatus;
using bearing::Vector5;
using Eigen::Index;

constexpr double balance_tolerance = 1e-11;  // of the largest load
constexpr double stalled_tolerance = 1e-9;   // where rounding stops short of it
constexpr int steps_of_one_newton = 40;
constexpr double contact_scale = 1e8;  // [N/m], of a bearing; only scales a residual

/// From the shaft's (a, v_y, θ_y, v_z, θ_z) to a bearing's (x, y, z, θy, θz), a the axial
/// coordinate that presses it. The frame of one that presses rearwards is that of (s, y, z); the
/// other one's is turned by half a turn about y. The transpose takes forces back.
Matrix5 to_bearing_frame(bool rearwards) {
  const double side = rearwards ? 1.0 : -1.0;
  Matrix5 t = Matrix5::Zero();
  t(0, 0) = 1.0;
  t(1, 1) = 1.0;
  t(2, 3) = side;
  t(3, 4) = -1.0;
  t(4, 2) = side;
  return t;
}

/// Unknowns: axial position of the shaft, that of the rear set, then (v, θ) of every bearing and
/// of the load's place in the plane of y, then the same in that of z.
class ShaftBalance5 {
 public:
  ShaftBalance5(const Beam& beam, const bearing::Arrangement& arrangement,
                std::span<const double> places, const bearing::ArrangementCondition& condition,
                const ShaftLoad& load, const bearing::EquilibriumOptions& options)
      : arrangement_(arrangement),
        seat_(arrangement.seat()),
        elongation_(arrangement.direction() * condition.elongation),
        axial_(arrangement.direction() * condition.external_load),
        condensed_(beam, masters(beam, places, load.position)),
        count_(places.size()),
        planar_(2 * static_cast<Index>(count_ + 1)) {
    for (std::size_t i = 0; i < count_; ++i) {
      const bearing::RingShift shift =
          condition.shifts.empty() ? bearing::RingShift{} : condition.shifts[i];
      held_.emplace_back(*arrangement.bearings()[i].bearing, condition.speed, shift,
                         options_of_bearing(options, i));
      frame_.push_back(to_bearing_frame(presses_rearwards(arrangement, i)));
    }
    loads_ = Eigen::VectorXd::Zero(size());
    const Index at = 2 + 2 * static_cast<Index>(masters_index_);
    loads_[at] = load.radial;
    loads_[at + 1] = load.moment;
    loads_[at + planar_] = load.radial_z;
    loads_[at + planar_ + 1] = load.moment_z;
    lever_ = std::max(0.05 * beam.length(), 1 * mm);
    force_scale_ = std::max({arrangement.preload(), std::abs(axial_), std::abs(load.radial),
                             std::abs(load.radial_z), std::abs(load.moment) / lever_,
                             std::abs(load.moment_z) / lever_, 1.0});
  }

  [[nodiscard]] Index size() const { return 2 + 2 * planar_; }
  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] double residual() const { return residual_; }
  [[nodiscard]] SolveStatus failure() const { return failure_; }

  /// From `u` to balance under a share of the radial load.
  bool newton(Eigen::VectorXd& u, double share, int most);
  void fill(const Eigen::VectorXd& u, LoadedShaft& result) const;

 private:
  std::vector<std::size_t> masters(const Beam& beam, std::span<const double> places,
                                   double load_place) {
    std::vector<std::size_t> nodes;
    for (const double p : places) nodes.push_back(beam.node_at(p));
    const std::size_t node = beam.node_at(load_place);
    const auto same = std::find(nodes.begin(), nodes.end(), node);
    masters_index_ = static_cast<std::size_t>(same - nodes.begin());
    // One more place than bearings, so that the numbering does not depend on the load's.
    if (same == nodes.end()) {
      nodes.push_back(node);
    } else {
      std::size_t other = 0;
      while (std::find(nodes.begin(), nodes.end(), other) != nodes.end()) ++other;
      if (other >= beam.nodes().size())
        throw std::invalid_argument("the beam needs more nodes than bearings");
      nodes.push_back(other);
    }
    return nodes;
  }
  /// Places in u of a bearing's (a, v_y, θ_y, v_z, θ_z).
  [[nodiscard]] std::array<Index, 5> indices(std::size_t i) const {
    const Index v = 2 + 2 * static_cast<Index>(i);
    return {arrangement_.side(i) == Side::front ? 0 : 1, v, v + 1, v + planar_, v + planar_ + 1};
  }
  [[nodiscard]] Vector5 place_of(const Eigen::VectorXd& u, std::size_t i) const {
    const auto at = indices(i);
    Vector5 own;
    for (int k = 0; k < 5; ++k) own[k] = u[at[static_cast<std::size_t>(k)]];
    own[0] = arrangement_.bearings()[i].offset +
             (at[0] == 0 ? arrangement_.displacement(Side::front) - u[0] : u[1]);
    return frame_[i] * own;
  }
  [[nodiscard]] bool tandem() const { return arrangement_.front_count() == count_; }
  bool assemble(const Eigen::VectorXd& u, double share, Eigen::VectorXd& missing,
                Eigen::MatrixXd* tangent);
  void seat(const Eigen::VectorXd& u, Eigen::VectorXd& missing, Eigen::MatrixXd* tangent);
  [[nodiscard]] double scaled(Index i, double value) const {
    return i >= 2 && i % 2 == 1 ? value / lever_ : value;
  }

  const bearing::Arrangement& arrangement_;
  bearing::Arrangement::Seat seat_;
  double elongation_, axial_;
  std::size_t masters_index_ = 0;
  CondensedBeam condensed_;
  std::size_t count_;
  Index planar_;
  std::vector<bearing::DisplacedBearing> held_;
  std::vector<Matrix5> frame_;
  Eigen::VectorXd loads_;
  double lever_ = unset, force_scale_ = unset;
  double front_ = 0.0, rear_ = 0.0;
  int iterations_ = 0;
  double residual_ = unset;
  SolveStatus failure_ = SolveStatus::no_equilibrium;
};

/// softness (F_r - F_0) = hardness (y - e - (δ_r - δ_r0)), scaled to a force.
void ShaftBalance5::seat(const Eigen::VectorXd& u, Eigen::VectorXd& missing,
                         Eigen::MatrixXd* tangent) {
  if (tandem()) {
    rear_ = arrangement_.preload() + seat_.hardness * (u[0] - elongation_);
    missing[1] = -u[1];
    if (tangent) {
      (*tangent)(1, 1) = 1.0;
      (*tangent)(0, 0) += seat_.hardness;
    }
    return;
  }
  const double scale = 1.0 / (seat_.softness + seat_.hardness / contact_scale);
  const double moved = u[0] - elongation_ - (u[1] - arrangement_.displacement(Side::rear));
  missing[1] = scale * (seat_.hardness * moved - seat_.softness * (rear_ - arrangement_.preload()));
  if (!tangent) return;
  tangent->row(1) *= scale * seat_.softness;
  (*tangent)(1, 0) -= scale * seat_.hardness;
  (*tangent)(1, 1) += scale * seat_.hardness;
}

bool ShaftBalance5::assemble(const Eigen::VectorXd& u, double share, Eigen::VectorXd& missing,
                             Eigen::MatrixXd* tangent) {
  missing = share * loads_;
  if (tangent) tangent->setZero(size(), size());
  for (const Index plane : {Index{2}, 2 + planar_}) {
    missing.segment(plane, planar_) -= condensed_.stiffness() * u.segment(plane, planar_);
    if (tangent) tangent->block(plane, plane, planar_, planar_) += condensed_.stiffness();
  }
  front_ = rear_ = 0.0;
  // Row 0 of the tangent: of F_r - F_f by u; row 1: of F_r, which seat() turns into its equation.
  for (std::size_t i = 0; i < count_; ++i) {
    if (!held_[i].hold(place_of(u, i))) return false;
    const Vector5 force = frame_[i].transpose() * held_[i].force();
    const auto at = indices(i);
    const bool front = at[0] == 0;
    (front ? front_ : rear_) += force[0];
    for (std::size_t k = 1; k < 5; ++k) missing[at[k]] -= force[static_cast<Index>(k)];
    if (!tangent) continue;
    const Matrix5 own = frame_[i].transpose() * held_[i].stiffness() * frame_[i];
    const double pressed = front ? -1.0 : 1.0;  // a follows -y or δ_r
    for (std::size_t c = 0; c < 5; ++c) {
      const double turn = c == 0 ? pressed : 1.0;
      for (std::size_t r = 1; r < 5; ++r)
        (*tangent)(at[r], at[c]) += turn * own(static_cast<Index>(r), static_cast<Index>(c));
      const double axial = turn * own(0, static_cast<Index>(c));
      (*tangent)(0, at[c]) += pressed * axial;
      if (!front) (*tangent)(1, at[c]) += axial;
    }
  }
  seat(u, missing, tangent);
  missing[0] = front_ - rear_ + axial_;
  return missing.allFinite();
}

bool ShaftBalance5::newton(Eigen::VectorXd& u, double share, int most) {
  Eigen::VectorXd missing, trial_missing;
  Eigen::MatrixXd tangent;
  const auto norm = [&](const Eigen::VectorXd& m) {
    double largest = 0.0;
    for (Index i = 0; i < m.size(); ++i) largest = std::max(largest, std::abs(scaled(i, m[i])));
    return largest / force_scale_;
  };
  if (!assemble(u, share, missing, &tangent)) return false;
  double residual = norm(missing);
  for (int i = 0; i < steps_of_one_newton && iterations_ < most; ++i) {
    residual_ = residual;
    if (residual <= balance_tolerance) return true;
    const Eigen::VectorXd step = algebra::solve_square(tangent, missing);
    if (!step.allFinite()) {
      failure_ = SolveStatus::singular;
      return false;
    }
    ++iterations_;
    double fraction = 1.0, next = 0.0;
    Eigen::VectorXd trial;
    bool taken = false;
    for (int halving = 0; halving < 12; ++halving, fraction *= 0.5) {
      trial = u + fraction * step;
      if (!assemble(trial, share, trial_missing, nullptr)) continue;
      next = norm(trial_missing);
      // A ball that changes between contact and none may raise the residual once.
      if (next <= (halving == 0 ? 2.0 : 1.0) * residual) {
        taken = true;
        break;
      }
    }
    if (residual <= stalled_tolerance && (!taken || next > 0.5 * residual)) return true;
    if (!taken) return false;
    u = trial;
    if (!assemble(u, share, missing, &tangent)) return false;
    residual = norm(missing);
  }
  residual_ = residual;
  return residual <= stalled_tolerance;
}

void ShaftBalance5::fill(const Eigen::VectorXd& u, LoadedShaft& result) const {
  result.position = arrangement_.direction() * u[0];
  result.rear_displacement = tandem() ? unset : u[1];
  result.front_force = front_;
  result.rear_force = rear_;
  result.y = condensed_.expand(u.segment(2, planar_));
  result.z = condensed_.expand(u.segment(2 + planar_, planar_));
  for (const bearing::DisplacedBearing& held : held_) {
    result.loads.push_back(held.force());
    result.bearings.push_back(held.equilibrium());
  }
}

/// The radial load grows from none, by steps as long as Newton allows.
bool follow_load(ShaftBalance5& balance, const Eigen::VectorXd& start, int most,
                 Eigen::VectorXd& u) {
  constexpr double shortest = 1e-4;
  u = start;
  double share = 0.0, step = 1.0;
  while (share < 1.0) {
    const double next = std::min(1.0, share + step);
    Eigen::VectorXd trial = u;
    if (balance.newton(trial, next, most)) {
      u = trial;
      share = next;
      step *= 2.0;
    } else if ((step *= 0.3) < shortest || balance.iterations() >= most) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool presses_rearwards(const bearing::Arrangement& arrangement, std::size_t i) {
  return (arrangement.side(i) == Side::front) == (arrangement.direction() > 0.0);
}

LoadedShaft solve_loaded_shaft(const Beam& beam, const bearing::Arrangement& arrangement,
                               std::span<const double> places,
                               const bearing::ArrangementCondition& condition,
                               const ShaftLoad& load, const bearing::EquilibriumOptions& options) {
  if (places.size() != arrangement.bearings().size())
    throw std::invalid_argument("positions: as many as bearings are needed");
  LoadedShaft result;
  bearing::ArrangementCondition axial = condition;
  axial.external_load += load.axial;
  const bearing::ArrangementEquilibrium start = solve_arrangement(arrangement, axial, options);
  if (!start.report.converged()) {
    result.report = start.report;
    return result;
  }
  ShaftBalance5 balance(beam, arrangement, places, axial, load, options);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(balance.size()), found;
  u[0] = arrangement.direction() * start.position;
  if (!arrangement.design().rear.empty()) u[1] = start.rear_displacement;
  const bool balanced = follow_load(balance, u, options.max_iterations, found);
  result.report.iterations = balance.iterations();
  result.report.residual = balance.residual();
  if (!balanced) {
    result.report.status = balance.iterations() >= options.max_iterations
                               ? SolveStatus::iteration_limit
                               : balance.failure();
    return result;
  }
  balance.fill(found, result);
  result.report.status = SolveStatus::converged;
  return result;
}

std::vector<Spring> bearing_springs(const bearing::Arrangement& arrangement,
                                    std::span<const double> places,
                                    std::span<const bearing::BearingEquilibrium> bearings) {
  if (places.size() != bearings.size())
    throw std::invalid_argument("positions: as many as bearings are needed");
  std::vector<Spring> springs;
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const Matrix5 k = bearings[i].stiffness;
    const double side = presses_rearwards(arrangement, i) ? 1.0 : -1.0;
    springs.push_back(
        {.position = places[i],
         .y = {.radial = k(1, 1), .tilt = k(4, 4), .coupling = side * 0.5 * (k(1, 4) + k(4, 1))},
         .z = {.radial = k(2, 2), .tilt = k(3, 3), .coupling = -side * 0.5 * (k(2, 3) + k(3, 2))}});
  }
  return springs;
}

}  // namespace raceway::spindle
