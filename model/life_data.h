#pragma once

#include "record/units.h"

namespace raceway::model {

/// Inputs of the rating life of a bearing. Missing ratings are computed from its geometry.
struct LifeData {
  double dynamic_load_rating = unset;  ///< dynamic load rating C [N]; NaN: computed by ISO 281
  double fatigue_load = unset;         ///< fatigue load limit C_u [N]; NaN: computed by ISO 281
  double contamination = 0.6;          ///< contamination factor e_C, from 0 (dirt) to 1 (clean) [1]
  double reliability = 90.0;           ///< [%]
  [[nodiscard]] bool operator==(const LifeData&) const = default;
};

}  // namespace raceway::model
