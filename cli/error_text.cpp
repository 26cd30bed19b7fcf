#include "cli/error_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "record/series_channel.h"

namespace raceway::cli {

std::string noise_text(const verdict::Comparison& c) {
  const record::Channel& of = *c.channel;
  if (!std::isnan(c.noise.rms))
    return fmt::format("{} {} ({})", error_text(c.noise.rms, of, 3), error_unit(of),
                       fit::name(c.noise.source));
  const auto column =
      std::find_if(record::channels.begin(), record::channels.end(),
                   [&](const record::Channel& other) { return other.of == of.name; });
  return fmt::format(
      "not known ({}){}",
      record::find_channel(of.name) == nullptr  // of a record over time
          ? "no noise is given, and the interval between readings is too long to estimate it"
          : fmt::format("too few repeated rows{}",
                        column == record::channels.end()
                            ? ""
                            : fmt::format(", and {} is not given in every row", column->name)),
      std::isnan(c.estimated_noise)
          ? ""
          : fmt::format("; estimated {} {}", error_text(c.estimated_noise, of, 3), error_unit(of)));
}

}  // namespace raceway::cli
