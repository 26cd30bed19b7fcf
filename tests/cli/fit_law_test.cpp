#include <cmath>
#include <string>

#include "tests/cli/sample.h"
#include "tests/places.h"

namespace raceway::tests {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

/// Every 250 rpm to 10 000 rpm of a function of the speed [rpm] in um.
template <typename U>
std::string curve(U u) {
  std::string text = "speed_rpm,axial_displacement_um\n";
  for (int n = 0; n <= 10000; n += 250) {
    char row[64];
    std::snprintf(row, sizeof row, "%d,%.17g\n", n, u(static_cast<double>(n)));
    text += row;
  }
  return text;
}

double published(double n) {
  return n > 0.0 ? 1.28e-3 * std::pow(n, 1.0 - 0.697 * std::exp(-5.3e-4 * n)) : 0.0;
}

double saturating(double n) {
  const double x = n / 10000.0;
  return 10.0 * x * x / (0.05 + x * x);
}

TEST(FitLaw, OfThePublishedLawPrintsItsNumbers) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("u.csv", curve(published));
  const Result text = run("fit-law " + file + " --at 5000");
  ASSERT_EQ(text.status, 0) << text.err;
  EXPECT_EQ(text.err, "");
  EXPECT_THAT(text.out, HasSubstr("A           0.00128000"));
  EXPECT_THAT(text.out, HasSubstr("B             0.697000"));
  EXPECT_THAT(text.out, HasSubstr("C          0.000530000"));
  EXPECT_THAT(text.out, HasSubstr("valid                0 to 10000 rpm"));
  EXPECT_THAT(text.out, HasSubstr("at 5000 rpm: u = 4.20754 um, du/dn = 0.00173537 um/rpm"));
  EXPECT_THAT(text.out, HasSubstr("The law follows the curve"));

  const json document = parsed(run("fit-law " + file + " --at 1000 --json"));
  EXPECT_THAT(keys(document), IsSupersetOf({"parameters", "mae_um", "max_abs_um", "rows",
                                            "valid_from_rpm", "valid_to_rpm", "verdict"}));
  EXPECT_NEAR(document["parameters"]["A"]["value"].get<double>(), 1.28e-3, 1.28e-9);
  EXPECT_NEAR(document["parameters"]["B"]["value"].get<double>(), 0.697, 0.697e-6);
  EXPECT_NEAR(document["parameters"]["C"]["value"].get<double>(), 5.3e-4, 5.3e-10);
  EXPECT_EQ(document["parameters"]["C"]["unit"], "1/rpm");
  EXPECT_EQ(document["valid_to_rpm"], 10000.0);
  EXPECT_EQ(document["rows"], 40);
  EXPECT_NEAR(document["at"]["axial_displacement_um"].get<double>(), 0.07524, 0.5e-5);
}

TEST(FitLaw, ReadsAPipe) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("u.csv", curve(published));
  for (const std::string& line :
       {"cat " + file + " | $raceway fit-law", "$raceway fit-law - < " + file}) {
    const Result r = run_shell(line);
    EXPECT_EQ(r.status, 0) << r.err;
    EXPECT_THAT(r.out, HasSubstr("fitted to standard input"));
  }
}

// The independent fits of data/reference/kinematic_law.csv, as a user gets them.
TEST(FitLaw, OfComputedSpindlesReturnsTheIndependentNumbers) {
  const auto fit = [](const std::string& model, const std::string& speeds) {
    return parsed(run_shell("$raceway displacement '" + tests::source_dir() + "/data/spindles/" +
                            model + "' --speed " + speeds + " -o - | $raceway fit-law --json"));
  };
  const json small = fit("two_against_one.toml", "0:10000:500");
  EXPECT_NEAR(small["parameters"]["A"]["value"].get<double>(), 5.56e-4, 0.5e-6);
  EXPECT_NEAR(small["parameters"]["B"]["value"].get<double>(), 0.741, 0.0005);
  EXPECT_NEAR(small["parameters"]["C"]["value"].get<double>(), 5.52e-4, 0.5e-6);
  EXPECT_NEAR(small["mae_um"].get<double>(), 0.0144, 0.00005);
  EXPECT_EQ(small["verdict"], "follows");
  const json large = fit("published_curve.toml", "0:10000:250");
  EXPECT_NEAR(large["parameters"]["A"]["value"].get<double>(), 1.230e-3, 0.5e-6);
  EXPECT_NEAR(large["parameters"]["B"]["value"].get<double>(), 0.715, 0.0005);
  EXPECT_NEAR(large["parameters"]["C"]["value"].get<double>(), 5.53e-4, 0.5e-6);
}

TEST(FitLaw, IsNotExtrapolated) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("u.csv", curve(published));
  expect_refused(run("fit-law " + file + " --at 10001"),
                 "--at = 10001 rpm: the law is valid only within the speeds of the displacement "
                 "curve, 0 to 10000 rpm");
}

TEST(FitLaw, OffersAMonotoneTableWhereTheLawIsTooStiff) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("u.csv", curve(saturating));
  const Result r = run("fit-law " + file);
  EXPECT_EQ(r.status, 0);
  EXPECT_THAT(r.out, HasSubstr("The law does not follow the curve"));
  EXPECT_THAT(r.out, HasSubstr("-o FILE writes the table"));
  const std::string table = scratch.file("table.csv");
  const Result written = run("fit-law " + file + " -o " + table);
  EXPECT_THAT(written.err, HasSubstr("table.csv written, 41 speeds"));
  EXPECT_THAT(file_text(table), HasSubstr("\nspeed_rpm,axial_displacement_um,slope_um_rpm\n0,0,"));
  EXPECT_THAT(run("fit-law " + file + " -o " + table).err, HasSubstr("exists already"));
  const Result to_stdout = run("fit-law " + file + " -o -");
  EXPECT_EQ(to_stdout.out, file_text(table));
  EXPECT_EQ(parsed(run("fit-law " + file + " --json"))["verdict"], "stiff");
}

TEST(FitLaw, SaysWhatIsWrongWithItsInput) {
  const ScratchFolder scratch;
  const auto of = [&](const std::string& rows) {
    return run("fit-law " + scratch.write("u.csv", "speed_rpm,axial_displacement_um\n" + rows));
  };
  expect_refused(of("0,0\n1000,1\n2000,2\n3000,3\n"), "3 different speeds above zero");
  expect_refused(of("1000,1\n1000,1.1\n1000,0.9\n1000,1\n"), "1 different speed above zero");
  expect_refused(of("0,0\n1000,0\n2000,0\n3000,0\n4000,0\n"), "all displacements are 0");
  expect_refused(of("-1000,1\n"), "u.csv:2: speed_rpm = -1000: must be from 0");
  expect_refused(of("1000,NaN\n"), "is not a finite number");
  expect_refused(of("1000;1\n"), "u.csv:2");
  expect_refused(run("fit-law nothing.csv"), "nothing.csv: no such file");
  expect_refused(run_shell("$raceway fit-law < /dev/null"), "standard input: the file is empty");
  expect_refused(run("fit-law a.csv --at -5"), "--at = -5 rpm: must be from 0");
  expect_refused(run("fit-law a.csv --json -o -"), "write to stdout; omit one of them");
}

TEST(FitLaw, SaysThatADisplacementAtStandstillIsNotTheLaws) {
  const ScratchFolder scratch;
  const std::string file =
      scratch.write("u.csv", curve([](double n) { return published(n) + 0.5; }));
  EXPECT_THAT(run("fit-law " + file).err,
              HasSubstr("the displacement at standstill is 0.5 um, but the law gives 0"));
}

}  // namespace
}  // namespace raceway::tests
