#include "files/suggest_columns.h"

#include "files/column_map.h"
#include "files/correction_file.h"
#include "files/data_file.h"
#include "files/series_file.h"
#include "files/subject.h"
#include "record/series_channel.h"
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
  EXPECT_THAT(map, HasSubstr("# friction_torque_Nmm = \"...\"  # not found, but needed\n"));
  EXPECT_THAT(map,
              HasSubstr("# axial_load_N = \"...\"  # not found, but needed: give a column, or a "
                        "number for all rows\n"));
}

/// A unit in [columns] is one that the user has said, and is not asked about again.
TEST(SuggestColumns, AUnitThatTheFileDoesNotStateIsNotProposed) {
  const std::string map = suggested("Drehzahl,Axialkraft,Reibmoment\n1,2,3\n2,3,4\n");
  EXPECT_THAT(
      map, HasSubstr("speed_rpm = \"Drehzahl\"  # no unit in the file; raceway reads it in rpm\n"));
  EXPECT_THAT(
      map,
      HasSubstr("friction_torque_Nmm = \"Reibmoment\"  # no unit in the file; raceway reads it in "
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
                             "the file has the unknown unit \"bananas\": is it N, kN"));
}

/// Single letters of a lab: the case decides where the numbers do not.
TEST(SuggestColumns, TimeAndTemperatureAreToldByLetterAndByNumbers) {
  const std::string map = suggested(
      "t,n,F,T,M\n0,1000,300,25,90\n60,2000,300,26,120\n"
      "120,3000,300,27,140\n180,1000,300,28,95\n");
  for (const char* line : {"\ntime_s = \"t\"", "\ntemperature_C = \"T\"", "\naxial_load_N = \"F\"",
                           "\nspeed_rpm = \"n\"", "\nfriction_torque_Nmm = \"M\""})
    EXPECT_THAT(map, HasSubstr(line));
  // What falls is no time, and what reaches thousands no temperature.
  const std::string by_numbers = suggested(
      "t,n,F,T,M\n41,1000,300,0,90\n38,2000,300,900,120\n"
      "36,3000,300,1800,140\n39,1000,300,2700,95\n");
  EXPECT_THAT(by_numbers, HasSubstr("\ntime_s = \"T\""));
  EXPECT_THAT(by_numbers, HasSubstr("\ntemperature_C = \"t\""));
}

TEST(SuggestColumns, TheOnlyTemperatureIsWhatTheViscosityFollows) {
  const std::string map = suggested(
      "n [rpm],Fa [N],T_OR [C],M [Nmm]\n1000,300,55,100\n2000,300,56,120\n3000,300,57,130\n");
  EXPECT_THAT(map, HasSubstr("\ntemperature_C = { column = \"T_OR [C]\", unit = \"C\" }  # the "
                             "only temperature of the file"));
  EXPECT_THAT(map, Not(HasSubstr("# temperature_C")));
  // Of two each is what it says.
  EXPECT_THAT(suggested("n [rpm],Fa [N],T_OR [C],T_oil [C],M [Nmm]\n1000,300,55,40,100\n"),
              HasSubstr("\nouter_ring_temperature_C = { column = \"T_OR [C]\""));
}

TEST(SuggestColumns, AColumnOfAnotherKindOfUnitIsNotTaken) {
  EXPECT_THAT(suggested("speed [rpm],load [mm],torque [Nm]\n1,2,3\n2,3,4\n"),
              HasSubstr("# not used: \"load [mm]\"\n"));
}

std::string suggested_for(const std::string& model, const std::string& record) {
  return suggested_columns({"d.csv", record}, parse_correction(model, "z.toml").models);
}

const std::string two_lags =
    "[correction]\ndisplacement = \"displacement_z_um\"\n"
    "[[correction.channel]]\nname = \"front\"\ninput = \"front_bearing_temperature_C\"\n"
    "sections = [{ gain_um_K = 4.0, time_constant_s = 1800 }]\n"
    "[[correction.channel]]\nname = \"room\"\ninput = \"ambient_temperature_C\"\n"
    "sections = [{ gain_um_K = 4.0, time_constant_s = 1800 }]\n";

const std::string german_machine =
    "Zeit;T Lager hinten [\u00b0C];T Lager vorn [\u00b0C];Raumtemperatur;n Spindel "
    "[1/min];Vorschub X "
    "[mm/min];KSS;Verlagerung Z [mm];Moment [Nm]\n"
    "12.03.2024 08:15:00;20,5;20,1;21,0;0;0;0;0,0000;1,2\n"
    "12.03.2024 08:16:00;20,7;20,6;21,0;3000;500;1;0,0012;1,3\n"
    "12.03.2024 08:17:00;21,0;21,4;21,1;3000;500;1;0,0021;1,3\n";

TEST(SuggestColumns, OfACorrectionAreWhatItAsksForByTheWordsOfTheirNames) {
  const std::string map = suggested_for(two_lags, german_machine);
  for (const char* line :
       {"\ntime_s = \"Zeit\"\n",
        "\ndisplacement_z_um = { column = \"Verlagerung Z [mm]\", unit = \"mm\" }\n",
        "\nfront_bearing_temperature_C = { column = \"T Lager vorn [\u00b0C]\", unit = \"C\" }\n",
        "\nambient_temperature_C = \"Raumtemperatur\"  # no unit in the file; raceway reads it in "
        "C\n",
        "\nlager_hinten_temperature_C = { column = \"T Lager hinten [\u00b0C]\", unit = \"C\" }  # "
        "the model does not use this column\n",
        "\nspeed_rpm = { column = \"n Spindel [1/min]\", unit = \"rpm\" }  # the model does not "
        "use this column\n",
        "\nx_feed_m_min = { column = \"Vorschub X [mm/min]\", unit = \"mm_min\" }",
        "\ncoolant_on = \"KSS\"",
        "\n# \"Moment [Nm]\" needs no line, because raceway knows this name\n"})
    EXPECT_THAT(map, HasSubstr(line));
  // As it stands it is a map.
  const ColumnMap columns = parse_column_map(map, "map.toml");
  const record::Record r =
      read_series({"d.csv", german_machine}, {record::series_channel("displacement_z_um")},
                  {record::series_channel("front_bearing_temperature_C")}, {.columns = columns});
  EXPECT_DOUBLE_EQ(r.value(*record::series_channel("displacement_z_um"), 2), 2.1e-6);
  EXPECT_DOUBLE_EQ(r.value(*record::series_channel("front_bearing_temperature_C"), 1),
                   kelvin(20.6));
}

TEST(SuggestColumns, OfACorrectionNameWhatIsNotFound) {
  const std::string map = suggested_for(two_lags, "time_s,T1,probe\n0,20,1\n60,21,2\n120,20,3\n");
  EXPECT_THAT(map, HasSubstr("\n# \"time_s\" needs no line, because raceway knows this name\n"));
  EXPECT_THAT(map, HasSubstr("\ndisplacement_z_um = \"probe\"  # no unit in the file; raceway "
                             "reads it in um  # the only remaining column of this quantity\n"));
  // Which of two it is nobody says.
  EXPECT_THAT(
      map,
      HasSubstr("\nt1_temperature_C = \"T1\"  # no unit in the file; raceway reads it in C  # the "
                "model does not use this column\n"));
  EXPECT_THAT(map,
              HasSubstr("\n# front_bearing_temperature_C = \"...\"  # not found, but needed\n"));
  EXPECT_THAT(map, HasSubstr("\n# ambient_temperature_C = \"...\"  # not found, but needed\n"));
}

TEST(SuggestColumns, OfACorrectionKnowTheSpindleAndTheRoom) {
  const std::string map = suggested_for(
      "[correction]\ndisplacement = \"displacement_z_um\"\n",
      "time_s,Spindle speed (rpm),T Arbeitsraum [\u00b0C],Raumluft [\u00b0C],displacement_z_um\n"
      "0,0,20,20,0\n60,3000,21,20,1\n120,3000,22,21,2\n");
  EXPECT_THAT(map, HasSubstr("\nspeed_rpm = { column = \"Spindle speed (rpm)\", unit = \"rpm\" }"));
  EXPECT_THAT(map, HasSubstr("\narbeitsraum_temperature_C = "));
  EXPECT_THAT(map, HasSubstr("\nroom_temperature_C = { column = \"Raumluft [\u00b0C]\""));
}

TEST(SuggestColumns, OfSeveralFilesAreOneMap) {
  Source record("temperatures.csv",
                "Zeit;Lager vorn [\u00b0C];Raumluft [\u00b0C];Bemerkung\n"
                "12.03.2024 08:00:00;20,5;20,0;\n12.03.2024 08:01:00;21,5;20,0;x\n");
  record.beside.emplace_back("probe.csv",
                             "Timestamp,Probe Z (mm)\n2024-03-12T08:00:30,0.001\n"
                             "2024-03-12T08:01:30,0.002\n");
  record.beside.emplace_back("speed.csv",
                             "Timestamp,Spindle speed (rpm)\n2024-03-12T08:00:00,0\n"
                             "2024-03-12T08:01:00,3000\n");
  const std::vector<correction::Model> models{
      {.displacement = record::series_channel("displacement_z_um")}};
  const std::string map = suggested_columns(record, models);
  EXPECT_THAT(map, HasSubstr("# Columns of temperatures.csv, probe.csv and speed.csv, proposed"));
  EXPECT_THAT(map, HasSubstr("\ntime_s = [\"Zeit\", \"Timestamp\"]\n"));
  EXPECT_THAT(map, HasSubstr("\ndisplacement_z_um = { column = \"Probe Z (mm)\", unit = \"mm\" }"));
  EXPECT_THAT(map, HasSubstr("\nspeed_rpm = { column = \"Spindle speed (rpm)\""));
  EXPECT_THAT(map, HasSubstr("\n# not used: \"Bemerkung\"\n"));
  EXPECT_THAT(map, Not(HasSubstr("not found")));
  EXPECT_EQ(parse_column_map(map, "map.toml").rules.size(), 6U);
}

TEST(SuggestColumns, OfABareCorrectionAreAllInputs) {
  const std::string map =
      suggested_for("[correction]\ndisplacement = \"displacement_z_um\"\n", german_machine);
  EXPECT_THAT(map,
              HasSubstr("\nlager_vorn_temperature_C = { column = \"T Lager vorn [\u00b0C]\", unit "
                        "= \"C\" }\n"));
  EXPECT_THAT(map, Not(HasSubstr("does not use")));
}

}  // namespace
}  // namespace raceway::files
