#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "tests/hidden_effect/generator.h"

namespace hidden_effect {

struct Outcome;

/// A share of the rigs of a kind that is held to a bar.
struct Demand {
  std::string_view what;
  bool at_least;      ///< the share should be large
  double must, good;  ///< [%]
  bool (*hit)(const Outcome&);
  bool (*among)(const Outcome&) = nullptr;  ///< null: among all rigs of the kind
};

/// A kind of rig as people build them: plan, noise and mistakes of a laboratory.
struct RealRig {
  std::string_view id;
  Setup setup;                                 ///< machine and seed vary
  int per_seed;                                ///< rigs for each seed asked for
  std::span<const std::string_view> accepted;  ///< names that are right where a card is wrong
  std::span<const Demand> demands;
  /// What is hidden is as large as the diagnosis says that it would have been found, of each effect
  /// of the catalogue in turn.
  bool as_stated = false;
};

[[nodiscard]] std::span<const RealRig> real_rigs();
/// Throws std::out_of_range.
[[nodiscard]] const RealRig& real_rig(std::string_view id);

}  // namespace hidden_effect
