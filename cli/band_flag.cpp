#include "cli/band_flag.h"

#include <fmt/format.h>

#include "cli/text_table.h"
#include "session/bands.h"

namespace raceway::cli {

void BandFlag::declare(CLI::App& command) {
  command.add_flag(
      "--band", on,
      "add the half width of the 95 % band (1.96 standard deviations) of each result, from the "
      "uncertainty of the fitted parameters; needs a model that calibrate or add has written. The "
      "band does not include missing effects or the noise of a reading");
}

std::optional<model::Band> BandFlag::of(const files::ModelFile& file) const {
  if (!on) return std::nullopt;
  return session::band_of(
      file, "--band",
      fmt::format("raceway calibrate {} DATA -o FILE writes a model with [calibration.covariance]",
                  file.source));
}

std::string band_text(double half_width, double unit) {
  return "+- " + number(half_width / unit, 2);
}

}  // namespace raceway::cli
