#include <gmock/gmock.h>

#include "tests/spindle_study/reference.h"

namespace spindle_study {
namespace {

// Of another program, at the bars of its cases.
TEST(SpindleStudyStartUps, OfTheReferenceAreMet) {
  for (const Compared& f : start_ups()) EXPECT_TRUE(f.good()) << line(f);
}

}  // namespace
}  // namespace spindle_study
