// How well the kinematic law follows computed spindles over a bearing catalogue: two bearings at
// the front against one at the rear, rigid, O, universally matched at the maker's preload classes,
// groove conformity from the printed rigidities. Says where the law stays within its tolerance, and
// what decides it.
//
//   kinematic_law_sweep [--to 10000] [--ceramic] [--list]
//
// `--to` is the highest speed [rpm], `--list` writes every case as CSV.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bearing/arrangement_equilibrium.h"
#include "shaft/conformity.h"
#include "shaft/fit_kinematic_law.h"
#include "tests/reference_table.h"

namespace {

using namespace raceway;

constexpr int speeds = 40;
constexpr double smallest_bore = 40.0, largest_bore = 100.0;  // [mm]

struct Case {
  std::string designation, preload_class;
  double bore, contact_angle;  // [mm], [deg]
  double preload = unset;      // on each side [N]
  /// Least load of a front bearing at the highest speed, Z F_c tan α0, over its preload: how far
  /// centrifugal forces have taken over [1].
  double centrifugal_ratio = unset;
  bool balanced = false;  // at every speed
  bool unloaded = false;  // a bearing has lost its inner race at some speed
  std::optional<shaft::KinematicLawFit> law = {};

  [[nodiscard]] bool within() const { return law && law->mae <= shaft::kinematic_law_tolerance; }
};

bearing::Bearing steel_bearing(const tests::ReferenceRow& row) {
  return {{.ball_count = static_cast<int>(row["ball_count"]),
           .ball_diameter = row["ball_diameter_mm"] * mm,
           .pitch_diameter = row["pitch_diameter_mm"] * mm,
           .contact_angle = row["contact_angle_deg"] * degree,
           .inner_conformity = 0.52,
           .outer_conformity = 0.52},
          bearing::steel(),
          bearing::steel()};
}

Case solved_case(const std::shared_ptr<const bearing::Bearing>& one, Case c, double pair_preload,
                 double highest_speed) {
  const bearing::Arrangement spindle(
      {.front = {{one}, {one}},
       .rear = {{one}},
       .preload = bearing::matched_preload(*one, pair_preload, *one, pair_preload)});
  c.preload = spindle.preload();
  std::vector<bearing::ArrangementCondition> conditions;
  for (int i = 1; i <= speeds; ++i) conditions.push_back({.speed = highest_speed * i / speeds});
  std::vector<bearing::ArrangementEquilibrium> results(conditions.size());
  solve_arrangement(spindle, conditions, results);
  std::vector<shaft::DisplacementPoint> curve;
  c.balanced = true;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].report.converged()) {
      c.balanced = false;
      return c;
    }
    for (const bearing::BearingInSet& b : results[i].bearings) c.unloaded |= b.lost();
    curve.push_back({conditions[i].speed, results[i].position});
  }
  c.centrifugal_ratio = results.back().bearings.front().minimum_load / (0.5 * c.preload);
  c.law = shaft::fit_kinematic_law(curve);
  return c;
}

std::vector<Case> all_cases(double highest_speed, bool ceramic) {
  std::vector<Case> cases;
  for (const auto& row : tests::reference_table("gmn_axial_rigidity.csv")) {
    if (row["bore_mm"] < smallest_bore || row["bore_mm"] > largest_bore) continue;
    std::vector<shaft::PairRigidity> classes;
    for (const std::string name : {"L", "M", "S"})
      classes.push_back({.preload_class = name,
                         .preload = row["preload_" + name + "_N"],
                         .printed = row["axial_rigidity_pair_" + name + "_N_per_um"] * N_per_um});
    const bearing::Bearing printed = steel_bearing(row);
    bearing::BearingGeometry geometry = printed.geometry();
    geometry.inner_conformity = geometry.outer_conformity =
        shaft::fit_conformity(printed, classes).conformity;
    const auto one = std::make_shared<const bearing::Bearing>(
        geometry, ceramic ? bearing::silicon_nitride() : bearing::steel(), bearing::steel());
    for (const shaft::PairRigidity& c : classes)
      cases.push_back(solved_case(one,
                                  {.designation = row.text("designation"),
                                   .preload_class = c.preload_class,
                                   .bore = row["bore_mm"],
                                   .contact_angle = row["contact_angle_deg"]},
                                  c.preload, highest_speed));
  }
  return cases;
}

void list(const std::vector<Case>& cases) {
  fmt::print(
      "designation,bore_mm,contact_angle_deg,class,preload_N,centrifugal_ratio,displacement_um,mae_"
      "um,"
      "max_abs_um,A,B,C,verdict,unloaded\n");
  for (const Case& c : cases) {
    fmt::print("{},{:.0f},{:.0f},{},{:.1f},{:.4g},", c.designation, c.bore, c.contact_angle,
               c.preload_class, c.preload, c.centrifugal_ratio);
    if (c.law)
      fmt::print("{:.4f},{:.4f},{:.4f},{:.4e},{:.4f},{:.4e},{},{}\n", c.law->largest / um,
                 c.law->mae / um, c.law->max_abs / um, c.law->law.A, c.law->law.B, c.law->law.C,
                 shaft::name(c.law->verdict), c.unloaded ? 1 : 0);
    else
      fmt::print(",,,,,,no_equilibrium,\n");
  }
}

double median(std::vector<double> values) {
  if (values.empty()) return unset;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// One line for the cases of a group.
void summarise(const std::string& group, const std::vector<const Case*>& cases) {
  std::vector<double> displacement, mae, share;
  long within = 0, lost = 0;
  for (const Case* c : cases) {
    within += c->within();
    lost += !c->law || c->unloaded;
    if (!c->law) continue;
    displacement.push_back(c->law->largest / um);
    mae.push_back(c->law->mae / um);
    share.push_back(100.0 * c->law->mae / c->law->largest);
  }
  if (mae.empty()) return;
  fmt::print("| {} | {} | {:.2f} | {:.3f} | {:.3f} | {:.2f} | {} of {} | {} |\n", group,
             cases.size(), median(displacement), median(mae),
             *std::max_element(mae.begin(), mae.end()), median(share), within, cases.size(), lost);
}

void print(const std::vector<Case>& cases) {
  fmt::print(
      "| group | cases | u, median (um) | MAE, median (um) | MAE, worst (um) | MAE/u, median (%) | "
      "within 0.023 um | a bearing unloaded |\n| --- | --- | --- | --- | --- | --- | --- | --- "
      "|\n");
  std::map<std::string, std::vector<const Case*>> groups;
  for (const Case& c : cases) {
    const char* const weight = c.preload_class == "L"   ? "1 light"
                               : c.preload_class == "M" ? "2 medium"
                                                        : "3 strong";
    groups[fmt::format("a. {:.0f} deg, {}", c.contact_angle, weight + 2)].push_back(&c);
    const char* const size = c.bore <= 50 ? "40 to 50" : c.bore <= 70 ? "55 to 70" : "75 to 100";
    groups[fmt::format("b. bore {} mm, {}", size, weight + 2)].push_back(&c);
    const double r = c.centrifugal_ratio;
    groups[r < 1.0   ? "c. centrifugal ratio below 1"
           : r < 2.0 ? "d. centrifugal ratio 1 to 2"
           : r < 3.0 ? "e. centrifugal ratio 2 to 3"
           : r < 5.0 ? "f. centrifugal ratio 3 to 5"
                     : "g. centrifugal ratio above 5"]
        .push_back(&c);
    groups["h. all"].push_back(&c);
  }
  for (const auto& [name, group] : groups) summarise(name.substr(3), group);
}

}  // namespace

int main(int argc, char** argv) {
  double to = 10000.0;
  bool ceramic = false, every = false;
  for (int i = 1; i < argc; ++i) {
    const std::string_view flag = argv[i];
    if (flag == "--ceramic") {
      ceramic = true;
    } else if (flag == "--list") {
      every = true;
    } else if (flag == "--to" && i + 1 < argc && std::atof(argv[i + 1]) > 0.0) {
      to = std::atof(argv[++i]);
    } else {
      fmt::print(stderr, "kinematic_law_sweep [--to 10000] [--ceramic] [--list]\n");
      return 1;
    }
  }
  const std::vector<Case> cases = all_cases(to * rpm, ceramic);
  every ? list(cases) : print(cases);
  return 0;
}
