#include "files/plausible.h"

#include <fmt/format.h>

#include <cmath>

#include "record/units.h"

namespace raceway::files {
namespace {

constexpr double inch = 25.4;  // [mm]

bool within(double value, double lower, double upper) { return value >= lower && value <= upper; }

}  // namespace

std::string looks_like_kelvin(std::string_view name, double temperature_C) {
  // -20 to 140 C in K.
  if (!within(temperature_C, 253.0, 413.0)) return {};
  return fmt::format("{} = {:.6g} C: the value is probably in kelvin; this would be {:.4g} C", name,
                     temperature_C, temperature_C - celsius_zero);
}

std::string looks_like_inches(const bearing::BearingGeometry& g) {
  const double ball = g.ball_diameter / mm, pitch = g.pitch_diameter / mm;
  // Balls of a spindle bearing fill 0.6 to 0.98 of their circle, of others down to 0.4.
  const double fill = g.ball_count * ball / (pi * pitch);
  if (fill < 0.1 && within(inch * fill, 0.4, 1.02))
    return fmt::format(
        "ball_diameter_mm = {:.6g}: the value is probably in inches; this would be {:.6g} mm. {} "
        "balls of {:.6g} mm fill only {:.0f} % of a pitch circle of {:.6g} mm",
        ball, inch * ball, g.ball_count, ball, 100.0 * fill, pitch);
  // C0 of steel balls is 10 to 17 N/mm² of Z D² cos α0 [ISO76].
  const double rating =
      g.static_load_rating / (g.ball_count * ball * ball * std::cos(g.contact_angle));
  if (rating > 100.0 && within(rating / (inch * inch), 4.0, 40.0))
    return fmt::format(
        "ball_diameter_mm = {:.6g}, pitch_diameter_mm = {:.6g}: the values are probably in inches; "
        "this would be {:.6g} and {:.6g} mm. static_load_rating_N = {:.6g} is {:.0f} times the "
        "usual rating of a bearing with such balls",
        ball, pitch, inch * ball, inch * pitch, g.static_load_rating, rating / 13.0);
  return {};
}

}  // namespace raceway::files
