#include "results/results.h"

#include <cmath>
#include <optional>
#include <utility>

#include "bearing/contact_pressure.h"
#include "bearing/frequencies.h"
#include "bearing/seat.h"
#include "bearing/shoulder.h"
#include "model/bearing_life.h"
#include "record/units.h"
#include "results/detail/model_objects.h"
#include "text/units.h"

namespace raceway::results {
namespace {

text::json effect_page(const effects::Description& d) {
  text::json needs = text::json::array();
  for (const effects::Need need : d.needs) needs.push_back(effects::text(need));
  for (const record::Channel* channel : d.channels) needs.push_back(effects::text(*channel));
  text::json supplies = text::json::array();
  for (const friction::Supply supply : d.supplies) supplies.push_back(friction::name(supply));
  text::json parameters = text::json::object();
  for (const effects::Parameter& p : d.parameters)
    parameters[std::string(p.name)] = {
        {"unit", p.unit},
        {"initial", p.initial},
        {"lower", p.lower},
        {"upper", p.upper},
        {"usual_lower", p.plausible_lower},
        {"usual_upper", p.plausible_upper},
        {"usual_goes_with_pitch_diameter_to_the", std::isnan(p.neutral) ? 0.0 : d.size_power},
        {"no_effect_at", p.neutral}};
  text::json measured = text::json::array();
  if (d.moves(effects::Form::rig) || d.moves(effects::Form::shaft, record::friction_torque))
    measured.push_back(record::friction_torque.variable);
  if (d.moves(effects::Form::shaft) || d.of_spindles_alone())
    measured.push_back(record::axial_displacement.variable);
  text::json forms = text::json::array();
  for (const effects::Form form : effects::all_the_forms)
    if (d.belongs_to(form)) forms.push_back(effects::name(form));
  return {{"id", d.id},
          {"title", d.title},
          {"kind", d.datum.empty() ? "physics" : "data"},
          {"acts_at", d.step()},
          {"acts_on", measured},
          {"acts_in", forms},
          {"mechanism", d.mechanism},
          {"formula", d.formula},
          {"source", d.source},
          {"parameters", parameters},
          {"needs", needs},
          {"supplies", supplies},
          {"within_contact_law",
           d.within_contacts.empty() ? text::json() : text::json(d.within_contacts)},
          {"needs_equilibrium", d.needs_equilibrium},
          {"confused_with", d.confused_with}};
}

text::json contact_json(const std::optional<friction::contact::ContactFriction>& c) {
  if (!c) return nullptr;
  return {{"film_um", {{"central", c->film.central / um}, {"minimum", c->film.minimum / um}}},
          {"lambda", c->film_ratio},
          {"asperity_share", c->asperity_share},
          {"pressure_GPa", c->peak_pressure / GPa},
          {"ellipse_um", text::json::array({c->semi_major_axis / um, c->semi_minor_axis / um})},
          {"spin_rad_s", c->spin},
          {"spin_to_roll",
           c->rolling_speed != 0.0 ? text::json(c->spin / c->rolling_speed) : text::json()},
          {"slip_m_s", c->mean_slip},
          {"mu_mean", c->mean_friction},
          {"sliding_W", c->sliding},
          {"rolling_W", c->rolling},
          {"hysteresis_W", c->hysteresis}};
}

/// β of ball k [rad]; NaN where it touches no race.
double pitch_angle(const bearing::Bearing& bearing, const bearing::BearingEquilibrium& e,
                   std::size_t k, const bearing::EquilibriumOptions& solver) {
  if (std::isnan(e.balls[k].outer_contact_angle)) return unset;
  return e.speeds(k, bearing, 1.0, solver.race_control).pitch_angle;
}

std::string_view race_control(const model::Model& model) {
  if (model.balanced_balls) return "balanced";
  return model.solver.race_control == bearing::RaceControl::outer ? "outer" : "inner";
}

/// Life, film and frequencies, as far as they hold for the bearing as a whole.
void add_life_and_film(text::json& document, const model::Model& model,
                       const bearing::OperatingPoint& point, const model::FrictionPrediction& f) {
  add_life(document, model, bearing_life(model, point, f));
  if (f.contacts) {
    document["holding_coefficient"] = f.contacts->holding_coefficient;
    document["drag_W"] = f.contacts->drag * point.speed;
  }
  add_frequencies(
      document,
      running_frequencies(bearing_of(model, f), *f.equilibrium, model.solver.race_control),
      point.speed, "ball_spin");
}

/// What the shoulders leave of the contact ellipses; null where none is given.
text::json shoulder_json(const bearing::Bearing& bearing, const bearing::BearingEquilibrium& e) {
  const bearing::PermissibleLoads load = permissible_axial_loads(bearing);
  if (std::isnan(load.least())) return nullptr;
  const bearing::ShoulderMargins left = shoulder_margins(bearing, e);
  const auto race = [&](bearing::Race which, double margin, double cut, double permissible) {
    const double angle = shoulder_angle(bearing.geometry(), which);
    if (std::isnan(angle)) return text::json();
    return text::json{{"shoulder_angle_deg", angle / degree},
                      {"margin_deg", margin / degree},
                      {"cut_share", std::isnan(margin) ? text::json() : text::json(cut)},
                      {"permissible_axial_load_N",
                       std::isinf(permissible) ? text::json() : text::json(permissible)}};
  };
  return {{"inner", race(bearing::Race::inner, left.inner, left.inner_cut, load.inner)},
          {"outer", race(bearing::Race::outer, left.outer, left.outer_cut, load.outer)},
          {"permissible_axial_load_N",
           std::isinf(load.least()) ? text::json() : text::json(load.least())}};
}

}  // namespace

std::string error_json(const std::string& message, const text::Place& place) {
  const auto known = [](const std::string& name) {
    return name.empty() ? text::json() : text::json(name);
  };
  return text::text({{"error",
                      {{"message", message},
                       {"file", known(place.file)},
                       {"line", place.line > 0 ? text::json(place.line) : text::json()},
                       {"key", known(place.key)}}}});
}

std::string solve_json(const model::Model& model, const bearing::OperatingPoint& point,
                       const bearing::BearingEquilibrium& e,
                       const model::FrictionPrediction& friction, const friction::HeatSplit& heat,
                       const BandOfResult* band, const model::Findings& findings) {
  text::json balls = text::json::array();
  const bearing::Bearing& bearing = bearing_of(model, friction);
  std::vector<friction::contact::BallFriction> contacts;
  if (friction.contacts) contacts = ball_contacts(model, point, friction);
  for (std::size_t k = 0; k < e.balls.size(); ++k) {
    const bearing::BallEquilibrium b = e.balls[k];
    balls.push_back({{"azimuth_deg", b.azimuth / degree},
                     {"inner_contact_angle_deg", b.inner_contact_angle / degree},
                     {"outer_contact_angle_deg", b.outer_contact_angle / degree},
                     {"inner_load_N", b.inner_load},
                     {"outer_load_N", b.outer_load},
                     {"centrifugal_force_N", b.centrifugal_force},
                     {"gyroscopic_moment_Nmm", b.gyroscopic_moment / N_mm},
                     {"pitch_angle_deg", pitch_angle(bearing, e, k, model.solver) / degree}});
    if (contacts.empty()) continue;
    balls.back()["inner"] = contact_json(contacts[e.balls.twin(k)].inner);
    balls.back()["outer"] = contact_json(contacts[e.balls.twin(k)].outer);
  }
  text::json matrix = text::json::array();
  for (int i = 0; i < 5; ++i) {
    text::json row = text::json::array();
    for (int j = 0; j < 5; ++j) row.push_back(e.stiffness(i, j));
    matrix.push_back(row);
  }
  const auto& u = e.displacement;
  const bearing::ContactPressure pressure = largest_pressure(bearing, e);
  text::json seat;
  if (e.report.converged() && bearing.geometry().contact_angle > 0.0)
    seat = bearing::name(bearing::seat(e, bearing.geometry()));
  text::json document = {
      {"bearing", model.name},
      {"speed_rpm", point.speed / rpm},
      {"axial_load_N", point.axial_load},
      {"radial_load_N", point.radial_load},
      {"temperature_C", celsius(point.temperature)},
      {"race_control", race_control(model)},
      {"axial_displacement_um", u[0] / um},
      {"radial_displacement_um", std::hypot(u[1], u[2]) / um},
      {"radial_displacement_y_um", u[1] / um},
      {"radial_displacement_z_um", u[2] / um},
      {"tilt_y_mrad", u[3] / mrad},
      {"tilt_z_mrad", u[4] / mrad},
      {"lost_balls", e.report.converged() ? text::json(e.lost_balls()) : text::json(nullptr)},
      {"seat", seat},
      {"shoulder", shoulder_json(bearing, e)},
      {"inner_contact_pressure_MPa", pressure.inner / MPa},
      {"outer_contact_pressure_MPa", pressure.outer / MPa},
      {"balls", balls},
      {"stiffness",
       {{"axial_N_um", e.stiffness(0, 0) / N_per_um},
        {"radial_N_um", e.stiffness(1, 1) / N_per_um},
        {"matrix", matrix}}},
      {"friction", friction_json(model, friction)},
      {"friction_torque_Nmm", friction.torque / N_mm},
      {"power_loss_W", friction.power_loss},
      {"inner_ring_heat_W", heat.inner},
      {"outer_ring_heat_W", heat.outer},
      {"judgement", judgement_json(findings)},
      {"report", report_json(e.report)}};
  if (e.report.converged()) add_life_and_film(document, model, point, friction);
  add_band(document, band);
  return text::text(std::move(document));
}

std::string table_json(const model::Model& model, const friction::StribeckTable& table,
                       const BandOfResult* band, const model::Findings& findings) {
  text::json rows = text::json::array();
  for (std::size_t i = 0; i < table.friction_moment.size(); ++i) {
    const bearing::OperatingPoint p = table.point(i);
    text::json row = {{"speed_rpm", p.speed / rpm},
                      {"axial_load_N", p.axial_load},
                      {"radial_load_N", p.radial_load},
                      {"temperature_C", celsius(p.temperature)},
                      {"friction_torque_Nmm", table.friction_moment[i] / N_mm}};
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      row[table.columns[c]] = table.row(i)[c] / text::column_unit(table.columns[c]);
    row["status"] = bearing::name(table.status[i]);
    rows.push_back(std::move(row));
  }
  text::json document = {
      {"bearing", model.name}, {"rows", rows}, {"judgement", judgement_json(findings)}};
  if (band) document["band"] = band_json(*band);
  return text::text(std::move(document));
}

std::string bearings_json(const std::vector<files::CatalogueBearing>& rows) {
  text::json bearings = text::json::array();
  for (const files::CatalogueBearing& r : rows)
    bearings.push_back({{"name", r.full_name()},
                        {"bore_mm", r.geometry.bore / mm},
                        {"outer_diameter_mm", r.geometry.outer_diameter / mm},
                        {"pitch_diameter_mm", r.geometry.pitch_diameter / mm},
                        {"ball_diameter_mm", r.geometry.ball_diameter / mm},
                        {"ball_count", r.geometry.ball_count},
                        {"contact_angle_deg", r.geometry.contact_angle / degree},
                        {"static_load_rating_N", r.geometry.static_load_rating}});
  return text::text({{"bearings", bearings}});
}

namespace {

text::json card_page(const correction::EffectCard& card) {
  text::json parameters = text::json::object();
  for (const record::NumberCard& n : card.numbers)
    parameters[std::string(n.name)] = {{"unit", n.unit},
                                       {"initial", n.initial},
                                       {"lower", n.lower},
                                       {"upper", n.upper},
                                       {"no_effect_at", n.neutral}};
  return {{"id", card.id},
          {"title", card.title},
          {"acts_on", text::json::array({"displacement over time"})},
          {"formula", card.form},
          {"needs", card.needs},
          {"confused_with", card.confused},
          {"of_this_record_alone", card.of_reading},
          {"parameters", std::move(parameters)}};
}

}  // namespace

std::string effect_json(const effects::Description& effect) {
  return text::text(effect_page(effect));
}

std::string effects_json(std::span<const effects::Description> all,
                         std::span<const correction::EffectCard> of_records) {
  text::json pages = text::json::array();
  for (const effects::Description& effect : all) pages.push_back(effect_page(effect));
  for (const correction::EffectCard& card : of_records) pages.push_back(card_page(card));
  return text::text({{"effects", pages}});
}

}  // namespace raceway::results
