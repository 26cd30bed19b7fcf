#include "text/missing_cell.h"

#include <gtest/gtest.h>

namespace raceway::text {
namespace {

TEST(MissingCell, IsWhatInstrumentsAndSpreadsheetsWriteInPlaceOfANumber) {
  for (const char* cell :
       {"",       "--",      "NaN",     "NaT",       "<NA>",      "#N/A",  "#REF!",
        "#NV",    "1.#QNAN", "-1.#IND", "Inf",       "OVER",      "+OVER", "-OVER",
        "OL",     "OVLD",    "OVRNG",   "Overrange", "Bad Input", "Error", "Open TC",
        "******", "#####",   "????",    "Invalid",   "No Data"})
    EXPECT_TRUE(is_missing(cell)) << cell;
}

TEST(MissingCell, IsNoNumberAndNoName) {
  for (const char* cell : {"0", "-1", "#1", "run 1", "open 2", "-5", "*1", "a", "N", "#", "*", "?"})
    EXPECT_FALSE(is_missing(cell)) << cell;
}

}  // namespace
}  // namespace raceway::text
