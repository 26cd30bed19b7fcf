#include "files/suggest_columns.h"

#include "files/column_map.h"
#include "files/data_file.h"
#include "files/subject.h"
#include "tests/support/message_of.h"
#include "tests/support/synthetic.h"

namespace raceway::files {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string suggested(const std::string& text) {
  return suggested_columns({"d.csv", text}, *make_subject(fit::synthetic_model()));
}

TEST(SuggestColumns, AGermanExportIsRecognised) {
  const std::string text =
      "Versuch 7; Öl\n\nZeit;Drehzahl [1/min];Axialkraft [kN];Reibmoment [Nm];Temperatur "
      "Außenring [°C];Temperatur Öl [°C];Weg [mm]\n"
      "12.03.2024 08:15:00;1000;0,3;0,12;41,5;40;1\n"
      "12.03.2024 08:16:00;2000;0,3;0,17;41,5;40;1\n";
  const std::string map = suggested(text);
  for (const char* line :
       {"speed_rpm = { column = \"Drehzahl [1/min]\", unit = \"rpm\" }\n",
        "axial_load_N = { column = \"Axialkraft [kN]\", unit = \"kN\" }\n",
        "temperature_C = { column = \"Temperatur Öl [°C]\", unit = \"C\" }\n",
        "outer_ring_temperature_C = { column = \"Temperatur Außenring [°C]\", unit = \"C\" }\n",
        "friction_torque_Nmm = { column = \"Reibmoment [Nm]\", unit = \"Nm\" }\n",
        "time_s = \"Zeit\"\n", "# not used: \"Weg [mm]\"\n"})
    EXPECT_THAT(map, HasSubstr(line));
  // As it stands it is a map.
  const auto subject = make_subject(fit::synthetic_model());
  const record::Record r =
      read_record({"d.csv", text}, *subject, {.columns = parse_column_map(map, "map.toml")});
  EXPECT_DOUBLE_EQ(r.value(record::friction_torque, 1), 0.17);
  EXPECT_DOUBLE_EQ(r.value(record::axial_load, 1), 300);
}

TEST(SuggestColumns, WhatIsNotFoundStandsAsAComment) {
  const std::string map = suggested("n [rpm],x\n1,2\n2,3\n");
  EXPECT_THAT(map, HasSubstr("speed_rpm = { column = \"n [rpm]\", unit = \"rpm\" }\n"));
  EXPECT_THAT(map, HasSubstr("# friction_torque_Nmm = \"...\"  # not found, and needed\n"));
  EXPECT_THAT(map, HasSubstr("# axial_load_N = \"...\"  # not found, and needed: a column, or a "
                             "number for all rows\n"));
}

/// A unit in [columns] is one that the user has said, and is not asked about again.
TEST(SuggestColumns, AUnitThatTheFileDoesNotStateIsNotProposed) {
  const std::string map = suggested("Drehzahl,Axialkraft,Reibmoment\n1,2,3\n2,3,4\n");
  EXPECT_THAT(map, HasSubstr("speed_rpm = \"Drehzahl\"  # no unit in the file: read in rpm\n"));
  EXPECT_THAT(map, HasSubstr("friction_torque_Nmm = \"Reibmoment\"  # no unit in the file: read in "
                             "Nmm\n"));
}

TEST(SuggestColumns, VoltsOfATorqueAreTheSignalOfItsSensor) {
  const std::string map = suggested("n [rpm],Fa [N],Drehmoment [mV],Signal\n1,2,3,4\n2,3,4,5\n");
  EXPECT_THAT(map,
              HasSubstr("torque_signal_V = { column = \"Drehmoment [mV]\", unit = \"mV\" }\n"));
  EXPECT_THAT(map, HasSubstr("# not used: \"Signal\"\n"));
  EXPECT_THAT(map, Not(HasSubstr("friction_torque_Nmm")));
}

TEST(SuggestColumns, AUnitThatIsNotKnownIsShownAndAsked) {
  const std::string map =
      suggested("Speed (rad/sec),Load (bananas),Torque (oz-in)\n1,2,3\n2,3,4\n");
  EXPECT_THAT(map, HasSubstr("speed_rpm = { column = \"Speed (rad/sec)\", unit = \"rad_s\" }\n"));
  EXPECT_THAT(map, HasSubstr("# axial_load_N = { column = \"Load (bananas)\", unit = \"...\" }  # "
                             "the file has \"bananas\", which is not known: N, kN"));
}

TEST(SuggestColumns, AColumnOfAnotherKindOfUnitIsNotTaken) {
  EXPECT_THAT(suggested("speed [rpm],load [mm],torque [Nm]\n1,2,3\n2,3,4\n"),
              HasSubstr("# not used: \"load [mm]\"\n"));
}

}  // namespace
}  // namespace raceway::files
