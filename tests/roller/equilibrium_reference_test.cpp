#include <cmath>

#include "bearing/frequencies.h"
#include "bearing/solve.h"
#include "tests/roller/reference_cases.h"

namespace raceway::roller {
namespace {

using bearing::Race;
using bearing::RollerBearing;
using bearing::RollerEquilibrium;
using nlohmann::json;

constexpr double N_per_um = 1.0 / um, mrad = 1e-3, MPa_ = 1e6;

std::vector<double> loads(const RollerEquilibrium& e, double bearing::LoadedRoller::*load) {
  std::vector<double> list;
  for (const auto& r : e.rollers) list.push_back(r.*load);
  return list;
}

/// Everything that a case or one of its rows says of a balance, by name.
void expect_balance(const ReferenceCase& c, const json& row, const RollerBearing& b,
                    const RollerEquilibrium& e, double speed) {
  ASSERT_EQ(e.report.status, bearing::SolveStatus::converged) << c.id();
  const bearing::ContactPressure p = largest_pressure(b, e);
  const auto peak = [](const std::vector<double>& v) {
    return *std::max_element(v.begin(), v.end());
  };
  const std::vector<double> inner = loads(e, &bearing::LoadedRoller::inner_load);
  const std::vector<double> outer = loads(e, &bearing::LoadedRoller::outer_load);
  const double per_mm = mm / b.lamina_length();
  const auto f = bearing::rolling_frequencies(b.geometry());
  const double cage = f.cage * speed / rpm;
  const double g = b.geometry().diameter_ratio();
  const std::vector<std::pair<std::string, double>> numbers{
      {"displacement_y_um", e.displacement[0] / um},
      {"displacement_z_um", e.displacement[1] / um},
      {"tilt_y_mrad", e.displacement[2] / mrad},
      {"tilt_z_mrad", e.displacement[3] / mrad},
      {"force_y_N", e.load[0]},
      {"force_z_N", e.load[1]},
      {"moment_y_Nm", e.load[2]},
      {"moment_z_Nm", e.load[3]},
      {"centrifugal_force_N", e.centrifugal_force},
      {"loaded_rollers", e.loaded_rollers()},
      {"largest_inner_lamina_N_mm", e.largest_lamina(Race::inner) * per_mm},
      {"largest_outer_lamina_N_mm", e.largest_lamina(Race::outer) * per_mm},
      {"inner_pressure_MPa", p.inner / MPa_},
      {"outer_pressure_MPa", p.outer / MPa_},
      {"stiffness_yy_N_um", e.stiffness(0, 0) / N_per_um},
      {"stiffness_zz_N_um", e.stiffness(1, 1) / N_per_um},
      {"stiffness_yz_N_um", e.stiffness(0, 1) / N_per_um},
      {"stiffness_tilt_z_Nm_rad", e.stiffness(3, 3)},
      {"stiffness_tilt_y_Nm_rad", e.stiffness(2, 2)},
      {"stiffness_y_tilt_z_N_mrad", e.stiffness(0, 3) * mrad},
      {"largest_load_N", peak(inner)},
      {"largest_inner_load_N", peak(inner)},
      {"largest_outer_load_N", peak(outer)},
      {"cage_rpm", cage},
      {"roller_rpm", f.ball_spin * speed / rpm},
      {"outer_pass_Hz", f.outer_race * speed / (2.0 * pi)},
      {"inner_pass_Hz", f.inner_race * speed / (2.0 * pi)},
      {"rolling_speed_m_s", 0.25 * speed * b.geometry().pitch_diameter * (1.0 - g * g)}};
  for (const auto& [key, value] : numbers)
    if (row.contains(key) && row.at(key).is_number()) c.holds(row, key, value);
  if (row.contains("inner_load_N")) c.holds(row, "inner_load_N", inner);
  if (row.contains("outer_load_N")) c.holds(row, "outer_load_N", outer);
}

void expect_case(const ReferenceCase& c, const json& row) {
  const RollerBearing b = steel_bearing(geometry(c, row));
  const auto number = [&](const char* key) {
    return row.contains(key) && !c.inputs().contains(key) ? row.at(key).get<double>() : c.in(key);
  };
  bearing::OperatingPoint point{.speed = number("speed_rpm") * rpm,
                                .radial_load = number("radial_load_N"),
                                .radial_load_z = number("radial_load_z_N"),
                                .moment_y = c.in("moment_y_Nm"),
                                .moment_z = c.in("moment_z_Nm")};
  bearing::RollerOptions options{.tilt_y = c.in("tilt_y_mrad") * mrad,
                                 .tilt_z = c.in("tilt_z_mrad") * mrad};
  if (c.inputs().value("tilt", "locked") == "free") options.tilt = bearing::Tilt::free;
  expect_balance(c, row, b, solve_roller_bearing(b, point, options), point.speed);
}

TEST(RollerReference, BalancesAreThoseOfAnIndependentProgram) {
  int count = 0;
  for (const ReferenceCase& c : reference_cases("equilibrium")) {
    SCOPED_TRACE(c.id());
    ++count;
    if (c.id() == "n1012_680") continue;  // below
    if (!c.outputs().contains("rows"))
      expect_case(c, c.outputs());
    else
      for (const json& row : c.outputs().at("rows")) {
        SCOPED_TRACE(row.dump());
        expect_case(c, row);
      }
  }
  EXPECT_GE(count, 13);
}

/// Where a growing function of x is `value`, by bisection.
template <typename Function>
double where(double low, double high, double value, const Function& f) {
  const bool grows = f(high) > f(low);
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high);
    ((f(x) < value) == grows ? low : high) = x;
  }
  return 0.5 * (low + high);
}

TEST(RollerReference, StiffnessOfThePaperIsReachedByPreloadOrUnderAnImplausibleLoad) {
  const ReferenceCase c = reference_case("equilibrium", "n1012_680");
  for (const json& row : c.outputs().at("rows")) {
    const auto stiffness = [&](bearing::RollerProfile profile, double clearance, double load) {
      bearing::RollerGeometry g = geometry(c, row);
      g.profile = profile;
      g.radial_clearance = clearance;
      return solve_roller_bearing(steel_bearing(g), {.radial_load = load}).stiffness(0, 0);
    };
    const auto load = [&](bearing::RollerProfile profile) {
      return where(100.0, 20000.0, 680 * N_per_um,
                   [&](double f) { return stiffness(profile, 0.0, f); });
    };
    c.holds(row, "load_at_680_none_N", load(bearing::RollerProfile::none));
    c.holds(row, "load_at_680_iso_N", load(bearing::RollerProfile::iso));
    c.holds(row, "preload_at_680_iso_um", where(-10 * um, -1 * um, 680 * N_per_um, [&](double s) {
                                            return stiffness(bearing::RollerProfile::iso, s, 0.0);
                                          }) / um);
  }
}

TEST(RollerReference, ContactAndProfile) {
  for (const ReferenceCase& c : reference_cases("contact")) {
    SCOPED_TRACE(c.id());
    for (const json& row : c.outputs().at("rows")) {
      if (row.contains("Q_N")) {
        const RollerBearing b = steel_bearing(geometry(c));
        const double n = static_cast<double>(bearing::lamina_count);
        const double to_mm = std::pow(mm, 10.0 / 9.0);
        const double both = b.contact().stiffness / std::pow(2.0, 10.0 / 9.0);
        c.holds(c.outputs(), "c_1_N_mm", b.contact().stiffness * to_mm);
        c.holds(c.outputs(), "c_s_N_mm", both * to_mm);
        c.holds(c.outputs(), "K_both_N_mm", n * both * to_mm);
        const double Q = row.at("Q_N"), w = Q / b.geometry().roller_length;
        c.holds(row, "approach_both_um", std::pow(Q / (n * both), 0.9) / um);
        for (const auto& [race, name] : {std::pair{Race::inner, "inner"}, {Race::outer, "outer"}}) {
          c.holds(row, name + std::string("_half_width_um"), b.contact().half_width(race, w) / um);
          c.holds(row, name + std::string("_pressure_MPa"),
                  b.contact().peak_pressure(race, w) / MPa_);
        }
      } else {
        const RollerBearing b =
            steel_bearing({.roller_count = 10,
                           .roller_diameter = row.at("roller_diameter_mm").get<double>() * mm,
                           .roller_length = row.at("roller_length_mm").get<double>() * mm,
                           .pitch_diameter = 77.5 * mm});
        std::vector<double> position, relief;
        for (const std::size_t k : {0, 5, 20, 40}) {
          position.push_back(b.positions()[k] / mm);
          relief.push_back(b.relief()[k] / um);
        }
        c.holds(row, "position_mm", position);
        c.holds(row, "relief_um", relief);
      }
    }
  }
}

}  // namespace
}  // namespace raceway::roller
