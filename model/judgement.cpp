#include "model/judgement.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "bearing/contact_pressure.h"
#include "bearing/seat.h"
#include "friction/palmgren.h"

namespace raceway::model {
namespace {

/// Distance of a value from its limit, divided by the limit: a measure for bearings of all sizes.
double excess(double value, double limit) {
  return limit == 0.0 ? value : (value - limit) / std::abs(limit);
}

constexpr double strength_of_rings = 2e9;          // [Pa]
constexpr double solid_oil = 1e7 * mm2_per_s;      // [m²/s]
constexpr double coldest = 50.0, hottest = 800.0;  // at which anything is asked [K]

double static_load(const bearing::Bearing& bearing, const JudgedBearing& state) {
  friction::BearingState<> s;
  s.bearing = &bearing;
  s.axial_load = state.axial_load;
  s.radial_load = state.radial_load;
  return friction::static_equivalent_load(s);
}

/// n d_m as catalogues print it [mm/min].
double speed_factor_of(double speed, double pitch_diameter) {
  return speed / rpm * pitch_diameter / mm;
}

const Limit& speed_limit_of(const Model& model) {
  return model.supply == friction::Supply::grease ? limits::speed_factor_grease
                                                  : limits::speed_factor;
}

std::string_view lubrication(const Model& model) {
  return model.supply == friction::Supply::grease ? "grease" : "oil";
}

/// Temperature below which an oil is stiffer than this [K]; the coldest where it never is.
double temperature_of(const friction::Lubricant& lubricant, double viscosity) {
  double low = coldest, high = kelvin(40);
  if (lubricant.kinematic_viscosity(low) <= viscosity) return low;
  while (high - low > 0.001) {
    const double middle = 0.5 * (low + high);
    (lubricant.kinematic_viscosity(middle) > viscosity ? low : high) = middle;
  }
  return high;
}

}  // namespace

bool has_ceramic_balls(const bearing::Bearing& bearing) {
  return bearing.balls().density < 0.7 * bearing.rings().density;
}

bool has_ceramic_balls(const Model& model) {
  const bearing::Bearing* const balls = model.bearing.ball_bearing();
  return balls && has_ceramic_balls(*balls);
}

Finding finding(const Limit& limit, double value, std::string text) {
  return {.limit = limit.id,
          .is_warning = limit.is_warning,
          .value = value,
          .allowed = limit.value,
          .unit = limit.unit,
          .text = std::move(text)};
}

std::vector<std::string> warnings_of(const Findings& findings) {
  std::vector<std::string> lines;
  for (const Finding& f : findings)
    if (f.is_warning) lines.push_back(f.text);
  return lines;
}

std::vector<std::string> notes_of(const Findings& findings) {
  std::vector<std::string> lines;
  for (const Finding& f : findings)
    if (!f.is_warning) lines.push_back(f.text);
  return lines;
}

Judge::Judge(const Model& model)
    : model_(&model),
      stiff_below_(temperature_of(model.lubricant, limits::oil_stiff.value * mm2_per_s)) {}

void Judge::Worst::look(double value_here, double limit_here, const std::string& place_here,
                        const bearing::OperatingPoint& point_here) {
  if (!(value_here > limit_here)) return;
  ++points;
  if (points > 1 && !(excess(value_here, limit_here) > excess(value, limit))) return;
  value = value_here;
  limit = limit_here;
  place = place_here;
  point = point_here;
}

void Judge::Worst::add(const Worst& other) {
  const bool is_worse =
      other.points > 0 && (points == 0 || excess(other.value, other.limit) > excess(value, limit));
  const std::size_t both = points + other.points;
  if (is_worse) *this = other;
  points = both;
}

void Judge::add(const Judge& other) {
  constexpr std::array all{&Judge::lost_,     &Judge::little_load_, &Judge::load_,
                           &Judge::pressure_, &Judge::bottom_,      &Judge::far_,
                           &Judge::running_,  &Judge::catalogue_,   &Judge::speed_factor_,
                           &Judge::ring_,     &Judge::preload_,     &Judge::stiff_,
                           &Judge::hot_,      &Judge::table_};
  for (Worst Judge::*const worst : all) (this->*worst).add(other.*worst);
  if (std::isnan(mounted_)) mounted_ = other.mounted_;
  points_ += other.points_;
  turning_ += other.turning_;
}

void Judge::look(const bearing::Bearing& bearing, const std::string& place,
                 const bearing::OperatingPoint& point, const JudgedBearing& state) {
  ++points_;
  lost_.look(state.lost_balls, 0.0, place, point);
  little_load_.look(-state.axial_load, -state.minimum_load, place, point);
  load_.look(static_load(bearing, state), bearing.geometry().static_load_rating, place, point);
  const double pressure = std::fmax(state.inner_pressure, state.outer_pressure);
  pressure_.look(pressure, bearing::static_limit_pressure, place, point);
  const double angle = bearing.geometry().contact_angle;
  switch (bearing::seat(state.least_inner_angle, state.largest_inner_angle, angle)) {
    case bearing::Seat::shoulder:
      break;
    case bearing::Seat::groove_bottom:
      bottom_.look(std::fmax(bearing::seating_load(state.radial_load, angle),
                             std::numeric_limits<double>::min()),
                   0.0, place, point);
      break;
    case bearing::Seat::far_side:
      far_.look(-state.least_inner_angle, 0.0, place, point);
      break;
  }
  if (point.speed > 0.0)
    running_.look(pressure, limits::running_pressure.value * GPa, place, point);
  look_at_rings(place, point, state.inner_ring_temperature, state.outer_ring_temperature);
  look_at_table(place, point, state.axial_load, state.radial_load);
  look_at_speed(bearing.geometry().pitch_diameter, has_ceramic_balls(bearing), place, point);
}

void Judge::look_at_rings(const std::string& place, const bearing::OperatingPoint& point,
                          double inner_ring_temperature, double outer_ring_temperature) {
  ring_.look(std::fmax(inner_ring_temperature, outer_ring_temperature),
             kelvin(limits::ring_temperature.value), place, point);
}

void Judge::look_at_speed(double pitch_diameter, bool ceramic, const std::string& place,
                          const bearing::OperatingPoint& point) {
  const double more = ceramic ? limits::ceramic_speed_factor : 1.0;
  const double printed = model_->supply == friction::Supply::grease ? model_->printed_speed.grease
                                                                    : model_->printed_speed.oil;
  if (printed > 0.0) catalogue_.look(point.speed, more * printed, place, point);
  speed_factor_.look(speed_factor_of(point.speed, pitch_diameter),
                     more * speed_limit_of(*model_).value, place, point);
  stiff_.look(-point.temperature, -stiff_below_, place, point);
  hot_.look(point.temperature, kelvin(limits::oil_hot.value), place, point);
}

void Judge::look_at_table(const std::string& place, const bearing::OperatingPoint& point,
                          double axial_load, double radial_load) {
  if (model_->law != friction::FrictionLaw::table || !(point.speed > 0.0)) return;
  ++turning_;
  friction::BearingState<> state;
  state.speed = point.speed;
  state.axial_load = axial_load;
  state.radial_load = std::fmax(0.0, radial_load);
  state.temperature = point.temperature;
  if (!std::isfinite(axial_load) || model_->table->holds(state)) return;
  bearing::OperatingPoint at = point;
  at.axial_load = axial_load, at.radial_load = state.radial_load;
  table_.look(point.speed * model_->law_values.front() * model_->table->moment(state), 0.0, place,
              at);
}

void Judge::look_at_preload(const bearing::OperatingPoint& point, double front_force,
                            double rear_force, double mounted) {
  mounted_ = mounted;
  // An external load presses one set and frees the other: preload is what both carry.
  preload_.look(std::fmin(front_force, rear_force) / mounted, limits::preload_factor.value, "",
                point);
}

std::string Judge::where(const Worst& worst) const {
  std::string text =
      fmt::format("{:.6g} rpm, {:.6g} N axial", worst.point.speed / rpm, worst.point.axial_load);
  if (worst.place.empty()) text += fmt::format(", {:.6g} N radial", worst.point.radial_load);
  if (!worst.place.empty()) text = fmt::format("{} at {}", worst.place, text);
  return points_ == 1 ? std::string() : " at " + text;
}

std::string Judge::before(const Worst& worst) const {
  if (points_ == 1) return {};
  return worst.place.empty()
             ? fmt::format("{:.6g} rpm: ", worst.point.speed / rpm)
             : fmt::format("{} at {:.6g} rpm: ", worst.place, worst.point.speed / rpm);
}

Finding Judge::finding_of(const Limit& limit, const Worst& worst, double unit, std::string text,
                          double offset) const {
  return {.limit = limit.id,
          .is_warning = limit.is_warning,
          .place = worst.place,
          .value = (worst.value - offset) / unit,
          .allowed = (worst.limit - offset) / unit,
          .unit = limit.unit,
          .speed = worst.point.speed,
          .points = worst.points,
          .text = std::move(text)};
}

void Judge::add_notes(Findings& findings) const {
  constexpr Limit lost{"lost_balls", 0.0, "balls", false};
  constexpr Limit bottom{"groove_bottom", unset, "N", false};
  constexpr Limit far_side{"far_side", unset, "deg", false};
  const auto count = [&](const Worst& worst) {
    return points_ == 1 ? std::string() : fmt::format("{} of {} points: ", worst.points, points_);
  };
  const auto add = [&](const Limit& limit, const Worst& worst, double unit, std::string text) {
    if (worst.points > 0)
      findings.push_back(
          finding_of(limit, worst, unit, count(worst) + std::move(text) + where(worst)));
  };
  add(lost, lost_, 1.0,
      fmt::format("{}{:.0f} ball{} lost contact with the inner race", points_ == 1 ? "" : "up to ",
                  lost_.value, lost_.value == 1.0 ? " has" : "s have"));
  if (little_load_.points > 0)
    findings.push_back(finding_of(
        limits::minimum_load, little_load_, -1.0,
        fmt::format(
            "{}{}the axial load of {:.4g} N is below the minimum load of {:.4g} N, so balls "
            "may skid",
            count(little_load_), before(little_load_), -little_load_.value, -little_load_.limit)));
  add(bottom, bottom_, 1.0,
      fmt::format("without an axial load, the balls run at the bottom of the grooves, at a contact "
                  "angle of about 0 deg; an axial load of {:.3g} N would press half of the balls "
                  "against the shoulders",
                  bottom_.value));
  add(far_side, far_, degree,
      fmt::format("balls run beyond the bottom of the inner groove, at a contact angle of {:.3g} "
                  "deg, on the side without a shoulder: the bearing needs more axial load",
                  -far_.value / degree));
  add(limits::static_load, load_, 1.0,
      fmt::format("the static equivalent load reaches {:.4g} N, above C0 = {:.6g} N", load_.value,
                  load_.limit));
  add(limits::static_pressure, pressure_, GPa,
      fmt::format(
          "the contact pressure reaches {:.3g} GPa; above 4.2 GPa the balls leave permanent dents",
          pressure_.value / GPa));
}

void Judge::add_speeds(Findings& findings) const {
  if (catalogue_.points > 0)
    findings.push_back(finding_of(
        limits::catalogue_speed, catalogue_, rpm,
        fmt::format("{}{:.6g} rpm is above {:.6g} rpm, the catalogue limit for {} lubrication and "
                    "one bearing with spring preload; rigid sets have a lower limit",
                    catalogue_.place.empty() ? "" : catalogue_.place + ": ",
                    catalogue_.point.speed / rpm, catalogue_.limit / rpm, lubrication(*model_))));
  if (speed_factor_.points > 0)
    findings.push_back(finding_of(
        limits::speed_factor, speed_factor_, 1.0,
        fmt::format("{}the speed factor n d_m of {:.3g} mm/min is above {:.3g} mm/min, "
                    "the limit of the fastest bearings of the catalogue with {} "
                    "lubrication: the friction law is far outside the range of its measurements",
                    before(speed_factor_), speed_factor_.value, speed_factor_.limit,
                    lubrication(*model_))));
}

void Judge::add_heat(Findings& findings) const {
  if (ring_.points > 0)
    findings.push_back(finding_of(
        limits::ring_temperature, ring_, 1.0,
        fmt::format("{}the ring temperature is {:.4g} C, above {:.4g} C: grease and oil age fast. "
                    "Less preload, speed or oil, or more cooling lowers the temperature",
                    before(ring_), celsius(ring_.value), limits::ring_temperature.value),
        celsius_zero));
  if (preload_.points > 0)
    findings.push_back(
        finding_of(limits::preload_factor, preload_, 1.0,
                   fmt::format("{:.6g} rpm: the preload is {:.4g} N, {:.3g} times the mounted "
                               "preload of {:.4g} N (limit: {:g} times): speed, and heat in a "
                               "warm spindle, press the sets together. Springs keep the preload "
                               "nearly constant",
                               preload_.point.speed / rpm, preload_.value * mounted_,
                               preload_.value, mounted_, limits::preload_factor.value)));
  if (stiff_.points > 0) {
    const double viscosity =
        model_->lubricant.kinematic_viscosity(stiff_.point.temperature) / mm2_per_s;
    Finding stiff =
        finding_of(limits::oil_stiff, stiff_, 1.0,
                   fmt::format("{}the viscosity of the oil is {:.3g} mm2/s at {:.4g} C, above {:g} "
                               "mm2/s: near its pour point, little oil reaches the contacts",
                               before(stiff_), viscosity, celsius(stiff_.point.temperature),
                               limits::oil_stiff.value));
    stiff.value = viscosity, stiff.allowed = limits::oil_stiff.value;
    findings.push_back(std::move(stiff));
  }
  if (hot_.points > 0)
    findings.push_back(
        finding_of(limits::oil_hot, hot_, 1.0,
                   fmt::format("{}the lubricant temperature is {:.4g} C, above {:.4g} C: the rings "
                               "change their size and the oil decomposes",
                               before(hot_), celsius(hot_.value), limits::oil_hot.value),
                   celsius_zero));
}

Findings Judge::findings() const {
  Findings findings;
  add_notes(findings);
  if (running_.points > 0)
    findings.push_back(finding_of(
        limits::running_pressure, running_, GPa,
        fmt::format("{}the contact pressure of the running bearing is {:.3g} GPa, above {:g} GPa: "
                    "the raceways can fatigue. Less load or preload lowers the pressure",
                    before(running_), running_.value / GPa, limits::running_pressure.value)));
  if (table_.points > 0) {
    const bearing::OperatingPoint& at = table_.point;
    const double torque = table_.value / at.speed;
    Finding beyond = finding_of(
        limits::friction_table, table_, at.speed * N_mm,
        fmt::format("{} of {} calculated points with rotation are outside the friction table {} "
                    "({}); for these points, the program uses the value at the edge of the table. "
                    "The point with the most heat is at {}{:.6g} rpm, {:.4g} N axial, {:.4g} N "
                    "radial, {:.4g} C; for this point, the program uses {:.4g} N mm",
                    table_.points, turning_, model_->table->file, model_->table->range(),
                    table_.place.empty() ? "" : table_.place + ", ", at.speed / rpm, at.axial_load,
                    at.radial_load, celsius(at.temperature), torque / N_mm));
    beyond.allowed = unset;  // a range of several axes
    findings.push_back(std::move(beyond));
  }
  add_speeds(findings);
  add_heat(findings);
  return findings;
}

Possible possible_speeds(const Model& model) {
  double most = std::numeric_limits<double>::infinity(), diameter = unset;
  const auto limit = [&](double inner_diameter, double density) {
    const double speed = std::sqrt(strength_of_rings / density) / (0.5 * inner_diameter);
    if (!(speed < most)) return;
    most = speed;
    diameter = inner_diameter;
  };
  const auto look = [&](const bearing::Bearing& b) {
    const bearing::BearingGeometry& g = b.geometry();
    limit(g.pitch_diameter - g.ball_diameter * std::cos(g.contact_angle), b.rings().density);
  };
  if (const bearing::Bearing* const balls = model.bearing.ball_bearing()) look(*balls);
  if (model.shaft)
    for (const bearing::MountedBearing& m : model.shaft->arrangement.bearings()) look(*m.bearing);
  if (const bearing::RollerBearing* const rollers = model.bearing.rollers())
    limit(rollers->geometry().pitch_diameter - rollers->geometry().roller_diameter,
          rollers->rings().density);
  return {.lower = 0.0,
          .upper = most,
          .why = fmt::format("above the upper limit, the inner ring bursts (hoop stress of 2 GPa "
                             "at a diameter of {:.4g} mm)",
                             diameter / mm)};
}

Possible possible_temperatures(const friction::Lubricant& lubricant) {
  const double lowest = temperature_of(lubricant, solid_oil);
  return {.lower = lowest,
          .upper = hottest,
          .why = lowest > coldest ? "below the lower limit, this oil is solid (1e7 mm2/s)" : ""};
}

}  // namespace raceway::model
