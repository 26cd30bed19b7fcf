#include <fmt/core.h>

#include <cmath>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/shared_flags.h"
#include "cli/text_table.h"
#include "files/catalogue_file.h"
#include "files/designation.h"
#include "record/units.h"
#include "results/results.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

struct BearingsFlags {
  std::string filter;
  double bore = unset, outer_diameter = unset;  // [m]
  bool json = false;
};

/// As printed: to a tenth of a millimetre.
bool is_size(double wanted, double size) {
  return std::isnan(wanted) || std::abs(wanted - size) < 0.05 * mm;
}

/// Bearings of the size that a designation has which no catalogue lists.
std::vector<files::CatalogueBearing> of_same_size(const std::vector<files::CatalogueBearing>& rows,
                                                  const std::string& designation) {
  files::require_angular_contact(designation);
  const std::string size = files::read_designation(designation).size();
  std::vector<files::CatalogueBearing> same;
  if (size.empty()) return same;
  for (const files::CatalogueBearing& row : rows)
    if (files::read_designation(row.designation).size() == size) same.push_back(row);
  if (!same.empty())
    tell(
        {fmt::format("{0} is not in the catalogue. These bearings have the same size; raceway new "
                     "\"{0}\" estimates this bearing",
                     designation)});
  return same;
}

int list_bearings(const BearingsFlags& flags) {
  const auto all = files::read_catalogues();
  auto rows = files::matching_bearings(all, flags.filter);
  if (rows.empty()) rows = of_same_size(all, flags.filter);
  std::erase_if(rows, [&](const files::CatalogueBearing& r) {
    return !is_size(flags.bore, r.geometry.bore) ||
           !is_size(flags.outer_diameter, r.geometry.outer_diameter);
  });
  const bool json = flags.json;
  if (rows.empty())
    throw text::InputError(
        fmt::format(
            "raceway bearings: no bearing has \"{}\" in its name{}; {}without a filter, the "
            "command lists all bearings",
            flags.filter,
            std::isnan(flags.bore) && std::isnan(flags.outer_diameter) ? "" : " and this size",
            files::read_designation(flags.filter).boundary()
                ? fmt::format("raceway new \"{}\" estimates this bearing; ", flags.filter)
                : ""),
        {.key = "FILTER"});
  if (json) {
    put_document(results::bearings_json(rows));
  } else {
    TextTable table({{"bearing", "", true},
                     {"bore", "mm"},
                     {"outer", "mm"},
                     {"pitch", "mm"},
                     {"balls", ""},
                     {"ball", "mm"},
                     {"angle", "deg"},
                     {"C0", "N"}});
    for (const files::CatalogueBearing& r : rows)
      table.add({r.full_name(), fmt::format("{:.4g}", r.geometry.bore / mm),
                 fmt::format("{:.4g}", r.geometry.outer_diameter / mm),
                 fmt::format("{:.5g}", r.geometry.pitch_diameter / mm),
                 fmt::format("{}", r.geometry.ball_count),
                 fmt::format("{:.5g}", r.geometry.ball_diameter / mm),
                 fmt::format("{:.3g}", r.geometry.contact_angle / degree),
                 fmt::format("{:.0f}", r.geometry.static_load_rating)});
    fmt::print("{}", table.text(terminal_width()));
  }
  return done;
}

}  // namespace

Run setup_bearings(CLI::App& command) {
  auto flags = std::make_shared<BearingsFlags>();
  command.add_option("FILTER", flags->filter, "part of a designation; default: all bearings")
      ->type_name("");
  add_length(command, "--bore", flags->bore, {1, 5000, "mm"},
             "only bearings with this bore, in mm or with a unit");
  add_length(command, "--outer-diameter", flags->outer_diameter, {2, 10000, "mm"},
             "only bearings with this outer diameter, in mm or with a unit");
  declare_json(command, flags->json);
  command.footer("Example:\n  raceway bearings \"S 60\"\n  raceway bearings --bore 70");
  return [flags] { return list_bearings(*flags); };
}

}  // namespace raceway::cli
