#include "cli/table_memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "cli/messages.h"
#include "text/error.h"

namespace raceway::cli {
namespace {

constexpr double GB = 1e9;
constexpr double most_points = 1e8, most_slabs = 1e6;

/// [B], as measured: a cell of a file takes 11 characters, which are there twice while it is
/// written; one of a JSON document is a value with its name.
double bytes_per_point(std::size_t columns, TableForm form) {
  const double inputs_and_status = 6.0, cells = static_cast<double>(columns) + inputs_and_status;
  const double held = 8.0 * static_cast<double>(columns) + 12.0;
  switch (form) {
    case TableForm::file:
      return held + 22.0 * cells;
    case TableForm::json:
      return held + 320.0 * cells;
    default:
      return held;
  }
}

/// That this process may take [B]: of the machine, of its container, by its limits.
double memory() {
  double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  double of_container = 0.0;
  if (std::ifstream("/sys/fs/cgroup/memory.max") >> of_container)
    bytes = std::min(bytes, of_container);
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  return bytes;
}

/// "3 slabs, --slab 1/3 to 3/3": so many that each keeps within `most` of `all`.
std::string slabs(double all, double most) {
  const double count = std::max(2.0, std::ceil(all / most));
  if (!(count <= most_slabs)) return "even a million slabs are not enough; use fewer points";
  return fmt::format(
      "calculate the table in {0:.0f} slabs with --slab 1/{0:.0f} to --slab {0:.0f}/{0:.0f}",
      count);
}

}  // namespace

void require_memory(const friction::TableAxes& axes, const friction::TableSlab& slab,
                    std::size_t columns, TableForm form) {
  // As a floating number: the product may be beyond every whole one.
  double all = 1.0;
  for (const auto* axis : {&axes.speed, &axes.axial_load, &axes.radial_load, &axes.temperature})
    all *= static_cast<double>(axis->size());
  const double points = all / static_cast<double>(slab.count);
  if (points > most_points)
    throw text::InputError(fmt::format("raceway table: {:.10g} points: at most 1e8 in one run; {}",
                                       points, slabs(all, most_points)));
  const double bytes = points * bytes_per_point(columns, form);
  // Some is for the program and for others.
  const double most = 0.8 * memory();
  if (bytes > most)
    throw text::InputError(fmt::format(
        "raceway table: {:.10g} points need {:.3g} GB of memory, but only {:.3g} GB are available; "
        "{}",
        points, bytes / GB, most / GB, slabs(bytes * static_cast<double>(slab.count), most)));
  if (bytes > GB)
    tell({fmt::format("{:.10g} points need {:.2g} GB of memory", points, bytes / GB)});
}

void require_memory_to_merge(const std::vector<std::string>& files) {
  double bytes = 0.0;
  for (const std::string& file : files) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (!error) bytes += 2.0 * static_cast<double>(size);
  }
  const double most = 0.8 * memory();
  if (bytes > most)
    throw text::InputError(
        fmt::format("raceway table: the slabs and their table need {:.3g} GB of memory, but only "
                    "{:.3g} GB are available; join them on a computer with more memory",
                    bytes / GB, most / GB));
}

}  // namespace raceway::cli
