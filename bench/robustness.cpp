// Solves random operating points over real bearings and says how many end how: the solver's claim
// that it finds an equilibrium wherever there is one, put to the test.
//
//   robustness [--points 1000000] [--seed 1] [--control outer|inner|both] [--scan 300] [--nodes 24]
//              [--mode scalar|batch|both] [--of bearings|arrangements|wild]
//
// `--mode batch` solves through solve_many(), `both` also counts where the two disagree.
// `--scan N` proves up to N of the `no_equilibrium` (loads along y) by a brute-force search that
// shares nothing of the solver's own search, and names the points where that finds one; see
// equilibrium_scan.h. `--nodes` is its grid with free tilt, 60 with locked. For bearings only.
// `--of wild` solves whatever files and flags let through, wild_domain.h, one by one and side by
// side with every instruction set; the exit status is 1 where they disagree, where a converged
// number is not finite or where a solve takes more than 2000 steps.

#include <fmt/core.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>
#include <string>

#include "bearing/solve_many.h"
#include "bench/arrangement_domain.h"
#include "bench/equilibrium_scan.h"
#include "bench/robustness_domain.h"
#include "bench/wild_domain.h"
#include "tests/reference_table.h"

namespace {

using namespace raceway;
using bearing::RaceControl;
using bearing::SolveStatus;

constexpr int one_run = 40;  // most steps of one run of Newton's method

struct Tally {
  std::array<long, 6> status{};
  long iterations = 0, in_eight = 0;
  long in_one_run = 0, iterations_of_one_run = 0;  ///< neither path nor search was needed
  int most = 0;
  double worst_load_error = 0.0;
  std::vector<std::uint64_t> without;  ///< indices that ended in no_equilibrium

  void add(std::uint64_t index, const bearing::SolveReport& report) {
    ++status[static_cast<std::size_t>(report.status)];
    if (report.status == SolveStatus::no_equilibrium) without.push_back(index);
    if (!report.converged()) return;
    iterations += report.iterations;
    in_eight += report.iterations <= 8;
    if (report.iterations <= one_run) {
      ++in_one_run;
      iterations_of_one_run += report.iterations;
    }
    most = std::max(most, report.iterations);
    worst_load_error = std::max(worst_load_error, report.recovered_load_error);
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

/// Cases [first, first + count) with their bearings.
struct Block {
  std::vector<robustness::Case> cases;
  std::vector<bearing::Bearing> bearings;

  Block(const std::vector<robustness::Size>& sizes, RaceControl control, std::uint64_t seed,
        long first, long count) {
    for (long i = first; i < first + count; ++i) {
      cases.push_back(robustness::make_case(sizes, control, seed, static_cast<std::uint64_t>(i)));
      bearings.emplace_back(cases.back().geometry, bearing::steel(), bearing::steel());
    }
  }
};

/// One by one, each from its own cold start.
void solve_scalar(const Block& block, std::vector<bearing::BearingEquilibrium>& results) {
  tbb::parallel_for(std::size_t{0}, block.cases.size(), [&](std::size_t i) {
    results[i] =
        solve_bearing_equilibrium(block.bearings[i], block.cases[i].point, block.cases[i].options);
  });
}

/// Side by side; tilt is an option of a call, so there are two.
void solve_batch(const Block& block, RaceControl control,
                 std::vector<bearing::BearingEquilibrium>& results) {
  for (const bearing::Tilt tilt : {bearing::Tilt::locked, bearing::Tilt::free}) {
    std::vector<bearing::BearingCase> cases;
    std::vector<std::size_t> index;
    for (std::size_t i = 0; i < block.cases.size(); ++i) {
      if (block.cases[i].options.tilt != tilt) continue;
      cases.push_back({&block.bearings[i], block.cases[i].point});
      index.push_back(i);
    }
    std::vector<bearing::BearingEquilibrium> solved(cases.size());
    solve_many(cases, solved, {.race_control = control, .tilt = tilt});
    for (std::size_t n = 0; n < index.size(); ++n) results[index[n]] = std::move(solved[n]);
  }
}

/// Largest difference of two displacements, relative to the larger one.
double difference(const bearing::BearingEquilibrium& a, const bearing::BearingEquilibrium& b) {
  return (a.displacement - b.displacement).head<3>().cwiseAbs().maxCoeff() /
         a.displacement.head<3>().cwiseAbs().maxCoeff();
}

struct Both {
  Tally scalar, batch;
  long other_status = 0, other_state = 0;
  double worst_difference = 0.0;  ///< of displacements, where both found the same state
};

Both solve_all(const std::vector<robustness::Size>& sizes, RaceControl control, std::uint64_t seed,
               long points, bool scalar, bool batch) {
  constexpr long block_size = 16384;
  Both all;
  for (long first = 0; first < points; first += block_size) {
    const long count = std::min(block_size, points - first);
    const Block block(sizes, control, seed, first, count);
    std::vector<bearing::BearingEquilibrium> one(static_cast<std::size_t>(count)), many = one;
    if (scalar) solve_scalar(block, one);
    if (batch) solve_batch(block, control, many);
    for (std::size_t i = 0; i < one.size(); ++i) {
      const auto index = static_cast<std::uint64_t>(first) + i;
      if (scalar) all.scalar.add(index, one[i].report);
      if (batch) all.batch.add(index, many[i].report);
      if (!scalar || !batch) continue;
      if (one[i].report.status != many[i].report.status) ++all.other_status;
      if (!one[i].report.converged() || !many[i].report.converged()) continue;
      const double d = difference(one[i], many[i]);
      if (d > 1e-6)
        ++all.other_state;
      else
        all.worst_difference = std::max(all.worst_difference, d);
    }
    show_progress("solved", first + count, points);
  }
  return all;
}

Tally solve_arrangements(const std::vector<robustness::Size>& sizes, RaceControl control,
                         std::uint64_t seed, long points) {
  constexpr long block_size = 16384;
  Tally total;
  for (long first = 0; first < points; first += block_size) {
    const long count = std::min(block_size, points - first);
    std::vector<bearing::SolveReport> reports(static_cast<std::size_t>(count));
    const auto index = [&](std::size_t i) { return static_cast<std::uint64_t>(first) + i; };
    tbb::parallel_for(std::size_t{0}, reports.size(), [&](std::size_t i) {
      const auto made = robustness::make_arrangement(sizes, control, seed, index(i));
      reports[i] = solve_arrangement(made.arrangement, made.condition, made.options).report;
    });
    for (std::size_t i = 0; i < reports.size(); ++i) total.add(index(i), reports[i]);
    show_progress("solved", first + count, points);
  }
  return total;
}

/// False where the claims of the wild domain do not hold.
bool solve_wild(std::uint64_t seed, long points) {
  constexpr int most_steps = 2000;
  std::atomic<long> converged = 0, other_status = 0, not_finite = 0, too_long = 0, finished = 0;
  std::atomic<int> most = 0;
  tbb::parallel_for(0L, points, [&](long i) {
    const auto c = robustness::make_wild_case(seed, static_cast<std::uint64_t>(i));
    const auto one = solve_bearing_equilibrium(c.bearing, c.point, c.options);
    converged += one.report.converged();
    not_finite += !robustness::finite_if_converged(one);
    too_long += one.report.iterations > most_steps;
    for (int seen = most; one.report.iterations > seen;)
      if (most.compare_exchange_weak(seen, one.report.iterations)) break;
    for (const auto set : {bearing::InstructionSet::sse2, bearing::InstructionSet::avx2,
                           bearing::InstructionSet::avx512}) {
      if (!available(set)) continue;
      bearing::BearingEquilibrium many;
      solve_many(c.bearing, {&c.point, 1}, {&many, 1}, c.options, set);
      other_status += many.report.status != one.report.status;
      not_finite += !robustness::finite_if_converged(many);
    }
    show_progress("solved", ++finished, points);
  });
  fmt::print(
      "{} wild points: {} converged, {} other statuses side by side, {} converged but not\n"
      "finite, {} over {} steps (at most {})\n",
      points, converged.load(), other_status.load(), not_finite.load(), too_long.load(), most_steps,
      most.load());
  return other_status == 0 && not_finite == 0 && too_long == 0;
}

struct ScanResult {
  long scanned = 0;
  std::vector<std::uint64_t> found;  ///< indices of the points that have an equilibrium after all
};

ScanResult scan_some(const std::vector<robustness::Size>& sizes, RaceControl control,
                     std::uint64_t seed, const std::vector<std::uint64_t>& without, long most,
                     int free_nodes) {
  std::vector<std::uint64_t> indices;
  std::vector<robustness::Case> cases;
  for (const std::uint64_t index : without) {
    const auto made = robustness::make_case(sizes, control, seed, index);
    if (made.point.radial_load_z != 0.0 || static_cast<long>(cases.size()) >= most) continue;
    indices.push_back(index);
    cases.push_back(made);
  }
  std::vector<char> found(cases.size());
  std::atomic<long> finished = 0;
  tbb::parallel_for(std::size_t{0}, cases.size(), [&](std::size_t i) {
    const bearing::Bearing one(cases[i].geometry, bearing::steel(), bearing::steel());
    const int nodes = cases[i].options.tilt == bearing::Tilt::free ? free_nodes : 60;
    found[i] = robustness::scan_finds_equilibrium(one, cases[i].point, cases[i].options, nodes);
    show_progress("scanned", ++finished, static_cast<long>(cases.size()));
  });
  ScanResult result{.scanned = static_cast<long>(cases.size()), .found = {}};
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (found[i]) result.found.push_back(indices[i]);
  return result;
}

void report(const char* control, const char* mode, const Tally& t, const ScanResult& scan,
            long points) {
  const long converged = t.status[static_cast<std::size_t>(SolveStatus::converged)];
  fmt::print("{} control, {} points, {}\n", control, points, mode);
  for (std::size_t s = 0; s < t.status.size(); ++s)
    if (t.status[s] > 0)
      fmt::print("  {:<16} {:>9}\n", bearing::name(static_cast<SolveStatus>(s)), t.status[s]);
  fmt::print("  Newton steps: {:.2f} on average, {:.1f} % within 8, at most {}\n",
             static_cast<double>(t.iterations) / static_cast<double>(converged),
             100.0 * static_cast<double>(t.in_eight) / static_cast<double>(converged), t.most);
  fmt::print("  in one run, without path or search: {:.1f} %, {:.2f} steps on average\n",
             100.0 * static_cast<double>(t.in_one_run) / static_cast<double>(converged),
             static_cast<double>(t.iterations_of_one_run) / static_cast<double>(t.in_one_run));
  fmt::print("  loads recovered to {:.1e} at worst\n", t.worst_load_error);
  if (scan.scanned == 0) return;
  // The scanned share stands for all points without equilibrium.
  const double missed = static_cast<double>(t.without.size()) *
                        static_cast<double>(scan.found.size()) / static_cast<double>(scan.scanned);
  fmt::print(
      "  no_equilibrium scanned: {}, an equilibrium found after all in {}: about {:.3f} % of the\n"
      "  points that have one\n",
      scan.scanned, scan.found.size(), 100.0 * missed / (missed + static_cast<double>(converged)));
  for (const std::uint64_t index : scan.found) fmt::print("  found after all: point {}\n", index);
}

}  // namespace

int main(int argc, char** argv) {
  long points = 1000000, scan = 300;
  int nodes = 24;
  std::uint64_t seed = 1;
  std::string control = "both", mode = "scalar", of = "bearings";
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string flag = argv[i];
    if (flag == "--points")
      points = std::atol(argv[i + 1]);
    else if (flag == "--scan")
      scan = std::atol(argv[i + 1]);
    else if (flag == "--nodes")
      nodes = std::atoi(argv[i + 1]);
    else if (flag == "--seed")
      seed = static_cast<std::uint64_t>(std::atol(argv[i + 1]));
    else if (flag == "--control")
      control = argv[i + 1];
    else if (flag == "--mode")
      mode = argv[i + 1];
    else if (flag == "--of")
      of = argv[i + 1];
    else {
      fmt::print(stderr, "robustness: {}: no such flag; see the head of bench/robustness.cpp\n",
                 flag);
      return 1;
    }
  }
  if (of == "wild") return solve_wild(seed, points) ? 0 : 1;
  const auto sizes = catalogue_sizes();
  for (const RaceControl c : {RaceControl::outer, RaceControl::inner}) {
    const char* name = c == RaceControl::outer ? "outer" : "inner";
    if (control != "both" && control != name) continue;
    if (of == "arrangements") {
      report(name, "one by one", solve_arrangements(sizes, c, seed, points), {}, points);
      continue;
    }
    const bool scalar = mode != "batch", batch = mode != "scalar";
    const Both all = solve_all(sizes, c, seed, points, scalar, batch);
    const Tally& one = scalar ? all.scalar : all.batch;
    const ScanResult found = scan_some(sizes, c, seed, one.without, scan, nodes);
    if (scalar) report(name, "one by one", all.scalar, found, points);
    if (batch) report(name, "side by side", all.batch, scalar ? ScanResult{} : found, points);
    if (scalar && batch)
      fmt::print(
          "  one by one against side by side: {} other statuses, {} other states, else equal to "
          "{:.1e}\n",
          all.other_status, all.other_state, all.worst_difference);
  }
  return 0;
}
