#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "loop/loop.h"
#include "record/units.h"
#include "verdict/diagnosis.h"

/// What the library says of machines with a known truth.
namespace correction_study {

namespace fit = raceway::fit;
namespace loop = raceway::loop;
namespace verdict = raceway::verdict;
using raceway::unset;

/// A machine as it lies in a folder: model, train.csv, test.csv, truth.json.
struct Case {
  std::string name{}, kind{};  ///< of the folder; the same without the seed
  std::filesystem::path folder{};
  std::vector<std::string> hidden{}, accept{}, verdicts{};
  double tolerance = unset;   ///< [um]
  double floor = unset;       ///< error of the right class on the test record [um]
  double lambda_sep = unset;  ///< of the best wrong answer against the right class
  bool outside = false;       ///< what is hidden is in no catalogue

  [[nodiscard]] bool is_clean() const { return hidden.empty(); }
  [[nodiscard]] bool is_pair() const { return hidden.size() > 1 && !outside; }
};

/// Nothing where a folder has no records to be judged by. Throws std::runtime_error naming what
/// cannot be read.
[[nodiscard]] std::optional<Case> read_case(const std::filesystem::path& folder);

struct Outcome {
  Case of{};
  verdict::Verdict verdict{};
  std::vector<std::vector<std::string>> sets{};  ///< of the verdict, without channel or axis
  bool first_is_right =
      false;  ///< lowest error held out among all that was tried alone, or in sets
  double base_held_out = unset, right_held_out = unset, wrong_held_out = unset;  ///< [um]
  std::string best_wrong{};
  double base_test = unset;   ///< of the refitted base on the test record [um]
  double added_test = unset;  ///< with the best set of the verdict; NaN without one [um]
  bool asked_again = false, content = false;  ///< with the best set on, and nothing is missing then
  double seconds = unset;                     ///< until single effects were tried, of one processor
  double pairs_seconds = unset;               ///< of a verdict that tried pairs; NaN where none was
  std::string sentence{}, failure{};          ///< what the library threw

  [[nodiscard]] bool follows_a_body() const;
  [[nodiscard]] bool right() const;
  /// A statement that excludes the truth.
  [[nodiscard]] bool wrong() const;
};

[[nodiscard]] Outcome judge(const Case& of);

/// Outcomes in the order of the cases, by so many threads.
[[nodiscard]] std::vector<Outcome> judge_all(const std::vector<Case>& cases, unsigned threads,
                                             const std::function<void(const Outcome&)>& done);

}  // namespace correction_study
