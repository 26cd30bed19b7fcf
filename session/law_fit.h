#pragma once

#include <optional>
#include <string>

#include "files/displacement_curve.h"
#include "results/kinematic_results.h"
#include "session/messages.h"
#include "session/reading.h"
#include "session/source.h"

namespace raceway::session {

/// The law of kinematic displacement, fitted to a curve.
struct LawFit {
  files::DisplacementCurve curve{};
  shaft::KinematicLawFit fit{};
  std::optional<results::LawAtSpeed> at{};

  /// Quality of the fit in a sentence; `table` is the place of the table that replaces it.
  [[nodiscard]] std::string statement(const std::string& table) const;
  [[nodiscard]] std::string json(const std::string& table) const;
};

/// Reads a curve of displacements over speeds and fits the law to it; `at_rpm`: a speed at which it
/// is asked for, NaN without. Throws text::InputError: a curve of too few speeds, a speed where the
/// law is not valid.
[[nodiscard]] LawFit fit_law(Messages& messages, const Source& curve, const Reading& reading,
                             double at_rpm);

}  // namespace raceway::session
