#include <fmt/core.h>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/number_flag.h"
#include "cli/shared_flags.h"
#include "cli/text_table.h"
#include "record/units.h"
#include "results/results.h"
#include "session/catalogues.h"

namespace raceway::cli {
namespace {

struct BearingsFlags {
  std::string filter;
  double bore = unset, outer_diameter = unset;  // [m]
  bool json = false;
};

int run(const BearingsFlags& flags) {
  const auto rows =
      session::find_bearings(messages(), flags.filter, flags.bore, flags.outer_diameter);
  if (flags.json) {
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
  return [flags] { return run(*flags); };
}

}  // namespace raceway::cli
