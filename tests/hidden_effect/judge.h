#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "record/parameter.h"
#include "tests/hidden_effect/generator.h"

namespace hidden_effect {

/// What the library answers to one rig, in the generator's units.
struct Answer {
  std::string verdict;             ///< as in JSON; "failed" where no diagnosis came back
  std::vector<std::string> names;  ///< effects of the verdict, the leading one first
  /// 95 % intervals of the sizes of `names`, in the unit of the model file.
  std::vector<raceway::record::Interval> intervals;
  std::string first;                   ///< effect of the largest gain, whatever the verdict
  std::vector<Point> suggested;        ///< operating points it would measure next
  std::vector<std::string> questions;  ///< about units and columns, before the verdict
  std::string other_law;  ///< base law that is said to explain the data in place of the believed
  std::vector<std::string> tried_laws;      ///< in that place, the best first
  std::vector<std::string> names_given_it;  ///< effects of the verdict with the best of them
  std::string shape;                        ///< formula of what is missing, where there is one
  std::vector<double> exponents;            ///< of speed, load and viscosity in `shape`
  /// Effects that would have been found, and the share of the torque from which on.
  std::vector<std::pair<std::string, double>> stated;
  std::string message;   ///< why it failed
  std::string sentence;  ///< what a user would read
  double seconds = 0.0;  ///< of processor time of the whole program, while it worked
};

/// Error of the model once the effects of an answer are added and everything free is refitted.
struct Improvement {
  double validation = 0.0;   ///< rms of prediction over true torque - 1, on the test points
  double in_sample = 0.0;    ///< rms of (prediction - reading)/sigma on the rows of the fit
  std::vector<double> free;  ///< numbers of the law, refitted, as free_values() has them
  bool converged = false;
};

/// How a rig is written down before it is read by the library.
struct Presentation {
  bool reversed_rows = false;
  bool reversed_catalogue = false;  ///< candidates in the opposite order
  bool other_start = false;         ///< believed f0 and z with other values, in the other order
};

/// Model and readings go through the files' text, as a user's would.
[[nodiscard]] Answer ask(const Rig& rig, std::span<const Reading> readings,
                         const Presentation& presentation = {});

/// The same from files made elsewhere.
[[nodiscard]] Answer ask(const std::string& model_text, const std::string& train_text,
                         const Presentation& presentation = {});

/// Adds these effects to the believed model and refits it.
[[nodiscard]] Improvement improve(const Rig& rig, std::span<const std::string> names);

/// True if the library adds the effect of that id to its law of the contacts.
[[nodiscard]] bool joins_contacts(std::string_view id);
/// True if the library has an effect of that id.
[[nodiscard]] bool is_known(std::string_view id);
/// True if it is a shape without a law behind it, which a verdict may only call alike.
[[nodiscard]] bool is_empirical(std::string_view id);
/// True if it stands for wrong data, as of an oil card or a sensor.
[[nodiscard]] bool is_datum(std::string_view id);

}  // namespace hidden_effect
