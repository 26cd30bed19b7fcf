#pragma once

#include <utility>
#include <vector>

#include "bearing/load_shares.h"

namespace raceway::bearing {

/// Searches for an equilibrium under inner control with each inner contact fixed as kept or lost.
/// The gyroscopic couple vanishes with the contact, and the ball then moves further from the race.
/// So for a range of groove positions both states are possible, and the search tries sets of kept
/// balls. A solution is valid if no kept ball is in tension and no lost ball penetrates the race.
class ContactSearch {
 public:
  explicit ContactSearch(RingSystem& system) : system_(system) {}

  /// Searches from the kept balls that statics chooses (load_shares.h). A ball on the wrong side
  /// changes sides until none is left. If a set recurs, the search tries similar sets, best statics
  /// fit first, then sets that differ by one ball from the near misses.
  [[nodiscard]] bool settle(RingState& state);
  /// Tries more of the last kind, with balls that turn far over.
  [[nodiscard]] bool widen(RingState& state);
  /// As a last resort: from the sets that a scan over places of the ring finds (contact_scan.h),
  /// then from those that differ from one of them by one ball.
  [[nodiscard]] bool scan(RingState& state);

 private:
  using Contacts = std::vector<InnerContact>;

  /// A set of contacts with an equilibrium, but with at least one ball on the wrong side.
  struct OpenSet {
    Contacts contacts;
    RingState state;
    bool pulls;  ///< true if a kept ball is in tension; else a lost one penetrates the race
  };

  [[nodiscard]] double direction() const;
  bool settle_from(const LoadShares& shares, Contacts contacts, RingState& state);
  bool retreat(const LoadShares& shares, Contacts& contacts, RingState& state);
  bool try_ranked(const LoadShares& shares, const Contacts& chosen, RingState& state);
  bool try_neighbours(int limit, RingState& state);
  bool try_changed(const OpenSet& open, std::size_t ball, int limit, RingState& state);
  [[nodiscard]] std::vector<Contacts> similar_sets(const LoadShares& shares,
                                                   const Contacts& chosen) const;
  bool is_seen(const Contacts& contacts);
  bool balance(const Contacts& contacts, RingState& state, int limit);
  [[nodiscard]] std::pair<std::size_t, bool> worst_contact(const Contacts& contacts,
                                                           const RingState& state) const;
  [[nodiscard]] double approach(const RingState& state, std::size_t ball) const;
  [[nodiscard]] Plane between_grooves(const RingState& state, std::size_t ball) const;

  RingSystem& system_;
  std::vector<OpenSet> open_;
  std::vector<Contacts> seen_;
};

}  // namespace raceway::bearing
