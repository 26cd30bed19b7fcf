#include "spindle/heat_flow.h"

#include <algorithm>
#include <cmath>

#include "spindle/tr_bdf2.h"

namespace raceway::spindle {
namespace {

/// Films and seats of a steady state no longer move temperatures by more [K].
constexpr double settled = 1e-6;
constexpr int most_rounds = 200, undamped_rounds = 20;
/// A steady state is where one step of this length leads to itself [s]: what no heat reaches or
/// leaves stays as it is, and no other body feels the step once it has settled.
constexpr double long_run = 1e6;
/// A step that turns over less is compared with this, as rounding of what is stored is larger [J].
constexpr double least_turnover = 100.0;

/// A link to a node that is held is a way out; that node stays as it is.
HeatPaths paths_of(const model::Network& network) {
  HeatPaths paths;
  const auto n = static_cast<Eigen::Index>(network.nodes.size());
  paths.capacity.setOnes(n);
  paths.source.setZero(n);
  double reference = kelvin(20);
  for (const model::Network::Node& node : network.nodes)
    if (!std::isnan(node.temperature)) reference = node.temperature;
  paths.temperature = {reference, reference, reference};
  const auto held = [&](std::size_t k) { return network.nodes[k].temperature; };
  const auto add_outlet = [&](std::size_t node, double temperature, double conductance) {
    paths.outlets.push_back({static_cast<int>(node), Reservoir::machine, conductance});
    paths.source[static_cast<Eigen::Index>(node)] += conductance * (temperature - reference);
  };
  for (std::size_t k = 0; k < network.nodes.size(); ++k) {
    if (!std::isnan(held(k))) {
      add_outlet(k, held(k), 1.0);
      continue;
    }
    paths.capacity[static_cast<Eigen::Index>(k)] = network.nodes[k].capacity;
    paths.source[static_cast<Eigen::Index>(k)] = network.nodes[k].heat;
  }
  for (const model::Network::Link& link : network.links) {
    const bool first = !std::isnan(held(link.from)), second = !std::isnan(held(link.to));
    if (first && !second) add_outlet(link.to, held(link.from), link.conductance);
    if (second && !first) add_outlet(link.from, held(link.to), link.conductance);
    if (!first && !second)
      paths.links.push_back(
          {static_cast<int>(link.from), static_cast<int>(link.to), link.conductance});
  }
  return paths;
}

}  // namespace

HeatFlow::HeatFlow(const model::Model& model, const effects::SpindleCondition& condition,
                   model::Cells cells) {
  if (model.spindle && model.spindle->network) {
    network_ = paths_of(*model.spindle->network);
    for (const model::Network::Node& node : model.spindle->network->nodes)
      held_.push_back(node.temperature);
  } else {
    system_ = std::make_unique<ThermalSystem>(model, condition, cells);
    coupling_ = std::make_unique<BearingCoupling>(model, condition, *system_);
  }
  newton_ = std::make_unique<CoupledNewton>(paths(), coupling_.get());
  start(kelvin(20));
}

void HeatFlow::start(double temperature) {
  temperatures_.setConstant(paths().size(), temperature);
  for (std::size_t k = 0; k < held_.size(); ++k)
    if (!std::isnan(held_[k])) temperatures_[static_cast<Eigen::Index>(k)] = held_[k];
}

bool HeatFlow::set_inputs(const Inputs& inputs) {
  if (!coupling_) return true;
  newton_->forget_derivatives();
  if (!coupling_->set_inputs(inputs)) return false;
  felt_ = coupling_->felt(temperatures_);
  return coupling_->bear(felt_) && coupling_->evaluate(felt_, given_);
}

bool HeatFlow::prepare(const Inputs& inputs, double machine_rise, const Vector& films) {
  if (!system_) return true;
  system_->set_inputs(inputs, machine_rise);
  system_->update(films, inputs);
  if (!coupling_->bends()) return true;
  return coupling_->bear(coupling_->felt(films)) && coupling_->evaluate(felt_, given_);
}

Vector HeatFlow::inflow(const Vector& temperatures, const Vector& given) const {
  Vector f = paths().inflow(temperatures);
  if (coupling_) coupling_->add_given(given, f);
  return f;
}

Status HeatFlow::failed(NewtonStatus status) {
  const double gain_now = gain();
  if (gain_now >= 1.0) return Status::thermal_runaway;
  return status == NewtonStatus::converged ? Status::converged : Status::no_equilibrium;
}

double HeatFlow::gain() {
  if (!coupling_ || !newton_->factorise(paths(), 1.0 / long_run)) return unset;
  return newton_->gain(felt_, given_);
}

HeatFlow::Step HeatFlow::advance(const Inputs& inputs, double machine_rise, double dt,
                                 const Vector& films, bool asks_for_error) {
  Step step;
  if (!prepare(inputs, machine_rise, films)) {
    step.status = Status::no_equilibrium;
    return step;
  }
  constexpr double d = TrBdf2::diagonal, w = TrBdf2::weight;
  const HeatPaths& p = paths();
  if (!newton_->factorise(p, 1.0 / (dt * d))) {
    step.status = Status::no_equilibrium;
    return step;
  }
  const Vector constant = p.constant_inflow();
  const Vector stored = p.capacity.cwiseProduct(temperatures_) / (dt * d);
  const Vector f0 = inflow(temperatures_, given_);
  Vector middle = temperatures_, given = given_, felt = felt_;
  NewtonStatus status = newton_->solve(stored + f0 + constant, middle, given, felt);
  if (status != NewtonStatus::converged) {
    step.status = failed(status);
    return step;
  }
  const Vector given_middle = given;
  const Vector f1 = inflow(middle, given);
  Vector end = middle;
  status = newton_->solve(stored + (w / d) * (f0 + f1) + constant, end, given, felt);
  if (status != NewtonStatus::converged) {
    step.status = failed(status);
    return step;
  }
  const Vector f2 = inflow(end, given);
  constexpr auto e = TrBdf2::error_weights;
  if (asks_for_error)
    step.error =
        newton_->solve_linear((e[0] * f0 + e[1] * f1 + e[2] * f2) / d).lpNorm<Eigen::Infinity>();

  step.out_before = p.outflow(temperatures_);
  step.out_after = p.outflow(end);
  const auto out_middle = p.outflow(middle);
  double in = p.source.sum(), turnover = p.source.cwiseAbs().sum();
  if (coupling_) {
    const double friction = w * given_.sum() + w * given_middle.sum() + d * given.sum();
    in += friction;
    turnover += std::abs(friction);
  }
  for (std::size_t r = 0; r < reservoirs; ++r) {
    const double out = w * step.out_before[r] + w * out_middle[r] + d * step.out_after[r];
    in -= out;
    turnover += std::abs(out);
  }
  const double gained = p.capacity.dot(end - temperatures_);
  step.energy_error = std::abs(gained - dt * in) / std::max(dt * turnover, least_turnover);
  step.rate_before = f0.cwiseQuotient(p.capacity);
  step.rate_after = f2.cwiseQuotient(p.capacity);
  temperatures_ = std::move(end);
  given_ = std::move(given);
  felt_ = std::move(felt);
  step.status = Status::converged;
  return step;
}

Status HeatFlow::settle(const Inputs& inputs, double machine_rise, int& iterations) {
  Vector films = temperatures_;
  for (iterations = 0; iterations < most_rounds; ++iterations) {
    if (!prepare(inputs, machine_rise, films)) return Status::no_equilibrium;
    if (!newton_->factorise(paths(), 1.0 / long_run)) return Status::no_equilibrium;
    const Vector stored = paths().capacity.cwiseProduct(temperatures_) / long_run;
    Vector next = temperatures_;
    const NewtonStatus status =
        newton_->solve(stored + paths().constant_inflow(), next, given_, felt_);
    if (status != NewtonStatus::converged) return failed(status);
    temperatures_ = std::move(next);
    if (felt_.size() > 0 && felt_.head(felt_.size() - 1).maxCoeff() > hottest_ring)
      return Status::thermal_runaway;
    if ((temperatures_ - films).lpNorm<Eigen::Infinity>() < settled)
      return gain() >= 1.0 ? Status::thermal_runaway : Status::converged;
    // A seat at the edge of coming loose is loose and tight in turn: half the way ends that.
    films += (iterations < undamped_rounds ? 1.0 : 0.5) * (temperatures_ - films);
  }
  return Status::step_limit;
}

}  // namespace raceway::spindle
