#include "results/beam_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "record/units.h"
#include "results/detail/model_objects.h"
#include "results/shaft_results.h"
#include "text/detail/csv_text.h"
#include "text/detail/json_text.h"
#include "text/printable.h"

namespace raceway::results {
namespace {

using bearing::Arrangement;
using bearing::Side;

constexpr double microradian = 1e-6;
constexpr double of_turn = 2.0 * pi;

/// A number of the sets at a speed by the name of its column, in the unit of that.
struct SetNumber {
  std::string name;
  double value;
};

double side_sum(const Arrangement& a, const ModesAtSpeed& m, Side side,
                double (*of)(const bearing::BearingEquilibrium&)) {
  double sum = 0.0;
  for (std::size_t i = 0; i < m.sets.bearings.size(); ++i)
    if (a.side(i) == side) sum += of(m.sets.bearings[i]);
  return sum;
}

/// Forces and stiffness, NaN where the sets have no balance; of each side, then of each bearing.
std::vector<SetNumber> set_numbers(const Arrangement& a, const ModesAtSpeed& m) {
  const bool known = m.sets.converged();
  const auto radial = [](const bearing::BearingEquilibrium& b) { return b.stiffness(1, 1); };
  const auto axial = [](const bearing::BearingEquilibrium& b) { return b.stiffness(0, 0); };
  std::vector<SetNumber> numbers{{"front_force_N", known ? m.sets.equilibrium.front_force : unset},
                                 {"rear_force_N", known ? m.sets.equilibrium.rear_force : unset}};
  for (const auto& [side, name] :
       {std::pair{Side::front, "front"}, std::pair{Side::rear, "rear"}}) {
    if (side == Side::rear && a.design().rear.empty()) continue;
    numbers.push_back({fmt::format("{}_radial_N_um", name),
                       known ? side_sum(a, m, side, radial) / N_per_um : unset});
    numbers.push_back({fmt::format("{}_axial_N_um", name),
                       known ? side_sum(a, m, side, axial) / N_per_um : unset});
  }
  for (std::size_t i = 0; i < a.bearings().size(); ++i) {
    const std::string place = bearing_place(a, i);
    const bearing::Matrix5 k =
        known ? m.sets.bearings[i].stiffness : bearing::Matrix5::Constant(unset);
    numbers.push_back(
        {place + "_force_N", known ? m.sets.equilibrium.bearings[i].axial_load : unset});
    numbers.push_back({place + "_radial_N_um", k(1, 1) / N_per_um});
    numbers.push_back({place + "_axial_N_um", k(0, 0) / N_per_um});
    numbers.push_back({place + "_tilt_Nm_rad", k(4, 4)});
    numbers.push_back(
        {place + "_coupling_N_rad", m.springs.empty() ? unset : m.springs[i].y.coupling});
    if (m.sets.moment) {
      const spindle::BearingState& warm = m.sets.moment->bearings[i];
      numbers.push_back(
          {place + "_inner_ring_temperature_C", celsius(warm.inner_ring_temperature)});
      numbers.push_back(
          {place + "_outer_ring_temperature_C", celsius(warm.outer_ring_temperature)});
    }
  }
  for (std::size_t i = 0; m.shaft && i < m.shaft->rollers.size(); ++i) {
    const std::string& name = m.roller_names[i];
    const bearing::RollerEquilibrium& e = m.shaft->rollers[i];
    numbers.push_back({name + "_clearance_um", e.clearance / um});
    numbers.push_back({name + "_radial_force_N", std::hypot(e.load[0], e.load[1])});
    numbers.push_back({name + "_radial_N_um", e.stiffness(0, 0) / N_per_um});
    numbers.push_back({name + "_tilt_Nm_rad", e.stiffness(3, 3)});
  }
  for (const auto& [name, per_turn] : m.rolling) {
    const double turns = m.speed / of_turn;
    numbers.push_back({name + "_cage_Hz", per_turn.cage * turns});
    numbers.push_back({name + "_outer_race_Hz", per_turn.outer_race * turns});
    numbers.push_back({name + "_inner_race_Hz", per_turn.inner_race * turns});
  }
  if (m.nose) {
    numbers.push_back({"nose_amplitude_um", m.nose->amplitude / um});
    numbers.push_back({"nose_lag_deg", m.nose->lag / degree});
  }
  return numbers;
}

void head(fmt::memory_buffer& out, std::string_view title, std::string_view source,
          std::string_view model_text) {
  fmt::format_to(std::back_inserter(out), "# {}: {}\n# raceway {}\n", title,
                 text::printable(source), RACEWAY_VERSION);
  text::append_model(out, model_text);
}

void cell(fmt::memory_buffer& out, double value) {
  text::append_value(out, value);
  out.push_back(',');
}

text::json bearing_json(const Arrangement& a, const spindle::LoadedShaft& shaft, std::size_t i) {
  const bearing::BearingEquilibrium& b = shaft.bearings[i];
  const bearing::Vector5& load = shaft.loads[i];
  double largest = 0.0, least = 1e300, steepest = unset, flattest = unset;
  for (const bearing::BallEquilibrium& ball : b.balls) {
    largest = std::max(largest, ball.inner_load);
    least = std::min(least, ball.inner_load);
    steepest = std::fmax(steepest, ball.inner_contact_angle);
    flattest = std::fmin(flattest, ball.inner_contact_angle);
  }
  text::json stiffness = text::json::array();
  for (int r = 0; r < 5; ++r) {
    text::json row = text::json::array();
    for (int c = 0; c < 5; ++c) row.push_back(b.stiffness(r, c));
    stiffness.push_back(std::move(row));
  }
  text::json balls = text::json::array();
  for (const bearing::BallEquilibrium& ball : b.balls)
    balls.push_back({{"azimuth_deg", ball.azimuth / degree},
                     {"inner_load_N", ball.inner_load},
                     {"outer_load_N", ball.outer_load},
                     {"inner_contact_angle_deg", ball.inner_contact_angle / degree},
                     {"outer_contact_angle_deg", ball.outer_contact_angle / degree}});
  return {{"place", bearing_place(a, i)},
          {"axial_load_N", load[0]},
          {"radial_load_N", std::hypot(load[1], load[2])},
          {"moment_Nm", std::hypot(load[3], load[4])},
          {"largest_inner_load_N", largest},
          {"least_inner_load_N", least},
          {"largest_inner_contact_angle_deg", steepest / degree},
          {"least_inner_contact_angle_deg", flattest / degree},
          {"lost_balls", b.lost_balls()},
          {"axial_stiffness_N_um", b.stiffness(0, 0) / N_per_um},
          {"radial_stiffness_N_um", b.stiffness(1, 1) / N_per_um},
          {"tilt_stiffness_Nm_rad", b.stiffness(4, 4)},
          {"stiffness_SI", std::move(stiffness)},
          {"balls", std::move(balls)}};
}

/// `before`: without the force.
text::json roller_json(const std::string& name, const bearing::RollerEquilibrium& e,
                       const bearing::RollerEquilibrium& before) {
  text::json stiffness = text::json::array(), rollers = text::json::array();
  for (int r = 0; r < 4; ++r) {
    text::json row = text::json::array();
    for (int c = 0; c < 4; ++c) row.push_back(e.stiffness(r, c));
    stiffness.push_back(std::move(row));
  }
  for (const bearing::LoadedRoller& r : e.rollers)
    rollers.push_back({{"azimuth_deg", r.azimuth / degree},
                       {"inner_load_N", r.inner_load},
                       {"outer_load_N", r.outer_load}});
  return {{"name", name},
          {"clearance_um", e.clearance / um},
          {"radial_load_N", std::hypot(e.load[0], e.load[1])},
          {"moment_Nm", std::hypot(e.load[2], e.load[3])},
          {"unloaded_radial_load_N", std::hypot(before.load[0], before.load[1])},
          {"loaded_rollers", e.loaded_rollers()},
          {"radial_stiffness_N_um", e.stiffness(0, 0) / N_per_um},
          {"unloaded_radial_stiffness_N_um", before.stiffness(0, 0) / N_per_um},
          {"tilt_stiffness_Nm_rad", e.stiffness(3, 3)},
          {"stiffness_SI", std::move(stiffness)},
          {"rollers", std::move(rollers)}};
}

text::json crossings_json(const std::vector<ModesAtSpeed>& speeds) {
  text::json list = text::json::array();
  for (const Crossing& c : crossings(speeds))
    list.push_back({{"excitation", c.excitation},
                    {"mode", c.mode},
                    {"whirl", spindle::name(c.whirl)},
                    {"speed_rpm", c.speed / rpm},
                    {"frequency_Hz", c.frequency / of_turn}});
  return list;
}

}  // namespace

std::string ModesAtSpeed::status() const {
  if (!sets.converged()) return std::string(spindle::name(sets.status));
  switch (modes.status) {
    case spindle::ModesStatus::converged:
      return "converged";
    case spindle::ModesStatus::not_held:
      return "not_held";
    case spindle::ModesStatus::not_run:
      return "not_run";
    case spindle::ModesStatus::not_converged:
      break;
  }
  return "not_converged";
}

std::string DeflectionResult::status() const {
  return std::string(sets.converged() ? bearing::name(shaft.report.status)
                                      : spindle::name(sets.status));
}

std::vector<Crossing> crossings(const std::vector<ModesAtSpeed>& speeds) {
  using spindle::Whirl;
  const auto in_sense = [](const ModesAtSpeed& m, Whirl sense) {
    std::vector<double> list;
    bool backward = true;  // the next one that stands
    for (const spindle::Mode& mode : m.modes.modes) {
      Whirl whirl = mode.whirl;
      if (whirl == Whirl::standing) {
        whirl = backward ? Whirl::backward : Whirl::forward;
        backward = !backward;
      }
      if (whirl == sense) list.push_back(mode.frequency);
    }
    return list;
  };
  // Frequencies per turn; of a bearing they follow its contact angles from speed to speed.
  const auto excitations = [](const ModesAtSpeed& m) {
    std::vector<std::pair<std::string, double>> list{{"1x", 1.0}, {"2x", 2.0}};
    for (const auto& [name, per_turn] : m.rolling) {
      list.emplace_back(name + " cage", per_turn.cage);
      list.emplace_back(name + " outer race", per_turn.outer_race);
      list.emplace_back(name + " inner race", per_turn.inner_race);
    }
    return list;
  };
  std::vector<Crossing> found;
  for (std::size_t k = 1; k < speeds.size(); ++k) {
    const ModesAtSpeed &from = speeds[k - 1], &to = speeds[k];
    const auto before = excitations(from), after = excitations(to);
    for (const Whirl sense : {Whirl::backward, Whirl::forward}) {
      const std::vector<double> low = in_sense(from, sense), high = in_sense(to, sense);
      for (std::size_t mode = 0; mode < std::min(low.size(), high.size()); ++mode)
        for (std::size_t e = 0; e < std::min(before.size(), after.size()); ++e) {
          const double a = low[mode] - before[e].second * from.speed;
          const double b = high[mode] - after[e].second * to.speed;
          const bool at_first = k == 1 && a == 0.0;
          if (!at_first && !(a > 0.0 && b <= 0.0) && !(a < 0.0 && b >= 0.0)) continue;
          const double share = at_first ? 0.0 : a / (a - b);
          found.push_back({.excitation = before[e].first,
                           .mode = mode + 1,
                           .whirl = sense,
                           .speed = std::lerp(from.speed, to.speed, share),
                           .frequency = std::lerp(low[mode], high[mode], share)});
        }
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Crossing& a, const Crossing& b) { return a.speed < b.speed; });
  return found;
}

std::string campbell_text(const Arrangement& a, const std::vector<ModesAtSpeed>& speeds,
                          std::string_view source, std::string_view model_text) {
  fmt::memory_buffer out;
  head(out, "Modes of the shaft on its bearings against speed", source, model_text);
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "speed_rpm,mode,frequency_Hz,whirl,damping_ratio,");
  // Columns are those of a warm row where there is any.
  const auto fullest = std::find_if(speeds.begin(), speeds.end(), [](const ModesAtSpeed& m) {
    return m.sets.moment.has_value();
  });
  const std::vector<SetNumber> names =
      set_numbers(a, fullest == speeds.end() ? speeds.front() : *fullest);
  for (const SetNumber& n : names) {
    text::append_text(out, n.name);
    out.push_back(',');
  }
  fmt::format_to(put, "status\n");
  for (const ModesAtSpeed& m : speeds) {
    std::vector<SetNumber> numbers = set_numbers(a, m);
    if (numbers.size() != names.size()) {
      numbers = names;
      for (SetNumber& n : numbers) n.value = unset;
    }
    for (std::size_t k = 0; k < std::max<std::size_t>(1, m.modes.modes.size()); ++k) {
      cell(out, m.speed / rpm);
      if (k < m.modes.modes.size()) {
        const spindle::Mode& mode = m.modes.modes[k];
        fmt::format_to(put, "{},", k + 1);
        cell(out, mode.frequency / of_turn);
        fmt::format_to(put, "{},", spindle::name(mode.whirl));
        cell(out, m.damping_ratio);
      } else {
        fmt::format_to(put, ",,,,");
      }
      for (const SetNumber& n : numbers) cell(out, n.value);
      fmt::format_to(put, "{}\n", m.status());
    }
  }
  return fmt::to_string(out);
}

std::string mode_shapes_text(const spindle::Beam& beam, const std::vector<ModesAtSpeed>& speeds,
                             std::string_view source, std::string_view model_text) {
  fmt::memory_buffer out;
  head(out, "Mode shapes of the shaft, scaled to a largest amplitude of 1", source, model_text);
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "speed_rpm,mode,frequency_Hz,whirl,position_mm,y_amplitude,z_amplitude\n");
  for (const ModesAtSpeed& m : speeds)
    for (std::size_t k = 0; k < m.modes.modes.size(); ++k) {
      const spindle::Mode& mode = m.modes.modes[k];
      for (std::size_t node = 0; node < beam.nodes().size(); ++node) {
        cell(out, m.speed / rpm);
        fmt::format_to(put, "{},", k + 1);
        cell(out, mode.frequency / of_turn);
        fmt::format_to(put, "{},", spindle::name(mode.whirl));
        cell(out, beam.nodes()[node] / mm);
        cell(out, mode.y[static_cast<Eigen::Index>(2 * node)]);
        text::append_value(out, mode.z[static_cast<Eigen::Index>(2 * node)]);
        out.push_back('\n');
      }
    }
  return fmt::to_string(out);
}

std::string campbell_json(const Arrangement& a, const std::vector<ModesAtSpeed>& speeds,
                          std::string_view source, const model::Findings& findings) {
  text::json rows = text::json::array();
  for (const ModesAtSpeed& m : speeds) {
    text::json row = {{"speed_rpm", m.speed / rpm}};
    for (const SetNumber& n : set_numbers(a, m)) row[n.name] = n.value;
    text::json modes = text::json::array();
    for (std::size_t k = 0; k < m.modes.modes.size(); ++k)
      modes.push_back({{"mode", k + 1},
                       {"frequency_Hz", m.modes.modes[k].frequency / of_turn},
                       {"whirl", spindle::name(m.modes.modes[k].whirl)},
                       {"damping_ratio", m.damping_ratio}});
    row["modes"] = std::move(modes);
    row["report"] = {{"status", m.status()}};
    if (!m.sets.message.empty()) row["report"]["message"] = m.sets.message;
    rows.push_back(std::move(row));
  }
  return text::text({{"model", text::printable(source)},
                     {"preload_N", a.preload()},
                     {"rows", std::move(rows)},
                     {"crossings", crossings_json(speeds)},
                     {"judgement", judgement_json(findings)}});
}

std::string load_words(const DeflectionResult& r) {
  std::string words = fmt::format("{:.6g} N {}", r.force, r.axial ? "axial" : "radial");
  if (r.axial_force != 0.0) words += fmt::format(", {:.6g} N axial", r.axial_force);
  if (r.moment != 0.0) words += fmt::format(", moment {:.6g} N m", r.moment);
  return words;
}

std::string deflection_json(const Arrangement& a, const DeflectionResult& r,
                            std::string_view source, const model::Findings& findings) {
  text::json document = {{"model", text::printable(source)},
                         {"speed_rpm", r.speed / rpm},
                         {"force_N", r.force},
                         {"direction", r.axial ? "axial" : "radial"},
                         {"at_mm", r.at / mm},
                         {"preload_N", a.preload()}};
  const bool sets = r.sets.converged();
  document["unloaded_front_force_N"] = sets ? r.sets.equilibrium.front_force : unset;
  document["unloaded_rear_force_N"] = sets ? r.sets.equilibrium.rear_force : unset;
  document["axial_force_N"] = r.axial ? r.force : r.axial_force;
  document["moment_Nm"] = r.moment;
  document["displacement_um"] = r.displacement / um;
  document["nose_displacement_um"] = r.nose / um;
  document["nose_slope_urad"] = r.slope / microradian;
  document["stiffness_N_um"] = r.stiffness() / N_per_um;
  document["tangent_displacement_um"] = r.tangent / um;
  document["front_force_N"] = r.shaft.front_force;
  document["rear_force_N"] = r.shaft.rear_force;
  text::json bearings = text::json::array();
  for (std::size_t i = 0; i < r.shaft.bearings.size(); ++i)
    bearings.push_back(bearing_json(a, r.shaft, i));
  document["bearings"] = std::move(bearings);
  text::json rollers = text::json::array();
  for (std::size_t i = 0; i < r.shaft.rollers.size(); ++i)
    rollers.push_back(roller_json(r.roller_names[i], r.shaft.rollers[i], r.unloaded->rollers[i]));
  document["roller_bearings"] = std::move(rollers);
  document["judgement"] = judgement_json(findings);
  document["report"] = {{"status", r.status()},
                        {"iterations", r.shaft.report.iterations},
                        {"residual", r.shaft.report.residual}};
  if (!r.sets.message.empty()) document["report"]["message"] = r.sets.message;
  return text::text(document);
}

std::string deflection_text(const spindle::Beam& beam, const DeflectionResult& r,
                            std::string_view source, std::string_view model_text) {
  fmt::memory_buffer out;
  head(out,
       fmt::format(
           "Bending line of the shaft under {} at {:.6g} mm behind the nose face, {:.6g} rpm",
           load_words(r), r.at / mm, r.speed / rpm),
       source, model_text);
  fmt::format_to(std::back_inserter(out), "position_mm,radial_displacement_um,slope_urad\n");
  for (std::size_t node = 0; r.converged() && node < beam.nodes().size(); ++node) {
    cell(out, beam.nodes()[node] / mm);
    cell(out, r.shaft.y[static_cast<Eigen::Index>(2 * node)] / um);
    text::append_value(out, r.shaft.y[static_cast<Eigen::Index>(2 * node + 1)] / microradian);
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace raceway::results
