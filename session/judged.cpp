#include "session/judged.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "bearing/ball_equilibrium.h"
#include "bearing/contact_pressure.h"
#include "bearing/frequencies.h"
#include "effects/catalogue.h"
#include "effects/interference_fit.h"
#include "model/row.h"
#include "results/shaft_results.h"
#include "results/spindle_results.h"
#include "shaft/shaft_balance.h"
#include "spindle/loaded_shaft.h"
#include "text/error.h"
#include "text/number_range.h"

namespace raceway::session {
namespace {

using model::Findings;
using model::Judge;
using model::JudgedBearing;

double mounted_preload(const model::Model& model) {
  return shaft::mounted_arrangement(model).preload();
}

/// The place of a bearing on its shaft; empty on a rig.
std::string place_of(const model::Model& model, std::size_t bearing) {
  return model.shaft ? results::bearing_place(model.shaft->arrangement, bearing) : std::string();
}

void judge_fit(const char* key, const char* of, double interference, double diameter,
               Findings& findings) {
  const double share = interference / diameter;
  if (share > model::limits::interference.value)
    findings.push_back(
        model::finding(model::limits::interference, share,
                       fmt::format("[seat] {}: an interference of {:.4g} um on {:.4g} mm is {:.2g} "
                                   "of the {}, above the limit {:g}: the ring can crack",
                                   key, interference / um, diameter / mm, share, of,
                                   model::limits::interference.value)));
}

double at(std::span<const double> row, std::size_t place) {
  return place < row.size() ? row[place] : unset;
}

/// A bearing of a spindle that runs; `pressures` may be NaN.
void judge_running(const model::Model& model, std::size_t bearing, const spindle::Inputs& inputs,
                   const spindle::BearingState& state, const bearing::ContactPressure& pressures,
                   Judge& judge) {
  const double oil = 0.5 * (state.inner_ring_temperature + state.outer_ring_temperature);
  const bearing::Bearing& b = *model.shaft->arrangement.bearings()[bearing].bearing;
  const double cage = nominal_frequencies(b.geometry(), b.geometry().contact_angle).cage;
  judge.look(
      b, place_of(model, bearing),
      {.speed = inputs.speed, .axial_load = inputs.axial_load, .temperature = oil},
      {.axial_load = state.force,
       .radial_load = state.radial_force,
       .minimum_load = minimum_load(b, cage * cage * bearing::full_centrifugal(b, inputs.speed)),
       .inner_pressure = pressures.inner,
       .outer_pressure = pressures.outer,
       .inner_ring_temperature = state.inner_ring_temperature,
       .outer_ring_temperature = state.outer_ring_temperature});
}

/// The roller bearings of a spindle, which stand behind those of the sets.
void judge_rollers(const model::Model& model, const spindle::Inputs& inputs,
                   const spindle::Moment& moment, Judge& judge) {
  for (std::size_t k = model.shaft->arrangement.bearings().size(); k < moment.bearings.size(); ++k)
    judge.look_at_rings(
        results::bearing_label(model, k), {.speed = inputs.speed, .axial_load = inputs.axial_load},
        moment.bearings[k].inner_ring_temperature, moment.bearings[k].outer_ring_temperature);
}

/// The pressure of a bearing alone under an axial and a radial load; NaN without balance.
bearing::ContactPressure pressure_under(const model::Model& model, const bearing::Bearing& bearing,
                                        double speed, const spindle::BearingState& state) {
  const bearing::BearingEquilibrium e = bearing::solve_bearing_equilibrium(
      bearing, {.speed = speed, .axial_load = state.force, .radial_load = state.radial_force},
      model.solver);
  return e.report.converged() ? largest_pressure(bearing, e) : bearing::ContactPressure{};
}

}  // namespace

Findings judge_mounted(const files::ModelFile& file) {
  const model::Model& model = file.model;
  if (!model.shaft) return {};
  Findings findings;
  const bearing::Arrangement mounted = shaft::mounted_arrangement(model);
  const bearing::ArrangementEquilibrium rest = solve_arrangement(mounted, {}, model.solver);
  double most = 0.0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < rest.bearings.size(); ++i) {
    const double p = std::fmax(rest.bearings[i].inner_pressure, rest.bearings[i].outer_pressure);
    if (p > most) most = p, worst = i;
  }
  if (most > bearing::static_limit_pressure) {
    model::Limit limit = model::limits::static_pressure;
    limit.is_warning = true;
    findings.push_back(model::finding(
        limit, most / GPa,
        fmt::format("the preload of {:.6g} N causes at {} a contact pressure of {:.3g} GPa as "
                    "mounted; above 4.2 GPa the balls leave permanent dents",
                    mounted.preload(), place_of(model, worst), most / GPa)));
    findings.back().place = place_of(model, worst);
  }
  if (!model.spindle || model.spindle->network) return findings;
  const bearing::BearingGeometry& g = mounted.bearings().front().bearing->geometry();
  judge_fit("inner_interference_um", "bore", model.spindle->seat.inner_interference, g.bore,
            findings);
  judge_fit("outer_clearance_um", "outer diameter", -model.spindle->seat.outer_clearance,
            g.outer_diameter, findings);
  return findings;
}

std::vector<record::Note> fit_notes(const model::Model& model) {
  if (!model.spindle || model.spindle->network) return {};
  const double seat = model.spindle->seat.inner_interference;
  for (const effects::Effect& e : model.effects) {
    if (e.description->id != effects::InterferenceFit::id) continue;
    // Both are entered in um.
    if (std::abs(e.values[0] - seat / um) <= 1e-9 * std::abs(seat / um)) return {};
    return {record::note::over_limit(
        fmt::format("the same fit has two different interferences: {:.6g} um in the effect "
                    "interference-fit (acts on the preload) and {:.6g} um in [seat] "
                    "inner_interference_um (acts on the heat through the seat)",
                    e.values[0], seat / um))};
  }
  const auto& preload = model.shaft->arrangement.design().preload;
  if (!std::holds_alternative<bearing::PreloadOffset>(preload) || !(seat > 0.0)) return {};
  const std::string so = fmt::format(
      "the preload of {:.4g} N is valid for bearings before mounting: [seat] inner_interference_um "
      "= {:.6g} um changes the heat through the seat, but not this preload",
      mounted_preload(model), seat / um);
  const effects::Description* const effect =
      effects::find(effects::InterferenceFit::id, effects::Form::spindle);
  if (seat / um > effect->parameters[0].upper) return {record::note::unused(so)};
  model::Model fitted = model;
  fitted.effects.push_back({.description = effect, .values = {seat / um}});
  return {
      record::note::unused(fmt::format("{}; with [[effect]] id = \"{}\", interference_um = {:.6g}, "
                                       "the preload as mounted is {:.4g} N",
                                       so, effect->id, seat / um, mounted_preload(fitted)))};
}

std::vector<record::Note> warnings_said(const model::Findings& findings) {
  std::vector<record::Note> notes;
  for (const model::Finding& f : findings)
    if (f.is_warning)
      notes.push_back(f.limit == model::limits::friction_table.id
                          ? record::note::beyond_range(f.text)
                          : record::note::over_limit(f.text));
  return notes;
}

std::vector<record::Note> said_of(const model::Findings& findings) {
  std::vector<record::Note> notes = warnings_said(findings);
  append(notes, notes_of(record::note::load_limit, model::notes_of(findings)));
  return notes;
}

Findings judge(const model::Model& model, std::span<const shaft::ShaftPoint> points,
               std::span<const shaft::ShaftPrediction> predictions) {
  Judge judge(model);
  const double mounted = mounted_preload(model);
  const std::size_t count = model.shaft->arrangement.bearings().size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < points.size(); ++k) {
      const bearing::ArrangementEquilibrium& e = predictions[k].equilibrium;
      if (e.bearings.size() != count) continue;
      const bearing::BearingInSet& b = e.bearings[i];
      const bearing::OperatingPoint point{.speed = points[k].speed,
                                          .axial_load = points[k].external_load,
                                          .temperature = points[k].temperature};
      const auto rings = model.shaft->temperatures.value_or(bearing::SetTemperatures());
      judge.look(*model.shaft->arrangement.bearings()[i].bearing, place_of(model, i), point,
                 {.axial_load = b.axial_load,
                  .radial_load = 0.0,
                  .inner_pressure = b.inner_pressure,
                  .outer_pressure = b.outer_pressure,
                  .inner_ring_temperature = rings.inner_ring,
                  .outer_ring_temperature = rings.outer_ring});
      if (i == 0) judge.look_at_preload(point, e.front_force, e.rear_force, mounted);
    }
  return judge.findings();
}

JudgedColumns::JudgedColumns(const model::Model& model, const std::vector<std::string>& names)
    : model_(&model) {
  const auto place = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  if (model.bearing.rollers()) return;
  const std::size_t count = model.shaft ? model.shaft->arrangement.bearings().size() : 1;
  for (std::size_t i = 0; i < count; ++i) {
    OfBearing b{.place = place_of(model, i)};
    const std::string prefix = model.shaft ? b.place + "_" : std::string();
    b.lost = place(prefix + "lost_balls");
    b.inner = place(prefix + "inner_contact_pressure_MPa");
    b.outer = place(prefix + "outer_contact_pressure_MPa");
    b.load = place(prefix + "axial_load_N");
    b.least = place("inner_contact_angle_min_deg");
    b.largest = place("inner_contact_angle_max_deg");
    bearings_.push_back(std::move(b));
  }
  if (!model.shaft) return;
  front_ = place("front_force_N"), rear_ = place("rear_force_N");
  mounted_ = mounted_preload(model);
}

void JudgedColumns::look(const bearing::OperatingPoint& p, std::span<const double> row,
                         Judge& judge) const {
  if (model_->bearing.rollers())
    return judge.look_at_speed(model_->bearing.pitch_diameter(), false, "", p);
  for (std::size_t i = 0; i < bearings_.size(); ++i) {
    const OfBearing& b = bearings_[i];
    judge.look(model_->shaft ? *model_->shaft->arrangement.bearings()[i].bearing : *model_->bearing,
               b.place, p,
               {.axial_load = model_->shaft ? at(row, b.load) : p.axial_load,
                .radial_load = p.radial_load,
                .lost_balls = at(row, b.lost),
                .inner_pressure = at(row, b.inner),
                .outer_pressure = at(row, b.outer),
                .least_inner_angle = at(row, b.least),
                .largest_inner_angle = at(row, b.largest)});
  }
  if (model_->shaft) judge.look_at_preload(p, at(row, front_), at(row, rear_), mounted_);
}

Findings judge(const model::Model& model, const friction::StribeckTable& table) {
  Judge judge(model);
  const JudgedColumns columns(model, table.columns);
  for (std::size_t k = 0; k < table.points(); ++k)
    columns.look(table.point(table.first() + k), table.row(k), judge);
  return judge.findings();
}

Findings judge(const model::Model& model, std::span<const results::SteadyState> states) {
  if (model.spindle->network) return {};
  Judge judge(model);
  const double mounted = mounted_preload(model);
  for (const results::SteadyState& s : states) {
    if (!s.report.converged()) continue;
    const std::size_t balls = model.shaft->arrangement.bearings().size();
    for (std::size_t k = 0; k < std::min(balls, s.moment.bearings.size()); ++k) {
      bearing::ContactPressure pressures;
      if (k < s.bearings.size())
        pressures = {.inner = s.bearings[k].inner_pressure, .outer = s.bearings[k].outer_pressure};
      judge_running(model, k, s.inputs, s.moment.bearings[k], pressures, judge);
    }
    judge_rollers(model, s.inputs, s.moment, judge);
    judge.look_at_preload({.speed = s.inputs.speed}, s.moment.front_force, s.moment.rear_force,
                          mounted);
  }
  return judge.findings();
}

Findings judge(const model::Model& model, std::span<const spindle::ProfileRow> profile,
               const spindle::Run& run) {
  if (model.spindle->network || run.moments.empty()) return {};
  Judge judge(model);
  const double mounted = mounted_preload(model);
  const auto bearings = model.shaft->arrangement.bearings();
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    const auto force = [&](const spindle::Moment& m) {
      return i < m.bearings.size() ? m.bearings[i].force + m.bearings[i].radial_force : 0.0;
    };
    const auto most = std::max_element(
        run.moments.begin(), run.moments.end(),
        [&](const spindle::Moment& a, const spindle::Moment& b) { return force(a) < force(b); });
    for (auto m = run.moments.begin(); m != run.moments.end(); ++m) {
      const spindle::Inputs& inputs =
          profile[static_cast<std::size_t>(m - run.moments.begin())].inputs;
      if (i >= m->bearings.size()) continue;
      judge_running(model, i, inputs, m->bearings[i],
                    m == most
                        ? pressure_under(model, *bearings[i].bearing, inputs.speed, m->bearings[i])
                        : bearing::ContactPressure{},
                    judge);
    }
  }
  for (std::size_t k = 0; k < run.moments.size(); ++k) {
    judge_rollers(model, profile[k].inputs, run.moments[k], judge);
    judge.look_at_preload({.speed = profile[k].inputs.speed}, run.moments[k].front_force,
                          run.moments[k].rear_force, mounted);
  }
  return judge.findings();
}

Findings judge(const model::Model& model, const bearing::Arrangement& mounted,
               const results::DeflectionResult& result, Wording wording) {
  if (!result.converged()) return {};
  const double slope = std::abs(result.slope);
  if (slope > model::beam_limit) {
    const std::string force = named(wording, "--force", "force_N");
    throw text::InputError(fmt::format("{} = {:.6g} N: the slope of the nose would be {:.3g} rad; "
                                       "the linear beam model is valid up to {:g} rad",
                                       force, result.force, slope, model::beam_limit),
                           {.key = force});
  }
  Judge judge(model);
  for (std::size_t i = 0; i < result.shaft.bearings.size(); ++i) {
    const bearing::Bearing& b = *mounted.bearings()[i].bearing;
    const bearing::BearingEquilibrium& e = result.shaft.bearings[i];
    const bearing::ContactPressure pressure = largest_pressure(b, e);
    const bearing::Vector5& load = result.shaft.loads[i];
    judge.look(b, place_of(model, i),
               {.speed = result.speed,
                .axial_load = load[0],
                .temperature = mounted.design().mounting_temperature},
               {.axial_load = load[0],
                .radial_load = std::hypot(load[1], load[2]),
                .inner_pressure = pressure.inner,
                .outer_pressure = pressure.outer});
  }
  if (result.sets.converged())
    judge.look_at_preload({.speed = result.speed}, result.sets.equilibrium.front_force,
                          result.sets.equilibrium.rear_force, mounted.preload());
  Findings findings = judge.findings();
  // No friction bends a shaft.
  std::erase_if(findings,
                [](const auto& f) { return f.limit == model::limits::friction_table.id; });
  if (slope > model::limits::nose_slope.value * mrad)
    findings.push_back(
        model::finding(model::limits::nose_slope, slope / mrad,
                       fmt::format("the slope of the nose is {:.3g} mrad, above {:g} mrad: at "
                                   "this slope, the bearings are tilted beyond their limit",
                                   slope / mrad, model::limits::nose_slope.value)));
  return findings;
}

std::vector<record::Note> states_not_counted(const model::Model& model) {
  if (model.law != friction::FrictionLaw::table) return {};
  return {record::note::limits(fmt::format(
      "for states outside the friction table {} ({}), the program uses the value at the edge of "
      "the table. This command does not count these states; use raceway spindle to count them",
      model.table->file, model.table->range()))};
}

Findings judge_speeds(const model::Model& model, std::span<const double> speeds) {
  Judge judge(model);
  for (const double speed : speeds)
    judge.look_at_speed(model.bearing.pitch_diameter(), model::has_ceramic_balls(model), "",
                        {.speed = speed});
  return judge.findings();
}

Findings judge(const model::Model& model, const record::Record& record) {
  Judge judge(model);
  if (!record.has(record::speed)) return {};
  const std::span<const double> speeds = record.values(record::speed);
  const bool measured = record.has(record::temperature);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    bearing::OperatingPoint point{.speed = speeds[i]};
    if (measured && std::isfinite(record.values(record::temperature)[i]))
      point.temperature = record.values(record::temperature)[i];
    judge.look_at_speed(model.bearing.pitch_diameter(), model::has_ceramic_balls(model), "", point);
  }
  if (!model.shaft)
    for (const model::Row& row : model::rows_of(record))
      judge.look_at_table("", row.point, row.point.axial_load,
                          std::hypot(row.point.radial_load, row.point.radial_load_z));
  return judge.findings();
}

namespace {

[[noreturn]] void refuse(const std::string& name, double value, double lower, double upper,
                         const char* unit, const std::string& why) {
  throw text::InputError(fmt::format("{} = {:.6g} {}: must be from {:.6g} to {:.6g} {}; {}", name,
                                     value, unit, lower, upper, unit, why),
                         {.key = name});
}

}  // namespace

void require_possible_speed(const model::Model& model, double speed, const std::string& name) {
  const model::Possible possible = possible_speeds(model);
  if (speed > possible.upper)
    refuse(name, speed / rpm, 0.0, std::floor(possible.upper / rpm), "rpm", possible.why);
}

void require_possible_temperature(const model::Model& model, double temperature,
                                  const std::string& name) {
  const model::Possible possible = model::possible_temperatures(model.lubricant);
  if (temperature < possible.lower)
    refuse(name, celsius(temperature), std::ceil(celsius(possible.lower)),
           text::temperature_range.upper, "C", possible.why);
}

void require_possible(const model::Model& model, const record::Record& record) {
  const auto look = [&](const record::Channel& channel, auto require) {
    if (!record.has(channel)) return;
    const std::span<const double> values = record.values(channel);
    // The first row at each end; NaN is neither.
    std::size_t least = values.size(), most = values.size();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isnan(values[i])) continue;
      if (least == values.size() || values[i] < values[least]) least = i;
      if (most == values.size() || values[i] > values[most]) most = i;
    }
    for (const std::size_t i : {least, most}) {
      if (i == values.size()) continue;
      try {
        require(values[i]);
      } catch (const text::InputError& e) {
        throw text::InputError(
            fmt::format("{}: {}: {}", record.source, record.place(i), e.what()),
            {.file = record.source, .line = record.line(i), .key = std::string(channel.name)});
      }
    }
  };
  look(record::speed, [&](double v) { require_possible_speed(model, v, "speed_rpm"); });
  look(record::temperature,
       [&](double v) { require_possible_temperature(model, v, "temperature_C"); });
  if (!model.spindle) return;
  const std::vector<model::Coolant> channels = model.spindle->channels();
  const bool water = std::any_of(channels.begin(), channels.end(), [&](const model::Coolant& c) {
    const bool follows = &c == channels.data() || std::isnan(c.inlet_temperature);
    return follows && c.fluid == model::Fluid::water;
  });
  if (!water) return;
  for (const record::Column& column : record.columns)
    if (column.channel->name == "coolant_inlet_temperature_C")
      look(*column.channel, [&](double v) {
        if (v < model::water_freezes || v > model::water_boils)
          refuse(std::string(column.channel->name), celsius(v), celsius(model::water_freezes),
                 celsius(model::water_boils), "C", "outside this range, water freezes or boils");
      });
}

}  // namespace raceway::session
