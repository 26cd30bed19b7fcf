#include "text/units.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "files/column_map.h"
#include "record/units.h"

namespace raceway::text {
namespace {

TEST(Units, AreFoundHoweverTheyAreWritten) {
  const auto suffix = [](std::string_view text) {
    const Unit* const unit = find_unit(text);
    return unit ? std::string(unit->suffix) : "none";
  };
  for (const char* text : {"1/min", "[1/min]", "min-1", "min^-1", "min⁻¹", "U/min", "rpm", "1_min"})
    EXPECT_EQ(suffix(text), "rpm") << text;
  for (const char* text : {"Nm", "N m", "N·m", "N*m", "(Nm)"})
    EXPECT_EQ(suffix(text), "Nm") << text;
  EXPECT_EQ(suffix("mN m"), "mNm");
  EXPECT_EQ(suffix("°C"), "C");
  EXPECT_EQ(suffix("µm"), "um");
  EXPECT_EQ(suffix("μm"), "um");
  EXPECT_EQ(suffix("mm²/s"), "mm2_s");
  EXPECT_EQ(suffix("rad/s"), "rad_s");
  EXPECT_EQ(suffix("furlong"), "none");
  EXPECT_EQ(suffix("bananas"), "none");
  EXPECT_EQ(suffix(""), "none");
}

/// Factors by the definitions of the pound, 0.45359237 kg, the inch, 25.4 mm, and standard gravity.
TEST(Units, CommonSpellingsOfLoggersAreKnown) {
  constexpr double g = 9.80665, lb = 0.45359237;
  struct Case {
    const char* text;
    Dimension dimension;
    double si;
  };
  for (const Case& c : {Case{"rad/sec", Dimension::speed, 1.0},
                        {"deg/s", Dimension::speed, pi / 180.0},
                        {"°/s", Dimension::speed, pi / 180.0},
                        {"kRPM", Dimension::speed, 2000.0 * pi / 60.0},
                        {"1/sec", Dimension::speed, 2.0 * pi},
                        {"rev/sec", Dimension::speed, 2.0 * pi},
                        {"lbs", Dimension::force, lb * g},
                        {"KN", Dimension::force, 1000.0},
                        {"mN", Dimension::force, 1e-3},
                        {"kg", Dimension::force, g},
                        {"ozf·in", Dimension::moment, lb / 16.0 * g * 0.0254},
                        {"oz-in", Dimension::moment, lb / 16.0 * g * 0.0254},
                        {"lb-ft", Dimension::moment, lb * g * 12.0 * 0.0254},
                        {"kgf cm", Dimension::moment, g * 0.01},
                        {"gf cm", Dimension::moment, 1e-3 * g * 0.01},
                        {"cNm", Dimension::moment, 0.01},
                        {"N•m", Dimension::moment, 1.0},
                        {"N∙mm", Dimension::moment, 1e-3},
                        {"minutes", Dimension::time, 60.0},
                        {"msec", Dimension::time, 1e-3},
                        {"ns", Dimension::time, 1e-9},
                        {"Hours", Dimension::time, 3600.0},
                        {"Millimeter", Dimension::length, 1e-3},
                        {"Micrometers", Dimension::length, 1e-6}}) {
    const Unit* const unit = find_unit(c.text, c.dimension);
    ASSERT_NE(unit, nullptr) << c.text;
    EXPECT_NEAR(unit->to_SI(1.0), c.si, 1e-12 * c.si) << c.text;
  }
  for (const char* fahrenheit : {"Deg F", "°F", "deg f", "Fahrenheit"})
    EXPECT_NEAR(find_unit(fahrenheit, Dimension::temperature)->to_SI(212.0), 373.15, 1e-9);
}

TEST(Units, ConvertToSI) {
  EXPECT_DOUBLE_EQ(find_unit("F")->to_SI(212), kelvin(100));
  EXPECT_DOUBLE_EQ(find_unit("kN")->to_SI(1.5), 1500);
  EXPECT_DOUBLE_EQ(find_unit("1/s")->to_SI(100), 6000 * rpm);
  EXPECT_DOUBLE_EQ(find_unit("inch")->to_SI(2), 50.8 * mm);
  EXPECT_EQ(conversion(*find_unit("Nm"), *find_unit("Nmm")), "1 N m = 1000 N mm");
  EXPECT_EQ(conversion(*find_unit("K"), *find_unit("C")), "C = K - 273.15");
  EXPECT_EQ(conversion(*find_unit("F"), *find_unit("C")), "C = (F - 32) / 1.8");
}

TEST(Units, NoTwoAreWrittenAlike) {
  std::set<std::string> seen;
  for (const Unit& unit : units()) EXPECT_TRUE(seen.emplace(unit.suffix).second) << unit.suffix;
}

TEST(Units, EveryChannelWithAUnitHasItInTheTable) {
  for (const record::Channel& channel : record::channels) {
    if (channel.unit.empty()) continue;
    const Unit* const unit = files::unit_of(channel);
    ASSERT_NE(unit, nullptr) << channel.name;
    EXPECT_EQ(unit->suffix, channel.key_unit());
    EXPECT_DOUBLE_EQ(unit->factor, channel.factor);
    EXPECT_DOUBLE_EQ(unit->offset, channel.offset);
  }
}

TEST(Units, AHeaderIsANameAndAUnit) {
  const auto parts = [](std::string_view header) {
    const HeaderParts p = header_parts(header);
    return std::string(p.name) + "|" + std::string(p.unit);
  };
  EXPECT_EQ(parts("Drehzahl [1/min]"), "Drehzahl|1/min");
  EXPECT_EQ(parts("Reibmoment (Nm)"), "Reibmoment|Nm");
  EXPECT_EQ(parts("Drehzahl in 1/min"), "Drehzahl|1/min");
  EXPECT_EQ(parts("friction_torque_Nm"), "friction_torque|Nm");
  EXPECT_EQ(parts("axial_rigidity_N_um"), "axial_rigidity|N_um");
  EXPECT_EQ(parts("Bemerkung"), "Bemerkung|");
}

TEST(Units, AUnitAtTheEndOfAHeaderIsFoundWhereItsKindIsKnown) {
  EXPECT_EQ(unit_at_end("Torque, N m", Dimension::moment)->suffix, "Nm");
  EXPECT_EQ(unit_at_end("Speed rad/s", Dimension::speed)->suffix, "rad_s");
  EXPECT_EQ(unit_at_end("Temperature F", Dimension::temperature), nullptr);  // the front one
  EXPECT_EQ(unit_at_end("Temperature min", Dimension::temperature), nullptr);
}

TEST(Units, TheNumbersOfAResultAreConvertedByTheEndOfTheirName) {
  EXPECT_DOUBLE_EQ(column_unit("load_Nmm"), N_mm);
  EXPECT_DOUBLE_EQ(column_unit("inner_contact_angle_min_deg"), degree);
  EXPECT_DOUBLE_EQ(column_unit("temperature_C"), 1.0);
  EXPECT_DOUBLE_EQ(column_unit("status"), 1.0);
}

}  // namespace
}  // namespace raceway::text
