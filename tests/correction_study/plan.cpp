#include "tests/correction_study/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace correction_study {
namespace {

constexpr double between_stops = 300.0;
constexpr double between_runs = 9.0 * hour;

/// A value that holds until the next begins.
template <typename T>
struct Blocks {
  struct Block {
    double begin;
    T value;
  };
  std::vector<Block> blocks{};
  [[nodiscard]] const T& at(double time) const {
    const auto after = std::find_if(blocks.begin() + 1, blocks.end(),
                                    [&](const Block& b) { return b.begin > time; });
    return (after - 1)->value;
  }
};

double some_speed(double top, Random& random) {
  return random.chance(0.25) ? 0.0 : top * 0.05 * random.whole(1, 20);
}

void add_spectrum(Blocks<double>& speeds, double begin, double end, double length, double top,
                  Random& random) {
  double last = -1.0;
  for (double t = begin; t < end; t += length) {
    double speed = some_speed(top, random);
    while (speed == last) speed = some_speed(top, random);
    last = speed;
    speeds.blocks.push_back({t, speed});
  }
}

void add_stairs(Blocks<double>& speeds, double end, double top, Random& random) {
  const bool rests = random.chance(0.5);
  constexpr std::array levels{0.2, 0.5, 0.8, 1.0, 0.65, 0.35};
  std::size_t i = static_cast<std::size_t>(random.whole(0, 5));
  for (double t = 0.0; t < end; ++i) {
    speeds.blocks.push_back({t, top * levels[i % levels.size()]});
    t += random.about(1.2 * hour, 0.3);
    if (!rests && i % 3 != 2) continue;
    speeds.blocks.push_back({t, 0.0});
    t += random.about(1.5 * hour, 0.4);
  }
}

Blocks<double> speeds_of(const PlanWish& wish, double seconds, Random& random) {
  Blocks<double> speeds;
  const double top = wish.top_speed;
  switch (wish.profile) {
    case Profile::heat_cool: {
      const double hot = random.about(0.25 * seconds, 0.2),
                   cold = random.about(0.18 * seconds, 0.2);
      speeds.blocks = {{0.0, 0.1 * top * random.whole(6, 9)}, {hot, 0.0}};
      add_spectrum(speeds, hot + cold, seconds, hour, top, random);
      break;
    }
    case Profile::stairs:
      add_stairs(speeds, seconds, top, random);
      break;
    case Profile::spectrum_30:
      add_spectrum(speeds, 0.0, seconds, 0.5 * hour, top, random);
      break;
    case Profile::spectrum_60:
      add_spectrum(speeds, 0.0, seconds, hour, top, random);
      break;
    case Profile::spectrum_120:
      add_spectrum(speeds, 0.0, seconds, 2.0 * hour, top, random);
      break;
  }
  return speeds;
}

/// One axis does most of the travel.
Blocks<std::array<double, 3>> feeds_of(double seconds, Random& random) {
  Blocks<std::array<double, 3>> feeds;
  for (double t = 0.0; t < seconds; t += random.between(0.6, 2.8) * hour) {
    std::array<double, 3> feed{};
    for (double& f : feed)
      if (random.chance(0.55)) f = random.sign() * random.between(3.0, 20.0);
    feeds.blocks.push_back({t, feed});
  }
  return feeds;
}

Blocks<bool> coolant_of(double seconds, Random& random) {
  Blocks<bool> coolant;
  bool on = random.chance(0.5);
  for (double t = 0.0; t < seconds; t += random.between(1.0, 3.5) * hour) {
    coolant.blocks.push_back({t, on});
    on = !on;
  }
  return coolant;
}

}  // namespace

std::vector<PlannedRow> make_plan(const PlanWish& wish, Random& random) {
  std::vector<PlannedRow> rows;
  const double seconds = wish.hours * hour / wish.runs;
  const int per_stop = static_cast<int>(between_stops / wish.sampling);
  double begin = 0.0;
  for (int run = 0; run < wish.runs; ++run, begin += seconds + between_runs) {
    const Blocks<double> speeds = speeds_of(wish, seconds, random);
    const auto feeds = feeds_of(wish.feeds ? seconds : 1.0, random);
    const auto coolant = coolant_of(wish.coolant_switches ? seconds : 1.0, random);
    double t = 0.0;
    for (int i = 0; t < seconds; ++i) {
      const bool stop = wish.stops && i % per_stop == 0;
      Setting setting{.speed = stop ? 0.0 : speeds.at(t)};
      if (wish.feeds && !stop) setting.feed = feeds.at(t);
      if (wish.coolant_switches) setting.coolant_on = coolant.at(t);
      rows.push_back({begin + t, setting, run + 1, stop || !wish.stops});
      t += wish.sampling * (wish.uneven ? random.between(0.6, 1.4) : 1.0);
      t = 0.01 * std::round(100.0 * t);
    }
  }
  return rows;
}

std::vector<double> calm_times(const std::vector<PlannedRow>& plan, int count, double apart,
                               Random& random) {
  std::vector<double> changes{plan.front().time, plan.back().time};
  for (std::size_t i = 1; i < plan.size(); ++i)
    if (plan[i].setting.speed != plan[i - 1].setting.speed) changes.push_back(plan[i].time);
  const double begin = plan.front().time, part = (plan.back().time - begin) / count;
  std::vector<double> times;
  for (int k = 0; k < count; ++k)
    for (int attempt = 0; attempt < 1000; ++attempt) {
      const double t = begin + part * (k + random.between(0.2, 0.8));
      const auto near = [&](double change) { return std::abs(t - change) < apart; };
      if (std::any_of(changes.begin(), changes.end(), near)) continue;
      times.push_back(t);
      break;
    }
  return times;
}

}  // namespace correction_study
