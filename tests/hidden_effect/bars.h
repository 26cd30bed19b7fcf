#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/hidden_effect/generator.h"
#include "tests/hidden_effect/judge.h"
#include "tests/hidden_effect/oracle.h"
#include "tests/hidden_effect/separation.h"

namespace hidden_effect {

/// One rig to be made and judged, in the block it belongs to.
struct Trial {
  std::string_view block;
  Setup setup;
  std::string_view kind{};  ///< of real_rigs(), in the block "real"
  bool oracle = false;      ///< also judge the record with its true noise and base law
};

/// What came of it.
struct Outcome {
  Trial trial;
  Answer answer;
  std::vector<std::vector<std::string_view>> accepted;  ///< right ids by hidden effect
  Visibility visibility;
  Improvement improvement;                 ///< factorial block, right single answers
  std::string after_proposed, after_same;  ///< verdict after 12 proposed points, 12 repeated ones
  bool right_after_proposed = false, right_after_same = false;
  bool wrong_after_proposed = false;
  std::optional<OracleAnswer> oracle{}, oracle_after_proposed{};
  /// The verdict names the one hidden effect: its interval holds the true size.
  std::optional<bool> size_held{};
  std::string changed_by;  ///< presentation under which the answer was another one
  bool outside = false;
  /// No size that leaves a torque reaches half the wished share: no case for a bar on effects.
  bool too_small = false;

  [[nodiscard]] bool alarm() const { return answer.verdict != "nothing-missing"; }
  [[nodiscard]] bool names_only_right() const;
  [[nodiscard]] bool names_every_hidden() const;
  [[nodiscard]] bool names_a_right() const;
  [[nodiscard]] bool names_data() const;
  [[nodiscard]] bool is(std::initializer_list<std::string_view> verdicts) const;
  /// `effect-like` with the right name first, of a shape without a law: all that is said of one.
  [[nodiscard]] bool acts_like_right_shape() const;
  /// One name or exact aliases of one effect, and it is right.
  [[nodiscard]] bool exact() const;
  [[nodiscard]] bool in_set() const;
  /// A statement that excludes the truth.
  [[nodiscard]] bool wrong() const;
  [[nodiscard]] bool right_first() const;
  /// The verdict is the one for the truth, alone or beside rivals.
  [[nodiscard]] bool includes_truth() const;
  /// The same, without rivals.
  [[nodiscard]] bool only_truth() const;
  /// A statement without rivals that excludes the truth.
  [[nodiscard]] bool names_wrong() const;
};

/// Ids and what they ask, in the order in which they run.
struct Block {
  std::string_view id;
  std::string_view what;
};
[[nodiscard]] const std::vector<Block>& blocks();

/// `seeds` rigs for each case of a block, from seed `first` on; of the block "real" only kinds with
/// the text `only` in their name. Machines take turns with the seed.
[[nodiscard]] std::vector<Trial> trials(std::string_view block, int seeds, int first = 0,
                                        std::string_view only = {});

[[nodiscard]] Outcome judge(const Trial& trial);

/// On all cores; the outcome does not depend on their number. `progress` gets the count done.
[[nodiscard]] std::vector<Outcome> judge_all(const std::vector<Trial>& trials,
                                             const std::function<void(std::size_t)>& progress);

struct Interval {
  double lower, upper;
};
/// Wilson's interval of 95 % for a share.
[[nodiscard]] Interval wilson(int successes, int trials);

/// A bar of the study and what was measured against it.
struct Bar {
  std::string number;
  std::string what;
  bool at_least;      ///< the figure should be large
  double must, good;  ///< in the unit of `measured`
  std::string unit;   ///< "%", "s", ...
  double measured;    ///< NaN where no trial bears on it
  Interval interval;  ///< NaN for figures that are no shares
  int trials;

  [[nodiscard]] bool missed() const;
  [[nodiscard]] bool is_good() const;
};

/// A question to the records of a kind, answered by the diagnosis and by the oracle.
struct Carried {
  std::string kind, what;
  int diagnosis = 0, oracle = 0, both = 0, cases = 0;
  int diagnosis_wrong = 0, oracle_wrong = 0;  ///< wrong names without rivals
};
/// Counts right answers of the diagnosis and of the oracle, by kind and question. Records without
/// an answer of the oracle are left out.
[[nodiscard]] std::vector<Carried> carried(const std::vector<Outcome>& judged);

[[nodiscard]] std::vector<Bar> bars(const std::vector<Outcome>& judged);

}  // namespace hidden_effect
