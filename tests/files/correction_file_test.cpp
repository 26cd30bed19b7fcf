#include "files/correction_file.h"

#include <gmock/gmock.h>

#include "correction/numbers.h"
#include "files/column_map.h"
#include "files/series_file.h"
#include "record/series_channel.h"
#include "text/error.h"

namespace raceway::files {
namespace {

using testing::Contains;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsNan;
using testing::ThrowsMessage;

const std::string head = "[correction]\ndisplacement = \"displacement_z_um\"\n";
const std::string channel_text =
    "[[correction.channel]]\nname = \"spindle\"\ninput = \"front_temperature_C\"\n"
    "sections = [{ gain_um_K = 5.0, time_constant_s = 5400 }]\n";

auto reading(const std::string& text) {
  return [text] { (void)parse_correction(text, "z.toml"); };
}
auto refused(const std::string& message) {
  return ThrowsMessage<text::InputError>(HasSubstr(message));
}

TEST(CorrectionFile, IsReadIntoSI) {
  const CorrectionFile file = parse_correction(
      head + "tolerance_um = 2\noffset_um = -3\n" + channel_text +
          "[[correction.channel]]\ninput = \"x_feed_m_min\"\n"
          "sections = [{ gain_um_m_min = 0.5, time_constant_s = 3000 }]\nscale = 1.1\n"
          "[correction.kinematic]\nA = 1.28e-3\nB = 0.697\nC = 5.3e-4\n",
      "z.toml");
  ASSERT_EQ(file.models.size(), 1U);
  const correction::Model& m = file.models[0];
  EXPECT_EQ(m.displacement->name, "displacement_z_um");
  EXPECT_NEAR(m.tolerance, 2e-6, 1e-18);
  EXPECT_NEAR(m.offset, -3e-6, 1e-18);
  EXPECT_NEAR(m.channels[0].sections[0].gain, 5e-6, 1e-18);
  EXPECT_EQ(m.channels[1].name, "x_feed");
  EXPECT_NEAR(m.channels[1].sections[0].gain, 0.5e-6 * 60, 1e-15);  // m per m/s
  EXPECT_EQ(m.channels[1].scale, 1.1);
  EXPECT_EQ(m.kinematic->B, 0.697);
}

TEST(CorrectionFile, ADelayElementGoesByAnyColumnButATemperature) {
  const auto channel = [](const std::string& input, const std::string& gain,
                          const std::string& time) {
    return head + "[[correction.channel]]\ninput = \"" + input + "\"\ngain = { " + gain +
           " }\ntime_constant = { " + time + " }\n";
  };
  const auto read = [](const std::string& text, const std::string& table = "") {
    return *parse_correction(text, "z.toml", {{.name = "k.csv", .path = "/k.csv", .text = table}})
                .models[0]
                .channels[0]
                .element;
  };
  const correction::DelayElement line = read(channel(
      "axial_load_N", "slope_um_N = 0.01, offset_um = 1", "slope_min_N = -0.02, offset_min = 30"));
  EXPECT_TRUE(line.both_signs);
  EXPECT_NEAR(line.gain(-200) / um, -1.0, 1e-12);
  EXPECT_NEAR(line.time_constant(-200), 34 * 60, 1e-9);
  EXPECT_NEAR(line.domain().upper, 1500, 1e-9);
  // A table in kilonewtons, and one of a feed, which acts by its amount.
  const std::string in_table = "table = \"k.csv\"";
  const correction::DelayElement table =
      read(channel("axial_load_N", in_table, in_table),
           "axial_load_kN,gain_um,time_constant_min\n-0.5,-3,20\n0.5,4,10\n");
  EXPECT_NEAR(table.gain(500) / um, 4.0, 1e-12);
  EXPECT_NEAR(table.time_constant(0), 15 * 60, 1e-9);
  const correction::DelayElement feed =
      read(channel("x_feed_m_min", in_table, in_table),
           "x_feed_m_min,gain_um,time_constant_min\n0,0,20\n10,4,10\n");
  EXPECT_FALSE(feed.both_signs);
  EXPECT_NEAR(feed.gain(5) / um, 2.0, 1e-12);  // of m/min
  EXPECT_THAT(reading(channel("axial_load_N", "slope_um_W = 0.01, offset_um = 1",
                              "slope_min_N = -0.02, offset_min = 30")),
              refused("slope_um_W"));
  EXPECT_THAT(
      reading(channel("front_temperature_C", "slope_um_K = 0.01, offset_um = 1",
                      "slope_min_K = -0.02, offset_min = 30")),
      refused("gain and time_constant are not possible for a temperature: use sections; gain and "
              "time_constant need input = \"power_W\" or a column such as a load"));
}

TEST(CorrectionFile, AnInputMayActInAWindow) {
  const std::string effect = head + channel_text +
                             "[[correction.effect]]\nid = \"input\"\ngain_um_K = 2\n"
                             "time_constant_s = 900\n";
  const CorrectionFile file = parse_correction(
      effect + "window = { column = \"x_position_mm\", points = [100, 400] }\n", "z.toml");
  EXPECT_EQ(correction::full_id(file.models[0].effects[0]), "input:x_position_mm:100..400");
  EXPECT_THAT(reading(effect), refused("input"));
  EXPECT_THAT(reading(head + channel_text +
                      "[[correction.effect]]\nid = \"second-time-constant\"\ngain_um_K = 2\n"
                      "time_constant_s = 900\nwindow = { column = \"x_position_mm\", "
                      "points = [100, 400] }\n"),
              refused(", only with id = \"input\""));
}

TEST(CorrectionFile, AFrictionTableIsReadAtARadialLoad) {
  const std::string table =
      "speed_rpm,axial_load_N,radial_load_N,friction_torque_Nmm\n0,100,0,10\n1000,100,0,20\n"
      "0,100,500,30\n1000,100,500,60\n0,100,2000,60\n1000,100,2000,120\n";
  const auto torque = [&](const std::string& text, const std::string& key) {
    const CorrectionFile file = parse_correction(
        head + "[[correction.channel]]\ninput = \"power_W\"\nfriction_table = \"t.csv\"\n" + key +
            "sections = [{ gain_um_W = 1, time_constant_s = 900 }]\n",
        "z.toml", {{.name = "t.csv", .path = "/t.csv", .text = text}});
    const correction::Input& in = file.models[0].channels[0].input;
    return (*in.table)({1000 * rpm, 100, in.radial_load.value, in.temperature.value}) / N_mm;
  };
  EXPECT_NEAR(torque(table, "radial_load_N = 500\n"), 60, 1e-9);
  EXPECT_NEAR(torque(table, "radial_load_N = 1250\n"), 90, 1e-9);
  EXPECT_NEAR(torque(table, "radial_load_N = 0\n"), 20, 1e-9);
  EXPECT_THAT([&] { (void)torque(table, ""); },
              refused("radial_load_N is missing, at which the friction table is read: give a "
                      "number or a column"));
  EXPECT_THAT([&] { (void)torque(table, "radial_load_N = 2001\n"); },
              refused("radial_load_N = 2001 N is outside the range of the friction table t.csv "
                      "(radial loads: 0, 500 and 2000 N)"));
  const std::string without = "speed_rpm,friction_torque_Nmm\n0,10\n1000,20\n";
  EXPECT_NEAR(torque(without, ""), 20, 1e-9);
  EXPECT_THAT([&] { (void)torque(without, "radial_load_N = 5\n"); }, refused("N is outside"));
}

TEST(CorrectionFile, AFrictionTableIsReadAtRecordedLoads) {
  const auto input = [](const std::string& keys) {
    return parse_correction(
               head + "[[correction.channel]]\ninput = \"power_W\"\nfriction_table = \"t.csv\"\n" +
                   keys + "sections = [{ gain_um_W = 1, time_constant_s = 900 }]\n",
               "z.toml",
               {{.name = "t.csv",
                 .path = "/t.csv",
                 .text = "speed_rpm,axial_load_N,radial_load_N,friction_torque_Nmm\n"
                         "0,100,0,10\n1000,100,0,20\n0,400,0,30\n1000,400,0,60\n"
                         "0,100,900,20\n1000,100,900,40\n0,400,900,60\n1000,400,900,120\n"}})
        .models[0]
        .channels[0]
        .input;
  };
  const correction::Input both =
      input("axial_load_N = \"axial_load_N\"\nradial_load_N = \"cutting_force_N\"\n");
  EXPECT_EQ(both.axial_load.column->name, "axial_load_N");
  EXPECT_EQ(both.radial_load.column->name, "cutting_force_N");
  EXPECT_NEAR((*both.table)({500 * rpm, 250, 450, kelvin(40)}) / N_mm, 45.0, 1e-9);
  EXPECT_NEAR(input("radial_load_N = 450\n").radial_load.value, 450, 1e-12);
  const auto reads = [&](const std::string& keys) { return [=] { (void)input(keys); }; };
  EXPECT_THAT(reads("axial_load_N = \"x_feed_m_min\"\nradial_load_N = 0\n"),
              refused("axial_load_N: must be a number, or a column that ends in _N"));
  EXPECT_THAT(reads("radial_load_N = 0\ntemperature_C = \"oil_temperature_C\"\n"),
              refused("\": the friction table has only one value of this quantity, so the column "
                      "would have no effect"));
}

TEST(CorrectionFile, AWindowRises) {
  const auto with = [](const std::string& window) {
    return head + "[[correction.channel]]\ninput = \"spindle_power_W\"\nwindow = " + window +
           "\nsections = [{ gain_um_W = 1, time_constant_s = 900 }]\n";
  };
  const CorrectionFile file = parse_correction(
      with("{ column = \"x_position_mm\", points = [0, 500, inf, inf], acts_on = \"input\" }"),
      "z.toml");
  const correction::Window& w = *file.models[0].channels[0].input.window;
  EXPECT_NEAR(w(0.25), 0.5, 1e-12);
  EXPECT_TRUE(w.of_input);
  EXPECT_THAT(reading(with("{ column = \"x_position_mm\", points = [0, 500, 400, 600] }")),
              refused("points = [...]: must be"));
  EXPECT_THAT(
      reading(with("{ column = \"x_position_mm\", points = [0, 500, 600] }")),
      refused(": must be [from, full_from, full_to, to] or [from, to], in ascending order"));
  EXPECT_THAT(reading(with("{ points = [0, 500] }")), refused("column is missing"));
  EXPECT_THAT(reading(with("{ column = \"x_position\", points = [0, 500] }")),
              refused("NAME_position_mm"));
}

TEST(CorrectionFile, SeveralDisplacementsAreAListOfTables) {
  const std::string text = "[[correction]]\ndisplacement = \"displacement_z_um\"\n" + channel_text +
                           "[[correction]]\ndisplacement = \"displacement_y_um\"\n" + channel_text;
  EXPECT_EQ(parse_correction(text, "z.toml").models.size(), 2U);
  EXPECT_THAT(reading("[[correction]]\ndisplacement = \"displacement_z_um\"\n" + channel_text +
                      "[[correction]]\ndisplacement = \"displacement_z_um\"\n" + channel_text),
              refused("two tables"));
}

TEST(CorrectionFile, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_THAT(reading("[correction]\n"), refused("displacement is missing"));
  EXPECT_THAT(reading("[correction]\ndisplacement = \"z_um\"\n"), refused("z.toml:2"));
  EXPECT_THAT(reading(head + "tolerence_um = 2\n"), refused("tolerance_um?"));
  EXPECT_THAT(reading(head + "tolerance_um = 0\n"), refused("must be above 0"));
  EXPECT_THAT(reading(head + "[[correction.channel]]\ninput = \"front_temperature_C\"\n"),
              refused(": sections are missing, for example sections = [{"));
  EXPECT_THAT(reading(head + "[[correction.channel]]\ninput = \"front_temperature_C\"\n"
                             "sections = [{ gain_um_W = 1, time_constant_s = 9 }]\n"),
              refused("gain_um_K"));
  EXPECT_THAT(
      reading(head + "[[correction.channel]]\ninput = \"power_W\"\nsections = []\n"),
      refused("input = \"power_W\": friction_table is missing. This key names a CSV with "
              "speed_rpm, axial_load_N, temperature_C and friction_torque_Nmm, which raceway table "
              "can write. For a recorded power, use its column, such as spindle_power_W"));
  EXPECT_THAT(reading(head + "[[correction.channel]]\ninput = \"front_temperature_C\"\n"
                             "numerator = [1.0]\ndenominator = [1.0, -0.9]\n"),
              refused("sampling_s is missing"));
  EXPECT_THAT(reading(head + channel_text + "[[correction.effect]]\nid = \"ambient-drfit\"\n"),
              refused("ambient-drift"));
  EXPECT_THAT(reading(head + channel_text + channel_text),
              refused("\": two channels have this name; rename one"));
  EXPECT_THAT(
      reading(head + channel_text + "[loop]\ntolerance_um = 1\n[calibration]\nfree=[\"gain\"]\n"),
      refused("gains"));
  EXPECT_THAT(reading(head + "tolerance_um = 2\n" + channel_text + "[loop]\ntolerance_um = 1\n"),
              refused("keep one of them"));
}

/// All else of a file stays as it was written.
TEST(CorrectionFile, NumbersAreChangedWhereTheyStand) {
  const std::string text = "# mine\n" + head + "tolerance_um = 2  # on parts held out\n" +
                           "offset_um = 1.0  # assumed\n" + channel_text +
                           "\n[calibration]\nfree = [\"gains\"]  # no more\n";
  const CorrectionFile file = parse_correction(text, "z.toml");
  std::vector<correction::Model> models = file.models;
  models[0].channels[0].sections = {{4e-6, 1000}, {1e-6, 9000}};
  models[0].offset = 2.5e-6;
  models[0].effects.push_back({.id = "slow-drift", .values = {3.0, 20000}});
  models[0].range = {{.column = record::series_channel("front_temperature_C"),
                      .name = "front_temperature_C",
                      .lower = kelvin(20),
                      .upper = kelvin(35)}};
  const std::string now = with_corrections(file, models);
  for (const char* kept : {"# mine\n", "# on parts held out", "free = [\"gains\"]  # no more"})
    EXPECT_THAT(now, HasSubstr(kept));
  EXPECT_THAT(now, HasSubstr("offset_um = 2.5\n"));  // a guess no more
  const correction::Model back = parse_correction(now, "z.toml").models[0];
  ASSERT_EQ(back.channels[0].sections.size(), 2U);
  EXPECT_NEAR(back.channels[0].sections[1].gain, 1e-6, 1e-18);
  EXPECT_NEAR(back.offset, 2.5e-6, 1e-18);
  ASSERT_EQ(back.effects.size(), 1U);
  EXPECT_EQ(back.effects[0].values, (std::vector<double>{3.0, 20000}));
  ASSERT_EQ(back.range.size(), 1U);
  EXPECT_NEAR(back.range[0].upper, kelvin(35), 1e-9);
  // Once more: the range is replaced, not doubled.
  models[0] = back;
  EXPECT_EQ(with_corrections(parse_correction(now, "z.toml"), models), now);
}

/// A model with all that says how far it may be trusted.
correction::Model trusted_model(const correction::Model& from) {
  correction::Model m = from;
  const record::Channel* const front = record::series_channel("front_temperature_C");
  const record::Channel* const room = record::series_channel("room_temperature_C");
  m.range = {{.column = front,
              .name = "front_temperature_C",
              .lower = kelvin(20.1234567),
              .upper = kelvin(35.7654321)}};
  m.together = correction::SeenTogether{.columns = {front, room},
                                        .mean = Eigen::Vector2d(kelvin(25), kelvin(21)),
                                        .std = Eigen::Vector2d(4.0, 0.5),
                                        .correlation = Eigen::Matrix2d::Identity(),
                                        .farthest = 2.7182818};
  m.together->correlation(0, 1) = m.together->correlation(1, 0) = 0.75;
  const std::vector<record::Parameter> p = correction::parameters(m);
  m.covariance = fit::Covariance{.names = {p[1].name, p[2].name},
                                 .values = Eigen::Vector2d(p[1].value, p[2].value),
                                 .matrix = (Eigen::Matrix2d() << 0.04, -3, -3, 400).finished()};
  m.left = correction::Left{.rms = 1.25e-6, .correlation_time = 1800};
  return m;
}

TEST(CorrectionFile, CarriesHowFarItMayBeTrusted) {
  const CorrectionFile file = parse_correction(head + channel_text, "z.toml");
  const correction::Model given = trusted_model(file.models[0]);
  const std::string text = with_corrections(file, {given});
  const CorrectionFile again = parse_correction(text, "z.toml");
  const correction::Model& back = again.models[0];
  ASSERT_TRUE(back.covariance && back.together && back.left) << text;
  EXPECT_EQ(back.covariance->names, given.covariance->names);
  EXPECT_NEAR((back.covariance->matrix - given.covariance->matrix).norm(), 0.0, 1e-3);
  EXPECT_NEAR(back.together->mean[1], kelvin(21), 1e-9);
  EXPECT_NEAR(back.together->correlation(0, 1), 0.75, 1e-12);
  EXPECT_NEAR(back.together->std[0], 4.0, 1e-12);
  EXPECT_NEAR(back.left->rms, 1.25e-6, 1e-15);
  EXPECT_NEAR(back.left->correlation_time, 1800, 1e-9);
  // Six digits, and never narrower than what was seen.
  EXPECT_LE(back.range[0].lower, given.range[0].lower);
  EXPECT_GE(back.range[0].upper, given.range[0].upper);
  EXPECT_NEAR(back.range[0].upper, given.range[0].upper, 2e-4);
  EXPECT_GE(back.together->farthest, 2.7182818);
  // Once more: tables are replaced, not doubled.
  EXPECT_EQ(with_corrections(again, again.models), text);
  correction::Model other = back;
  other.left->rms = 2e-6;
  const std::string changed = with_corrections(again, {other});
  EXPECT_EQ(changed.size(), text.size() - 1) << changed;  // 1.25 became 2.0
}

TEST(CorrectionFile, ACovarianceOfOtherNumbersIsLeftOutWithANote) {
  const CorrectionFile file = parse_correction(head + channel_text, "z.toml");
  std::string text = with_corrections(file, {trusted_model(file.models[0])});
  const std::size_t at = text.find("time_constant_s = ");
  ASSERT_NE(at, text.npos);
  text.insert(at + std::string("time_constant_s = ").size(), "1");  // by hand
  const CorrectionFile edited = parse_correction(text, "z.toml");
  EXPECT_FALSE(edited.models[0].covariance);
  EXPECT_FALSE(edited.models[0].left);
  EXPECT_EQ(edited.models[0].range.size(), 1U);
  EXPECT_THAT(texts(edited.notes), testing::Contains(testing::AllOf(HasSubstr("time_constant_1 = "),
                                                                    HasSubstr("no error band"))));
}

/// Each of several displacements has tables of its own, before the next one.
TEST(CorrectionFile, SeveralCorrectionsAreEachWrittenInTheirPlace) {
  const auto one = [](const std::string& axis) {
    return "# of " + axis + "\n[[correction]]\ndisplacement = \"displacement_" + axis +
           "_um\"\n[[correction.channel]]\nname = \"a\"\ninput = \"front_temperature_C\"\n"
           "sections = [{ gain_um_K = 2.0, time_constant_s = 1000 }]\n\n";
  };
  const CorrectionFile file = parse_correction(one("x") + one("y"), "xy.toml");
  std::vector<correction::Model> models;
  for (const correction::Model& m : file.models) models.push_back(trusted_model(m));
  models[0].left->rms = 3e-6;
  models[0].effects.push_back({.id = "slow-drift", .values = {3.0, 20000}});
  const std::string text = with_corrections(file, models);
  const CorrectionFile back = parse_correction(text, "xy.toml");
  EXPECT_NEAR(back.models[0].left->rms, 3e-6, 1e-15);
  EXPECT_NEAR(back.models[1].left->rms, 1.25e-6, 1e-15);
  EXPECT_EQ(back.models[0].effects.size(), 1U);
  EXPECT_TRUE(back.models[1].effects.empty());
  EXPECT_TRUE(back.models[0].covariance && back.models[1].covariance);
  EXPECT_THAT(text, HasSubstr("\n# of y\n[[correction]]\n"));
  EXPECT_EQ(with_corrections(back, back.models), text);
}

TEST(CorrectionFile, ARangeIsOfAnInputOrOfThePowerOfAChannel) {
  const std::string text = head + channel_text;
  const auto reading = [&](const std::string& range) {
    return
        [text = text + "[correction.range]\n" + range] { (void)parse_correction(text, "z.toml"); };
  };
  EXPECT_THAT(reading("nonsense = [1, 2]\n"), refused("nonsense"));
  EXPECT_THAT(reading("front_temperature_C = [30, 20]\n"),
              refused(": the lowest value must not be above the highest"));
  EXPECT_THAT(reading("\"other power_W\" = [0, 20]\n"), refused("no channel other"));
}

const std::string displacement_header = "time_s,speed_rpm,front_temperature_C,displacement_z_um\n";

record::Record series(const std::string& text) {
  return read_series({"r.csv", text}, {record::series_channel("displacement_z_um")}, {});
}

TEST(SeriesFile, AWordInThePlaceOfAReadingDoesNotTakePartAndIsNamed) {
  const record::Record r =
      series("time_s,speed_rpm,displacement_z_um\n0,0,1\n1,0,OVER\n2,0,\n3,0,Bad Input\n4,0,2\n");
  const auto moved = r.values(*record::series_channel("displacement_z_um"));
  EXPECT_TRUE(std::isnan(moved[1]) && std::isnan(moved[2]) && std::isnan(moved[3]));
  EXPECT_DOUBLE_EQ(moved[4], 2e-6);
  EXPECT_THAT(texts(r.notes),
              testing::Contains("2 of 5 readings of displacement_z_um have no valid value (OVER "
                                "and Bad Input) and are not used (lines 3, 5)"));
}

std::vector<double> times(const std::vector<std::string>& stamps, const std::string& map = "") {
  std::string text = "Time,displacement_z_um\n";
  for (const std::string& stamp : stamps) text += stamp + ",1\n";
  const record::Record r = read_series(
      {"r.csv", text}, {record::series_channel("displacement_z_um")}, {},
      {.columns = parse_column_map("[columns]\ntime_s = \"Time\"\n" + map, "map.toml")});
  return {r.values(record::time).begin(), r.values(record::time).end()};
}

TEST(SeriesFile, TheOrderOfDayAndMonthIsAskedForWhereItMatters) {
  using Times = std::vector<double>;
  EXPECT_EQ(times({"09/11/2024 08:00:00 AM", "09/11/2024 08:01:00 PM"}), (Times{0, 43260}));
  EXPECT_EQ(times({"09/12/2024 08:00", "09/13/2024 08:00"}), (Times{0, 86400}));  // 13 is no month
  const std::vector<std::string> both{"09/11/2024 23:00", "09/11/2024 23:30", "09/12/2024 00:00"};
  EXPECT_THAT([&] { (void)times(both); },
              refused("r.csv:4: Time = 09/12/2024 00:00: is it 2024-12-09 or 2024-09-12? Set "
                      "date_order = \"day first\" or \"month first\" in [columns]"));
  EXPECT_EQ(times(both, "date_order = \"month first\"\n"), (Times{0, 1800, 3600}));
  EXPECT_EQ(times(both, "date_order = \"day first\"\n").back(), 30 * 86400.0 - 23 * 3600.0);
  EXPECT_EQ(times({"0:59:30", "1:00:00", "1 00:00:00"}), (Times{0, 30, 86400 - 3570}));
}

TEST(SeriesFile, AChangeOfClocksIsNoStepBackAndNoGap) {
  using Times = std::vector<double>;
  EXPECT_EQ(times({"27.10.2024 02:58:00", "27.10.2024 02:59:00", "27.10.2024 02:00:00",
                   "27.10.2024 02:01:00"}),
            (Times{0, 60, 120, 180}));
  EXPECT_EQ(times({"31.03.2024 01:58:00", "31.03.2024 01:59:00", "31.03.2024 03:00:00",
                   "31.03.2024 03:01:00"}),
            (Times{0, 60, 120, 180}));
  // A clock that states its zone does not change, and on other days nothing does.
  EXPECT_EQ(times({"2024-03-31T01:58:00Z", "2024-03-31T01:59:00Z", "2024-03-31T03:00:00Z",
                   "2024-03-31T03:01:00Z"})
                .back(),
            3780);
  EXPECT_THAT(
      [] {
        (void)times({"28.10.2024 02:58", "28.10.2024 02:59", "28.10.2024 02:00"});
      },
      refused("goes back"));
}

TEST(SeriesFile, AnEmptyDisplacementWasNotRead) {
  const record::Record r = series(displacement_header + "0,100,20,1\n60,100,21,\n120,100,22,3\n");
  EXPECT_EQ(r.rows(), 3U);
  EXPECT_TRUE(std::isnan(r.values(*record::series_channel("displacement_z_um"))[1]));
  EXPECT_NEAR(r.values(*record::series_channel("front_temperature_C"))[2], kelvin(22), 1e-12);
}

/// Sensors have rates of their own, and a control writes a speed when it changes.
TEST(SeriesFile, InputsAreFilledBetweenTheirReadings) {
  const record::Record r =
      series(displacement_header + "0,100,20,1\n60,,,2\n120,300,23,3\n180,,24,4\n240,,,5\n");
  EXPECT_EQ(std::vector<double>(r.values(record::speed).begin(), r.values(record::speed).end()),
            (std::vector<double>{100 * rpm, 100 * rpm, 300 * rpm, 300 * rpm, 300 * rpm}));
  const auto front = r.values(*record::series_channel("front_temperature_C"));
  for (const auto& [row, expected] : {std::pair{1, 21.5}, {3, 24.0}, {4, 24.0}})
    EXPECT_NEAR(front[static_cast<std::size_t>(row)], kelvin(expected), 1e-9) << row;
  EXPECT_THAT(texts(r.notes),
              testing::Contains(testing::HasSubstr(
                  "3 of 5 rows have no speed_rpm: the last value is used until the next one")));
  EXPECT_THAT(texts(r.notes), testing::Contains(testing::HasSubstr("over gaps of up to 1200 s")));
}

// Measured with a correction switched on: the machine itself moved by what was read less the
// offset.
TEST(SeriesFile, AnOffsetThatTheControlAddedIsTakenOff) {
  const record::Channel& z = *record::series_channel("displacement_z_um");
  const auto read = [&](const std::string& map) {
    return read_series({"r.csv",
                        "time_s,offset_z_um,displacement_z_um,offset_y_um\n"
                        "0,0,1,5\n60,-4,3,5\n120,,3,5\n180,-6,,5\n"},
                       {&z}, {}, {.columns = parse_column_map(map, "map.toml")});
  };
  const record::Record r = read("[columns]\n");
  EXPECT_THAT(r.values(z), ElementsAre(DoubleEq(1e-6), DoubleEq(7e-6), DoubleEq(7e-6), IsNan()));
  EXPECT_FALSE(r.has(*record::series_channel("offset_z_um")));
  EXPECT_THAT(
      texts(r.notes),
      Contains("the offset of the control, offset_z_um, is subtracted from displacement_z_um"));
  EXPECT_THAT(texts(r.notes),
              Contains(HasSubstr("offset_y_um: not used, because the record has no displacement")));
  EXPECT_DOUBLE_EQ(
      read("[columns]\noffset_z_um = { column = \"offset_z_um\", factor = -1 }\n").values(z)[1],
      -1e-6);
}

TEST(SeriesFile, RowsWithoutAnInputAreLeftOutOrBreakTheRecord) {
  using testing::Contains;
  const record::Channel &z = *record::series_channel("displacement_z_um"),
                        &front = *record::series_channel("front_temperature_C");
  // Nothing is known before the first value, in each run.
  record::Record r = series(displacement_header + "0,,20,1\n60,100,20,1\n");
  EXPECT_EQ(r.rows(), 1u);
  EXPECT_THAT(texts(r.notes),
              Contains("rows before the first value of speed_rpm are not used: line 2"));
  r = series("run_id,time_s,speed_rpm,displacement_z_um\na,0,100,1\na,60,,1\nb,0,,1\n");
  EXPECT_EQ(r.rows(), 2u);
  // What was measured in a long gap takes no part.
  const std::string gap =
      displacement_header + "0,100,20,1\n30,100,20,1\n60,100,20,1\n400,100,,1\n800,100,22,1\n";
  r = read_series({"r.csv", gap}, {&z}, {&front});
  EXPECT_DOUBLE_EQ(r.value(front, 3), kelvin(20.0 + 2.0 * 340.0 / 740.0));
  EXPECT_THAT(r.values(z),
              ElementsAre(DoubleEq(1e-6), DoubleEq(1e-6), DoubleEq(1e-6), IsNan(), DoubleEq(1e-6)));
  EXPECT_THAT(
      texts(r.notes),
      Contains("front_temperature_C has no reading for more than 5 min, line 5: the program treats "
               "these rows as a gap of the record and does not use their readings"));
  // A column that the model does not ask for is left out.
  r = series(gap);
  EXPECT_FALSE(r.has(front));
  EXPECT_THAT(texts(r.notes),
              Contains("front_temperature_C has no value for 1 of 5 rows: the column is not used"));
}

TEST(SeriesFile, NoRowIsLostForAPowerThatNobodyAskedFor) {
  const std::string text =
      "time_s,front_temperature_C,drive_W,displacement_z_um\n0,20,,1\n60,20,5,1\n120,21,6,1\n";
  const record::Channel &z = *record::series_channel("displacement_z_um"),
                        &front = *record::series_channel("front_temperature_C"),
                        &drive = *record::series_channel("drive_W");
  const record::Record unasked = read_series({"r.csv", text}, {&z}, {&front});
  EXPECT_EQ(unasked.rows(), 3u);
  EXPECT_FALSE(unasked.has(drive));
  EXPECT_THAT(texts(unasked.notes),
              Contains("drive_W has no value for 1 of 3 rows: the column is not used"));
  EXPECT_EQ(read_series({"r.csv", text}, {&z}, {&front, &drive}).rows(), 2u);
}

TEST(SeriesFile, NumbersThatMarkAMissingReadingAreNone) {
  const record::Record r = series(displacement_header +
                                  "0,100,20,1\n60,100,21,-9999\n120,100,22,9.9e37\n180,100,22,2\n");
  const auto z = r.values(*record::series_channel("displacement_z_um"));
  EXPECT_TRUE(std::isnan(z[1]) && std::isnan(z[2]));
  EXPECT_THAT(texts(r.notes),
              testing::Contains("2 of 4 readings of displacement_z_um have no valid value (-9999 "
                                "and 9.9e37) and are not used (lines 3, 4)"));
  // Where others come near it is a reading.
  EXPECT_NEAR(series(displacement_header + "0,1,20,990\n60,1,20,999\n120,1,20,1005\n")
                  .values(*record::series_channel("displacement_z_um"))[1],
              999 * um, 1e-9);
}

TEST(SeriesFile, TimeMustRiseWithinARun) {
  EXPECT_THAT([] { (void)series(displacement_header + "0,1,20,1\n60,1,20,1\n30,1,20,1\n"); },
              refused("r.csv:4: time_s = 30: goes back"));
  EXPECT_THAT([] { (void)series(displacement_header + "0,1,20,1\n60,1,20,1\n60,1,20,1\n"); },
              refused("occurs twice within a run; time must increase"));
  const record::Record runs = series("run_id,time_s,displacement_z_um\na,0,1\na,60,2\nb,0,3\n");
  EXPECT_EQ(runs.runs, (std::vector<std::string>{"a", "b"}));
}

TEST(SeriesFile, ReadsOtherUnitsAndDates) {
  const record::Record r = series(
      "time_s;Spindle speed [1/min];front_temperature_K;displacement_z_mm;x_feed_mm_min\n"
      "2024-03-12T08:15:00;100;293,15;0,001;600\n2024-03-12T08:16:00;100;294,15;0,002;600\n");
  EXPECT_NEAR(r.values(record::time)[1], 60.0, 1e-9);
  EXPECT_NEAR(r.values(*record::series_channel("front_temperature_C"))[0], 293.15, 1e-9);
  EXPECT_NEAR(r.values(*record::series_channel("displacement_z_um"))[1], 2e-6, 1e-15);
  EXPECT_NEAR(r.values(*record::series_channel("x_feed_m_min"))[0], 0.01, 1e-12);
}

TEST(SeriesFile, NamesGapsAndWhatItDoesNotKnow) {
  std::string text = "time_s,front_temperature_C,displacement_z_um,note\n";
  for (int k = 0; k < 50; ++k)
    text += std::to_string(k < 25 ? 10 * k : 10 * k + 5000) + ",20,1,x\n";
  const record::Record r = series(text);
  EXPECT_THAT(texts(r.notes), testing::Contains(HasSubstr("1 gap in time")));
  EXPECT_THAT(texts(r.notes), testing::Contains(HasSubstr("column note is unknown")));
}

TEST(SeriesChannel, AQuantityIsMadeOnce) {
  const record::Channel* const c = record::series_channel("rear_bearing_temperature_C");
  ASSERT_NE(c, nullptr);
  EXPECT_EQ(c, record::series_channel("rear_bearing_temperature_C"));
  EXPECT_EQ(c->words, "rear bearing temperature");
  EXPECT_EQ(c->key_unit(), "C");
  EXPECT_EQ(record::series_channel("x_feed_m_min")->key_unit(), "m_min");
  EXPECT_EQ(record::series_channel("speed_rpm"), &record::speed);
  for (const char* none :
       {"temperature_C", "_temperature_C", "displacement_um", "a b_temperature_C"})
    EXPECT_EQ(record::series_channel(none), nullptr) << none;
  EXPECT_TRUE(record::is_ambient(*record::series_channel("hall_air_temperature_C")));
  EXPECT_FALSE(record::is_ambient(*record::series_channel("repair_temperature_C")));
}

}  // namespace
}  // namespace raceway::files
