// The table of coefficients, read back; the record that programs are held to.
#include "control/check_record.h"
#include "control/table_reader.h"
#include "tests/control/control_case.h"

namespace raceway::control::control_test {
namespace {

using testing::HasSubstr;

const std::string with_keys = everything + every_range +
                              "[export]\nlimit_um = { displacement_z_um = 80 }\nunit = \"counts\"\n"
                              "smoothing_s = { front_temperature_C = 20 }\nrestart = \"resume\"\n"
                              "plausible = { speed_rpm = [0, 20000] }\n";

TEST(ControlTableText, ReadsBackToTheSameProgramsAndTheSameTable) {
  Case c(with_keys);
  c.plan.check = made_up_check(c.plan, c.file.models);
  EXPECT_EQ(c.plan.check.rows.size(), 60u);
  const std::string table = control_csv(c.plan);
  EXPECT_TRUE(is_control_table(table));
  EXPECT_FALSE(is_control_table(with_keys));
  const ControlPlan read = read_control_table(table, "table.csv");
  EXPECT_EQ(control_csv(read), table);
  EXPECT_EQ(control_python(read), control_python(c.plan));
  EXPECT_EQ(control_c(read, "machine"), control_c(c.plan, "machine"));
}

TEST(ControlTableText, ReadsDifferenceEquationsBack) {
  Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\nsampling_s = 1\n"
      "[[correction.channel]]\nname = \"y\"\ninput = \"room_temperature_C\"\n"
      "numerator = [0.0557978, -0.0073149, -0.0481798]\n"
      "denominator = [1, -0.1719017, -0.8278259]\n",
      "time_s,room_temperature_C\n0,20\n1,20\n");
  c.plan.check = made_up_check(c.plan, c.file.models);
  const std::string table = control_csv(c.plan);
  EXPECT_THAT(table, HasSubstr("\ndisplacement_z_um,y,equation 1,denominator 1,-0.1719017,1\n"));
  EXPECT_THAT(table, HasSubstr("\ndisplacement_z_um,y,equation 1,sampling,1,s\n"));
  const ControlPlan read = read_control_table(table, "table.csv");
  EXPECT_EQ(control_csv(read), table);
  EXPECT_EQ(control_python(read), control_python(c.plan));
  EXPECT_EQ(control_c(read, "machine"), control_c(c.plan, "machine"));
  EXPECT_EQ(read.warnings, c.plan.warnings);
  std::string shorter = table;
  const std::string row = "displacement_z_um,y,equation 1,denominator 2,-0.8278259,1\n";
  shorter.replace(shorter.find(row), row.size(), "");
  EXPECT_THROW((void)read_control_table(shorter, "table.csv"), text::InputError);
}

TEST(ControlTableText, ReadsWindowsBack) {
  Case c(
      "[correction]\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\n"
      "name = \"screw\"\ninput = \"x_drive_W\"\n"
      "sections = [{ gain_um_W = 0.02, time_constant_s = 1500 }]\n"
      "window = { column = \"x_position_mm\", points = [0, 500, inf, inf] }\n"
      "[correction.range]\nx_drive_W = [-50, 400]\nx_position_mm = [0, 500]\n",
      "time_s,x_drive_W,x_position_mm\n0,20,0\n1,20,100\n");
  EXPECT_EQ(c.plan.inputs[0].plausible_low, -4000);
  c.plan.check = made_up_check(c.plan, c.file.models);
  EXPECT_EQ(c.plan.check.rows.size(), 60u);
  const std::string table = control_csv(c.plan);
  const ControlPlan read = read_control_table(table, "table.csv");
  EXPECT_EQ(control_csv(read), table);
  EXPECT_EQ(control_python(read), control_python(c.plan));
  EXPECT_EQ(control_c(read, "machine"), control_c(c.plan, "machine"));
}

TEST(ControlTableText, TakesNumbersThatWereChanged) {
  const Case c(with_keys);
  std::string table = control_csv(c.plan);
  const std::string row = "displacement_z_um,spindle,section 2,time_constant,900,s";
  table.replace(table.find(row), row.size(),
                "displacement_z_um,spindle,section 2,time_constant,850,s");
  EXPECT_EQ(read_control_table(table, "table.csv").axes[0].sections[1].time_constant_s, 850);
}

TEST(ControlTableText, KeepsNamesWithApostrophesBeforeASign) {
  for (const std::string name : {"=spindle", "'=spindle", "''-spindle", "'spindle"}) {
    Case c(with_keys);
    c.plan.axes[0].sections[0].channel = name;
    const ControlPlan read = read_control_table(control_csv(c.plan), "table.csv");
    EXPECT_EQ(read.axes[0].sections[0].channel, name);
    EXPECT_EQ(control_csv(read), control_csv(c.plan));
  }
}

TEST(ControlTableText, HasOneRowOfTheCheckPerTime) {
  Case c(with_keys);
  c.plan.check = made_up_check(c.plan, c.file.models);
  c.plan.check.rows.resize(1);
  const std::string table = control_csv(c.plan);
  const std::string rows = table.substr(table.find(",,check,") - c.plan.inputs[0].column.size());
  ASSERT_THAT(rows, HasSubstr("at 0 s"));
  std::string other_digits = rows;
  for (std::size_t at = 0; (at = other_digits.find("at 0 s", at)) != other_digits.npos;)
    other_digits.replace(at, 6, "at -0 s");
  const ControlPlan read = read_control_table(
      table + c.plan.inputs[0].column + ",,input,stuck,60,s\n" + rows + other_digits, "table.csv");
  EXPECT_EQ(read.check.rows.size(), 1u);
}

TEST(ControlTableText, RefusesInOneMessage) {
  const Case c(with_keys);
  const std::string table = control_csv(c.plan);
  const auto refused = [&](const std::string& row, const std::string& instead) {
    std::string text = table;
    const std::size_t at = text.find(row);
    if (at == text.npos) return "no row " + row;
    text.replace(at, row.size(), instead);
    try {
      (void)read_control_table(text, "table.csv");
    } catch (const text::InputError& e) {
      return std::string(e.what());
    }
    return std::string("read");
  };
  EXPECT_THAT(
      refused("section 2,time_constant,900,s", "section 2,time_constant,-900,s"),
      HasSubstr("displacement_z_um, section 2, time_constant = -900: must be from 1e-09 to"));
  EXPECT_THAT(refused("section 2,time_constant,900,s", "section 2,time_constant,9O0,s"),
              HasSubstr("is not a number"));
  EXPECT_THAT(refused("displacement_z_um,spindle,section 2,time_constant,900,s\n", ""),
              HasSubstr("displacement_z_um, section 2: time_constant is missing"));
  EXPECT_THAT(refused("section 1,input,front_temperature_C", "section 1,input,other_temperature_C"),
              HasSubstr("the table has no input of this name"));
  EXPECT_THAT(refused(",,control,restart,resume,", ",,control,restart,again,"),
              HasSubstr("must be one of: decay resume rest"));
  EXPECT_THAT(refused("displacement,sign,-1,1", "displacement,sign,0.5,1"),
              HasSubstr("\"sign\" must be 1 or -1"));
  EXPECT_THAT(refused("of,channel,part", "off,channel,part"),
              HasSubstr("the columns must be of,channel"));
  EXPECT_THAT(refused("output,offset_z_counts", "output,offset z()"),
              HasSubstr("\"output\" must consist of letters, digits, _ and -"));
  EXPECT_THAT(refused("section 1,course,", "section 1,curse,"),
              HasSubstr("unknown name in this part of the table"));
}

TEST(ControlCheckRecord, IsReplayedByEveryProgram) {
  Case c(with_keys);
  c.plan.check = made_up_check(c.plan, c.file.models);
  (void)c.folder.write("machine.py", control_python(c.plan));
  EXPECT_THAT(c.folder.shell("python3 machine.py --check"), HasSubstr("check: 60 rows over"));
  (void)c.folder.write("machine.h", control_c(c.plan, "machine"));
  const std::string compile = "cc -std=c99 -O2 -Wall -Wextra -Wpedantic -Werror -DMACHINE_CHECK ";
  EXPECT_THAT(c.folder.shell(compile + "-x c machine.h -o check -lm && ./check"),
              HasSubstr(": good"));
  EXPECT_THAT(c.folder.shell(compile + "-DMACHINE_SINGLE -x c machine.h -o check -lm && ./check"),
              HasSubstr("of 1e-03 um: good"));
  // It can fail.
  c.plan.check.rows[30].displacements_um[0] += 2e-9;
  (void)c.folder.write("machine.py", control_python(c.plan));
  EXPECT_THAT(c.folder.shell("! python3 machine.py --check"), HasSubstr("FAILED"));
  (void)c.folder.write("machine.h", control_c(c.plan, "machine"));
  EXPECT_THAT(c.folder.shell(compile + "-x c machine.h -o check -lm && ! ./check"),
              HasSubstr("FAILED"));
}

TEST(ControlCheckRecord, OfARecordIsItsFirstRunHeldWithinTheRange) {
  const std::string narrow =
      std::string(every_range)
          .replace(std::string(every_range).find("front_temperature_C = [10, 60]"), 30,
                   "front_temperature_C = [22, 30]");
  Case c(everything + narrow);
  c.plan.check = check_of(c.plan, c.file.models, c.data);
  ASSERT_EQ(c.plan.check.rows.size(), 600u);  // the second run is another one
  for (const ControlCheck::Row& r : c.plan.check.rows)
    for (std::size_t k = 0; k < c.plan.inputs.size(); ++k) {
      if (c.plan.inputs[k].column != "front_temperature_C") continue;
      EXPECT_GE(r.inputs[k], 22);
      EXPECT_LE(r.inputs[k], 30);
    }
  (void)c.folder.write("machine.py", control_python(c.plan));
  EXPECT_THAT(c.folder.shell("python3 machine.py --check"), HasSubstr("check: 600 rows over"));
}

// A name may hold anything: it stays in comments and cells.
TEST(ControlTableText, HostileNamesStayNames) {
  const std::string name =
      "=cmd|' /C calc'!A0,\\\"\\\"\\\"*/ }; system(\\\"x\\\"); /* __import__('os') ?/";
  const std::string model =
      "[correction]\nname = \"" + name +
      "\"\ndisplacement = \"displacement_z_um\"\n[[correction.channel]]\nname = "
      "\"@EVIL@#{}';--\"\ninput = \"front_temperature_C\"\nsections = [{ gain_um_K = 5, "
      "time_constant_s = 900 }]\n";
  const std::string record = "time_s,front_temperature_C\n0,20\n100,30\n";
  Case c(model, record);
  c.plan.check = made_up_check(c.plan, c.file.models);
  (void)c.folder.write("machine.py", control_python(c.plan));
  EXPECT_THAT(c.folder.shell("python3 machine.py --check"), HasSubstr(": good"));
  (void)c.folder.write("machine.h", control_c(c.plan, "machine"));
  EXPECT_THAT(
      c.folder.shell("cc -std=c99 -Wall -Wextra -Wpedantic -Werror -DMACHINE_CHECK -x c machine.h "
                     "-o check -lm && ./check"),
      HasSubstr(": good"));
  const std::string table = control_csv(c.plan);
  EXPECT_EQ(control_csv(read_control_table(table, "t.csv")), table);
  for (const char c_of_table : table) EXPECT_TRUE(c_of_table == '\n' || c_of_table >= ' ');
}

}  // namespace
}  // namespace raceway::control::control_test
