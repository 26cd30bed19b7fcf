#include "correction/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "correction/effect_kind.h"
#include "correction/numbers.h"
#include "correction/own_effect.h"
#include "correction/range.h"

namespace raceway::correction {
namespace {

constexpr double same_sampling = 1e-6;  // share by which steps may differ from the printed one

void require_sampling(const Series& series, double sampling, const std::string& name) {
  const Clock& clock = series.clock();
  for (std::size_t k = 0; k < clock.rows(); ++k)
    if (!clock.begins[k] && std::abs(clock.steps[k] - sampling) > same_sampling * sampling)
      throw std::invalid_argument(
          fmt::format("the coefficients of channel {} are only valid for a sampling interval of {} "
                      "s, but {} comes {:.6g} s after the row before",
                      name, sampling, series.record().place(k), clock.steps[k]));
}

/// An input as its column has it.
std::vector<double> in_its_unit(const Input& of, std::vector<double> input) {
  for (double& u : input) u /= of.factor();
  return input;
}

/// Of one sampling, from rest in every run.
std::vector<double> run_printed(const DrivenChannel& channel, const Series& series,
                                const std::vector<double>& of) {
  require_sampling(series, channel.printed->sampling, channel.name);
  const double unit = channel.input.factor();
  const TransferFunction function = direct_form(*channel.printed, unit);
  const std::vector<double> input = in_its_unit(channel.input, of);
  std::vector<double> all;
  const std::vector<bool>& begins = series.clock().begins;
  for (std::size_t first = 0; first < input.size();) {
    std::size_t last = first + 1;
    while (last < input.size() && !begins[last]) ++last;
    const std::vector<double> part = run(function, std::span(input).subspan(first, last - first));
    for (const double y : part) all.push_back(y * um);
    first = last;
  }
  return all;
}

void add_channel(const Model& model, const DrivenChannel& channel, const Series& series,
                 const Sink& sink) {
  DrivenChannel c = channel;
  if (c.input.exponent != 1.0) c.input.seen = seen_of(model, *c.input.columns.front());
  const Series::Values input = series.input(c.input);
  const Series::Values share = series.shown_share(c.input);
  const auto show = [&](std::vector<double> u) {
    for (std::size_t k = 0; share && k < u.size(); ++k) u[k] *= (*share)[k];
    sink(c.scale, std::make_shared<const std::vector<double>>(std::move(u)));
  };
  if (c.element) {
    std::vector<double> u(series.rows());
    delay_response(series.clock(), in_its_unit(c.input, *input), *c.element, u,
                   seen_by_element(model, c));
    show(std::move(u));
  }
  if (c.printed) show(run_printed(c, series, *input));
  if (c.feedthrough != 0.0) sink(c.scale * c.feedthrough, series.at_once(c.input));
  const Answer answer = answer_of(model, channel);
  for (const Section& s : c.sections)
    if (s.gain != 0.0) sink(c.scale * s.gain, series.lag(c.input, s.time_constant, answer));
}

void add_effect(const Model& model, const Effect& e, const Series& series, const Sink& sink) {
  add_share(kind_of(e).share(e, model), series, seen_speed(model), sink);
}

Sink add_to(std::span<double> sum) {
  return [sum](double weight, const Series::Values& values) {
    for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += weight * (*values)[k];
  };
}

}  // namespace

Answer answer_of(const Model& model, const DrivenChannel& channel) {
  Answer answer;
  for (const Effect& e : model.effects)
    if (card_of(e).of_channel && find_channel(model, e.where) == &channel)
      kind_of(e).change(e, model, answer);
  return answer;
}

void simulate(const Model& model, const Series& series, std::span<double> displacement) {
  std::fill(displacement.begin(), displacement.end(), model.offset);
  show_parts(model, series, add_to(displacement));
}

void show_parts(const Model& model, const Series& series, const Sink& sink) {
  for (const DrivenChannel& c : model.channels) add_channel(model, c, series, sink);
  if (model.kinematic) add_share(*model.kinematic, series, seen_speed(model), sink);
  for (const Effect& e : model.effects) add_effect(model, e, series, sink);
}

std::vector<Contribution> contributions(const Model& model, const Series& series) {
  std::vector<Contribution> list;
  const auto part = [&](std::string name) {
    list.push_back({std::move(name), std::vector<double>(series.rows())});
    return add_to(list.back().displacement);
  };
  for (const DrivenChannel& c : model.channels) add_channel(model, c, series, part(c.name));
  if (model.kinematic) add_share(*model.kinematic, series, seen_speed(model), part("kinematic"));
  for (const Effect& e : model.effects)
    if (!card_of(e).of_channel) add_effect(model, e, series, part(full_id(e)));
  return list;
}

std::vector<const Channel*> inputs_of(const Model& model) {
  std::vector<const Channel*> list;
  const auto add = [&](const Channel* c) {
    if (c && c->is_input() && std::find(list.begin(), list.end(), c) == list.end())
      list.push_back(c);
  };
  const auto add_input = [&](const Input& input) {
    for (const Channel* c : input.columns) add(c);
    add(input.reference);
    if (input.window) add(input.window->column);
    if (input.formula)
      for (const Channel* c : input.formula->columns()) add(c);
    if (!input.is_power()) return;
    add(&record::speed);
    for (const TableCoordinate& c : {input.axial_load, input.radial_load, input.temperature})
      add(c.column);
  };
  for (const DrivenChannel& c : model.channels) add_input(c.input);
  if (model.kinematic) add(&record::speed);
  for (const Effect& e : model.effects) {
    if (e.off) continue;
    add_input(input_of(e, model));
    for (const Channel* c : kind_of(e).other_columns(e)) add(c);
  }
  return list;
}

}  // namespace raceway::correction
