#pragma once

#include <utility>
#include <vector>

#include "bearing/load_shares.h"

namespace raceway::bearing {

/// Searches for an equilibrium under inner control. In each trial, every ball is either kept (in
/// contact with the inner race) or lost (without this contact), see InnerContact. When a ball loses
/// the contact, its gyroscopic couple becomes zero, and the ball moves further away from the race.
/// Over a range of groove positions, a ball therefore has an equilibrium with inner contact and
/// another equilibrium without inner contact. The search therefore tries several sets of kept
/// balls. A solution is valid if no kept ball is in tension and no lost ball penetrates the race.
class ContactSearch {
 public:
  explicit ContactSearch(RingSystem& system) : system_(system) {}

  /// Starts with the kept balls that LoadShares::choose() returns. Each round solves the
  /// equilibrium and then changes the contact of one ball: the kept ball with the largest tension
  /// or, if no kept ball is in tension, the lost ball that penetrates the race most. The rounds end
  /// when the solution is valid. If the rounds find no valid equilibrium, the search tries similar
  /// sets of kept balls, those with the smallest LoadShares::violation() first. Then the search
  /// tries sets that differ by one ball from sets whose equilibrium was found but is not valid.
  /// Returns true if a valid equilibrium is found, and writes this equilibrium to `state`.
  [[nodiscard]] bool settle(RingState& state);
  /// Continues the last stage of settle() with more Newton steps for each set. This stage tries
  /// sets that differ by one ball from sets whose equilibrium was found but is not valid.
  [[nodiscard]] bool widen(RingState& state);
  /// Starts from the sets of kept balls that a scan over ring positions finds (contact_scan.h).
  /// Then tries sets that differ from one of these sets by one ball. Use this function if all other
  /// methods fail.
  [[nodiscard]] bool scan(RingState& state);

 private:
  using Contacts = std::vector<InnerContact>;

  /// A set of contacts whose equilibrium was found, but is not valid for at least one ball.
  struct OpenSet {
    Contacts contacts;
    RingState state;
    /// True if a kept ball is in tension. Otherwise a lost ball penetrates the race.
    bool pulls;
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
