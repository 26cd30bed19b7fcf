#include "session/new_model.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "files/catalogue_file.h"
#include "files/designation.h"
#include "files/model_file.h"
#include "files/new_correction.h"
#include "files/roller_estimate.h"
#include "friction/roller_friction.h"
#include "text/error.h"

namespace raceway::session {
namespace {

friction::FrictionLaw wanted_law(const NewModel& wanted) {
  using friction::FrictionLaw;
  if (wanted.law == friction::name(FrictionLaw::table))
    throw text::InputError(
        "raceway new: law = \"table\" needs a friction table; create the model with another law, "
        "then write law = \"table\" and file = \"TABLE.csv\" under [friction]",
        {.key = "--law"});
  return friction::find_friction_law(wanted.law)
      .value_or(wanted.spindle ? FrictionLaw::palmgren : FrictionLaw::contact);
}

/// The model of a cylindrical roller bearing by its designation.
std::string new_roller_model(Messages& messages, const NewModel& wanted, bool described) {
  const auto refuse = [&](const std::string& why) {
    throw text::InputError(
        fmt::format("raceway new: {} is a cylindrical roller bearing; {}", wanted.bearing, why),
        {.key = "BEARING"});
  };
  if (described)
    refuse("--bore, --outer-diameter, --balls and --contact-angle are only for ball bearings");
  if (wanted.spindle) refuse("a spindle needs ball bearings");
  if (wanted.law == friction::name(friction::FrictionLaw::contact))
    refuse("choose the law palmgren or skf");
  const files::EstimatedRollers rollers = files::estimated_rollers(wanted.bearing);
  messages.say(record::note::assumed(
      wanted.bearing +
          " is a cylindrical roller bearing: its roller data are estimated and marked in the "
          "model",
      {.key = "bearing"}));
  return files::estimated_model_text(
      rollers,
      friction::find_roller_law(wanted.law).value_or(friction::FrictionLaw::roller_palmgren),
      wanted.outline.ball_material, wanted.oil);
}

/// What the flags say of a bearing; of one in the catalogue they must say nothing.
files::BearingOutline outline(const NewModel& wanted) {
  files::BearingOutline result = files::outline_of(wanted.bearing);
  if (!std::isnan(wanted.outline.bore) || !std::isnan(wanted.outline.outer_diameter))
    result.width = unset, result.dimension_series.clear();
  if (!std::isnan(wanted.outline.bore)) result.bore = wanted.outline.bore;
  if (!std::isnan(wanted.outline.outer_diameter))
    result.outer_diameter = wanted.outline.outer_diameter;
  if (!std::isnan(wanted.contact_angle)) result.contact_angle = wanted.contact_angle * degree;
  result.ball_count = wanted.outline.ball_count;
  if (wanted.outline.ball_material != "steel") result.ball_material = wanted.outline.ball_material;
  return result;
}

/// "15 deg (C)", "15 deg assumed"
std::string angle_text(const NewModel& wanted, double angle) {
  const files::Designation d = files::read_designation(wanted.bearing);
  const std::string why = !std::isnan(wanted.contact_angle) ? ""
                          : std::isnan(d.contact_angle)
                              ? " assumed, because the designation has no contact angle"
                              : fmt::format(" by its designation ({})", d.angle_code);
  return fmt::format("{:.4g} deg{}", angle / degree, why);
}

std::string balls_text(const NewModel& wanted, const std::string& material) {
  if (material == "steel") return {};
  const files::Designation d = files::read_designation(wanted.bearing);
  return fmt::format(", balls of {}{}", material,
                     d.ceramic_balls && wanted.outline.ball_material == "steel"
                         ? fmt::format(" by its designation ({})", d.ball_code)
                         : "");
}

}  // namespace

std::string new_model_text(Messages& messages, const NewModel& wanted) {
  const auto rows = files::read_catalogues();
  const files::BearingOutline& given = wanted.outline;
  const bool described = !std::isnan(given.bore) || !std::isnan(given.outer_diameter) ||
                         !std::isnan(wanted.contact_angle) || given.ball_count > 0;
  if (const files::CatalogueBearing* const row = files::known_bearing(rows, wanted.bearing)) {
    if (described)
      throw text::InputError(
          fmt::format("raceway new: the catalogue has the inner geometry of {}; remove --bore, "
                      "--outer-diameter, --balls and --contact-angle, which are for bearings that "
                      "are not in the catalogue",
                      row->full_name()),
          {.key = "BEARING"});
    files::CatalogueBearing bearing = *row;
    if (given.ball_material != "steel" && !std::isnan(row->static_load_rating_silicon_nitride))
      bearing.geometry.static_load_rating = row->static_load_rating_silicon_nitride;
    return files::model_text(bearing, {.ball_material = given.ball_material,
                                       .law = wanted_law(wanted),
                                       .of_spindle = wanted.spindle,
                                       .oil = wanted.oil});
  }
  if (files::names_rollers(wanted.bearing)) return new_roller_model(messages, wanted, described);
  const files::BearingOutline known = outline(wanted);
  // A misspelt name of the catalogue is answered with the nearest ones.
  if (!described && std::isnan(known.bore)) {
    try {
      (void)files::find_bearing(rows, wanted.bearing);
    } catch (const text::InputError& e) {
      throw text::InputError(
          std::string(e.what()) +
              "\nto estimate the inner geometry of a bearing that is not in the catalogue, give "
              "--bore and --outer-diameter, and --balls if you know the number of balls",
          e.place);
    }
  }
  const files::EstimatedBearing bearing = files::estimated_bearing(known, rows);
  messages.say(
      record::note::assumed(fmt::format("{} is not in the catalogue: {:.6g} x {:.6g} mm, {}{}; "
                                        "estimated values are marked in the model",
                                        wanted.bearing, known.bore / mm, known.outer_diameter / mm,
                                        angle_text(wanted, bearing.outline.contact_angle),
                                        balls_text(wanted, known.ball_material)),
                            {.key = "bearing"}));
  return files::estimated_model_text(bearing, wanted_law(wanted), wanted.spindle, wanted.oil);
}

std::string new_correction_text(Messages& messages, const Source& data, const Reading& reading) {
  if (data.name.ends_with(".toml"))
    throw text::InputError(data.name + ": this is a model file; a record (CSV) is expected here",
                           {.file = data.name});
  const files::NewCorrection made =
      files::new_correction(files::repeatable(reading.sources({data}).front()), reading.options());
  messages.say(made.notes);
  return made.text;
}

}  // namespace raceway::session
