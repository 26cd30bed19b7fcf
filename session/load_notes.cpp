#include "session/load_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bearing/contact_pressure.h"
#include "bearing/seat.h"
#include "friction/palmgren.h"

namespace raceway::session {
namespace {

double static_load(const bearing::Bearing& bearing, const CarriedLoad& carried) {
  friction::BearingState<> state;
  state.bearing = &bearing;
  state.axial_load = carried.axial_load;
  state.radial_load = carried.radial_load;
  return friction::static_equivalent_load(state);
}

}  // namespace

void LoadNotes::Worst::look(double value_here, double limit_here, const std::string& place_here,
                            const bearing::OperatingPoint& point_here) {
  if (!(value_here > limit_here)) return;
  ++points;
  if (!(value_here > value)) return;
  value = value_here;
  limit = limit_here;
  place = place_here;
  point = point_here;
}

void LoadNotes::look(const bearing::Bearing& bearing, const std::string& place,
                     const bearing::OperatingPoint& point, const CarriedLoad& carried) {
  ++points_;
  lost_.look(carried.lost_balls, 0.0, place, point);
  load_.look(static_load(bearing, carried), bearing.geometry().static_load_rating, place, point);
  pressure_.look(std::fmax(carried.inner_pressure, carried.outer_pressure),
                 bearing::static_limit_pressure, place, point);
  const double angle = bearing.geometry().contact_angle;
  switch (bearing::seat(carried.least_inner_angle, carried.largest_inner_angle, angle)) {
    case bearing::Seat::shoulder:
      break;
    case bearing::Seat::groove_bottom:
      bottom_.look(std::fmax(bearing::seating_load(carried.radial_load, angle),
                             std::numeric_limits<double>::min()),
                   0.0, place, point);
      break;
    case bearing::Seat::far_side:
      far_.look(-carried.least_inner_angle, 0.0, place, point);
      break;
  }
}

std::string LoadNotes::where(const Worst& worst) const {
  std::string text =
      fmt::format("{:.6g} rpm, {:.6g} N axial", worst.point.speed / rpm, worst.point.axial_load);
  if (worst.place.empty()) text += fmt::format(", {:.6g} N radial", worst.point.radial_load);
  if (!worst.place.empty()) text = fmt::format("{} at {}", worst.place, text);
  return points_ == 1 ? std::string() : " at " + text;
}

std::vector<std::string> LoadNotes::lines() const {
  std::vector<std::string> lines;
  const auto count = [&](const Worst& worst) {
    return points_ == 1 ? std::string() : fmt::format("{} of {} points: ", worst.points, points_);
  };
  if (lost_.points > 0)
    lines.push_back(fmt::format("{}balls have lost the inner race, up to {:.0f}{}", count(lost_),
                                lost_.value, where(lost_)));
  if (bottom_.points > 0)
    lines.push_back(fmt::format(
        "{}no axial load holds the contact angle: the ring has moved back until the balls carry at "
        "the bottom of the grooves, at about 0 deg; {:.3g} N axial would press half of them "
        "against the shoulders{}",
        count(bottom_), bottom_.value, where(bottom_)));
  if (far_.points > 0)
    lines.push_back(fmt::format(
        "{}balls carry beyond the bottom of the groove, at {:.3g} deg, where an angular-contact "
        "bearing has no shoulder: it needs more axial load than this{}",
        count(far_), -far_.value / degree, where(far_)));
  if (load_.points > 0)
    lines.push_back(
        fmt::format("{}the static equivalent load is above C0 = {:.6g} N, up to {:.4g} N{}",
                    count(load_), load_.limit, load_.value, where(load_)));
  if (pressure_.points > 0)
    lines.push_back(fmt::format(
        "{}the contact pressure is above 4.2 GPa, which leaves dents, up to {:.3g} GPa{}",
        count(pressure_), pressure_.value / GPa, where(pressure_)));
  return lines;
}

}  // namespace raceway::session
