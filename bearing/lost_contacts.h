#pragma once

#include <utility>
#include <vector>

#include "bearing/load_shares.h"

namespace raceway::bearing {

/// Searches for an equilibrium under inner control with each inner contact fixed as kept or lost.
/// When a ball loses the contact, its gyroscopic couple becomes zero and the ball moves further
/// from the race. Over a range of groove positions, both `kept` and `lost` are therefore possible.
/// The search tries sets of kept balls. A solution is valid if no kept ball is in tension and no
/// lost ball penetrates the race.
class ContactSearch {
 public:
  explicit ContactSearch(RingSystem& system) : system_(system) {}

  /// Searches from the kept balls that statics chooses (load_shares.h). In each round, the kept
  /// ball most in tension or the lost ball that penetrates the race most changes its contact, until
  /// no such ball exists. If these rounds end without a valid equilibrium, for example because a
  /// set recurs, the search tries similar sets, beginning with the sets that fit statics best. Then
  /// the search tries sets that differ by one ball from the sets that were solved but not valid.
  /// Returns true if a valid equilibrium is found, with `state` as the solution.
  [[nodiscard]] bool settle(RingState& state);
  /// Repeats the last stage of settle(), the sets changed by one ball, with more Newton steps for
  /// each set.
  [[nodiscard]] bool widen(RingState& state);
  /// Last resort: starts from the sets that a scan over ring positions finds (contact_scan.h), then
  /// from sets that differ from one of these sets by one ball.
  [[nodiscard]] bool scan(RingState& state);

 private:
  using Contacts = std::vector<InnerContact>;

  /// A set of contacts that was solved, but is not valid for at least one ball.
  struct OpenSet {
    Contacts contacts;
    RingState state;
    bool pulls;  ///< true if a kept ball is in tension; else a lost ball penetrates the race
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
