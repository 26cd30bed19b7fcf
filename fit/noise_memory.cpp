#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "fit/detail/noise_search.h"

namespace raceway::fit {

namespace {

constexpr double unknown_runs = 0.5;   // share beside the states, where nothing tells it
constexpr double blocks_found = 6.63;  // of -2 ln L: 1 % of one parameter
constexpr double undetermined = 0.5;   // of -2 ln L
constexpr double worth_even_runs =
    2.0;  // of -2 ln L: a form as good is no reason to leave the usual

}  // namespace

double NoiseSearch::value() const {
  return misfit(noise_.correlation, noise_.run_share, shares_) + cost(shares_) +
         worth_a_parameter *
             ((noise_.correlation > 0.0 ? 1.0 : 0.0) + (noise_.run_share > 0.0 ? 1.0 : 0.0));
}

NoiseSearch::Memory NoiseSearch::memory() const {
  return {noise_.correlation, noise_.run_share, shares_, even_runs_};
}

void NoiseSearch::recall(const Memory& memory) {
  noise_.correlation = memory.correlation;
  noise_.run_share = memory.run_share;
  shares_ = memory.shares;
  even_runs_ = memory.even_runs;
}

void NoiseSearch::search_memory(bool timed, bool runs) {
  double &phi = noise_.correlation, &g = noise_.run_share;
  const double rest = beside_states();
  phi = g = 0.0;
  double best = value();
  const auto try_out = [&](double p, double q) {
    const double phi_before = std::exchange(phi, p), g_before = std::exchange(g, q);
    const double v = value();
    if (v < best) {
      best = v;
    } else {
      phi = phi_before;
      g = g_before;
    }
  };
  for (const double p : {0.0, 0.2, 0.4, 0.6, 0.75, 0.87, 0.95})
    for (const double q : {0.0, 0.1, 0.25, 0.5, 0.75, 0.9})
      if ((p == 0.0 || timed) && (q == 0.0 || runs)) try_out(p, q * rest);
  for (double step = 0.06; step > 0.005; step *= 0.5)
    for (const auto& [dp, dq] : std::array<std::pair<double, double>, 4>{
             {{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}}) {
      const double p = phi + dp, q = g + dq;
      if ((dp != 0.0 && (phi == 0.0 || p <= 0.0)) || (dq != 0.0 && (g == 0.0 || q <= 0.0)))
        continue;
      if (p <= 0.985 && q <= 0.95 * rest) try_out(p, q);
    }
}

void NoiseSearch::find_memory() {
  const bool timed = options_.correlation && order_.has_time;
  const bool runs = options_.runs && order_.has_runs;
  if (!timed && !runs) return;
  even_runs_ = false;
  search_memory(timed, runs);
  if (runs) {
    const Memory in_proportion = memory();
    const double of_proportion = value();
    // The parts were found as if rows were independent: offsets of one size look like absolute
    // noise.
    even_runs_ = true;
    const bool free = options_.absolute && !declared_;
    if (free) {
      noise_.correlation = 0.0;
      noise_.run_share = unknown_runs * beside_states();
      find_shares();
    }
    for (int round = 0; round < 2; ++round) {
      search_memory(timed, runs);
      if (free) find_shares();
    }
    const double of_even = value();
    const bool even = of_even < of_proportion - worth_even_runs;
    rival_.reset();
    if (std::abs(of_even - of_proportion) < within_the_likely)
      rival_ = even ? in_proportion : memory();
    if (!even) recall(in_proportion);
  }
  // Where runs and levels coincide nothing says how much the runs differ: as much as may be.
  double& g = noise_.run_share;
  const double phi = noise_.correlation;
  const double unknown = unknown_runs * beside_states();
  if (runs && misfit(phi, unknown, shares_) < misfit(phi, g, shares_) + undetermined) {
    g = std::max(g, unknown);
    noise_.unknown_runs = true;
  }
}

void NoiseSearch::find_states() {
  double best = value();
  NoiseModel chosen = noise_;
  Shares chosen_shares = shares_;
  const double phi = noise_.correlation, g = noise_.run_share;
  // As if rows were independent, the scatter within dwells took the part of the states as well.
  const std::vector<Shares> list =
      options_.absolute && !declared_ ? all_shares() : std::vector<Shares>{shares_};
  for (const double h : {0.1, 0.25, 0.5, 0.75, 0.9})
    for (const double p : {0.0, phi}) {
      if (g + h > 0.98) continue;
      noise_.state_share = h;
      noise_.correlation = p;
      find_shares(list);
      const double found = value() + worth_a_parameter;
      if (!(found < best)) continue;
      best = found;
      chosen = noise_;
      chosen_shares = shares_;
    }
  noise_ = std::move(chosen);
  shares_ = chosen_shares;
}

void NoiseSearch::find_blocks() {
  const double independent = misfit(0.0, 0.0, shares_) + cost(shares_), before = value();
  const NoiseModel without = noise_;
  const Shares shares = shares_;
  const RowOrder order = order_, some = some_order_;
  for (RowOrder* of : {&order_, &some_order_}) {
    of->new_run = of->new_block;
    of->has_runs = true;
  }
  find_memory();
  // Neighbours in time are alike within a block, too: of blocks and a correlation the better one.
  const double with = value();
  const bool found = noise_.run_share > 0.0 && with < independent - blocks_found && with < before;
  // Passages at a level each may be runs: the columns of the levels hold whatever they differ by,
  // even where the noise has a shape in which their offsets are no multiple of a column.
  const bool cautious = order.own_levels && options_.runs;
  if (cautious && !found) {
    noise_.run_share = std::max(noise_.run_share, unknown_runs * beside_states());
    noise_.unknown_runs = true;
  }
  if (found || cautious) {
    noise_.undeclared_blocks = true;
    return;
  }
  std::vector<Whitening> allowed;
  const auto allow = [&] {
    double factor = 1.0;
    if (noise_.run_share > 0.0 && value() < std::min(independent, before + within_the_likely))
      allowed.push_back(scaled(noise_.correlation, noise_.run_share, shares_, factor));
  };
  allow();
  if (rival_) {
    recall(*rival_);
    allow();
  }
  noise_ = without;
  shares_ = shares;
  even_runs_ = false;
  rival_.reset();
  std::move(allowed.begin(), allowed.end(), std::back_inserter(noise_.allowed));
  order_ = order;
  some_order_ = some;
}

}  // namespace raceway::fit
