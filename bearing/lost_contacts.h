#pragma once

#include <utility>
#include <vector>

#include "bearing/load_shares.h"

namespace raceway::bearing {

/// Under inner control: looks for a state of balance with each ball's inner contact held kept or
/// lost. With the contact the gyroscopic couple vanishes, by which a ball moves further from the
/// race: within a range of places of the groove a ball can stand either way, so sets of kept balls
/// are tried, and a solution counts where no kept ball pulls and no lost one reaches into the race.
class ContactSearch {
 public:
  explicit ContactSearch(RingSystem& system) : system_(system) {}

  /// From the kept balls that statics chooses (load_shares.h): a ball on the wrong side changes it,
  /// until none is left; where that comes back to a set it has seen, sets like the chosen one,
  /// those first that statics thinks fit best, then sets that differ by one ball from those that
  /// came near.
  [[nodiscard]] bool settle(RingState& state);
  /// More of the last, with balls that turn far over.
  [[nodiscard]] bool widen(RingState& state);
  /// As a last resort: from the sets that a scan over places of the ring finds (contact_scan.h),
  /// then from those that differ from one of them by one ball.
  [[nodiscard]] bool scan(RingState& state);

 private:
  using Contacts = std::vector<InnerContact>;

  /// A set of contacts whose balance exists, but in which one ball at least is on the wrong side.
  struct OpenSet {
    Contacts contacts;
    RingState state;
    bool pulls;  ///< a kept ball does; else a lost one reaches into the race
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
