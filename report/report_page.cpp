#include <string_view>

#include "report/detail/report_document.h"
#include "report/report.h"
#include "report/report_template.h"
#include "text/error.h"

namespace raceway::report {

Document::Document(const std::string& kind) {
  add("raceway_report", 1);
  add("program", "raceway " RACEWAY_VERSION);
  add("kind", kind);
}

bool report_available() { return !report_template().empty(); }

std::string report_page(const std::string& document) {
  constexpr std::string_view mark = "@DOCUMENT@";
  const std::string_view page = report_template();
  if (page.empty())
    throw text::InputError(
        "this program was built without reports (-DRACEWAY_REPORT=OFF); build it again with "
        "-DRACEWAY_REPORT=ON, which needs Node and npm",
        {.key = "--report"});
  const std::size_t at = page.find(mark);
  std::string text;
  text.reserve(page.size() + document.size() + document.size() / 16);
  text += page.substr(0, at);
  // In JSON these occur within strings only, where the escape means the same character.
  for (const char c : document) {
    if (c == '<')
      text += "\\u003c";
    else if (c == '>')
      text += "\\u003e";
    else if (c == '&')
      text += "\\u0026";
    else
      text += c;
  }
  return text += page.substr(at + mark.size());
}

}  // namespace raceway::report
