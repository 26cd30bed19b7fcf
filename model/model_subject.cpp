#include "model/model_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "effects/catalogue.h"
#include "effects/formula.h"
#include "model/base_laws.h"
#include "model/candidates.h"
#include "model/corrected_data.h"
#include "model/needs.h"
#include "model/own_data.h"
#include "record/nearest_names.h"

namespace raceway::model {
namespace {

Model without(Model model, const std::vector<std::string>& ids) {
  std::erase_if(model.effects, [&](const effects::Effect& e) {
    return std::find(ids.begin(), ids.end(), e.description->id) != ids.end();
  });
  return model;
}

template <typename SomeModel>  // const or not
auto* find_effect(SomeModel& model, std::string_view id) {
  const auto found = std::find_if(model.effects.begin(), model.effects.end(),
                                  [&](const auto& e) { return e.description->id == id; });
  return found == model.effects.end() ? nullptr : &*found;
}

/// `known`: effects of the user's own.
[[noreturn]] void refuse_unknown(const std::string& id, std::vector<std::string> known,
                                 effects::Form form, const record::Channel& measured) {
  for (const effects::Description& d : effects::catalogue(form))
    if (d.moves(form, measured)) known.emplace_back(d.id);
  throw std::invalid_argument(
      fmt::format("unknown effect \"{}\"; nearest: {}", id, record::nearest_names(id, known, 3)));
}

}  // namespace

ModelSubject::ModelSubject(const Model& model) : ModelSubject(model, waiting_effects(model)) {}

ModelSubject::ModelSubject(Model model, std::vector<std::string> waiting)
    : model_(std::move(model)), active_(without(model_, waiting)), waiting_(std::move(waiting)) {}

std::unique_ptr<ModelSubject> ModelSubject::with(Model model,
                                                 std::vector<std::string> waiting) const {
  std::unique_ptr<ModelSubject> subject = make(std::move(model), std::move(waiting));
  subject->corrected_ = corrected_;
  return subject;
}

const record::Channel& ModelSubject::leading_channel() const { return *measured().front().channel; }

bool ModelSubject::moves(const effects::Description& effect) const {
  return effect.moves(model_.form(), leading_channel());
}

bool ModelSubject::waits(std::string_view id) const {
  return std::find(waiting_.begin(), waiting_.end(), id) != waiting_.end();
}

std::unique_ptr<fit::Subject> ModelSubject::informed_by(const fit::Record& record) const {
  Model informed = model_;
  for (const double t : record.values(record::temperature)) {
    informed.coldest = std::fmin(informed.coldest, t);
    informed.hottest = std::fmax(informed.hottest, t);
  }
  if (!std::isfinite(informed.hottest - informed.coldest)) return nullptr;
  if (std::isnan(informed.rig.room_temperature)) informed.rig.room_temperature = informed.coldest;
  return with(std::move(informed), waiting_);
}

std::vector<fit::Parameter> ModelSubject::parameters() const {
  std::vector<fit::Parameter> list = model::parameters(model_);
  std::erase_if(list, [&](const fit::Parameter& p) {
    const std::size_t dot = p.name.find('.');
    return dot != p.name.npos && waits(std::string_view(p.name).substr(0, dot));
  });
  for (const std::string& id : corrected_) list.push_back(own_datum_parameter(model_, id));
  return list;
}

std::vector<std::string> ModelSubject::free() const {
  return model_.free.empty() ? usual_free() : model_.free;
}

std::vector<std::string> ModelSubject::usual_free() const { return default_free(model_); }

std::unique_ptr<fit::Subject> ModelSubject::with_values(
    std::span<const fit::NamedValue> values) const {
  Model changed = model_;
  for (const fit::NamedValue& v : values)
    set(changed, fit::find_parameters(*this, {v.name}).front(), v.value);
  return with(std::move(changed), waiting_);
}

std::vector<fit::Candidate> ModelSubject::candidates() const {
  std::vector<fit::Candidate> list;
  const auto add = [&](const effects::Description& d) {
    if (auto candidate = candidate_of(d, model_)) list.push_back(*std::move(candidate));
  };
  for (const effects::Effect& e : model_.effects)
    if (waits(e.description->id)) add(*e.description);
  for (const effects::Description& d : effects::catalogue(model_.form()))
    if (moves(d) && !find_effect(model_, d.id)) add(d);
  // A number is not wrong and free at once.
  const std::vector<fit::Parameter> free_already = fit::find_parameters(*this, free());
  for (const std::string& id : own_data(model_)) {
    fit::Candidate datum = *own_datum(model_, id);
    const auto shares = [&](const fit::Parameter& p) {
      return std::any_of(p.addresses.begin(), p.addresses.end(), [&](const std::string& address) {
        const auto& own = datum.parameters.front().addresses;
        return std::find(own.begin(), own.end(), address) != own.end();
      });
    };
    if (std::find(corrected_.begin(), corrected_.end(), id) == corrected_.end() &&
        std::none_of(free_already.begin(), free_already.end(), shares))
      list.push_back(std::move(datum));
  }
  std::sort(list.begin(), list.end(),
            [](const fit::Candidate& a, const fit::Candidate& b) { return a.id < b.id; });
  return list;
}

std::vector<std::string> ModelSubject::catalogue() const {
  std::vector<std::string> ids;
  for (const effects::Description& d : effects::catalogue(model_.form()))
    if (d.belongs_to(model_.form()) || !d.of_spindles_alone()) ids.emplace_back(d.id);
  ids.insert(ids.end(), waiting_.begin(), waiting_.end());
  for (std::string& id : own_data(model_)) ids.push_back(std::move(id));
  return ids;
}

std::unique_ptr<fit::Subject> ModelSubject::with_candidates(
    std::span<const std::string> ids) const {
  Model extended = model_;
  std::vector<std::string> waiting = waiting_, corrected = corrected_;
  const std::vector<std::string> data = own_data(model_);
  for (auto id = ids.begin(); id != ids.end(); ++id) {
    if (std::find(ids.begin(), id, *id) != id)
      throw std::invalid_argument(fmt::format("{} is listed twice", *id));
    if (std::find(data.begin(), data.end(), *id) != data.end()) {
      corrected.push_back(*id);
    } else if (waits(*id)) {
      effects::Effect& own = *find_effect(extended, *id);
      own.values = effects::initial_values(*own.description);
      std::erase(waiting, *id);
    } else {
      extended.effects.push_back(from_catalogue(*id));
    }
  }
  std::unique_ptr<ModelSubject> subject = with(std::move(extended), std::move(waiting));
  subject->corrected_ = std::move(corrected);
  return subject;
}

std::unique_ptr<fit::Subject> ModelSubject::without_free_candidates() const {
  Model bare = model_;
  std::vector<std::string> waiting = waiting_, leaving;
  bool any = false;
  for (const effects::Effect& e : active_.effects) {
    const effects::Description& d = *e.description;
    if (!is_free(model_, d.id) || !candidate_of(d, model_)) continue;
    any = true;
    (d.user_made ? waiting : leaving).emplace_back(d.id);
    std::erase_if(bare.free, [&](const std::string& name) {
      return name.starts_with(std::string(d.id) + ".");
    });
  }
  if (!any) return nullptr;
  return with(without(std::move(bare), leaving), std::move(waiting));
}

std::unique_ptr<fit::Subject> ModelSubject::with_shape(const std::string& id,
                                                       const fit::Shape& shape) const {
  effects::UserMadeEffect own{.id = id,
                              .title = "shape of the missing effect, found in measurements",
                              .torque_Nmm = shape.formula,
                              .parameters = {}};
  for (const fit::Parameter& c : shape.coefficients)
    own.parameters.push_back({c.name, c.unit, c.value, c.lower, c.upper});
  Model with_it = model_;
  with_it.effects.push_back(effects::make_effect(own));
  effects::Effect& effect = with_it.effects.back();
  effect.values = effects::neutral_values(*effect.description);
  std::vector<std::string> waiting = waiting_;
  waiting.push_back(id);
  return with(std::move(with_it), std::move(waiting));
}

effects::Effect ModelSubject::from_catalogue(const std::string& id) const {
  const effects::Form form = model_.form();
  if (find_effect(model_, id))
    throw std::invalid_argument(fmt::format("{}: the model already has this effect", id));
  if (id == fmt::format("law:{}", friction::name(model_.law)))
    throw std::invalid_argument(fmt::format("{}: the model already has this law", id));
  const effects::Description* const d = effects::find(id, form);
  if (!d) {
    std::vector<std::string> known = waiting_;
    for (fit::OtherBase& base : other_bases()) known.push_back(std::move(base.id));
    refuse_unknown(id, std::move(known), form, leading_channel());
  }
  if (!moves(*d))
    throw std::invalid_argument(fmt::format("{}: this effect does not change the measured {}", id,
                                            leading_channel().words));
  if (!candidate_of(*d, model_))
    throw std::invalid_argument("add cannot fit an effect that has no parameter for its size");
  effects::Effect effect{.description = d, .values = effects::initial_values(*d)};
  for (std::size_t k = 0; k < effect.values.size(); ++k) {
    const auto [lower, upper] = bounds_of(d->parameters[k], model_);
    effect.values[k] = std::clamp(effect.values[k], lower, upper);
  }
  return effect;
}

std::string ModelSubject::rules_out(const std::string& id) const {
  const effects::Description* const d = description(id);
  if (!d || !moves(*d)) return {};
  if (std::string why = ruled_out(*d, model_); !why.empty()) return why;
  const std::string why = refused_by_law(*d, active_);
  return why.empty() ? why : "needs " + why;
}

std::string ModelSubject::correction(const std::string& id, std::span<const double> values) const {
  const effects::Description* const d = description(id);
  if (!d) return values.empty() ? std::string() : own_datum_text(model_, id, values.front());
  return correction_text(active_, {.description = d, .values = {values.begin(), values.end()}});
}

std::string ModelSubject::lacks(const std::string& id, const fit::Record& record) const {
  const effects::Description* const d = description(id);
  return d ? missing_need(*d, active_, record) : std::string();
}

std::string ModelSubject::lacks_levels(const std::string& id, const fit::Record& record) const {
  const effects::Description* const d = description(id);
  return d ? missing_levels(*d, active_, record) : std::string();
}

std::vector<ParameterPlace> ModelSubject::places(const std::vector<std::string>& names) const {
  std::vector<ParameterPlace> list;
  std::vector<fit::Parameter> known = model::parameters(active_);
  for (const std::string& id : corrected_) known.push_back(own_datum_parameter(active_, id));
  for (const fit::Parameter& chosen : fit::find_parameters(*this, names))
    list.emplace_back(active_, *std::find_if(known.begin(), known.end(),
                                             [&](const auto& p) { return p.name == chosen.name; }));
  return list;
}

fit::Measured ModelSubject::with_tolerance(fit::Measured measured) const {
  for (const record::NamedValue& t : model_.tolerances)
    if (t.name == measured.channel->name) measured.tolerance = t.value;
  return measured;
}

fit::Measured ModelSubject::measured_torque() const {
  // Below this share of the rms, errors of a torque sensor no longer shrink with the reading.
  constexpr double torque_floor = 0.05;
  // Rigs scatter by 1 to 5 %.
  constexpr double most_torque_scatter = 0.1;
  return with_tolerance({.channel = &record::friction_torque,
                         .floor = torque_floor,
                         .most_scatter = most_torque_scatter});
}

std::vector<fit::OtherBase> ModelSubject::other_laws() const {
  std::vector<fit::OtherBase> list;
  for (const friction::FrictionLaw law : friction::laws_of_same_bearing(model_.law)) {
    if (law == model_.law) continue;
    if (law == friction::FrictionLaw::table && !model_.table) continue;  // it names none
    const std::string name(friction::name(law));
    fit::OtherBase base{
        .id = "law:" + name, .words = "law = " + name, .lacks = lacks_for_law(model_, law)};
    base.fitted_form = friction::has_fitted_exponents(law);
    if (base.fitted_form) base.words += " (fitted exponents)";
    if (base.lacks.empty()) base.subject = with(with_law(model_, law), waiting_);
    list.push_back(std::move(base));
  }
  return list;
}

const effects::Description* ModelSubject::description(const std::string& id) const {
  const effects::Effect* const own = find_effect(model_, id);
  return own ? own->description : effects::find(id, model_.form());
}

const Model& model_of(const fit::Subject& subject) {
  const auto* const known = dynamic_cast<const ModelSubject*>(&subject);
  if (!known) throw std::invalid_argument("the model is not a bearing or a shaft");
  return known->model();
}

}  // namespace raceway::model
