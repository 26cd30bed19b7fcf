#include "cli/band_flag.h"

#include <fmt/format.h>

#include "cli/text_table.h"
#include "io/error.h"
#include "io/names.h"

namespace raceway::cli {

void BandFlag::declare(CLI::App& command) {
  command.add_flag("--band", on,
                   "half the width of the 95 % band (1.96 std) from the fitted parameters\n"
                   "alone, of a model that calibrate or add has written; what the model\n"
                   "lacks and the noise of a reading are no part of it");
}

std::optional<model::Band> BandFlag::of(const io::ModelFile& file) const {
  if (!on) return std::nullopt;
  if (!file.model.covariance)
    throw io::InputError(
        fmt::format(
            "--band: {} has no [calibration.covariance] of the values that stand in it; raceway "
            "calibrate {} DATA -o FILE first, FILE has one",
            file.source, file.source),
        {.file = file.source, .key = "calibration.covariance"});
  return model::Band(file.model);
}

std::string band_statement(const model::Band& band) {
  return fmt::format(
      "95 % band of the fitted {} alone; what the model lacks and noise are no part of it",
      io::listed(band.fitted()));
}

std::string band_text(double half_width, double unit) {
  return "+- " + number(half_width / unit, 2);
}

}  // namespace raceway::cli
