#include "files/bearing_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "files/designation.h"
#include "files/model_file.h"
#include "record/median.h"
#include "record/units.h"
#include "text/error.h"
#include "text/names.h"

namespace raceway::files {
namespace {

constexpr double ball_step = 25.4 * mm / 32.0;  // balls come in steps of 1/32 inch
constexpr std::size_t enough_rows = 8;

/// Height of the section over the pitch circle: tells dimension series apart, whatever the size.
double section(double bore, double outer_diameter) {
  return (outer_diameter - bore) / (outer_diameter + bore);
}

Estimate over(const std::vector<double>& ratios) {
  const auto [lower, upper] = std::minmax_element(ratios.begin(), ratios.end());
  return {record::median(ratios), *lower, *upper};
}

Estimate times(const Estimate& ratio, double factor) {
  return {ratio.value * factor, ratio.lower * factor, ratio.upper * factor};
}

Estimate exactly(double value) { return {value, value, value}; }

struct Ratios {
  Estimate ball, fill, rating;
  std::size_t rows = 0;
  bool like_section = false;
};

Ratios ratios_of(const BearingOutline& outline, const std::vector<CatalogueBearing>& rows) {
  std::vector<const CatalogueBearing*> near, all;
  for (const CatalogueBearing& row : rows) {
    const bearing::BearingGeometry& g = row.geometry;
    if (!(g.contact_angle > 0)) continue;
    all.push_back(&row);
    if (std::abs(section(g.bore, g.outer_diameter) -
                 section(outline.bore, outline.outer_diameter)) < 0.025)
      near.push_back(&row);
  }
  const bool like_section = near.size() >= enough_rows;
  const auto& used = like_section ? near : all;
  if (used.empty())
    throw text::InputError("the catalogue is empty, so the program cannot estimate a bearing");
  std::vector<double> ball, fill, rating;
  for (const CatalogueBearing* row : used) {
    const bearing::BearingGeometry& g = row->geometry;
    // Makers rate bearings with ceramic balls lower.
    const double of_ceramic = row->static_load_rating_silicon_nitride;
    const bool ceramic = outline.ball_material == "silicon-nitride" && !std::isnan(of_ceramic);
    ball.push_back(2.0 * g.ball_diameter / (g.outer_diameter - g.bore));
    fill.push_back(g.ball_count * g.ball_diameter / (pi * g.pitch_diameter));
    rating.push_back((ceramic ? of_ceramic : g.static_load_rating) /
                     (g.ball_count * std::pow(g.ball_diameter, 2) * std::cos(g.contact_angle)));
  }
  return {over(ball), over(fill), over(rating), used.size(), like_section};
}

std::string spread(const Estimate& e, double unit, std::string_view words) {
  const auto number = [&](double value) {
    return value < 1e4 ? fmt::format("{:.4g}", value) : fmt::format("{:.0f}", value);
  };
  return fmt::format("estimated: {} to {} {}", number(e.lower / unit), number(e.upper / unit),
                     words);
}

}  // namespace

BearingOutline outline_of(std::string_view designation) {
  require_angular_contact(designation);
  const Designation d = read_designation(designation);
  BearingOutline outline{.designation = std::string(designation),
                         .contact_angle = d.contact_angle,
                         .ball_material = d.ceramic_balls ? "silicon-nitride" : "steel"};
  if (const auto size = d.boundary()) {
    outline.bore = size->bore;
    outline.outer_diameter = size->outer_diameter;
    outline.width = size->width;
    outline.dimension_series = d.dimensions;
  }
  return outline;
}

NamedRow bearing_called(std::string_view name, const std::vector<CatalogueBearing>& rows) {
  if (const CatalogueBearing* const row = known_bearing(rows, name)) return {*row};
  const BearingOutline outline = outline_of(name);
  if (std::isnan(outline.bore)) return {find_bearing(rows, name)};  // which says what is near
  NamedRow named{row_of(estimated_bearing(outline, rows))};
  named.is_estimated = true;
  named.ceramic_balls = outline.ball_material != "steel";
  named.states_angle = !std::isnan(outline.contact_angle);
  return named;
}

EstimatedBearing estimated_bearing(const BearingOutline& given,
                                   const std::vector<CatalogueBearing>& rows) {
  EstimatedBearing b;
  b.outline = given;
  BearingOutline& o = b.outline;
  if (std::isnan(o.bore) || std::isnan(o.outer_diameter))
    throw text::InputError(
        fmt::format("bearing \"{}\" is not in the catalogue; to estimate its inner geometry, give "
                    "--bore and --outer-diameter, and --balls if you know the number of balls",
                    o.designation),
        {.key = "BEARING"});
  if (!(o.bore > 0 && o.outer_diameter > 1.1 * o.bore && o.outer_diameter < 5.0 * o.bore))
    throw text::InputError(
        fmt::format(
            "--outer-diameter = {:.6g} mm: must be from 1.1 to 5 times the bore ({:.6g} mm)",
            o.outer_diameter / mm, o.bore / mm),
        {.key = "--outer-diameter"});
  if (std::isnan(o.contact_angle)) o.contact_angle = 15 * degree;
  const Ratios ratios = ratios_of(o, rows);
  b.rows = ratios.rows;
  b.like_section = ratios.like_section;
  b.like_series = o.dimension_series.empty() ||
                  std::any_of(rows.begin(), rows.end(), [&](const CatalogueBearing& row) {
                    return read_designation(row.designation).dimensions == o.dimension_series;
                  });
  const double pitch = 0.5 * (o.bore + o.outer_diameter);
  b.pitch_diameter = exactly(pitch);
  b.ball_diameter = o.ball_count > 0 ? times(ratios.fill, pi * pitch / o.ball_count)
                                     : times(ratios.ball, 0.5 * (o.outer_diameter - o.bore));
  double& ball = b.ball_diameter.value;
  ball = std::clamp(std::round(ball / ball_step) * ball_step, ball_step,
                    0.95 * (o.outer_diameter - o.bore) / 2);
  if (o.ball_count > 0) {
    b.ball_count = exactly(o.ball_count);
  } else {
    b.ball_count = times(ratios.fill, pi * pitch / ball);
    b.ball_count = {std::round(b.ball_count.value), std::floor(b.ball_count.lower),
                    std::ceil(b.ball_count.upper)};
  }
  b.conformity = {0.52, 0.517, 0.54};
  b.static_load_rating =
      times(ratios.rating, b.ball_count.value * ball * ball * std::cos(o.contact_angle));
  return b;
}

CatalogueBearing row_of(const EstimatedBearing& b) {
  CatalogueBearing row;
  row.designation = b.outline.designation;
  row.width = b.outline.width;
  row.geometry = {.ball_count = static_cast<int>(b.ball_count.value),
                  .ball_diameter = b.ball_diameter.value,
                  .pitch_diameter = b.pitch_diameter.value,
                  .contact_angle = b.outline.contact_angle,
                  .inner_conformity = b.conformity.value,
                  .outer_conformity = b.conformity.value,
                  .bore = b.outline.bore,
                  .outer_diameter = b.outline.outer_diameter,
                  .static_load_rating = b.static_load_rating.value};
  row.geometry.static_load_rating = std::round(row.geometry.static_load_rating / 100.0) * 100.0;
  return row;
}

std::string estimated_model_text(const EstimatedBearing& b, friction::FrictionLaw law,
                                 bool of_spindle, const std::string& oil) {
  const BearingOutline& o = b.outline;
  const CatalogueBearing row = row_of(b);
  const auto of_rows =
      fmt::format("from {} catalogue bearings of {} cross-section{}", b.rows,
                  b.like_section ? "similar" : "any",
                  b.like_series ? "" : fmt::format(", none of series {}", o.dimension_series));
  const auto of_rigidity = spread(b.conformity, 1.0, "from catalogue rigidities of bearing pairs");
  ModelRemarks remarks{
      .title = fmt::format("Model of a {} on a rig. The catalogue does not contain this bearing: "
                           "values marked as estimated\n# come from bearings of {} cross-section. "
                           "Replace them if you know the correct values.",
                           o.designation, b.like_section ? "similar" : "any"),
      .ball_material = o.ball_material,
      .of_key = {{"ball_diameter_mm", spread(b.ball_diameter, mm, of_rows)},
                 {"pitch_diameter_mm", "estimated: mean of bore and outer diameter"},
                 {"inner_conformity", of_rigidity},
                 {"outer_conformity", of_rigidity},
                 {"static_load_rating_N", spread(b.static_load_rating, 1.0, of_rows)}}};
  if (b.ball_count.lower < b.ball_count.upper)
    remarks.of_key.emplace_back("ball_count", spread(b.ball_count, 1.0, of_rows));
  remarks.law = law;
  remarks.of_spindle = of_spindle;
  remarks.oil = oil;
  return model_text(row, remarks);
}

}  // namespace raceway::files
