#include <string>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

TEST(Conformity, OfADesignationMakesAUsableModel) {
  const ScratchFolder scratch;
  const std::string model = scratch.file("my.toml");
  const Result r = run("calibrate \"s6014c\" -o " + model);
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_THAT(r.out, HasSubstr("conformity of both grooves  0.5203"));
  const std::string text = file_text(model);
  EXPECT_THAT(
      text,
      HasSubstr("# fitted to the catalogue rigidity of preload class L, M, S, standard error"));
  EXPECT_THAT(text, Not(HasSubstr("assumed\nstatic")));
  const Result solved = run("solve " + model + " --speed 10000 --axial-load 600");
  EXPECT_EQ(solved.status, 0) << solved.err;
}

TEST(Conformity, OfAModelWithACatalogueRowKeepsAllElse) {
  const ScratchFolder scratch;
  const std::string before =
      "[bearing]\ncatalogue = \"GMN S 6014 E\"   # mine\nouter_conformity = 0.53  # guessed\n\n"
      "[lubricant]\nviscosity_40C_mm2_s = 22.0\nviscosity_100C_mm2_s = 4.8\n";
  const std::string model = scratch.write("a.toml", before), fitted = scratch.file("b.toml");
  ASSERT_EQ(run("calibrate " + model + " -o " + fitted).status, 0);
  const json document = parsed(run("calibrate " + model + " --json"));
  EXPECT_THAT(keys(document), IsSupersetOf({"bearing", "conformity", "classes", "rms_percent"}));
  EXPECT_EQ(document["classes"].size(), 3U);
  EXPECT_NEAR(document["conformity"]["value"].get<double>(), 0.523, 0.001);
  const std::string after = file_text(fitted);
  EXPECT_THAT(after, HasSubstr("catalogue = \"GMN S 6014 E\"   # mine\n"));
  EXPECT_THAT(after, HasSubstr("outer_conformity = 0.523"));
  EXPECT_THAT(after, HasSubstr("  # the same value for both grooves\n"));
  EXPECT_THAT(after, Not(HasSubstr("guessed")));
  EXPECT_THAT(after, HasSubstr("viscosity_40C_mm2_s = 22.0\n"));
}

TEST(Conformity, SaysWhatIsMissing) {
  const ScratchFolder scratch;
  expect_refused(run("calibrate \"S 9999 C\""), "is not in the catalogue; similar designations: ");
  const std::string own = scratch.write("own.toml", model_text);
  const Result r = run("calibrate " + own);
  EXPECT_EQ(r.status, 1);
  EXPECT_THAT(r.err, HasSubstr("raceway calibrate: DATA is missing. To fit the conformity to the "
                               "rigidities in the catalogue instead,"));
  expect_refused(run("calibrate nothing.toml"), "nothing.toml: no such file");
}

TEST(Conformity, IsNotWrittenWhereNoneIsPlausible) {
  const ScratchFolder scratch;
  const std::string folder = scratch.file("data");
  const Result r =
      run_shell("mkdir -p " + folder +
                "/bearings; sed 's/85.0,700.0,140.0,1400.0,200.0/285,700,440,1400,600/' '" +
                tests::source_dir() + "/data/bearings/gmn_spindle.csv' > " + folder +
                "/bearings/gmn.csv\n"
                "RACEWAY_DATA=" +
                folder + " $raceway calibrate \"S 6014 C\" -o " + scratch.file("a.toml"));
  EXPECT_EQ(r.status, 2);
  EXPECT_THAT(r.err,
              HasSubstr("no conformity from 0.505 to 0.56 gives the rigidities of the catalogue"));
  EXPECT_EQ(file_text(scratch.file("a.toml")), "");
}

}  // namespace
}  // namespace raceway::tests
