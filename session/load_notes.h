#pragma once

#include <string>
#include <vector>

#include "bearing/bearing.h"
#include "bearing/operating_point.h"

namespace raceway::session {

/// What one bearing carries at a point [SI]; NaN where it is not known.
struct CarriedLoad {
  double axial_load = unset, radial_load = unset;
  double lost_balls = unset;
  double inner_pressure = unset, outer_pressure = unset;
  double least_inner_angle = unset, largest_inner_angle = unset;  ///< of the balls that touch
};

/// Looks at points one by one, and says of all of them where balls have lost the inner race or do
/// not lie against the shoulders of an angular-contact bearing (bearing/seat.h), where the load is
/// above the static rating and where the contact pressure leaves dents: how many
/// points, and the worst.
class LoadNotes {
 public:
  /// `place` is that of the bearing on its shaft, empty for one on a rig; `point` is the one asked.
  void look(const bearing::Bearing& bearing, const std::string& place,
            const bearing::OperatingPoint& point, const CarriedLoad& carried);
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  struct Worst {
    std::size_t points = 0;
    double value = 0.0, limit = 0.0;
    bearing::OperatingPoint point;
    std::string place;
    void look(double value, double limit, const std::string& place,
              const bearing::OperatingPoint& point);
  };
  [[nodiscard]] std::string where(const Worst& worst) const;

  Worst lost_, load_, pressure_, bottom_, far_;
  std::size_t points_ = 0;
};

}  // namespace raceway::session
