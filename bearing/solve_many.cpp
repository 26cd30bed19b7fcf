#include "bearing/solve_many.h"

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "bearing/simd_kernel.h"

namespace raceway::bearing {
namespace {

constexpr std::size_t chunk = 512;  // points that a thread takes
constexpr std::size_t batch = 128;  // of these at most go through a kernel at a time

/// Memory of a thread, kept between calls.
struct Memory {
  std::vector<KernelBlock> blocks;
  std::vector<std::size_t> index;  // of the points in these, in the call
  std::vector<BallReport<Eight>> balls;
  std::vector<bool> done;
  std::vector<BearingEquilibrium> visited;
};

Memory& memory() {
  thread_local Memory m;
  return m;
}

/// What points must have in common to be solved side by side.
struct Kind {
  int ball_count;
  Symmetry symmetry;
  bool at_rest;
  bool operator==(const Kind&) const = default;
};

template <typename Case>
class Chunk {
 public:
  /// `at(i)` is case i of the chunk.
  Chunk(const Case& at, std::span<BearingEquilibrium> results, const EquilibriumOptions& options,
        InstructionSet set)
      : at_(at), results_(results), options_(options), set_(set) {}

  void solve() {
    m_.done.assign(results_.size(), false);
    for (std::size_t i = 0; i < results_.size(); ++i) {
      if (m_.done[i]) continue;
      const auto [bearing, point] = at_(i);
      if (point.axial_load > 0.0 && options_.rotations.empty()) {
        solve_like(i, kind(bearing, point));
      } else {
        results_[i] = solve_bearing_equilibrium(bearing, point, options_);
      }
    }
  }

 private:
  static Kind kind(const Bearing& bearing, const OperatingPoint& point) {
    return {bearing.geometry().ball_count, ball_circle(bearing, point).symmetry,
            point.speed == 0.0};
  }

  /// Point i and those after it that are of its kind, as many as make a batch.
  void solve_like(std::size_t first, const Kind& like) {
    m_.blocks.resize(batch / Eight::size);
    m_.index.clear();
    const Bearing* unloaded = nullptr;
    RingPoint<double> ring{};
    const auto place = [&](std::size_t n) {
      copy_lanes(m_.blocks[n / Eight::size].points, n % Eight::size, ring, 0);
    };
    for (std::size_t i = first; i < results_.size() && m_.index.size() < batch; ++i) {
      if (m_.done[i]) continue;
      const auto [bearing, point] = at_(i);
      if (!(point.axial_load > 0.0) || kind(bearing, point) != like) continue;
      m_.done[i] = true;
      if (&bearing != unloaded) ring = unloaded_point(bearing, options_);
      unloaded = &bearing;
      set_operating_point(ring, bearing, point, options_);
      place(m_.index.size());
      m_.index.push_back(i);
    }
    const std::size_t count = m_.index.size();
    for (std::size_t n = count; n % Eight::size != 0; ++n) place(n);
    const auto [bearing, point] = at_(first);
    const BallCircle circle = ball_circle(bearing, point);
    const auto used = static_cast<std::size_t>(circle.used());
    m_.balls.resize(m_.blocks.size() * used);
    run({.circle = circle,
         .model = ball_model(ring, options_),
         .tilts = options_.tilt == Tilt::free,
         .tolerance = options_.tolerance,
         .blocks = m_.blocks.data(),
         .count = count,
         .balls = m_.balls.data()});
    for (std::size_t n = 0; n < count; ++n) take(n, circle);
  }

  /// Point n of the batch as its result.
  void take(std::size_t n, const BallCircle& circle) {
    const KernelBlock& block = m_.blocks[n / Eight::size];
    const std::size_t lane = n % Eight::size;
    BearingEquilibrium& result = results_[m_.index[n]];
    // Where rounding decides, instruction sets that round less would see what others do not: there
    // the word is that of the single solve.
    if (!block.converged[lane] ||
        !(block.points.rounding.lanes[lane] <= 10.0 * options_.tolerance) ||
        !(block.report.recovered_load_error.lanes[lane] <= largest_load_error)) {
      const auto [bearing, point] = at_(m_.index[n]);
      result = solve_bearing_equilibrium(bearing, point, options_);
      return;
    }
    const auto used = static_cast<std::size_t>(circle.used());
    fill_equilibrium(block.points.lever, circle, block.ring, block.report,
                     &m_.balls[n / Eight::size * used], lane, result);
    result.report.status = SolveStatus::converged;
    result.report.iterations = block.steps[lane];
  }

  void run(const KernelCall& call) const {
    switch (set_) {
      case InstructionSet::sse2:
        return solve_sse2(call);
      case InstructionSet::avx2:
        return solve_avx2(call);
      case InstructionSet::avx512:
        return solve_avx512(call);
    }
  }

  const Case& at_;
  std::span<BearingEquilibrium> results_;
  const EquilibriumOptions& options_;
  InstructionSet set_;
  Memory& m_ = memory();
};

void require_available(InstructionSet set) {
  if (!available(set))
    throw std::invalid_argument("this computer does not support the instruction set " +
                                std::string(name(set)));
}

template <typename Body>
void for_chunks(std::size_t count, const Body& body) {
  tbb::parallel_for(
      std::size_t{0}, (count + chunk - 1) / chunk,
      [&](std::size_t c) { body(c * chunk, std::min(chunk, count - c * chunk)); },
      tbb::simple_partitioner());
}

struct OneCase {
  const Bearing& bearing;
  const OperatingPoint& point;
};

}  // namespace

std::string_view name(InstructionSet set) {
  switch (set) {
    case InstructionSet::sse2:
      return "sse2";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
  }
  return "sse2";
}

bool available(InstructionSet set) {
  switch (set) {
    case InstructionSet::sse2:
      return true;
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
             __builtin_cpu_supports("avx512vl");
  }
  return false;
}

InstructionSet best_instruction_set() {
  static const InstructionSet best = available(InstructionSet::avx512) ? InstructionSet::avx512
                                     : available(InstructionSet::avx2) ? InstructionSet::avx2
                                                                       : InstructionSet::sse2;
  return best;
}

void solve_many(const Bearing& bearing, std::span<const OperatingPoint> points,
                std::span<BearingEquilibrium> results, const EquilibriumOptions& options,
                InstructionSet set) {
  if (points.size() != results.size())
    throw std::invalid_argument(
        "solve_many: the number of results must equal the number of points");
  require_available(set);
  for (const OperatingPoint& p : points) validate(p);
  for_chunks(points.size(), [&](std::size_t first, std::size_t count) {
    const auto at = [&](std::size_t i) { return OneCase{bearing, points[first + i]}; };
    Chunk(at, results.subspan(first, count), options, set).solve();
  });
}

void solve_many(std::span<const BearingCase> cases, std::span<BearingEquilibrium> results,
                const EquilibriumOptions& options, InstructionSet set) {
  if (cases.size() != results.size())
    throw std::invalid_argument("solve_many: the number of results must equal the number of cases");
  require_available(set);
  for (const BearingCase& c : cases) validate(c.point);
  for_chunks(cases.size(), [&](std::size_t first, std::size_t count) {
    const auto at = [&](std::size_t i) {
      return OneCase{*cases[first + i].bearing, cases[first + i].point};
    };
    Chunk(at, results.subspan(first, count), options, set).solve();
  });
}

void visit_equilibria(const Bearing& bearing, std::span<const OperatingPoint> points,
                      const std::function<void(std::size_t, const BearingEquilibrium&)>& take,
                      const EquilibriumOptions& options, InstructionSet set) {
  require_available(set);
  for (const OperatingPoint& p : points) validate(p);
  for_chunks(points.size(), [&](std::size_t first, std::size_t count) {
    const auto at = [&](std::size_t i) { return OneCase{bearing, points[first + i]}; };
    std::vector<BearingEquilibrium>& results = memory().visited;
    if (results.size() < count) results.resize(count);
    Chunk(at, std::span(results).first(count), options, set).solve();
    for (std::size_t i = 0; i < count; ++i) take(first + i, results[i]);
  });
}

}  // namespace raceway::bearing
