// How far a correction may be trusted, from the fit to the control.
#include <string>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string exact_record = source_dir() + "/data/corrections/exact/";
const std::string one_way =
    "do not use, because in the record of the fit the displacement changes only once, in one "
    "direction, so no test shows the error on another day: record a cool-down as well, or test the "
    "model with "
    "another record (identify --validate)";

/// Identified on the first hours of a record, into found.toml of a folder.
Result identified(const ScratchFolder& scratch, const std::string& flags) {
  return run("identify " + exact_record + "correction.toml " + exact_record + "train.csv " + flags +
             " --force -o " + scratch.file("found.toml"));
}

/// Four hours in which the machine warms up: on another day this model is worse than none.
TEST(Trust, ACorrectionOfFourHoursIsNotExported) {
  const ScratchFolder scratch;
  const std::string found = scratch.file("found.toml"), program = scratch.file("z.py");
  EXPECT_THAT(identified(scratch, "--until 4h --order 1").out,
              testing::EndsWith("\ntrust in displacement_z_um: " + one_way + "\n"));
  EXPECT_THAT(file_text(found), HasSubstr("[correction.trust]  # " + one_way + "\nerror_um = "));
  EXPECT_THAT(run("correct " + found + " " + exact_record + "test.csv").out,
              HasSubstr("\ntrust in displacement_z_um: do not use, because the RMS error on this "
                        "record is 14.9 um; the RMS displacement without correction is 14.7 um\n"));
  expect_refused(run("export " + found + " --format python -o " + program), one_way);
  expect_refused(run("export " + found + " --format python -o " + program), "--accept-untrusted");
  const Result forced =
      run("export " + found + " --format csv --accept-untrusted -o " + scratch.file("z.csv"));
  ASSERT_EQ(forced.status, 0) << forced.err;
  EXPECT_THAT(forced.err, HasSubstr("warning: trust in displacement_z_um: " + one_way));
  // The table carries it.
  EXPECT_THAT(file_text(scratch.file("z.csv")),
              HasSubstr("\ndisplacement_z_um,,displacement,trust,do-not-use,\n"));
  expect_refused(run("export " + scratch.file("z.csv") + " --format python"), one_way);
  EXPECT_EQ(run("export " + scratch.file("z.csv") + " --format csv --accept-untrusted --quiet").out,
            file_text(scratch.file("z.csv")));
}

TEST(Trust, AWholeRecordIsGoodAndSaysSo) {
  const ScratchFolder scratch;
  const std::string found = scratch.file("found.toml");
  EXPECT_THAT(identified(scratch, "").out, HasSubstr("\ntrust in displacement_z_um: good\n"));
  for (const std::string format : {"python", "c", "csv"}) {
    const Result written = run("export " + found + " --format " + format);
    EXPECT_THAT(written.out, HasSubstr(" Trust in displacement_z_um: good.\n")) << format;
    EXPECT_THAT(written.err, HasSubstr("note: trust in displacement_z_um: good\n")) << format;
  }
  const json inside = parsed(run("correct " + found + " " + exact_record + "train.csv --json"));
  EXPECT_EQ(inside["trust"]["verdict"], "good");
  const json beyond = parsed(run("correct " + found + " " + exact_record + "test.csv --json"));
  ASSERT_GT(beyond["rows_beyond_range"], 0);
  EXPECT_EQ(beyond["trust"]["verdict"], "within-range");
  // A tighter tolerance judges the same evidence anew.
  scratch.write("found.toml",
                replaced(file_text(found), "tolerance_um = 1.0", "tolerance_um = 0.1"));
  EXPECT_THAT(
      run("export " + found + " --format c").err,
      HasSubstr("warning: trust in displacement_z_um: only inside its range: the RMS error on "
                "held-out parts is 0.185 um (tolerance 0.1 um)"));
}

TEST(Trust, AnotherRecordDecidesWhereOneWasGiven) {
  const ScratchFolder scratch;
  // Of 6 h of a warm-up it may be right, which another record shows; of one section it is not.
  const std::string by_another = " --until 6h --validate " + exact_record + "test.csv";
  EXPECT_THAT(identified(scratch, by_another).out,
              testing::EndsWith("\ntrust in displacement_z_um: good\n"));
  EXPECT_THAT(file_text(scratch.file("found.toml")), HasSubstr("judged_by = \"other-record\"\n"));
  EXPECT_EQ(run("export " + scratch.file("found.toml") + " --format c").status, 0);
  EXPECT_THAT(
      identified(scratch, "--until 4h --order 1 --validate " + exact_record + "test.csv").out,
      testing::EndsWith("do not use, because the RMS error on another record is 14.9 um; the "
                        "RMS displacement without correction is 14.7 um\n"));
}

TEST(Trust, IsNotKnownOfAFileThatDoesNotSayIt) {
  const ScratchFolder scratch;
  const std::string found = scratch.file("found.toml");
  const Result bare = run("export " + exact_record + "correction.toml --format python");
  EXPECT_EQ(bare.status, 0);
  EXPECT_THAT(bare.err, HasSubstr("note: displacement_z_um: the trust in this correction is not "
                                  "known: the model file has no held-out error"));
  // Nor of one whose numbers were changed since.
  ASSERT_EQ(identified(scratch, "--until 4h").status, 0);
  scratch.write("found.toml", replaced(file_text(found), "offset_um = -", "offset_um = "));
  const Result changed = run("export " + found + " --format c");
  EXPECT_EQ(changed.status, 0) << changed.err;
  EXPECT_THAT(changed.err, HasSubstr("the trust in this correction is not known"));
}

TEST(Trust, OfATableIsRefusedWhereItSaysSomethingElse) {
  const ScratchFolder scratch;
  ASSERT_EQ(identified(scratch, "--until 4h").status, 0);
  const std::string found = scratch.file("found.toml");
  scratch.write("found.toml",
                replaced(file_text(found), "course = \"one-way\"", "course = \"up\""));
  expect_refused(run("export " + found + " --format c"),
                 "course = \"up\": must be returns or one-way");
}

}  // namespace
}  // namespace raceway::tests
