#pragma once

#include <optional>
#include <string>

#include "files/displacement_curve.h"
#include "results/kinematic_results.h"
#include "session/messages.h"
#include "session/reading.h"
#include "session/source.h"

namespace raceway::session {

/// Law that is fitted to a measured curve of displacement over speed. The law describes the
/// kinematic displacement, which follows the speed without delay.
struct LawFit {
  files::DisplacementCurve curve{};
  shaft::KinematicLawFit fit{};
  std::optional<results::LawAtSpeed> at{};

  /// Describes the quality of the fit in one or two sentences. `table` has the same meaning as in
  /// law_statement().
  [[nodiscard]] std::string statement(const std::string& table) const;
  [[nodiscard]] std::string json(const std::string& table) const;
};

/// Reads a curve of displacement over speed, and fits the law of the kinematic displacement to this
/// curve. `at_rpm` is a speed at which the fitted law is also evaluated; NaN means no such speed.
/// Throws text::InputError for a curve with too few speeds, and if `at_rpm` is outside the speeds
/// of the curve.
[[nodiscard]] LawFit fit_law(Messages& messages, const Source& curve, const Reading& reading,
                             double at_rpm);

}  // namespace raceway::session
