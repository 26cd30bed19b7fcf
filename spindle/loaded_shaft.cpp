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

}  // namespace

/// Unknowns: axial position of the shaft, that of the rear set, then (v, θ) of every bearing and
/// of the loads' other places in the plane of y, then the same in that of z.
class ShaftBalance5 {
 public:
  ShaftBalance5(const Beam& beam, ShaftBearings held, std::span<const double> load_places)
      : sets_(held.sets),
        held_(std::move(held)),
        count_(held_.places.size()),
        condensed_(beam, masters(beam, load_places)),
        planar_(condensed_.stiffness().rows()),
        lever_(std::max(0.05 * beam.length(), 1 * mm)) {
    for (std::size_t i = 0; i < count_ + held_.rollers.size(); ++i)
      frame_.push_back(to_bearing_frame(i >= count_ || presses_rearwards(*sets_, i)));
    if (sets_) seat_ = sets_->seat();
  }

  /// Puts the bearings into another state, and these loads on the shaft.
  void put(const bearing::ArrangementCondition& condition, std::span<const double> clearances,
           std::span<const ShaftLoad> loads, const bearing::EquilibriumOptions& options);
  [[nodiscard]] Index size() const { return 2 + 2 * planar_; }
  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] double residual() const { return residual_; }
  [[nodiscard]] SolveStatus failure() const { return failure_; }
  [[nodiscard]] const bearing::Arrangement* sets() const { return sets_; }

  /// From `u` to balance under a share of the radial load.
  bool newton(Eigen::VectorXd& u, double share, int most);
  void fill(const Eigen::VectorXd& u, LoadedShaft& result) const;

 private:
  std::vector<std::size_t> masters(const Beam& beam, std::span<const double> load_places) {
    std::vector<std::size_t> nodes;
    for (const double p : held_.places) nodes.push_back(beam.node_at(p));
    for (const RollerSupport& r : held_.rollers) nodes.push_back(beam.node_at(r.position));
    for (const double p : load_places) {
      const std::size_t node = beam.node_at(p);
      const auto same = std::find(nodes.begin(), nodes.end(), node);
      loaded_.push_back(2 * (same - nodes.begin()));
      if (same == nodes.end()) {
        nodes.push_back(node);
        continue;
      }
      // Each load has one more place than bearings: the numbering does not depend on where it acts.
      std::size_t other = 0;
      while (std::find(nodes.begin(), nodes.end(), other) != nodes.end()) ++other;
      if (other >= beam.nodes().size())
        throw std::invalid_argument("the beam needs more nodes than bearings");
      nodes.push_back(other);
    }
    return nodes;
  }
  /// Places in u of a bearing's (a, v_y, θ_y, v_z, θ_z). Rollers feel and press nothing along a.
  [[nodiscard]] std::array<Index, 5> indices(std::size_t i) const {
    const Index v = 2 + 2 * static_cast<Index>(i);
    const bool rear = i < count_ && sets_->side(i) == Side::rear;
    return {rear ? 1 : 0, v, v + 1, v + planar_, v + planar_ + 1};
  }
  [[nodiscard]] Vector5 place_of(const Eigen::VectorXd& u, std::size_t i) const {
    const auto at = indices(i);
    Vector5 own;
    for (int k = 0; k < 5; ++k) own[k] = u[at[static_cast<std::size_t>(k)]];
    if (i < count_)
      own[0] = sets_->bearings()[i].offset +
               (at[0] == 0 ? sets_->displacement(Side::front) - u[0] : u[1]);
    return frame_[i] * own;
  }
  [[nodiscard]] bool tandem() const { return sets_->front_count() == count_; }
  bool assemble(const Eigen::VectorXd& u, double share, Eigen::VectorXd& missing,
                Eigen::MatrixXd& tangent);
  template <typename Held>
  bool press(Held& held, std::size_t i, const Eigen::VectorXd& u, Eigen::VectorXd& missing,
             Eigen::MatrixXd& tangent);
  void seat(const Eigen::VectorXd& u, Eigen::VectorXd& missing, Eigen::MatrixXd& tangent);
  [[nodiscard]] double scaled(Index i, double value) const {
    return i >= 2 && i % 2 == 1 ? value / lever_ : value;
  }

  const bearing::Arrangement* sets_;
  ShaftBearings held_;
  std::size_t count_;          // bearings of the sets
  std::vector<Index> loaded_;  // places of the loads among the planar unknowns
  CondensedBeam condensed_;
  Index planar_;
  double lever_;
  std::vector<Matrix5> frame_;
  bearing::Arrangement::Seat seat_{};
  double elongation_ = 0.0, axial_ = 0.0;
  double speed_ = unset;
  std::vector<bearing::DisplacedBearing> balls_;
  std::vector<bearing::DisplacedRollerBearing> rollers_;
  Eigen::VectorXd loads_;
  double force_scale_ = unset;
  double front_ = 0.0, rear_ = 0.0;
  int iterations_ = 0;
  double residual_ = unset;
  SolveStatus failure_ = SolveStatus::no_equilibrium;
};

void ShaftBalance5::put(const bearing::ArrangementCondition& condition,
                        std::span<const double> clearances, std::span<const ShaftLoad> loads,
                        const bearing::EquilibriumOptions& options) {
  const double direction = sets_ ? sets_->direction() : 1.0;
  elongation_ = direction * condition.elongation;
  axial_ = direction * condition.external_load;
  const bool other = condition.speed != speed_;
  speed_ = condition.speed;
  // Balls that no race holds turn as they are told with each condition.
  if (other || !options.rotations.empty()) balls_.clear();
  const bool new_balls = balls_.empty();
  for (std::size_t i = 0; i < count_; ++i) {
    const bearing::RingShift shift =
        condition.shifts.empty() ? bearing::RingShift{} : condition.shifts[i];
    if (new_balls)
      balls_.emplace_back(*sets_->bearings()[i].bearing, speed_, shift,
                          options_of_bearing(options, i));
    else
      balls_[i].set_shift(shift);
  }
  if (other) rollers_.clear();
  const bool new_rollers = rollers_.empty();
  for (std::size_t i = 0; i < held_.rollers.size(); ++i) {
    if (new_rollers)
      rollers_.emplace_back(*held_.rollers[i].bearing, speed_, clearances[i]);
    else
      rollers_[i].set_clearance(clearances[i]);
  }
  loads_ = Eigen::VectorXd::Zero(size());
  force_scale_ = std::max({sets_ ? sets_->preload() : 0.0, std::abs(axial_), 1.0});
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const ShaftLoad& load = loads[k];
    const Index at = 2 + loaded_[k];
    loads_[at] += load.radial;
    loads_[at + 1] += load.moment;
    loads_[at + planar_] += load.radial_z;
    loads_[at + planar_ + 1] += load.moment_z;
    force_scale_ = std::max({force_scale_, std::abs(load.radial), std::abs(load.radial_z),
                             std::abs(load.moment) / lever_, std::abs(load.moment_z) / lever_});
  }
  iterations_ = 0;
  residual_ = unset;
  failure_ = SolveStatus::no_equilibrium;
}

/// softness (F_r - F_0) = hardness (y - e - (δ_r - δ_r0)), scaled to a force.
void ShaftBalance5::seat(const Eigen::VectorXd& u, Eigen::VectorXd& missing,
                         Eigen::MatrixXd& tangent) {
  if (tandem()) {
    rear_ = sets_->preload() + seat_.hardness * (u[0] - elongation_);
    missing[1] = -u[1];
    tangent(1, 1) = 1.0;
    tangent(0, 0) += seat_.hardness;
    return;
  }
  const double scale = 1.0 / (seat_.softness + seat_.hardness / contact_scale);
  const double moved = u[0] - elongation_ - (u[1] - sets_->displacement(Side::rear));
  missing[1] = scale * (seat_.hardness * moved - seat_.softness * (rear_ - sets_->preload()));
  tangent.row(1) *= scale * seat_.softness;
  tangent(1, 0) -= scale * seat_.hardness;
  tangent(1, 1) += scale * seat_.hardness;
}

/// What a bearing presses with at u. Row 0 of the tangent: of F_r - F_f by u; row 1: of F_r, which
/// seat() turns into its equation.
template <typename Held>
bool ShaftBalance5::press(Held& held, std::size_t i, const Eigen::VectorXd& u,
                          Eigen::VectorXd& missing, Eigen::MatrixXd& tangent) {
  if (!held.hold(place_of(u, i))) return false;
  const Vector5 force = frame_[i].transpose() * held.force();
  const auto at = indices(i);
  const bool front = at[0] == 0;
  (front ? front_ : rear_) += force[0];
  for (std::size_t k = 1; k < 5; ++k) missing[at[k]] -= force[static_cast<Index>(k)];
  const Matrix5 own = frame_[i].transpose() * held.stiffness() * frame_[i];
  const double pressed = front ? -1.0 : 1.0;  // a follows -y or δ_r
  for (std::size_t c = 0; c < 5; ++c) {
    const double turn = c == 0 ? pressed : 1.0;
    for (std::size_t r = 1; r < 5; ++r)
      tangent(at[r], at[c]) += turn * own(static_cast<Index>(r), static_cast<Index>(c));
    const double axial = turn * own(0, static_cast<Index>(c));
    tangent(0, at[c]) += pressed * axial;
    if (!front) tangent(1, at[c]) += axial;
  }
  return true;
}

bool ShaftBalance5::assemble(const Eigen::VectorXd& u, double share, Eigen::VectorXd& missing,
                             Eigen::MatrixXd& tangent) {
  missing = share * loads_;
  tangent.setZero(size(), size());
  for (const Index plane : {Index{2}, 2 + planar_}) {
    missing.segment(plane, planar_) -= condensed_.stiffness() * u.segment(plane, planar_);
    tangent.block(plane, plane, planar_, planar_) += condensed_.stiffness();
  }
  front_ = rear_ = 0.0;
  for (std::size_t i = 0; i < count_; ++i)
    if (!press(balls_[i], i, u, missing, tangent)) return false;
  for (std::size_t i = 0; i < rollers_.size(); ++i)
    if (!press(rollers_[i], count_ + i, u, missing, tangent)) return false;
  if (sets_) {
    seat(u, missing, tangent);
    missing[0] = front_ - rear_ + axial_;
  } else {
    tangent.topLeftCorner(2, 2).setIdentity();
  }
  return missing.allFinite();
}

bool ShaftBalance5::newton(Eigen::VectorXd& u, double share, int most) {
  Eigen::VectorXd missing, trial_missing;
  Eigen::MatrixXd tangent, trial_tangent;
  const auto norm = [&](const Eigen::VectorXd& m) {
    double largest = 0.0;
    for (Index i = 0; i < m.size(); ++i) largest = std::max(largest, std::abs(scaled(i, m[i])));
    return largest / force_scale_;
  };
  if (!assemble(u, share, missing, tangent)) return false;
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
      if (!assemble(trial, share, trial_missing, trial_tangent)) continue;
      next = norm(trial_missing);
      // A ball that changes between contact and none may raise the residual once.
      if (next <= (halving == 0 ? 2.0 : 1.0) * residual) {
        taken = true;
        break;
      }
    }
    if (residual <= stalled_tolerance && (!taken || next > 0.5 * residual)) return true;
    if (!taken) return false;
    std::swap(u, trial);
    std::swap(missing, trial_missing);
    std::swap(tangent, trial_tangent);
    residual = next;
  }
  residual_ = residual;
  return residual <= stalled_tolerance;
}

void ShaftBalance5::fill(const Eigen::VectorXd& u, LoadedShaft& result) const {
  if (sets_) {
    result.position = sets_->direction() * u[0];
    result.rear_displacement = tandem() ? unset : u[1];
    result.front_force = front_;
    result.rear_force = rear_;
  }
  result.y = condensed_.expand(u.segment(2, planar_));
  result.z = condensed_.expand(u.segment(2 + planar_, planar_));
  for (const bearing::DisplacedBearing& held : balls_) {
    result.loads.push_back(held.force());
    result.bearings.push_back(held.equilibrium());
  }
  for (const bearing::DisplacedRollerBearing& held : rollers_)
    result.rollers.push_back(held.equilibrium());
}

namespace {

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

ShaftOnBearings::ShaftOnBearings(const Beam& beam, ShaftBearings held,
                                 std::span<const double> load_places) {
  if (held.places.size() != (held.sets ? held.sets->bearings().size() : 0))
    throw std::invalid_argument("positions: give one position for each bearing");
  balance_ = std::make_unique<ShaftBalance5>(beam, std::move(held), load_places);
}
ShaftOnBearings::ShaftOnBearings(ShaftOnBearings&&) noexcept = default;
ShaftOnBearings::~ShaftOnBearings() = default;

LoadedShaft ShaftOnBearings::solve(const bearing::ArrangementCondition& condition,
                                   std::span<const double> clearances,
                                   std::span<const ShaftLoad> loads,
                                   const bearing::EquilibriumOptions& options,
                                   const bearing::ArrangementEquilibrium* unbent) {
  LoadedShaft result;
  bearing::ArrangementCondition axial = condition;
  for (const ShaftLoad& load : loads) axial.external_load += load.axial;
  balance_->put(axial, clearances, loads, options);
  bool balanced = last_.size() > 0 && balance_->newton(last_, 1.0, options.max_iterations);
  if (!balanced) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(balance_->size());
    if (const bearing::Arrangement* const sets = balance_->sets()) {
      const bearing::ArrangementEquilibrium start =
          unbent ? *unbent : solve_arrangement(*sets, axial, options);
      if (!start.report.converged()) {
        result.report = start.report;
        last_.resize(0);
        return result;
      }
      u[0] = sets->direction() * start.position;
      if (!sets->design().rear.empty()) u[1] = start.rear_displacement;
    }
    balanced = follow_load(*balance_, u, options.max_iterations, last_);
  }
  result.report.iterations = balance_->iterations();
  result.report.residual = balance_->residual();
  if (!balanced) {
    result.report.status = balance_->iterations() >= options.max_iterations
                               ? SolveStatus::iteration_limit
                               : balance_->failure();
    last_.resize(0);
    return result;
  }
  balance_->fill(last_, result);
  result.report.status = SolveStatus::converged;
  return result;
}

LoadedShaft solve_loaded_shaft(const Beam& beam, const bearing::Arrangement& arrangement,
                               std::span<const double> places,
                               const bearing::ArrangementCondition& condition,
                               const ShaftLoad& load, const bearing::EquilibriumOptions& options) {
  return ShaftOnBearings(beam, {.sets = &arrangement, .places = {places.begin(), places.end()}},
                         {&load.position, 1})
      .solve(condition, {}, {&load, 1}, options);
}

std::vector<Spring> bearing_springs(const bearing::Arrangement& arrangement,
                                    std::span<const double> places,
                                    std::span<const bearing::BearingEquilibrium> bearings) {
  if (places.size() != bearings.size())
    throw std::invalid_argument("positions: give one position for each bearing");
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

Spring roller_spring(double position, const bearing::RollerEquilibrium& rollers) {
  const bearing::Matrix4& k = rollers.stiffness;
  return {.position = position,
          .y = {.radial = k(0, 0), .tilt = k(3, 3), .coupling = k(0, 3)},
          .z = {.radial = k(1, 1), .tilt = k(2, 2), .coupling = -k(1, 2)}};
}

}  // namespace raceway::spindle
