#include "correction/correction_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "correction/catalogue.h"
#include "correction/leaps.h"
#include "correction/own_effect.h"
#include "correction/range.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "record/nearest_names.h"
#include "record/series_channel.h"

namespace raceway::correction {
namespace {

constexpr int parts = 8;  // of which each is held out

using Beginning = CorrectionSubject::Beginning;

/// One model simulated again and again.
class CorrectionPredictor : public fit::Predictor {
 public:
  CorrectionPredictor(const Model& model, const TimeConstantLimits& limits,
                      std::vector<Beginning> beginnings, const std::vector<std::string>& names,
                      std::shared_ptr<const Series> series)
      : model_(model), beginnings_(std::move(beginnings)), series_(std::move(series)) {
    numbers_ = numbers(model_, limits);
    for (const std::string& name : names) {
      const auto number = std::find_if(numbers_.begin(), numbers_.end(),
                                       [&](const Number& n) { return n.parameter.name == name; });
      const auto beginning =
          std::find_if(beginnings_.begin(), beginnings_.end(),
                       [&](const Beginning& b) { return b.parameter.name == name; });
      places_.push_back(number != numbers_.end() ? number->place : &beginning->parameter.value);
      factors_.push_back(number != numbers_.end() ? number->factor : 1.0);
      parameters_.push_back(number != numbers_.end() ? number->parameter : beginning->parameter);
    }
  }
  // numbers_ point into model_.
  CorrectionPredictor(const CorrectionPredictor&) = delete;
  CorrectionPredictor& operator=(const CorrectionPredictor&) = delete;

  void readings(std::span<const double> values, std::span<double> out) override {
    for (std::size_t k = 0; k < values.size(); ++k) *places_[k] = values[k] * factors_[k];
    simulate(model_, *series_, out);
    for (const Beginning& b : beginnings_) {
      const double size = b.parameter.value * um;
      if (size == 0.0) continue;
      if (b.is_state) {
        const Series::Values decay = decay_of(b);
        const Series::Values share = series_->shown_share(model_.channels[b.channel].input);
        for (std::size_t k = 0; k < out.size(); ++k)
          out[k] += size * (*decay)[k] * (share ? (*share)[k] : 1.0);
      } else {
        for (std::size_t k = 0; k < out.size(); ++k)
          if (series_->zero()[k] == b.zero) out[k] += size;
      }
    }
  }

  /// Columns are cached by their parameters. A parameter bends a column if moving it gives another
  /// object.
  [[nodiscard]] bool bends(std::size_t parameter, std::size_t of) override {
    if (bends_.empty()) find_bends();
    return bends_.at(parameter).at(of == none ? places_.size() : of);
  }

 private:
  using Terms = std::vector<std::pair<double, Series::Values>>;

  [[nodiscard]] Series::Values decay_of(const Beginning& b) const {
    return series_->decay(model_.channels[b.channel].sections[b.section].time_constant);
  }

  [[nodiscard]] Terms terms_of(std::size_t of) {
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (parameters_[k].proportional) *places_[k] = k == of ? factors_[k] : 0.0;
    Terms terms{{model_.offset, nullptr}};
    show_parts(model_, *series_,
               [&](double weight, const Series::Values& v) { terms.emplace_back(weight, v); });
    for (const Beginning& b : beginnings_)
      if (b.parameter.value != 0.0)
        terms.emplace_back(b.parameter.value, b.is_state ? decay_of(b) : nullptr);
    return terms;
  }

  /// Starts a little inside the bounds of the parameters: at a bound an effect may change nothing.
  void find_bends() {
    std::vector<double> by;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const fit::Parameter& p = parameters_[k];
      const double start = std::clamp(p.start, p.lower, p.upper);
      const double inwards = p.upper - start > start - p.lower ? 0.01 : -0.01;
      by.push_back(inwards * (start != 0.0 ? std::abs(start) : 1.0) * factors_[k]);
      *places_[k] = start * factors_[k] + by[k];
    }
    bends_.assign(places_.size(), std::vector<bool>(places_.size() + 1, false));
    for (std::size_t of = 0; of <= places_.size(); ++of) {
      if (of < places_.size() && !parameters_[of].proportional) continue;
      const Terms before = terms_of(of);
      for (std::size_t k = 0; k < places_.size(); ++k) {
        if (parameters_[k].proportional) continue;
        const double here = *places_[k];
        *places_[k] += by[k];
        bends_[k][of] = terms_of(of) != before;
        *places_[k] = here;
      }
    }
  }

  Model model_;
  std::vector<Beginning> beginnings_;
  std::shared_ptr<const Series> series_;
  std::vector<Number> numbers_;
  std::vector<fit::Parameter> parameters_;  // by name
  std::vector<std::vector<bool>> bends_;    // by parameter and what it may bend; empty: not asked
  std::vector<double*> places_;
  std::vector<double> factors_;
};

/// Part in which each row lies; all parts have equally many rows of `read`.
std::vector<int> in_parts(std::size_t rows, std::span<const std::size_t> read) {
  std::vector<int> part(rows);
  std::size_t next = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    while (next < read.size() && read[next] < k) ++next;
    part[k] = std::min(parts - 1, static_cast<int>(next * parts / read.size()));
  }
  return part;
}

/// Parts of each run by itself, see in_parts().
std::vector<int> in_parts_of_runs(const fit::Record& record, std::span<const std::size_t> read) {
  std::map<int, std::vector<std::size_t>> by_run;
  for (const std::size_t k : read) by_run[record.run_of(k)].push_back(k);
  std::vector<int> part(record.rows(), -1);
  for (const auto& [run, rows] : by_run) {
    const std::vector<int> of_run = in_parts(record.rows(), rows);
    for (std::size_t k = 0; k < record.rows(); ++k)
      if (record.run_of(k) == run) part[k] = of_run[k];
  }
  return part;
}

/// An input that moves within one part alone: without that part nothing is known of its channel. A
/// temperature that drives above a reference moves where it leaves the reference: with the room all
/// temperatures rise, in every run. Of what a control records besides temperatures, speeds and
/// feeds those count that the model uses.
struct WithinPart {
  const Channel* input = nullptr;
  int part = 0;
};

std::vector<WithinPart> inputs_within_a_part(const Model& model, const fit::Record& record,
                                             std::span<const int> part) {
  constexpr double nearly_all = 0.8;  // of the sum of squares of its rise
  const std::vector<const Channel*> used = inputs_of(model);
  const Series series(record);
  const auto above_reference = [&](const Channel& column) -> Series::Values {
    for (const DrivenChannel& c : model.channels)
      for (const Channel* const of : c.input.columns)
        if (c.input.reference && *of == column) return series.input(c.input);
    return nullptr;
  };
  std::vector<WithinPart> list;
  for (const record::Column& c : record.columns) {
    if (!c.channel->is_input()) continue;
    const bool counts =
        record::is_temperature(*c.channel) || record::acts_by_amount(*c.channel) ||
        std::any_of(used.begin(), used.end(), [&](const Channel* u) { return *u == *c.channel; });
    if (!counts) continue;
    const Series::Values above = above_reference(*c.channel);
    const std::vector<double>& values = above ? *above : c.values;
    const bool from_first = !above && record::course_of(*c.channel) == record::Course::straight;
    std::array<double, parts> squares{};
    double first = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (k == 0 || record.run_of(k) != record.run_of(k - 1)) first = from_first ? values[k] : 0.0;
      if (part[k] >= 0)
        squares[static_cast<std::size_t>(part[k])] += std::pow(values[k] - first, 2);
    }
    const auto most = std::max_element(squares.begin(), squares.end());
    const double all = std::accumulate(squares.begin(), squares.end(), 0.0);
    if (all > 0.0 && *most > nearly_all * all)
      list.push_back({c.channel, static_cast<int>(most - squares.begin())});
  }
  return list;
}

fit::Parameter beginning_parameter(std::string name, const Model& model) {
  fit::Parameter p;
  p.name = std::move(name);
  p.unit = unit_of(model);
  p.start = p.value = p.initial = 0.0;
  p.lower = p.plausible_lower = -std::numeric_limits<double>::infinity();
  p.upper = p.plausible_upper = std::numeric_limits<double>::infinity();
  p.proportional = true;
  return p;
}

}  // namespace

CorrectionSubject::CorrectionSubject(Model model) : model_(std::move(model)) {}

std::vector<fit::Measured> CorrectionSubject::measured() const {
  return {{.channel = model_.displacement,
           .std = model_.measured_std,
           .begins = name(model_.initial_state),
           .approximate = true,
           .any_zero = true,
           .tolerance = model_.tolerance}};
}

void CorrectionSubject::require(const fit::Record& record) const {
  if (!record.has(record::time))
    throw std::invalid_argument("a displacement over time needs a column time_s");
  for (const Channel* c : inputs_of(model_))
    if (!record.has(*c))
      throw std::invalid_argument(fmt::format("column {} is missing; the model needs it", c->name));
  for (const Effect& e : model_.effects) {
    const Input input = input_of(e, model_);
    if (!input.formula || e.off) continue;
    const Series::Values driving = Series(record).input(input);
    const auto bad = std::find_if(driving->begin(), driving->end(),
                                  [](double value) { return !std::isfinite(value); });
    if (bad != driving->end())
      throw std::invalid_argument(
          fmt::format("the formula of effect {} gives no finite value in {}", e.id,
                      record.place(static_cast<std::size_t>(bad - driving->begin()))));
  }
}

std::shared_ptr<const void> CorrectionSubject::prepare(const fit::Record& record) const {
  return std::make_shared<const Series>(record);
}

std::unique_ptr<fit::Predictor> CorrectionSubject::predictor(
    const fit::Record& record, const std::vector<std::string>& names,
    const std::shared_ptr<const void>& prepared) const {
  (void)fit::find_parameters(*this, names);
  auto series = prepared ? std::static_pointer_cast<const Series>(prepared)
                         : std::make_shared<const Series>(record);
  return std::make_unique<CorrectionPredictor>(model_, limits_, beginnings_, names,
                                               std::move(series));
}

std::unique_ptr<fit::Subject> CorrectionSubject::informed_by(const fit::Record& record) const {
  auto result = std::make_unique<CorrectionSubject>(*this);
  forget_what_was_seen(result->model_);
  const Series series(record);
  result->limits_ = time_constants_of(series);
  result->columns_.clear();
  result->ranges_.clear();
  for (const record::Column& c : record.columns) {
    const auto [low, high] = std::minmax_element(c.values.begin(), c.values.end());
    if (!c.channel->is_input() || c.values.empty() || !(*high > *low)) continue;
    result->columns_.push_back(c.channel);
    result->ranges_.push_back({*low, *high});
  }
  const std::span<const double> time = record.values(record::time);
  result->end_ = *std::max_element(time.begin(), time.end()) + 1.0;
  result->jump_times_ = leaps(record, *model_.displacement);
  result->beginnings_.clear();
  for (int z = 1; z < series.zeros(); ++z)
    result->beginnings_.push_back(
        {.parameter = beginning_parameter(fmt::format("zero.{}", z + 1), model_), .zero = z});
  if (model_.initial_state == InitialState::free)
    for (std::size_t c = 0; c < model_.channels.size(); ++c)
      for (std::size_t s = 0; s < model_.channels[c].sections.size(); ++s)
        result->beginnings_.push_back(
            {.parameter = beginning_parameter(
                 fmt::format("initial.{}.{}", model_.channels[c].name, s + 1), model_),
             .channel = c,
             .section = s,
             .is_state = true});
  result->informed_ = true;
  return result;
}

void CorrectionSubject::keep_range(const Model& model) { model_.range = model.range; }

std::vector<fit::Parameter> CorrectionSubject::parameters() const {
  std::vector<fit::Parameter> list = correction::parameters(model_, limits_);
  for (const Beginning& b : beginnings_) list.push_back(b.parameter);
  return list;
}

std::vector<std::string> CorrectionSubject::free() const {
  std::vector<std::string> names = free_names(model_);
  for (const Beginning& b : beginnings_) names.push_back(b.parameter.name);
  return names;
}

std::unique_ptr<fit::Subject> CorrectionSubject::with_values(
    std::span<const fit::NamedValue> values) const {
  auto result = std::make_unique<CorrectionSubject>(*this);
  const std::vector<Number> all = numbers(result->model_, limits_);
  for (const fit::NamedValue& v : values) {
    (void)fit::find_parameters(*this, {v.name});
    for (const Number& n : all)
      if (n.parameter.name == v.name) *n.place = v.value * n.factor;
    for (Beginning& b : result->beginnings_)
      if (b.parameter.name == v.name) b.parameter.start = b.parameter.value = v.value;
  }
  return result;
}

/// Effects that the columns allow and the model does not have, as they would be switched on.
std::vector<Effect> CorrectionSubject::possible() const {
  const Surroundings in = surroundings();
  std::vector<Effect> list;
  for (const Effect& e : model_.effects)
    if (e.off && std::any_of(e.own->columns().begin(), e.own->columns().end(),
                             [&](const Channel* c) { return in.varies(*c); }))
      list.push_back(e);
  for (const EffectKind* kind : kinds()) {
    if (kind->card().evidence) continue;  // faults() tells of it
    for (Effect& e : kind->possible(in)) {
      const std::string full = full_id(e);
      if (std::none_of(model_.effects.begin(), model_.effects.end(),
                       [&](const Effect& own) { return full_id(own) == full; }))
        list.push_back(std::move(e));
    }
  }
  // A column that drives a named effect is no candidate of its own.
  std::vector<std::vector<const Channel*>> named;
  for (const Effect& e : list)
    if (!card_of(e).by_column) named.push_back(e.columns);
  std::erase_if(list, [&](const Effect& e) {
    return card_of(e).by_column && !e.window &&
           std::find(named.begin(), named.end(), e.columns) != named.end();
  });
  return list;
}

Surroundings CorrectionSubject::surroundings() const {
  return {.model = model_,
          .varying = columns_,
          .ranges = ranges_,
          .jump_times = jump_times_,
          .end = end_};
}

std::vector<fit::Candidate> CorrectionSubject::candidates() const {
  const Surroundings in = surroundings();
  std::vector<fit::Candidate> list;
  for (const Effect& e : possible()) {
    const EffectKind& kind = kind_of(e);
    const EffectCard& card = kind.card();
    fit::Candidate candidate{.id = full_id(e),
                             .size = card.size,
                             .of_the_user = e.own != nullptr,
                             .of_reading = card.of_reading,
                             .by_column = card.by_column};
    Model with = model_;
    if (!e.own) with.effects.push_back(e);
    if (e.window)
      candidate.acts_on = {{"column", std::string(e.window->column->name)},
                           {"window", e.window->range_text()},
                           {"channel", find_channel(model_, e.where)->name}};
    else if (card.at_channel)
      candidate.acts_on = {{"channel", find_channel(model_, e.where)->name}};
    else if (card.by_column)
      candidate.acts_on = {{"column", std::string(e.columns.front()->name)}};
    else if (!e.where.empty())
      candidate.acts_on = {{"axis", e.where}};
    const std::string prefix = candidate.id + ".";
    for (const fit::Parameter& p : correction::parameters(with, limits_))
      if (p.name.starts_with(prefix)) candidate.parameters.push_back(p);
    for (std::size_t k = 0; k < e.values.size(); ++k) candidate.only.push_back(kind.choices(k, in));
    if (std::all_of(candidate.only.begin(), candidate.only.end(),
                    [](const std::vector<double>& values) { return values.empty(); }))
      candidate.only.clear();
    list.push_back(std::move(candidate));
  }
  std::sort(list.begin(), list.end(),
            [](const fit::Candidate& a, const fit::Candidate& b) { return a.id < b.id; });
  return list;
}

std::vector<std::string> CorrectionSubject::catalogue() const {
  std::vector<std::string> ids;
  for (const EffectCard& card : correction::catalogue()) ids.emplace_back(card.id);
  for (const Effect& e : model_.effects)
    if (e.off) ids.push_back(e.id);
  return ids;
}

std::string CorrectionSubject::meant_by(const std::string& id) const {
  std::vector<std::string> of_its_kind;
  for (const Effect& e : possible()) {
    const std::string full = full_id(e);
    if (full == id) return full;
    // The main channel by its name.
    if (e.where.empty() && !model_.channels.empty() &&
        id == fmt::format("{}:{}", e.id, model_.channels.front().name))
      return full;
    if (e.id == id) of_its_kind.push_back(full);
  }
  if (of_its_kind.size() > 1)
    throw std::invalid_argument(
        fmt::format("the effect {} is ambiguous: write {}", id, fmt::join(of_its_kind, " or ")));
  return of_its_kind.empty() ? id : of_its_kind.front();
}

Effect CorrectionSubject::as_switched_on(const std::string& id) const {
  std::vector<std::string> known;
  for (Effect& e : possible()) {
    if (full_id(e) == id) return std::move(e);
    known.push_back(full_id(e));
  }
  for (const Effect& e : model_.effects)
    if (full_id(e) == id)
      throw std::invalid_argument(e.off ? fmt::format("{}: needs {}", id, e.own->card().needs)
                                        : fmt::format("{}: the model already has this effect", id));
  if (const EffectCard* const card = find_card(id))
    throw std::invalid_argument(
        card->evidence ? fmt::format("{}: this effect describes a fault of the record and has no "
                                     "parameter, so add cannot write it to a model",
                                     id)
                       : fmt::format("{}: needs {}", id, card->needs));
  throw std::invalid_argument(
      fmt::format("unknown effect \"{}\"; nearest: {}", id, record::nearest_names(id, known, 3)));
}

std::unique_ptr<fit::Subject> CorrectionSubject::with_candidates(
    std::span<const std::string> ids) const {
  auto result = std::make_unique<CorrectionSubject>(*this);
  for (auto id = ids.begin(); id != ids.end(); ++id) {
    if (std::find(ids.begin(), id, *id) != id)
      throw std::invalid_argument(fmt::format("{} is listed twice", *id));
    Effect on = as_switched_on(*id);
    on.off = false;
    std::vector<Effect>& all = result->model_.effects;
    const auto own =
        std::find_if(all.begin(), all.end(), [&](const Effect& e) { return e.off && e.id == *id; });
    if (own != all.end())
      own->off = false;
    else
      all.push_back(std::move(on));
  }
  if (!model_.free.empty() && !ids.empty())
    if (std::find(model_.free.begin(), model_.free.end(), "effects") == model_.free.end())
      result->model_.free.emplace_back("effects");
  return result;
}

std::string CorrectionSubject::lacks(const std::string& id, const fit::Record&) const {
  for (const Effect& e : possible())
    if (full_id(e) == id || e.id == id) return {};
  for (const Effect& e : model_.effects)
    if (e.off && e.id == id) return std::string(e.own->card().needs);
  const EffectKind* const kind = find_kind(id);
  // Evidence is no candidate; what it needs it still may lack.
  if (!kind || (kind->card().evidence && !kind->possible(surroundings()).empty())) return {};
  return std::string(kind->card().needs);
}

std::vector<fit::Fault> CorrectionSubject::faults(const fit::Record& record) const {
  const Series series(record);
  std::vector<double> left = fit::predict(*this, record);
  for (std::size_t k = 0; k < left.size(); ++k)
    left[k] = record.value(*model_.displacement, k) - left[k];
  std::vector<fit::Fault> list;
  for (const EffectKind* const kind : kinds())
    for (fit::Fault& fault : kind->faults({model_, series, left})) list.push_back(std::move(fault));
  return list;
}

std::vector<fit::Blocking> CorrectionSubject::blockings(const fit::Record& record) const {
  std::vector<std::size_t> read;
  for (std::size_t k = 0; k < record.rows(); ++k)
    if (std::isfinite(record.value(*model_.displacement, k))) read.push_back(k);
  if (read.size() < static_cast<std::size_t>(2 * parts)) return {};
  fit::Blocking blocking{
      .variable = "time", .block = in_parts(record.rows(), read), .blocks = parts};
  if (record.runs.size() > 1 && !inputs_within_a_part(model_, record, blocking.block).empty())
    blocking.block = in_parts_of_runs(record, read);
  for (const WithinPart& only : inputs_within_a_part(model_, record, blocking.block)) {
    std::replace(blocking.block.begin(), blocking.block.end(), only.part, -1);
    blocking.untold.emplace_back(only.input->words);
  }
  if (model_.initial_state == InitialState::free)
    std::replace(blocking.block.begin(), blocking.block.end(), 0, -1);
  return {std::move(blocking)};
}

const Model& model_of(const fit::Subject& subject) {
  const auto* const of = dynamic_cast<const CorrectionSubject*>(&subject);
  if (!of) throw std::invalid_argument("this model is not a correction");
  return of->model();
}

}  // namespace raceway::correction
