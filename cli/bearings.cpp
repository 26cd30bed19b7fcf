#include <fmt/core.h>

#include "cli/commands.h"
#include "cli/text_table.h"
#include "io/catalogue_file.h"
#include "io/error.h"
#include "io/results.h"

namespace raceway::cli {
namespace {

int list_bearings(const std::string& filter, bool json) {
  const auto rows = io::matching_bearings(io::read_catalogues(), filter);
  if (json) {
    fmt::print("{}", io::bearings_json(rows));
  } else if (!rows.empty()) {
    TextTable table({{"bearing", "", true},
                     {"bore", "mm"},
                     {"outer", "mm"},
                     {"pitch", "mm"},
                     {"balls", ""},
                     {"ball", "mm"},
                     {"angle", "deg"},
                     {"C0", "N"}});
    for (const io::CatalogueBearing& r : rows)
      table.add({r.full_name(), fmt::format("{:.4g}", r.geometry.bore / mm),
                 fmt::format("{:.4g}", r.geometry.outer_diameter / mm),
                 fmt::format("{:.5g}", r.geometry.pitch_diameter / mm),
                 fmt::format("{}", r.geometry.ball_count),
                 fmt::format("{:.5g}", r.geometry.ball_diameter / mm),
                 fmt::format("{:.3g}", r.geometry.contact_angle / degree),
                 fmt::format("{:.0f}", r.geometry.static_load_rating)});
    fmt::print("{}", table.text(terminal_width()));
  }
  if (rows.empty()) {
    fmt::print(
        stderr,
        "raceway bearings: no bearing has \"{}\" in its name; without a filter all are listed\n",
        filter);
    return wrong_input;
  }
  return done;
}

}  // namespace

Run setup_bearings(CLI::App& command) {
  auto filter = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  command.add_option("FILTER", *filter, "part of a designation; all bearings without it")
      ->type_name("");
  command.add_flag("--json", *json, "one JSON document instead of text");
  command.footer("Example:\n  raceway bearings \"S 60\"");
  return [=] { return list_bearings(*filter, *json); };
}

}  // namespace raceway::cli
