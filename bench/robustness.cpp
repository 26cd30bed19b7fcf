// Solves random operating points over real bearings and says how many end how: the solver's claim
// that it finds an equilibrium wherever there is one, put to the test.
//
//   robustness [--points 1000000] [--seed 1] [--control outer|inner|both] [--scan 300]
//              [--of bearings|arrangements]
//
// `--scan N` proves up to N of the `no_equilibrium` (loads along y) by a brute-force search that
// shares nothing of the solver's own search; see equilibrium_scan.h. It is for bearings only.

#include <fmt/core.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <string>

#include "bench/arrangement_domain.h"
#include "bench/equilibrium_scan.h"
#include "bench/robustness_domain.h"
#include "tests/reference_table.h"

namespace {

using namespace raceway;
using bearing::RaceControl;
using bearing::SolveStatus;

struct Tally {
  std::array<long, 6> status{};
  long iterations = 0, in_eight = 0;
  int most = 0;
  double worst_load_error = 0.0;
  std::vector<std::uint64_t> without;  ///< indices that ended in no_equilibrium

  void add(std::uint64_t index, const bearing::SolveReport& report) {
    ++status[static_cast<std::size_t>(report.status)];
    if (report.status == SolveStatus::no_equilibrium) without.push_back(index);
    if (!report.converged()) return;
    iterations += report.iterations;
    in_eight += report.iterations <= 8;
    most = std::max(most, report.iterations);
    worst_load_error = std::max(worst_load_error, report.recovered_load_error);
  }
  void add(const Tally& other) {
    for (std::size_t i = 0; i < status.size(); ++i) status[i] += other.status[i];
    iterations += other.iterations;
    in_eight += other.in_eight;
    most = std::max(most, other.most);
    worst_load_error = std::max(worst_load_error, other.worst_load_error);
    without.insert(without.end(), other.without.begin(), other.without.end());
  }
};

std::vector<robustness::Size> catalogue_sizes() {
  std::vector<robustness::Size> sizes;
  for (const auto& row : tests::reference_table("gmn_sizes.csv"))
    sizes.push_back({.ball_count = static_cast<int>(row["ball_count"]),
                     .ball_diameter = row["ball_diameter_mm"] * mm,
                     .pitch_diameter = row["pitch_diameter_mm"] * mm,
                     .static_load_rating = row["static_load_rating_N"]});
  return sizes;
}

void show_progress(const char* what, long done, long all) {
  if (isatty(STDERR_FILENO) != 0)
    fmt::print(stderr, "\r{} {} of {}{}", what, done, all, done == all ? "\n" : "");
}

/// Solves all cases of `solve`, which makes a SolveReport of an index.
template <typename Solve>
Tally solve_all(const Solve& solve, long points) {
  constexpr long chunk = 200;
  Tally total;
  std::mutex lock;
  long finished = 0;
  tbb::parallel_for(0L, (points + chunk - 1) / chunk, [&](long c) {
    Tally part;
    for (long i = c * chunk; i < std::min(points, (c + 1) * chunk); ++i) {
      const auto index = static_cast<std::uint64_t>(i);
      part.add(index, solve(index));
    }
    const std::lock_guard guard(lock);
    total.add(part);
    finished += std::min(points, (c + 1) * chunk) - c * chunk;
    show_progress("solved", finished, points);
  });
  std::sort(total.without.begin(), total.without.end());
  return total;
}

Tally solve_bearings(const std::vector<robustness::Size>& sizes, RaceControl control,
                     std::uint64_t seed, long points) {
  return solve_all(
      [&](std::uint64_t index) {
        const auto made = robustness::make_case(sizes, control, seed, index);
        const bearing::Bearing one(made.geometry, bearing::steel(), bearing::steel());
        return solve_bearing_equilibrium(one, made.point, made.options).report;
      },
      points);
}

Tally solve_arrangements(const std::vector<robustness::Size>& sizes, RaceControl control,
                         std::uint64_t seed, long points) {
  return solve_all(
      [&](std::uint64_t index) {
        const auto made = robustness::make_arrangement(sizes, control, seed, index);
        return solve_arrangement(made.arrangement, made.condition, made.options).report;
      },
      points);
}

struct ScanResult {
  long scanned = 0, found = 0;
};

ScanResult scan_some(const std::vector<robustness::Size>& sizes, RaceControl control,
                     std::uint64_t seed, const std::vector<std::uint64_t>& without, long most) {
  std::vector<robustness::Case> cases;
  for (const std::uint64_t index : without) {
    const auto made = robustness::make_case(sizes, control, seed, index);
    if (made.point.radial_load_z == 0.0 && static_cast<long>(cases.size()) < most)
      cases.push_back(made);
  }
  std::atomic<long> found = 0, finished = 0;
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
    const bearing::Bearing one(cases[i].geometry, bearing::steel(), bearing::steel());
    const int nodes = cases[i].options.tilt == bearing::Tilt::free ? 24 : 60;
    found += robustness::scan_finds_equilibrium(one, cases[i].point, cases[i].options, nodes);
    show_progress("scanned", ++finished, static_cast<long>(cases.size()));
  });
  return {static_cast<long>(cases.size()), found};
}

void report(const char* control, const Tally& t, const ScanResult& scan, long points) {
  const long converged = t.status[static_cast<std::size_t>(SolveStatus::converged)];
  fmt::print("{} control, {} points\n", control, points);
  for (std::size_t s = 0; s < t.status.size(); ++s)
    if (t.status[s] > 0)
      fmt::print("  {:<16} {:>9}\n", bearing::name(static_cast<SolveStatus>(s)), t.status[s]);
  fmt::print("  Newton steps: {:.2f} on average, {:.1f} % within 8, at most {}\n",
             static_cast<double>(t.iterations) / static_cast<double>(converged),
             100.0 * static_cast<double>(t.in_eight) / static_cast<double>(converged), t.most);
  fmt::print("  loads recovered to {:.1e} at worst\n", t.worst_load_error);
  if (scan.scanned == 0) return;
  // The scanned share stands for all points without equilibrium.
  const double missed = static_cast<double>(t.without.size()) * static_cast<double>(scan.found) /
                        static_cast<double>(scan.scanned);
  fmt::print(
      "  no_equilibrium scanned: {}, an equilibrium found after all in {}: about {:.3f} % of the\n"
      "  points that have one\n",
      scan.scanned, scan.found, 100.0 * missed / (missed + static_cast<double>(converged)));
}

}  // namespace

int main(int argc, char** argv) {
  long points = 1000000, scan = 300;
  std::uint64_t seed = 1;
  std::string control = "both", of = "bearings";
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string flag = argv[i];
    if (flag == "--points")
      points = std::atol(argv[i + 1]);
    else if (flag == "--scan")
      scan = std::atol(argv[i + 1]);
    else if (flag == "--seed")
      seed = static_cast<std::uint64_t>(std::atol(argv[i + 1]));
    else if (flag == "--control")
      control = argv[i + 1];
    else if (flag == "--of")
      of = argv[i + 1];
    else {
      fmt::print(stderr, "robustness: {}: no such flag; see the head of bench/robustness.cpp\n",
                 flag);
      return 1;
    }
  }
  const auto sizes = catalogue_sizes();
  for (const RaceControl c : {RaceControl::outer, RaceControl::inner}) {
    const char* name = c == RaceControl::outer ? "outer" : "inner";
    if (control != "both" && control != name) continue;
    if (of == "arrangements") {
      report(name, solve_arrangements(sizes, c, seed, points), {}, points);
      continue;
    }
    const Tally tally = solve_bearings(sizes, c, seed, points);
    report(name, tally, scan_some(sizes, c, seed, tally.without, scan), points);
  }
  return 0;
}
