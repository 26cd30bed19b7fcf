#include "files/oil_grade.h"

#include <gmock/gmock.h>

#include <string>

#include "text/error.h"

namespace raceway::tests {
namespace {

using files::oil_grade;

/// Viscosity at 40 C of an oil of viscosity index 100 that has v at 100 C [mm2/s]: H of ASTM D
/// 2270, by its formulas.
double index_100(double v) {
  if (v < 3.8) return 0.84155 * v * v + 1.5521 * v - 0.077;
  if (v < 4.4) return 0.78571 * v * v + 1.7929 * v - 0.183;
  if (v < 5.0) return 0.82143 * v * v + 1.5679 * v + 0.119;
  if (v < 6.4) return 0.04985 * v * v + 9.1613 * v - 18.557;
  if (v < 7.0) return 0.22619 * v * v + 7.7369 * v - 16.656;
  if (v < 7.7) return 0.79762 * v * v - 0.7321 * v + 14.610;
  if (v < 9.0) return 0.05794 * v * v + 10.5156 * v - 28.240;
  if (v < 12.0) return 0.26665 * v * v + 6.7015 * v - 10.810;
  return 0.20073 * v * v + 8.4658 * v - 22.490;
}

TEST(OilGrade, HasTheViscositiesOfIndex100) {
  for (const int grade : {5, 7, 10, 15, 22, 32, 46, 68, 100, 150})
    // A tenth of mm2/s at 100 C.
    EXPECT_NEAR(index_100(oil_grade(std::to_string(grade)).at_100_C), grade, 0.05 * grade) << grade;
}

TEST(OilGrade, IsReadAsPeopleWriteIt) {
  for (const char* const words : {"VG 32", "ISO VG 32", "32", "vg32", "iso vg 32"})
    EXPECT_EQ(oil_grade(words).grade, 32) << words;
}

TEST(OilGrade, OfAnotherNameIsRefusedWithAllGrades) {
  for (const char* const words : {"", "VG 33", "Mobil 1", "32 mm2/s", "SAE 30"})
    EXPECT_THAT([&] { (void)oil_grade(words); }, testing::ThrowsMessage<text::InputError>(
                                                     testing::HasSubstr("5, 7, 10, 15, 22, 32")))
        << words;
}

}  // namespace
}  // namespace raceway::tests
