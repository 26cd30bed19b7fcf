#include "results/record_text.h"

#include <fmt/format.h>

#include "files/data_file.h"
#include "files/subject.h"
#include "tests/support/message_of.h"
#include "tests/support/synthetic.h"

namespace raceway::results {
namespace {

TEST(RecordText, ReadsBackAsItIs) {
  model::Model model = fit::synthetic_model();
  model.rig.axial_load = 100;
  const auto subject = files::make_subject(model);
  const record::Record first = files::read_record({"d.csv",
                                                   "run_id;speed_1_s;temperature_F;friction_torque_"
                                                   "Nm\n\"a, b\";10;104;0,25\n=1+1;20;113;0,3\n"},
                                                  *subject);
  const record::Record again = files::read_record({"e.csv", record_text(first)}, *subject);
  ASSERT_EQ(again.rows(), 2u);
  EXPECT_EQ(again.runs, first.runs);
  EXPECT_EQ(first.runs[1], "=1+1");
  EXPECT_THAT(record_text(first), testing::HasSubstr("'=1+1"));  // no formula of a spreadsheet
  for (const record::Column& column : first.columns) {
    ASSERT_TRUE(again.has(*column.channel)) << column.channel->name;
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_NEAR(again.value(*column.channel, i), column.values[i],
                  1e-11 * std::abs(column.values[i]));
  }
}

TEST(RecordText, OfACoastDownItHasTheTorques) {
  model::Model model = fit::synthetic_model();
  model.rig.axial_load = 100;
  model.rig.inertia = 0.1;
  const auto subject = files::make_subject(model);
  std::string text = "time_s,speed_rpm\n";
  for (int i = 0; i < 200; ++i)  // with the last digit of a counter
    text += fmt::format("{},{}\n", i, 6000 - 20 * i + (i * 7 % 5 - 2) * 0.1);
  const record::Record torques = files::read_record({"d.csv", text}, *subject);
  EXPECT_THAT(record_text(torques), testing::HasSubstr("friction_torque_Nmm,std_Nmm"));
  const record::Record again = files::read_record({"e.csv", record_text(torques)}, *subject);
  EXPECT_EQ(again.rows(), torques.rows());
  // J dw/dt of 20 rpm in a second
  EXPECT_NEAR(again.value(record::friction_torque, 3), 0.1 * 20 * rpm, 0.02 * 0.1 * 20 * rpm);
}

}  // namespace
}  // namespace raceway::results
