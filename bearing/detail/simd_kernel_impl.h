#pragma once

#include <cstring>
#include <vector>
#include <xsimd/xsimd.hpp>

#include "bearing/ring_newton.h"
#include "bearing/simd_kernel.h"
#include "bearing/thrust_start.h"

// One source file for each instruction set includes this header. The linker must not merge code
// compiled for different instruction sets, so each function is templated on T or always inlined.
// (The argument reduction of xsimd for very large angles is an exception, but contact angles are
// never so large.)
namespace raceway::bearing {

/// Memory of a kernel. Each thread has one such object and uses it again in later calls.
template <typename T>
struct KernelMemory {
  RingNewton<T> newton;
  std::vector<ThrustStart<T>> starts;  ///< starting states; each entry has `width` points
  std::vector<Mask<T>> started;
  std::vector<PlaneOf<T>> balls;  ///< positions in equilibrium; each entry has `width` points
  std::vector<BallReport<T>> reports;
};

template <typename T, BallModel model, class C>
class KernelRun {
 public:
  KernelRun(const KernelCall& call, KernelMemory<T>& memory)
      : call_(call),
        memory_(memory),
        used_(static_cast<std::size_t>(call.circle.used())),
        groups_((call.count + width - 1) / width) {}

  void run() {
    memory_.starts.resize(groups_);
    memory_.started.resize(groups_);
    memory_.balls.resize(groups_ * used_);
    memory_.reports.resize(used_);
    memory_.newton.resize(used_);
    find_starts();
    iterate();
    for (std::size_t g = 0; g < groups_; ++g) report(g);
  }

 private:
  static constexpr std::size_t width = Lanes<T>::count;

  [[nodiscard]] KernelBlock& block_of(std::size_t point) const {
    return call_.blocks[point / Eight::size];
  }

  void find_starts() {
    constexpr auto control =
        model == BallModel::inner_control ? RaceControl::inner : RaceControl::outer;
    RingPoint<T> p;
    for (std::size_t g = 0; g < groups_; ++g) {
      copy_lanes<width>(p, 0, block_of(g * width).points, g * width % Eight::size);
      memory_.started[g] = thrust_start<control, T>(
          p.ball, p.free, p.load[0] * (1.0 / call_.circle.count), memory_.starts[g]);
    }
  }

  /// Each lane solves one point. When the point is finished, the lane begins the next point.
  void iterate() {
    constexpr int most_steps = 40;
    const NewtonLimits limits{.tolerance = call_.tolerance, .steps = most_steps};
    std::size_t next = 0, working = 0;
    for (std::size_t i = 0; i < width; ++i) {
      // A lane without work computes the first point of the call again.
      copy_lanes(memory_.newton.point, i, call_.blocks[0].points, 0);
      point_of_[i] = none;
      working += begin(i, next);
    }
    while (working > 0) {
      const NewtonProgress<T> p = memory_.newton.template pass<model, C>(call_.circle, limits);
      const Mask<T> ended = p.converged || p.not_finite || p.singular || p.exhausted;
      if (!any(ended)) continue;
      const T end = select(ended, T(1.0), T(0.0)), good = select(p.converged, T(1.0), T(0.0));
      for (std::size_t i = 0; i < width; ++i) {
        if (lane(end, i) == 0.0 || point_of_[i] == none) continue;
        if (lane(good, i) != 0.0) keep(i);
        point_of_[i] = none;
        --working;
        working += begin(i, next);
      }
    }
  }

  /// Starts lane i with the next point for which a thrust start was found. Returns false if no such
  /// point is left.
  bool begin(std::size_t i, std::size_t& next) {
    RingNewton<T>& newton = memory_.newton;
    while (next < call_.count) {
      const std::size_t n = next++;
      block_of(n).converged[n % Eight::size] = false;
      const Mask<T>& started = memory_.started[n / width];
      if (lane(select(started, T(1.0), T(0.0)), n % width) == 0.0) continue;
      const ThrustStart<T>& start = memory_.starts[n / width];
      copy_lanes(newton.point, i, block_of(n).points, n % Eight::size);
      for (const int c : C::at) set_lane(newton.trial_ring[c], i, 0.0);
      set_lane(newton.trial_ring[0], i, lane(start.axial_displacement, n % width));
      const double axial = lane(start.ball_centre.axial, n % width);
      const double radial = lane(start.ball_centre.radial, n % width);
      for (PlaneOf<T>& x : newton.trial_balls) {
        set_lane(x.axial, i, axial);
        set_lane(x.radial, i, radial);
      }
      newton.begin(i);
      point_of_[i] = n;
      return true;
    }
    return false;
  }

  void keep(std::size_t i) {
    const RingNewton<T>& newton = memory_.newton;
    const std::size_t n = point_of_[i], j = n % Eight::size;
    KernelBlock& block = block_of(n);
    block.converged[j] = true;
    block.steps[j] = static_cast<int>(lane(newton.steps, i));
    for (Eight& q : block.ring) q.lanes[j] = 0.0;
    for (const int c : C::at) block.ring[c].lanes[j] = lane(newton.trial_ring[c], i);
    PlaneOf<T>* const balls = &memory_.balls[n / width * used_];
    for (std::size_t k = 0; k < used_; ++k) {
      set_lane(balls[k].axial, n % width, lane(newton.trial_balls[k].axial, i));
      set_lane(balls[k].radial, n % width, lane(newton.trial_balls[k].radial, i));
    }
  }

  void report(std::size_t group) {
    const std::size_t block = group * width / Eight::size, first = group * width % Eight::size;
    KernelBlock& b = call_.blocks[block];
    RingPoint<T> p;
    copy_lanes<width>(p, 0, b.points, first);
    T ring[5];
    for (int c = 0; c < 5; ++c) std::memcpy(&ring[c], b.ring[c].lanes + first, sizeof(T));
    RingReport<T> found;
    report_ring<model>(p, call_.circle, call_.tilts, ring, &memory_.balls[group * used_],
                       memory_.reports.data(), found);
    copy_lanes<width>(b.report, first, found, 0);
    for (std::size_t k = 0; k < used_; ++k)
      copy_lanes<width>(call_.balls[block * used_ + k], first, memory_.reports[k], 0);
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  const KernelCall& call_;
  KernelMemory<T>& memory_;
  std::size_t used_, groups_;
  std::size_t point_of_[width];
};

template <typename T>
void solve_in(const KernelCall& call) {
  thread_local KernelMemory<T> memory;
  with_race_control(call.model, [&](auto model) {
    with_coordinates(call.circle.symmetry, call.tilts, [&](auto coordinates) {
      KernelRun<T, decltype(model)::value, decltype(coordinates)>(call, memory).run();
    });
  });
}

}  // namespace raceway::bearing
