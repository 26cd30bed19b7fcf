#include "text/missing_cell.h"

#include <algorithm>
#include <iterator>

#include "text/names.h"

namespace raceway::text {

bool is_missing(std::string_view cell) {
  // Nothing, dashes, and cells that were too narrow for their number.
  if (cell.find_first_not_of('-') == cell.npos) return true;
  for (const char filler : {'*', '#', '?'})
    if (cell.size() > 1 && cell.find_first_not_of(filler) == cell.npos) return true;
  constexpr std::string_view words[]{
      "nan", "-nan", "na", "n/a", "<na>", "nat", "null", "none",
      // infinite and out of range, by C libraries and instruments
      "inf", "+inf", "-inf", "infinity", "-infinity", "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind",
      "1.#inf", "-1.#inf", "over", "+over", "-over", "under", "ol", "+ol", "-ol", "ovl", "ovld",
      "ovr", "ovrng", "overload", "overflow", "underflow", "overrange", "underrange", "over range",
      "under range",
      // loggers and spreadsheets, in English and German
      "bad", "bad input", "error", "err", "invalid", "fault", "open", "open tc", "no data", "n.a.",
      "#n/a", "#nv", "#div/0!", "#wert!", "#value!", "#ref!", "#bezug!", "#name?", "#num!"};
  return std::find(std::begin(words), std::end(words), lower_case(cell)) != std::end(words);
}

}  // namespace raceway::text
