#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tests/spindle_study/rig.h"

/// What the program `raceway` says of spindles with a known truth.
namespace spindle_study {

/// A spindle as it lies in a folder.
struct Case {
  std::string name{}, kind{};  ///< of the folder; the same without the seed
  std::filesystem::path folder{};
  std::vector<std::string> accept{}, verdicts{};
  double signal = nan;
  bool hidden = false;
};

/// In the order of their names; folders without truth.json are left out.
[[nodiscard]] std::vector<Case> cases_in(const std::filesystem::path& folder,
                                         const std::vector<const Class*>& wished);

/// Errors on the test record, rms against its readings, whose noise is 0.1 K and 0.3 um.
struct Errors {
  double temperature = nan;   ///< largest of the sensors [K]
  double displacement = nan;  ///< [um]
};

struct Outcome {
  Case of{};
  std::string verdict{}, sentence{}, failure{};
  std::vector<std::vector<std::string>> sets{};
  Errors before{}, after{};  ///< as calibrated; with the best set of the verdict
  double seconds = nan;      ///< that diagnose took

  [[nodiscard]] bool right() const;
  /// Names what is not hidden, or something where nothing is.
  [[nodiscard]] bool wrong_name() const;
};

[[nodiscard]] Outcome judge(const Case& of, const std::string& raceway);

[[nodiscard]] std::vector<Outcome> judge_all(const std::vector<Case>& cases,
                                             const std::string& raceway, unsigned threads,
                                             const std::function<void(const Outcome&)>& done);

[[nodiscard]] std::string line(const Outcome& outcome);
[[nodiscard]] std::string table(const std::vector<Outcome>& outcomes);

}  // namespace spindle_study
