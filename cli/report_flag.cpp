#include "cli/report_flag.h"

#include "cli/messages.h"
#include "report/report.h"
#include "text/error.h"

namespace raceway::cli {
void ReportFlag::declare(CLI::App& command) {
  command
      .add_option(
          "--report", path,
          report::report_available()
              ? "HTML page to write, with the results as pictures; works offline in any browser"
              : "not available: this program was built with -DRACEWAY_REPORT=OFF")
      ->type_name("FILE");
}

void ReportFlag::check(text::IfExists if_exists) const {
  if (path.empty()) return;
  if (!report::report_available())
    throw text::InputError(
        "--report: this program was built without reports (-DRACEWAY_REPORT=OFF); with Node and "
        "npm installed, build it with -DRACEWAY_REPORT=ON",
        {.key = "--report"});
  text::require_name_of(path, text::Written::page);
  text::require_writable(path, if_exists);
}

void ReportFlag::write(const std::function<std::string()>& page, text::IfExists if_exists) const {
  if (path.empty()) return;
  text::write_text(path, page(), if_exists);
  say(path + " written; open this page in a browser");
}

}  // namespace raceway::cli
