#include "tests/spindle_study/reference.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/places.h"
#include "tests/spindle_study/base_spindle.h"
#include "tests/spindle_study/simulator.h"

namespace spindle_study {
namespace {

using nlohmann::json;

constexpr double ambient = 293.15, zero_C = 273.15;

json outputs(const json& cases, const std::string& id) {
  for (const json& c : cases)
    if (c.at("id") == id) return c.at("outputs");
  throw std::runtime_error("spindle_reference.json: no case " + id);
}

double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (double v : values) total += v;
  return total;
}

void steady(const json& cases, bool cooled, std::vector<Compared>& all) {
  const std::string id = cooled ? "spindle_steady_6000_cooled" : "spindle_steady_6000_uncooled";
  const json expected = outputs(cases, id);
  Simulator s(base_spindle());
  const Inputs in{.time = 0.0, .speed = 6000.0 * rpm, .coolant_on = cooled};
  s.settle(in);
  const Reading r = s.reading();
  const auto take = [&](const std::string& name, const char* unit, double own, double reference,
                        double tolerance, double least = 0.0) {
    all.push_back({id + " " + name, unit, own, reference, tolerance, least});
  };
  take("displacement", "um", 1e6 * r.displacement, expected.at("axial_displacement_um"), 0.05);
  for (std::size_t b = 0; b < r.power.size(); ++b) {
    const std::string which = " " + std::to_string(b + 1);
    const double inner = expected.at("inner_ring_C").at(b),
                 outer = expected.at("outer_ring_C").at(b);
    take("inner ring" + which, "K", r.inner_rings[b] - ambient, inner + zero_C - ambient, 0.05);
    take("outer ring" + which, "K", r.outer_rings[b] - ambient, outer + zero_C - ambient, 0.05);
    take("force" + which, "N", r.set.bearings[b].force, expected.at("bearing_force_N").at(b), 0.1);
    take("power" + which, "W", r.power[b], expected.at("friction_power_W").at(b), 0.05);
  }
  Balance heat = s.heat(in);
  for (const auto& [name, watts] : expected.at("heat_out_W").items())
    take("heat by " + name, "W", heat.out[name], watts, 0.05, 0.005 * heat.in);
}

void steps(const json& cases, std::vector<Compared>& all) {
  Simulator s(base_spindle());
  const json expected = outputs(cases, "step_responses_cooled");
  for (const json& row : expected.at("rows")) {
    const double speed = row.at("rpm");
    const std::string id = fmt::format("start-up to {:.0f} rpm ", speed);
    s.start(ambient);
    Inputs in{.speed = speed * rpm};
    const auto force_at = [&](double time, const char* name) {
      in.time = time;
      s.advance(in);
      all.push_back({id + "force " + name, "N", s.reading().set.front_force,
                     row.at("front_force_N").at(name), 0.06});
    };
    force_at(600.0, "10 min");
    force_at(3600.0, "1 h");
    force_at(14400.0, "end");
    const Reading r = s.reading();
    all.push_back({id + "power", "W", sum(r.power), row.at("P_end_W"), 0.06});
    const double kinematic = row.at("kinematic_um"), thermal = row.at("end_um");
    all.push_back({id + "displacement", "um", 1e6 * r.displacement, kinematic + thermal, 0.06});
  }
}

void cold_preload(const json& cases, std::vector<Compared>& all) {
  const json expected = outputs(cases, "preload_feedback_8000").at("friction_by_cold_preload");
  Spindle spindle = base_spindle();
  spindle.preload_feedback = false;
  Simulator s(spindle);
  Inputs in{.speed = 8000.0 * rpm};
  const std::array minutes{10, 30, 60, 120};
  for (std::size_t k = 0; k < minutes.size(); ++k) {
    in.time = 60.0 * minutes[k];
    s.advance(in);
    const Reading r = s.reading();
    const std::string id = fmt::format("friction by the cold set, {} min ", minutes[k]);
    all.push_back({id + "power", "W", sum(r.power), expected.at("power_W").at(k), 0.06});
    all.push_back({id + "displacement", "um", 1e6 * r.displacement,
                   expected.at("displacement_um").at(k), 0.06});
  }
}

json reference_cases() {
  std::ifstream in(raceway::tests::source_dir() + "/data/reference/spindle_reference.json");
  if (!in) throw std::runtime_error("cannot read data/reference/spindle_reference.json");
  return json::parse(in);
}

}  // namespace

double Compared::deviation() const { return own / reference - 1.0; }

bool Compared::good() const {
  return std::fabs(deviation()) <= tolerance || std::fabs(own - reference) <= least;
}

std::vector<Compared> steady_states() {
  const json cases = reference_cases();
  std::vector<Compared> all;
  steady(cases, true, all);
  steady(cases, false, all);
  return all;
}

std::vector<Compared> start_ups() {
  const json cases = reference_cases();
  std::vector<Compared> all;
  steps(cases, all);
  cold_preload(cases, all);
  return all;
}

std::string line(const Compared& f) {
  return fmt::format("{:<46} {:9.3f} {:9.3f} {:<2} {:+6.1f} % of {:2.0f} %{}", f.name, f.own,
                     f.reference, f.unit, 100.0 * f.deviation(), 100.0 * f.tolerance,
                     f.good() ? "" : "  !");
}

}  // namespace spindle_study
