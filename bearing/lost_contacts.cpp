#include "bearing/lost_contacts.h"

#include <algorithm>
#include <cmath>

#include "bearing/contact_scan.h"

namespace raceway::bearing {
namespace {

// Steps of one Newton run: from the first set, from others; from a scan, whose starts are coarse.
constexpr int first_limit = 12, ranked_limit = 10, neighbour_limit = 8, wide_limit = 15;
constexpr int scan_limit = 20;
constexpr int most_rounds = 12;          // changes of one set
constexpr std::size_t most_ranked = 10;  // sets tried of those that statics ranks
// Sets of a scan that balance with a contact on the wrong side; more of them are not looked for.
constexpr std::size_t most_scanned = 60;

}  // namespace

bool ContactSearch::settle(RingState& state) {
  if (system_.balls_used() < 2) return false;
  std::vector<std::pair<LoadShares, Contacts>> sides;
  sides.emplace_back(LoadShares(system_, direction()), Contacts());
  // The couple turns the force of a ball so far that balls opposite to the load may carry it.
  if (system_.options().tilt == Tilt::locked)
    sides.emplace_back(LoadShares(system_, direction() + pi), Contacts());
  for (auto& [shares, chosen] : sides)
    if (shares.choose(chosen, state) && settle_from(shares, chosen, state)) return true;
  for (const auto& [shares, chosen] : sides)
    if (!chosen.empty() && try_ranked(shares, chosen, state)) return true;
  return try_neighbours(neighbour_limit, state);
}

bool ContactSearch::widen(RingState& state) { return try_neighbours(wide_limit, state); }

/// A set counts as it is; of those with a contact on the wrong side the neighbours are tried then,
/// from the set that was nearest to balance on.
bool ContactSearch::scan(RingState& state) {
  if (system_.balls_used() < 2) return false;
  std::vector<OpenSet> open;
  for (ScannedSet& set : scan_contacts(system_, direction())) {
    if (system_.exhausted() || open.size() == most_scanned) break;
    if (!balance(set.contacts, set.state, scan_limit)) continue;
    const auto [worst, pulls] = worst_contact(set.contacts, set.state);
    if (worst == set.contacts.size()) {
      state = std::move(set.state);
      return true;
    }
    open.push_back({std::move(set.contacts), std::move(set.state), pulls});
  }
  open_.assign(open.rbegin(), open.rend());  // the last is tried first
  return try_neighbours(wide_limit, state);
}

/// Of the load, or of what a moment alone presses most.
double ContactSearch::direction() const {
  const Vector5 load = system_.load();
  return load.segment<2>(1).norm() > 0.0 ? std::atan2(load[2], load[1])
                                         : std::atan2(load[3], -load[4]);
}

/// From a set and its start to one in which all contacts hold.
bool ContactSearch::settle_from(const LoadShares& shares, Contacts contacts, RingState& state) {
  for (int round = 0; round < most_rounds && !system_.exhausted(); ++round) {
    if (is_seen(contacts)) return false;
    if (!balance(contacts, state, first_limit) && (round > 0 || !retreat(shares, contacts, state)))
      return false;
    const auto [worst, pulls] = worst_contact(contacts, state);
    if (worst == contacts.size()) return true;
    open_.push_back({contacts, state, pulls});
    contacts[worst] = pulls ? InnerContact::lost : InnerContact::kept;
    if (pulls) state.balls[worst] = system_.thrown_ball();
  }
  return false;
}

/// Fewer kept balls than statics chose, from which the others can be added one by one.
bool ContactSearch::retreat(const LoadShares& shares, Contacts& contacts, RingState& state) {
  for (std::size_t place = shares.order().size(); place-- > 2;) {
    InnerContact& contact = contacts[shares.order()[place]];
    if (contact == InnerContact::lost) continue;
    contact = InnerContact::lost;
    return shares.spread(contacts, state) && balance(contacts, state, first_limit);
  }
  return false;
}

bool ContactSearch::try_ranked(const LoadShares& shares, const Contacts& chosen, RingState& state) {
  struct Candidate {
    double violation;
    Contacts contacts;
    RingState state;
  };
  std::vector<Candidate> ranked;
  for (Contacts& contacts : similar_sets(shares, chosen)) {
    if (std::find(seen_.begin(), seen_.end(), contacts) != seen_.end()) continue;
    RingState start;
    const double violation = shares.violation(contacts, start);
    if (std::isfinite(violation))
      ranked.push_back({violation, std::move(contacts), std::move(start)});
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const Candidate& a, const Candidate& b) {
    return a.violation < b.violation;
  });
  if (ranked.size() > most_ranked) ranked.resize(most_ranked);
  for (Candidate& c : ranked) {
    if (system_.exhausted()) return false;
    if (is_seen(c.contacts) || !balance(c.contacts, c.state, ranked_limit)) continue;
    const auto [worst, pulls] = worst_contact(c.contacts, c.state);
    if (worst == c.contacts.size()) {
      state = std::move(c.state);
      return true;
    }
    open_.push_back({std::move(c.contacts), std::move(c.state), pulls});
  }
  return false;
}

/// A few more or less kept at either end, and the same with one ball of a group moved on to its
/// inner side: K.KK, KK.K or .KKK in place of KKK.
std::vector<ContactSearch::Contacts> ContactSearch::similar_sets(const LoadShares& shares,
                                                                 const Contacts& chosen) const {
  const bool free_tilt = system_.options().tilt == Tilt::free;
  const std::vector<std::size_t>& order = shares.order();
  const int n = static_cast<int>(chosen.size());
  const auto kept_at = [&](int place) {
    return chosen[order[static_cast<std::size_t>(place)]] == InnerContact::kept;
  };
  int first = 0, last = 0;
  while (first < n && kept_at(first)) ++first;
  while (first < n && kept_at(n - 1 - last)) ++last;
  std::vector<Contacts> sets;
  std::vector<int> places;
  const auto add = [&] {
    Contacts& contacts = sets.emplace_back(chosen.size(), InnerContact::lost);
    for (const int place : places)
      contacts[order[static_cast<std::size_t>(place)]] = InnerContact::kept;
  };
  for (int a = std::max(1, first - 2); a <= std::min(n, first + 2); ++a) {
    for (int b = std::max(0, last - 2); b <= std::min(n - a, last + (free_tilt ? 2 : 1)); ++b) {
      places.clear();
      for (int i = 0; i < a; ++i) places.push_back(i);
      for (int i = 0; i < b; ++i) places.push_back(n - 1 - i);
      add();
      if (a + b >= n) continue;
      for (int i = 0; i < a + b; ++i) {
        const bool middle = i < a ? i > 3 && i < a - 4 : i - a > 3 && i - a < b - 4;
        if (middle) continue;
        const int place = std::exchange(places[static_cast<std::size_t>(i)], i < a ? a : n - 1 - b);
        add();
        places[static_cast<std::size_t>(i)] = place;
      }
    }
  }
  return sets;
}

/// Sets that differ by one ball from those that come near, the last ones first.
bool ContactSearch::try_neighbours(int limit, RingState& state) {
  for (std::size_t i = open_.size(); i-- > 0 && !system_.exhausted();) {
    const OpenSet open = open_[i];
    std::vector<std::pair<double, std::size_t>> nearest;
    for (std::size_t k = 0; k < open.contacts.size(); ++k)
      if ((open.contacts[k] == InnerContact::kept) == open.pulls)
        nearest.emplace_back(std::abs(approach(open.state, k)), k);
    std::sort(nearest.begin(), nearest.end());
    for (const auto& [distance, k] : nearest)
      if (!system_.exhausted() && try_changed(open, k, limit, state)) return true;
  }
  return false;
}

/// An open set with one ball the other way.
bool ContactSearch::try_changed(const OpenSet& open, std::size_t ball, int limit,
                                RingState& state) {
  Contacts contacts = open.contacts;
  const bool lose = contacts[ball] == InnerContact::kept;
  contacts[ball] = lose ? InnerContact::lost : InnerContact::kept;
  if (is_seen(contacts)) return false;
  state = open.state;
  state.balls[ball] = lose ? system_.thrown_ball() : between_grooves(state, ball);
  return balance(contacts, state, limit) && worst_contact(contacts, state).first == contacts.size();
}

bool ContactSearch::is_seen(const Contacts& contacts) {
  if (std::find(seen_.begin(), seen_.end(), contacts) != seen_.end()) return true;
  seen_.push_back(contacts);
  return false;
}

bool ContactSearch::balance(const Contacts& contacts, RingState& state, int limit) {
  system_.contacts = contacts;
  system_.newton_limit = limit;
  system_.newton_rise = 400.0;
  const bool found = system_.newton(state);
  system_.newton_limit = 40;
  system_.newton_rise = 4.0;
  system_.contacts.clear();
  return found;
}

/// The ball furthest on the wrong side, and whether it pulls; all sides right: the count of
/// balls.
std::pair<std::size_t, bool> ContactSearch::worst_contact(const Contacts& contacts,
                                                          const RingState& state) const {
  std::size_t pulling = contacts.size(), reaching = contacts.size();
  double most_pull = 0.0, most_reach = 0.0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const double into_race = approach(state, k);
    const bool kept = contacts[k] == InnerContact::kept;
    if (kept && into_race <= most_pull) {
      most_pull = into_race;
      pulling = k;
    } else if (!kept && into_race > most_reach) {
      most_reach = into_race;
      reaching = k;
    }
  }
  if (pulling < contacts.size()) return {pulling, true};
  return {reaching, false};
}

/// Of ball k to the inner race [m].
double ContactSearch::approach(const RingState& state, std::size_t k) const {
  const Plane a = system_.groove_centre(state.ring, k), x = state.balls[k];
  return std::hypot(a.axial - x.axial, a.radial - x.radial) - system_.constants().inner_radius;
}

/// On the line between the groove centres, pressed against both races.
Plane ContactSearch::between_grooves(const RingState& state, std::size_t k) const {
  const Plane a = system_.groove_centre(state.ring, k);
  const double length = std::hypot(a.axial, a.radial);
  const double outer = system_.constants().outer_radius, inner = system_.constants().inner_radius;
  const double part = std::max(1.0001 * outer, length * outer / (outer + inner)) / length;
  return {part * a.axial, part * a.radial};
}

}  // namespace raceway::bearing
