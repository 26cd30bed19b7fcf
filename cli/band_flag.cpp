#include "cli/band_flag.h"

#include <fmt/format.h>

#include "cli/text_table.h"
#include "session/bands.h"

namespace raceway::cli {

void BandFlag::declare(CLI::App& command) {
  command.add_flag("--band", on,
                   "half the width of the 95 % band (1.96 std) from the fitted parameters\n"
                   "alone, of a model that calibrate or add has written; what the model\n"
                   "lacks and the noise of a reading are no part of it");
}

std::optional<model::Band> BandFlag::of(const files::ModelFile& file) const {
  if (!on) return std::nullopt;
  return session::band_of(
      file, "--band",
      fmt::format("raceway calibrate {} DATA -o FILE writes a model that has one", file.source));
}

std::string band_text(double half_width, double unit) {
  return "+- " + number(half_width / unit, 2);
}

}  // namespace raceway::cli
