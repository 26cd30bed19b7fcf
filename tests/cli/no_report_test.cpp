// Linked with report/no_report.cpp, as all of a program built with -DRACEWAY_REPORT=OFF is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/report_flag.h"
#include "report/report.h"
#include "text/error.h"
#include "text/output_file.h"

namespace raceway::cli {
namespace {

using testing::HasSubstr;

TEST(WithoutReports, TheFlagSaysHowTheProgramWasBuilt) {
  ASSERT_FALSE(report::report_available());
  CLI::App app;
  ReportFlag flag;
  flag.declare(app);
  EXPECT_THAT(app.help(), HasSubstr("-DRACEWAY_REPORT=OFF"));
  EXPECT_NO_THROW(flag.check(text::IfExists::refuse)) << "no report was requested";
  app.parse("--report page.html");
  try {
    flag.check(text::IfExists::refuse);
    FAIL() << "a report was promised";
  } catch (const text::InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("without reports (-DRACEWAY_REPORT=OFF)"));
    EXPECT_THAT(e.what(), HasSubstr("Node and npm"));
  }
}

}  // namespace
}  // namespace raceway::cli
