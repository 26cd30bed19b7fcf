#include "text/missing_cell.h"

#include <algorithm>
#include <array>

#include "text/names.h"

namespace raceway::text {

bool is_missing(std::string_view cell) {
  constexpr std::array<std::string_view, 42> words{
      "", "-", "--", "---", "nan", "-nan", "na", "n/a", "<na>", "nat", "null", "none",
      // infinite and out of range, by C libraries and instruments
      "inf", "+inf", "-inf", "infinity", "-infinity", "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind",
      "1.#inf", "-1.#inf", "over", "under", "ol", "-ol", "overload", "overflow", "underflow",
      // loggers and spreadsheets, in English and German
      "bad", "bad input", "no data", "#n/a", "#nv", "#div/0!", "#wert!", "#value!", "#ref!",
      "#bezug!", "#name?", "#num!"};
  return std::find(words.begin(), words.end(), lower_case(cell)) != words.end();
}

}  // namespace raceway::text
