// Tables of a spindle in a model file.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "files/model_file.h"
#include "model/parameters.h"
#include "model/rings.h"
#include "tests/files/spindle_text.h"
#include "tests/support/message_of.h"

namespace raceway::files {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using tests::base_spindle;
using tests::shortest_spindle;
using tests::with;
using tests::with_circuit;

ModelFile spindle_file(const std::string& text) { return parse_model(text, "s.toml"); }

model::Spindle spindle_of(const std::string& text) {
  return spindle_file(text).model.spindle.value();
}

std::string spindle_error(const std::string& text) {
  return tests::message_of([&] { (void)spindle_file(text); });
}

TEST(SpindleSection, ShortestFileHasEveryDefaultNamed) {
  const ModelFile file = spindle_file(shortest_spindle);
  const model::Spindle& s = *file.model.spindle;
  EXPECT_TRUE(s.preload_feedback);
  EXPECT_DOUBLE_EQ(s.bearing_width, 20 * mm);  // GMN S 6014 C
  EXPECT_DOUBLE_EQ(s.lubricant_conductance, 1650 * 21 * 11.906e-3 * 11.906e-3);
  EXPECT_TRUE(std::isnan(s.inner_heat_share));
  EXPECT_EQ(s.shaft.segments.size(), 5u);
  EXPECT_EQ(s.shaft.segments[0].material.conductivity, 42);
  EXPECT_DOUBLE_EQ(s.housing.segments.at(0).material.thermal_expansion, 10.5e-6);
  EXPECT_FALSE(s.coolant);
  EXPECT_DOUBLE_EQ(s.model_floor_temperature, 0.5);
  EXPECT_DOUBLE_EQ(s.model_floor_displacement, 1e-6);
  EXPECT_EQ(file.model.free, std::vector<std::string>{"f0"});
  for (const char* one :
       {"bearing.lubricant_conductance_W_K = 4.911735767 (default)",
        "spindle.preload_feedback = true (default)", "shaft.conductivity_W_mK = 42 (default)",
        "housing.flange_conductance_W_K = 4 (default)",
        "seat.collar_conductance_W_m2K = 8000 (default)", "ambient.emissivity = 0.85 (default)",
        "solver.cells = \"medium\" (default)", "rig.model_floor_K = 0.5 (default)",
        "rig.model_floor_um = 1 (default)"})
    EXPECT_THAT(lines(file.defaults), Contains(one));
}

TEST(SpindleSection, BaseFileIsReadIntoSi) {
  const ModelFile file = spindle_file(base_spindle);
  const model::Spindle& s = *file.model.spindle;
  EXPECT_EQ(s.name, "externally driven, 70 mm, two against one");
  EXPECT_EQ(file.model.name, "7014 C like");
  EXPECT_EQ(s.front_positions, (std::vector{60 * mm, 90 * mm}));
  EXPECT_EQ(s.rear_positions, std::vector{290 * mm});
  EXPECT_DOUBLE_EQ(s.inner_ring_shoulder, 82e-3);
  EXPECT_DOUBLE_EQ(s.outer_ring_shoulder, 98e-3);
  EXPECT_EQ(s.inner_heat_share, 0.5);
  ASSERT_EQ(s.shaft.segments.size(), 5u);
  EXPECT_DOUBLE_EQ(s.shaft.segments[2].length, 0.18);
  EXPECT_DOUBLE_EQ(s.shaft.segments[2].diameter, 0.082);
  EXPECT_DOUBLE_EQ(s.shaft.segments[2].bore, 0.036);
  EXPECT_DOUBLE_EQ(s.housing.start, 0.04);
  EXPECT_DOUBLE_EQ(s.housing.flange, 0.12);
  EXPECT_DOUBLE_EQ(s.housing.segments.at(0).diameter, 0.18);
  EXPECT_TRUE(std::isnan(s.housing.segments[0].bore));
  EXPECT_DOUBLE_EQ(s.seat.inner_interference, 6e-6);
  EXPECT_DOUBLE_EQ(s.seat.roughness, 0.8e-6);
  EXPECT_DOUBLE_EQ(s.seat.hardness, 3e9);
  EXPECT_EQ(s.coolant.value().fluid, model::Fluid::water);
  EXPECT_DOUBLE_EQ(s.coolant->flow, 2e-3 / 60);
  EXPECT_DOUBLE_EQ(s.coolant->inlet_temperature, kelvin(20));
  EXPECT_DOUBLE_EQ(s.coolant->pitch, 14e-3);
  EXPECT_EQ(s.coolant->stagnant, 25);
  ASSERT_EQ(s.sensors.size(), 2u);
  EXPECT_EQ(s.sensors[1].name, "shaft_end");
  EXPECT_EQ(s.sensors[1].part, model::ThermometerPlace::Part::shaft);
  EXPECT_DOUBLE_EQ(s.sensors[1].radius, 0.029);
}

TEST(SpindleSection, DistanceOfTheSetsFollowsFromTheirMiddles) {
  EXPECT_DOUBLE_EQ(spindle_file(base_spindle).model.shaft->arrangement.design().distance, 0.215);
}

TEST(SpindleSection, DistanceMayStandBesidePositionsThatGiveIt) {
  const auto text = [](const char* distance) {
    return with(shortest_spindle, "preload_N = 300",
                fmt::format("preload_N = 300\ndistance_mm = {}", distance));
  };
  EXPECT_EQ(spindle_error(text("215")), "(no error)");
  EXPECT_THAT(spindle_error(text("200")),
              HasSubstr("s.toml:12: distance_mm = 200 mm: the distance calculated from"));
}

TEST(SpindleSection, SetsExpandAsShaftAndHousingDo) {
  const auto design = spindle_file(with(base_spindle, "start_mm = 40.0",
                                        "thermal_expansion_1e6_K = 12.5\nstart_mm = 40.0"))
                          .model.shaft->arrangement.design();
  EXPECT_DOUBLE_EQ(design.shaft_expansion, 11.5e-6);
  EXPECT_DOUBLE_EQ(design.housing_expansion, 12.5e-6);
}

TEST(SpindleSection, InlineSegmentsAndTablesOfThemAreTheSame) {
  const auto a = spindle_of(shortest_spindle).shaft.segments,
             b = spindle_of(base_spindle).shaft.segments;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].length, b[k].length);
    EXPECT_EQ(a[k].diameter, b[k].diameter);
    EXPECT_EQ(a[k].bore, b[k].bore);
  }
}

TEST(SpindleSection, SegmentMayHaveItsOwnBoreAndMaterial) {
  const model::Spindle s = spindle_of(
      with(shortest_spindle, "{length_mm = 75, diameter_mm = 60}",
           "{length_mm = 75, diameter_mm = 60, bore_mm = 20, material = \"carbon\"}") +
      "[material.carbon]\nelastic_modulus_GPa = 180\npoisson_ratio = 0.3\ndensity_kg_m3 = 1600\n"
      "thermal_expansion_1e6_K = 0.5\nconductivity_W_mK = 8\nheat_capacity_J_kgK = 800\n");
  EXPECT_DOUBLE_EQ(s.shaft.segments[4].bore, 0.02);
  EXPECT_EQ(s.shaft.segments[4].material.conductivity, 8);
  EXPECT_DOUBLE_EQ(s.shaft.segments[3].bore, 0.036);
  EXPECT_EQ(s.shaft.segments[3].material.conductivity, 42);
}

TEST(SpindleSection, MaterialWithoutHeatIsRefusedForASegment) {
  EXPECT_THAT(
      spindle_error(with(shortest_spindle, "{length_mm = 75, diameter_mm = 60}",
                         "{length_mm = 75, diameter_mm = 60, material = \"carbon\"}") +
                    "[material.carbon]\nelastic_modulus_GPa = 180\npoisson_ratio = 0.3\n"
                    "density_kg_m3 = 1600\nthermal_expansion_1e6_K = 0.5\n"),
      HasSubstr("[material.carbon] conductivity_W_mK is missing, which [shaft.segment] needs"));
}

TEST(SpindleSection, HousingMayBeStepped) {
  const model::Spindle s =
      spindle_of(with(shortest_spindle, "length_mm = 275\nouter_diameter_mm = 180",
                      "segment = [{length_mm = 200, outer_diameter_mm = 180}, {length_mm = 75, "
                      "outer_diameter_mm = 150, bore_mm = 110}]"));
  ASSERT_EQ(s.housing.segments.size(), 2u);
  EXPECT_DOUBLE_EQ(s.housing.segments[1].bore, 0.11);
}

TEST(SpindleSection, DisksAndSupportsStandOnTheShaft) {
  const model::Spindle s = spindle_of(
      shortest_spindle +
      "[[shaft.disk]]\nposition_mm = 350\nmass_kg = 3\ndiametral_inertia_kgm2 = 0.004\n"
      "polar_inertia_kgm2 = 0.007\n[[shaft.support]]\nposition_mm = 360\nradial_N_um = 200\n"
      "tilt_Nm_rad = 5000\n");
  EXPECT_EQ(s.shaft.disks.at(0).mass, 3);
  EXPECT_DOUBLE_EQ(s.shaft.supports.at(0).radial_stiffness, 200e6);
  EXPECT_EQ(s.shaft.supports[0].tilt_stiffness, 5000);
}

/// A roller bearing on the rear end of the base spindle, whose housing is longer for it.
std::string with_rollers(const std::string& more = "", const std::string& name = "belt_end") {
  const std::string housing =
      with(base_spindle, "length_mm = 275.0\nouter_diameter_mm = 180.0\n",
           "segment = [{length_mm = 265, outer_diameter_mm = 180},\n"
           "           {length_mm = 40, outer_diameter_mm = 180, bore_mm = 95}]\n");
  return housing + "[[shaft.roller_bearing]]\nname = \"" + name +
         "\"\nposition_mm = 330\nbore_mm = 60\nouter_diameter_mm = 95\nwidth_mm = 18\n"
         "roller_count = 20\nroller_diameter_mm = 8\nroller_length_mm = 8\n"
         "pitch_diameter_mm = 77.5\n" +
         more;
}

TEST(SpindleSection, ARollerBearingStandsOnTheShaft) {
  const ModelFile file = spindle_file(with_rollers("radial_clearance_um = -3\n"));
  const model::RollerOnShaft& r = file.model.spindle->rollers.at(0);
  EXPECT_EQ(r.name, "belt_end");
  EXPECT_DOUBLE_EQ(r.position, 330 * mm);
  EXPECT_DOUBLE_EQ(r.bearing.geometry().radial_clearance, -3 * um);
  EXPECT_EQ(r.f0, 1.5);
  EXPECT_EQ(r.f1, 0.0003);
  EXPECT_TRUE(std::isnan(r.inner_interference));
  const auto rings = model::rings_of(*file.model.spindle, file.model.shaft->arrangement);
  ASSERT_EQ(rings.size(), 4u);
  EXPECT_DOUBLE_EQ(rings[3].inner_interference, 6 * um);  // of [seat]
  EXPECT_DOUBLE_EQ(rings[3].inner_shoulder, 69.5 * mm);
  EXPECT_THAT(lines(file.defaults), Contains("shaft.roller_bearing.f1 = 0.0003 (default)"));
  const model::RollerOnShaft own =
      spindle_of(with_rollers("f0 = 2\nf1 = 0.0002\nf1_load = \"F_r\"\ntaper = 12\n"
                              "drive_up_mm = 0.12\nouter_clearance_um = 8\n"
                              "lubricant_conductance_W_K = 0.5\n"))
          .rollers.at(0);
  EXPECT_EQ(own.f0, 2.0);
  EXPECT_EQ(own.counted, friction::F1Load::F_r);
  EXPECT_DOUBLE_EQ(own.inner_interference, 10 * um);
  EXPECT_DOUBLE_EQ(own.outer_clearance, 8 * um);
  EXPECT_EQ(own.lubricant_conductance, 0.5);
}

TEST(SpindleSection, ARollerBearingThatCannotStandThereIsRefused) {
  const auto why = [](const std::string& text) { return spindle_error(text); };
  EXPECT_THAT(why(with(with_rollers(), "position_mm = 330", "position_mm = 295")),
              HasSubstr("the bearing overlaps the bearing at 290 mm"));
  EXPECT_THAT(why(with(with_rollers(), "position_mm = 330", "position_mm = 372")),
              HasSubstr("does not lie entirely on the shaft"));
  EXPECT_THAT(why(with(with_rollers(), "bore_mm = 95", "bore_mm = 100")),
              HasSubstr("the housing has bore_mm = 100 mm"));
  EXPECT_THAT(why(with_rollers("drive_up_mm = 0.1\n")),
              HasSubstr("mm: only possible with a tapered bore, such as taper = 12 for 1:12"));
  EXPECT_THAT(why(with_rollers("taper = 12\ndrive_up_mm = 0.1\ninner_interference_um = 5\n")),
              HasSubstr("both give the fit of the inner ring; remove one"));
  EXPECT_THAT(why(with_rollers("inner_interference_um = 310\n")), HasSubstr("the ring yields"));
  EXPECT_THAT(why(with_rollers("z = 0.0007\n")),
              HasSubstr("unknown key in [shaft.roller_bearing]"));
  EXPECT_THAT(why(with_rollers("", "front_9")), HasSubstr("must not begin with front_ or rear_"));
  EXPECT_THAT(why(with(with_rollers(), "width_mm = 18\n", "")), HasSubstr("width_mm is missing"));
  EXPECT_THAT(why(with(with_rollers(), "roller_count = 20", "roller_count = 40")),
              HasSubstr("roller_count"));
}

TEST(SpindleSection, ABeltPullsWhereItSays) {
  const model::Spindle s = spindle_of(
      base_spindle + "[drive]\nbelt_force_N = 1500\nbelt_angle_deg = 90\nposition_mm = 350\n");
  ASSERT_TRUE(s.belt);
  EXPECT_EQ(s.belt->force, 1500.0);
  EXPECT_DOUBLE_EQ(s.belt->angle, pi / 2.0);
  EXPECT_DOUBLE_EQ(s.belt->position, 350 * mm);
  EXPECT_EQ(s.drive.value().watts, 0.0);
  EXPECT_FALSE(spindle_of(base_spindle + "[drive]\nheat_W = 20\n").belt);
  EXPECT_THAT(spindle_error(base_spindle + "[drive]\nbelt_force_N = 1500\n"),
              HasSubstr("position_mm is missing"));
  EXPECT_THAT(spindle_error(base_spindle + "[drive]\nheat_W = 20\nbelt_angle_deg = 30\n"),
              HasSubstr("belt_angle_deg: belt_force_N is missing; set belt_force_N = 0 if speed "
                        "programmes give the force"));
  EXPECT_THAT(spindle_error(base_spindle + "[drive]\nposition_mm = 350\n"),
              HasSubstr("heat_W is missing"));
}

TEST(SpindleSection, HeatOfADriveIsAFormulaOfTheSpeed) {
  const model::Spindle s = spindle_of(base_spindle + "[drive]\nheat_W = \"0.015*speed_rpm\"\n");
  const std::vector<double> speed{10000.0};
  EXPECT_DOUBLE_EQ((*s.drive.value().formula)(speed), 150.0);
  EXPECT_TRUE(std::isnan(s.drive->position));
}

TEST(SpindleSection, SourcesOfHeatHaveANameAPlaceAndANumberOrAFormula) {
  const model::Spindle s =
      spindle_of(base_spindle +
                 "[[heat]]\nname = \"belt\"\nat = \"rear_1\"\nheat_W = 80\nshaft_share = 0.7\n"
                 "[[heat]]\nname = \"rotor\"\nat = \"shaft\"\nposition_mm = 190\nlength_mm = 60\n"
                 "heat_W = \"0.1*motor_power_W + 0.01*belt_force_N\"\nheat_factor = 1.5\n"
                 "[[heat]]\nname = \"node\"\nat = \"housing\"\nposition_mm = 120\nlength_mm = 20\n"
                 "radius_mm = 80\nheat_W = 30\n");
  using Place = model::HeatSource::Place;
  ASSERT_EQ(s.heat.size(), 3u);
  EXPECT_EQ(s.heat[0].place, Place::bearing);
  EXPECT_EQ(s.heat[0].bearing, 2u);
  EXPECT_EQ(s.heat[0].watts, 80.0);
  EXPECT_EQ(s.heat[0].rotor_share, 0.7);
  EXPECT_EQ(s.heat[1].place, Place::shaft);
  EXPECT_EQ(s.heat[1].factor, 1.5);
  const std::vector<double> force_and_power{1000.0, 2000.0};
  EXPECT_DOUBLE_EQ((*s.heat[1].formula)(force_and_power), 210.0);
  EXPECT_DOUBLE_EQ(s.heat[2].radius, 80 * mm);
}

TEST(SpindleSection, SourcesOfHeatThatCannotBeAreRefused) {
  const auto refused = [](const std::string& lines) {
    return spindle_error(base_spindle + "[[heat]]\nname = \"a\"\n" + lines);
  };
  EXPECT_THAT(refused("heat_W = 1\nat = \"rear_2\"\n"),
              HasSubstr("at = \"rear_2\": must be shaft, housing, motor, pulley, seal, front_1, "
                        "front_2 or rear_1"));
  EXPECT_THAT(refused("heat_W = 1\nat = \"shaft\"\n"), HasSubstr("position_mm is missing"));
  EXPECT_THAT(refused("heat_W = 1\nat = \"seal\"\nlength_mm = 5\n"),
              HasSubstr("position_mm is missing"));
  EXPECT_THAT(refused("heat_W = 1\nat = \"shaft\"\nposition_mm = 370\nlength_mm = 20\n"),
              HasSubstr("does not lie entirely on the shaft"));
  EXPECT_THAT(refused("heat_W = 1\nat = \"housing\"\nposition_mm = 120\nlength_mm = 20\n"
                      "radius_mm = 20\n"),
              HasSubstr("the radius must be inside the housing, from"));
  EXPECT_THAT(refused("heat_W = 1\nat = \"front_1\"\nposition_mm = 60\n"),
              HasSubstr("already gives the position"));
  EXPECT_THAT(refused("heat_W = 1\nat = \"seal\"\nshaft_share = 0.5\n"),
              HasSubstr("heats only one part; only a motor or a bearing has a share"));
  EXPECT_THAT(refused("heat_W = 1\nheat_factor = 2\nat = \"seal\"\n"),
              HasSubstr("heat_W is a number"));
  EXPECT_THAT(refused("heat_W = 1\nat = \"seal\"\n[[heat]]\nname = \"a\"\nheat_W = 1\n"
                      "at = \"pulley\"\n"),
              HasSubstr("another source of heat has this name"));
}

TEST(SpindleSection, MisspeltVariableOfHeatIsNamed) {
  const std::string message =
      spindle_error(base_spindle + "[drive]\nheat_W = \"0.015*sped_rpm\"\n");
  EXPECT_THAT(message, HasSubstr("did you mean speed_rpm?"));
  EXPECT_THAT(message, HasSubstr("[drive] heat_W"));
}

TEST(SpindleSection, MaterialMachineAndMotorAreReadWithTheirUnits) {
  const model::Spindle s = spindle_of(
      with(base_spindle, "emissivity = 0.85",
           "temperature_C = 22\nmachine_temperature_C = 25\nrotating_convection = \"kendoush\"") +
      "[motor]\nheat_W = 120\nposition_mm = 190\nlength_mm = 120\nrotor_share = 0.3\n");
  EXPECT_DOUBLE_EQ(s.ambient.temperature, kelvin(22));
  EXPECT_DOUBLE_EQ(s.ambient.machine_temperature, kelvin(25));
  EXPECT_EQ(s.ambient.rotating_convection, model::RotatingConvection::kendoush);
  EXPECT_EQ(s.motor.value().watts, 120.0);
  EXPECT_EQ(s.motor->rotor_share, 0.3);
}

/// A file that is wrong in one place, and what is said of it.
struct WrongSpindle {
  const char *from, *to, *message;
};

TEST(SpindleSection, WhatCannotBeIsRefusedWithItsPlace) {
  const std::vector<WrongSpindle> cases{
      {"length_mm = 50.0\ndiameter_mm = 104.0", "length_mm = 0.0\ndiameter_mm = 104.0",
       "length_mm = 0 mm: must be from"},
      {"diameter_mm = 60.0", "diameter_mm = 30.0", "must be below the diameter"},
      {"front_position_mm = [60.0, 90.0]", "front_position_mm = [60.0]",
       "must be a list of length 2"},
      {"front_position_mm = [60.0, 90.0]", "front_position_mm = [60.0, 70.0]", "one width apart"},
      {"front_position_mm = [60.0, 90.0]\n", "", "front_position_mm is missing"},
      {"rear_position_mm = [290.0]", "rear_position_mm = [368.0]",
       "does not lie entirely on the shaft"},
      {"rear_position_mm = [290.0]", "rear_position_mm = [200.0]",
       "the shaft has diameter_mm = 82 mm"},
      {"rear_position_mm = [290.0]", "rear_position_mm = [20.0]", "must be further from the nose"},
      {"length_mm = 275.0", "length_mm = 255.0", "does not lie entirely in the housing"},
      {"outer_diameter_mm = 180.0", "outer_diameter_mm = 105.0", ", so the housing has no wall"},
      {"flange_mm = 120.0", "flange_mm = 310.0",
       ", the flange does not lie entirely on the housing:"},
      {"flange_mm = 120.0\n", "", "[housing] flange_mm is missing"},
      {"diameter_mm = 140.0", "diameter_mm = 112.0", "outside the wall of the housing"},
      {"end_mm = 300.0", "end_mm = 330.0", "the housing reaches from 40 mm to 315 mm"},
      {"pitch_mm = 14.0", "pitch_mm = 8.0", "must be at least channel_width_mm"},
      {"radius_mm = 57.0", "radius_mm = 50.0",
       "at this position, the radius must be inside the housing, from 55 mm to 90 mm"},
      {"position_mm = 365.0", "position_mm = 380.0", "the shaft reaches from 0 to 375 mm"},
      {"part = \"shaft\"", "part = \"rotor\"", "must be shaft, ring, housing or coolant"},
      {"name = \"shaft_end\"", "name = \"shaft end\"", "must be letters, digits and _"},
      {"name = \"shaft_end\"", "name = \"front_bearing\"", "another sensor has this name"},
      {"name = \"shaft_end\"", "name = \"ambient\"", "raceway already has a column"},
      {"inner_ring_shoulder_mm = 82.0", "inner_ring_shoulder_mm = 92.0",
       "must be between 70 and 90"},
      {"inner_heat_share = 0.5", "inner_heat_share = 1.5", "must be from 0 to 1"},
      {"emissivity = 0.85", "emisivity = 0.85", "did you mean emissivity?"},
      {"fluid = \"water\"", "fluid = \"air\"", "must be water or oil"},
      {"[housing]\nstart_mm", "[housing]\nstart", "start"}};
  for (const WrongSpindle& one : cases) {
    SCOPED_TRACE(one.to);
    const std::string message = spindle_error(with(base_spindle, one.from, one.to));
    EXPECT_THAT(message, HasSubstr(one.message));
    EXPECT_THAT(message, HasSubstr("s.toml:"));
  }
}

TEST(SpindleSection, FurtherCircuitsAreReadWithTheirUnits) {
  const model::Spindle s = spindle_of(with_circuit());
  ASSERT_EQ(s.circuits.size(), 1u);
  EXPECT_EQ(s.circuits[0].name, "jacket");
  const model::Coolant& c = s.circuits[0].channel;
  EXPECT_EQ(c.fluid, model::Fluid::water);
  EXPECT_DOUBLE_EQ(c.flow, 4e-3 / 60);
  EXPECT_DOUBLE_EQ(c.inlet_temperature, kelvin(25));
  EXPECT_DOUBLE_EQ(c.channel_depth, 5e-3);
  EXPECT_DOUBLE_EQ(c.start, 190e-3);
  EXPECT_TRUE(std::isnan(spindle_of(with_circuit("inlet_temperature_C = 25\n", ""))
                             .circuits[0]
                             .channel.inlet_temperature));
}

TEST(SpindleSection, ACircuitThatCannotBeIsRefusedWithItsPlace) {
  const std::vector<WrongSpindle> cases{
      {"name = \"jacket\"\n", "", "[coolant.circuit] name is missing"},
      {"\"jacket\"", "\"air\"",
       "the result already has a column heat_to_air_W; choose another name"},
      {"\"jacket\"", "\"my jacket\"", "must be letters, digits and _"},
      {"inlet_temperature_C = 25", "inlet_temperature_C = 120", "must be from 0 to 100 C"},
      {"pitch_mm = 12", "pitch_mm = 5", "must be at least channel_width_mm"},
      {"end_mm = 300", "end_mm = 320", "the housing reaches from 40 mm to 315 mm"},
      {"diameter_mm = 140", "diameter_mm = 178", "outside the wall of the housing"},
      {"flow_l_min = 4", "flow = 4", "did you mean flow_l_min?"},
      {"start_mm = 190", "start_mm = 170",
       "start_mm = 170 mm, end_mm = 300 mm: circuit [coolant] reaches from 60 mm to 180 mm"}};
  for (const WrongSpindle& one : cases) {
    SCOPED_TRACE(one.to);
    const std::string message = spindle_error(with_circuit(one.from, one.to));
    EXPECT_THAT(message, HasSubstr(one.message));
    EXPECT_THAT(message, HasSubstr("s.toml:"));
  }
}

TEST(SpindleSection, ScrewsOfTheFlangeAreReadWithTheirUnits) {
  const std::string joint =
      "flange_screws = 8\nflange_screw_force_N = 12000\nflange_contact_mm2 = 15000\n";
  const auto with_joint = [&](const std::string& text) {
    return with(base_spindle, "flange_mm = 120.0\n", "flange_mm = 120.0\n" + text);
  };
  const auto read = spindle_of(with_joint(joint)).housing.flange_joint;
  ASSERT_TRUE(read);
  EXPECT_DOUBLE_EQ(read->pressure(), 6.4 * MPa);
  EXPECT_FALSE(spindle_of(base_spindle).housing.flange_joint);
  EXPECT_THAT(spindle_error(with_joint(with(joint, "flange_contact_mm2 = 15000\n", ""))),
              HasSubstr("flange_contact_mm2 is missing"));
  EXPECT_THAT(spindle_error(with_joint(with(joint, "flange_screws = 8\n", ""))),
              HasSubstr("flange_screws is missing"));
  EXPECT_THAT(spindle_error(with_joint(with(joint, "= 8", "= 8.5"))),
              HasSubstr("must be a whole number"));
  EXPECT_THAT(
      spindle_error(with_joint(with(joint, "15000", "1000"))),
      HasSubstr(
          "this force on each of 8 screws causes a contact pressure of 96 MPa. With hardness_GPa = "
          "3, the formula for the contact conductance is valid only up to 60 MPa"));
}

TEST(SpindleSection, ClampingForcesAreReadAndMustPressAFace) {
  const auto with_force = [](const std::string& text, const std::string& of = base_spindle) {
    return with(of, "outer_clearance_um = 4.0\n", "outer_clearance_um = 4.0\n" + text);
  };
  const model::Seat seat = spindle_of(with_force("inner_clamping_force_N = 8000\n")).seat;
  EXPECT_EQ(seat.inner_clamping_force, 8000.0);
  EXPECT_TRUE(std::isnan(seat.outer_clamping_force));
  EXPECT_TRUE(std::isnan(spindle_of(base_spindle).seat.inner_clamping_force));
  // From 70 to 82 mm, 90 kN press with 62.8 MPa.
  const std::string much = spindle_error(with_force("inner_clamping_force_N = 90000\n"));
  EXPECT_THAT(
      much,
      HasSubstr(
          "inner_clamping_force_N = 90000 N: this force on the smallest ring face (1433 mm2, at "
          "the bearing at 60 mm) causes a contact pressure of 62.82 MPa. With hardness_GPa = 3, "
          "the formula for the contact conductance is valid only up to 60 MPa"));
  EXPECT_THAT(much, HasSubstr("s.toml:"));
  // The housing is bored to the bearings, whose outer rings stand apart.
  EXPECT_THAT(spindle_error(with_force("outer_clamping_force_N = 5000\n")),
              HasSubstr("the clamping force acts on no face, because neither a shoulder nor "
                        "another ring touches the outer rings"));
  const std::string stepped =
      with(base_spindle, "length_mm = 275.0\nouter_diameter_mm = 180.0\n",
           "segment = [{length_mm = 10, outer_diameter_mm = 180, bore_mm = 105},\n"
           "           {length_mm = 265, outer_diameter_mm = 180}]\n");
  EXPECT_EQ(
      spindle_of(with_force("outer_clamping_force_N = 5000\n", stepped)).seat.outer_clamping_force,
      5000.0);
  EXPECT_THAT(spindle_error(with_force("inner_clamping_force_N = 0\n")),
              HasSubstr("must be from 1 to 10000000 N"));
}

TEST(SpindleSection, ShaftAloneIsNoSpindle) {
  const std::string text = shortest_spindle.substr(0, shortest_spindle.find("[housing]"));
  EXPECT_THAT(spindle_error(text),
              HasSubstr("a spindle needs both [shaft] and [housing]; add [housing]"));
}

TEST(SpindleSection, ATandemIsRefusedByTheNameInTheFile) {
  for (const std::string layout : {"\"DT\"", "\"tandem\""}) {
    const std::string text =
        "[bearing]\ncatalogue = \"S 6014 C\"\n[lubricant]\nviscosity_40C_mm2_s = 22\n"
        "viscosity_100C_mm2_s = 4.8\n[friction]\nlaw = \"palmgren\"\nf0 = 1.5\n[arrangement]\n"
        "layout = " +
        layout +
        "\nfront = 2\nrear = 0\nmounting = \"spring\"\npreload_N = 600\n"
        "front_position_mm = [60, 80]\n" +
        shortest_spindle.substr(shortest_spindle.find("[shaft]"));
    EXPECT_THAT(spindle_error(text), HasSubstr("layout = " + layout + ": not possible, because "));
  }
}

TEST(SpindleSection, TableOfASpindleWithoutOneIsRefused) {
  const std::string text = shortest_spindle.substr(0, shortest_spindle.find("[shaft]")) +
                           "[ambient]\nemissivity = 0.5\n";
  EXPECT_THAT(spindle_error(text), HasSubstr("s.toml:14: [ambient]: only possible for a spindle"));
}

TEST(SpindleSection, NumbersOfEachCircuitAreFreeByName) {
  const auto with_free = [](const std::string& name, const std::string& circuit) {
    return circuit + "[calibration]\nfree = [\"" + name + "\"]\n";
  };
  for (const char* name :
       {"inlet_temperature_C", "flow_l_min", "jacket.inlet_temperature_C", "jacket.flow_l_min"})
    EXPECT_EQ(spindle_file(with_free(name, with_circuit())).model.free,
              std::vector<std::string>{name});
  const std::string following = with_circuit("inlet_temperature_C = 25\n", "");
  EXPECT_THAT(spindle_error(with_free("jacket.inlet_temperature_C", following)),
              HasSubstr("this circuit uses the inlet temperature of [coolant]; give a start value "
                        "under its [[coolant.circuit]]"));
  EXPECT_THAT(spindle_error(with_free("jacket.flow_l_mn", following)),
              HasSubstr("did you mean jacket.flow_l_min?"));
}

TEST(SpindleSection, FittedNumbersOfACircuitAreWrittenIntoItsTable) {
  const ModelFile file = spindle_file(with_circuit());
  model::Model fitted = file.model;
  model::Coolant& jacket = fitted.spindle->circuits[0].channel;
  jacket.inlet_temperature = kelvin(27.5);
  jacket.flow = 3.25e-3 / 60;
  fitted.spindle->coolant->flow = 1.5e-3 / 60;
  const std::string text = with_model(file, fitted);
  const model::Spindle read = spindle_of(text);
  EXPECT_NEAR(read.circuits[0].channel.inlet_temperature, kelvin(27.5), 1e-11);
  EXPECT_NEAR(read.circuits[0].channel.flow, 3.25e-3 / 60, 1e-18);
  EXPECT_NEAR(read.coolant->flow, 1.5e-3 / 60, 1e-18);
  EXPECT_EQ(read.coolant->inlet_temperature, kelvin(20));
  EXPECT_THAT(text, HasSubstr("[[coolant.circuit]]\nname = \"jacket\"\nflow_l_min = 3.25\n"
                              "inlet_temperature_C = 27.5\n"));
}

TEST(SpindleSection, BearingsAreFreeToFitInTheUnitOfTheFile) {
  ModelFile file =
      spindle_file(base_spindle +
                   "[calibration]\nfree = [\"f0\", \"z\", \"preload_N\", \"convection_factor\", "
                   "\"lubricant_conductance_W_K\", \"flange_conductance_W_K\"]\n");
  EXPECT_EQ(file.model.free.size(), 6u);
  model::Model changed = file.model;
  for (const record::Parameter& p : model::parameters(changed)) {
    if (p.name == "convection_factor") model::set(changed, p, 1.25);
    if (p.name == "lubricant_conductance_W_K") model::set(changed, p, 2.5);
    if (p.name == "flange_conductance_W_K") model::set(changed, p, 5.5);
  }
  EXPECT_EQ(changed.spindle->ambient.convection_factor, 1.25);
  const model::Spindle back = spindle_of(with_model(file, changed));
  EXPECT_EQ(back.ambient.convection_factor, 1.25);
  EXPECT_EQ(back.lubricant_conductance, 2.5);
  EXPECT_EQ(back.housing.flange_conductance, 5.5);
}

TEST(SpindleSection, OuterSeatIsFreeOnlyWhereItHasAValue) {
  const std::string free = "[calibration]\nfree = [\"outer_conductance_W_m2K\"]\n";
  EXPECT_THAT(spindle_error(base_spindle + free),
              HasSubstr("the model has no such value, because it calculates this conductance from "
                        "the fit of the rings in the housing; give a start value under [seat]"));
  const ModelFile file = spindle_file(
      with(base_spindle, "slope = 0.15", "slope = 0.15\nouter_conductance_W_m2K = 3000") + free);
  EXPECT_EQ(file.model.spindle->seat.outer_conductance, 3000);
}

const std::string network_text =
    shortest_spindle.substr(0, shortest_spindle.find("[shaft]")) +
    "[[network.node]]\nname = \"rotor\"\ncapacity_J_K = 900\nheat_W = 40\n"
    "[[network.node]]\nname = \"body\"\ncapacity_J_K = 20000\n"
    "[[network.link]]\nfrom = \"rotor\"\nto = \"body\"\nconductance_W_K = 5\n"
    "[[network.link]]\nfrom = \"body\"\nto = \"ambient\"\nconductance_W_K = 2\n";

TEST(SpindleSection, NetworkStandsInPlaceOfAGeometry) {
  const model::Spindle s = spindle_of(network_text);
  const model::Network& n = s.network.value();
  ASSERT_EQ(n.nodes.size(), 3u);
  EXPECT_EQ(n.nodes[0].heat, 40);
  EXPECT_EQ(n.nodes[2].name, "ambient");
  EXPECT_DOUBLE_EQ(n.nodes[2].temperature, kelvin(20));
  EXPECT_EQ(n.links.at(1).from, 1u);
  EXPECT_EQ(n.links[1].to, 2u);
  EXPECT_EQ(s.sensors.size(), 3u);
}

TEST(SpindleSection, NetworkWithoutAWayOutIsRefused) {
  EXPECT_THAT(
      spindle_error(with(network_text, "to = \"ambient\"", "to = \"rotor\"")),
      HasSubstr(": no chain of links leads from this node to a body at constant "
                "temperature (temperature_C, ambient, machine), so the heat cannot leave it"));
}

TEST(SpindleSection, UnknownNodeIsNamedWithTheNearest) {
  EXPECT_THAT(spindle_error(with(network_text, "to = \"body\"", "to = \"bodi\"")),
              HasSubstr("to = \"bodi\": no such node; did you mean body?"));
}

TEST(SpindleSection, NodeThatNoLinkNamesIsRefused) {
  EXPECT_THAT(spindle_error(network_text + "[[network.node]]\nname = \"lost\"\ncapacity_J_K = 1\n"),
              HasSubstr("node lost: no [[network.link]] names this node"));
}

TEST(SpindleSection, NetworkBesideAShaftIsRefused) {
  EXPECT_THAT(spindle_error(shortest_spindle + "[network]\n"),
              HasSubstr("not possible together with [network], which replaces the geometry; remove "
                        "one of the two"));
}

}  // namespace
}  // namespace raceway::files
