#pragma once

#include <stdexcept>
#include <utility>
#include <variant>

#include "bearing/bearing.h"
#include "bearing/roller_bearing.h"
#include "life/roller_life.h"

namespace raceway::model {

/// Bearing of a model: a ball bearing or a cylindrical roller bearing.
///
/// The conversion to bearing::Bearing throws std::invalid_argument for a roller bearing.
class ModelBearing {
 public:
  // Implicit conversions from both kinds of bearing.
  ModelBearing(bearing::Bearing balls) : kind_(std::move(balls)) {}            // NOLINT
  ModelBearing(bearing::RollerBearing rollers) : kind_(std::move(rollers)) {}  // NOLINT

  /// Returns the roller bearing; null for a ball bearing.
  [[nodiscard]] const bearing::RollerBearing* rollers() const {
    return std::get_if<bearing::RollerBearing>(&kind_);
  }
  /// Returns the ball bearing; null for a roller bearing.
  [[nodiscard]] const bearing::Bearing* ball_bearing() const {
    return std::get_if<bearing::Bearing>(&kind_);
  }

  operator const bearing::Bearing&() const { return with_balls(); }  // NOLINT
  [[nodiscard]] const bearing::Bearing& operator*() const { return with_balls(); }
  [[nodiscard]] const bearing::BearingGeometry& geometry() const { return with_balls().geometry(); }
  [[nodiscard]] const bearing::Material& balls() const { return with_balls().balls(); }
  [[nodiscard]] const bearing::Material& rings() const {
    return rollers() ? rollers()->rings() : with_balls().rings();
  }

  // Functions for both kinds of bearing.
  [[nodiscard]] double pitch_diameter() const {
    return rollers() ? rollers()->geometry().pitch_diameter : geometry().pitch_diameter;
  }
  /// Returns the static load rating C0 [N]. For a roller bearing, C0 is calculated from the
  /// geometry. For a ball bearing, C0 is an input; NaN if it is not given.
  [[nodiscard]] double static_load_rating() const {
    return rollers() ? life::static_load_rating(rollers()->geometry())
                     : geometry().static_load_rating;
  }

 private:
  [[nodiscard]] const bearing::Bearing& with_balls() const {
    if (const bearing::Bearing* const balls = ball_bearing()) return *balls;
    throw std::invalid_argument(
        "the model has a cylindrical roller bearing; this calculation is only for ball bearings");
  }

  std::variant<bearing::Bearing, bearing::RollerBearing> kind_;
};

}  // namespace raceway::model
