#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/correction_study/setup.h"

namespace correction_study {

/// What is known of a rig, and how far it can be found out.
struct Truth {
  std::string id{};                   ///< class and seed
  std::vector<std::string> hidden{};  ///< what the base lacks
  std::vector<std::string> accept{};  ///< names by which an answer is right
  std::vector<std::string> verdicts{};
  double tolerance = 0.0;                  ///< [um]
  double noise = 0.0;                      ///< standard deviation of a reading [um]
  Fit base{}, right{};                     ///< errors of the base and of the right class [um]
  std::map<std::string, double> rivals{};  ///< errors of other effects on the train record [um]
  double hidden_rms = 0.0;                 ///< of what is hidden in the train record [um]
  std::vector<double> clean_test{};        ///< displacement of every row of the test [um]
};

struct Rig {
  std::string model_toml{};          ///< what the user believes
  std::string friction_table_csv{};  ///< empty where the model has no need of one
  std::string record_csv{}, test_csv{};
  Truth truth{};
  Setup setup;
};

/// A rig whose truth can be found out: what is hidden matters, and nothing that is not accepted
/// comes near. Machines that cannot show it are drawn anew, by Floors alone.
[[nodiscard]] Rig make_rig(const Class& wished, unsigned seed);

/// The truth in the form of the given examples.
[[nodiscard]] std::string truth_json(const Rig& rig);

/// All files of a rig, into a folder of its name. Throws where one cannot be written.
void write_rig(const Rig& rig, const std::filesystem::path& folder);

}  // namespace correction_study
