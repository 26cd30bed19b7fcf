#include "correction/numbers.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "correction/catalogue.h"
#include "correction/correction_subject.h"
#include "tests/correction/made_record.h"

namespace raceway::correction {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

Model two_channels() {
  Model m{.name = "z", .displacement = record::series_channel("displacement_z_um")};
  m.channels.push_back({.name = "spindle",
                        .input = {.name = "front_temperature_C",
                                  .columns = {record::series_channel("front_temperature_C")}},
                        .sections = {{5e-6, 5400}, {3e-6, 900}}});
  m.channels.push_back(
      {.name = "feed",
       .input = {.name = "x_feed_m_min", .columns = {record::series_channel("x_feed_m_min")}},
       .sections = {{6e-5, 3000}}});
  m.kinematic = Kinematic{1.28e-3, 0.697, 5.3e-4};
  return m;
}

TEST(Numbers, AreInTheUnitsOfTheFiles) {
  const std::vector<record::Parameter> list = parameters(two_channels());
  const auto value = [&](const std::string& name) {
    for (const record::Parameter& p : list)
      if (p.name == name) return p.value;
    return unset;
  };
  EXPECT_NEAR(value("spindle.gain_1"), 5.0, 1e-12);  // um/K
  EXPECT_NEAR(value("feed.gain_1"), 1.0, 1e-12);     // um per m/min: 6e-5 m per m/s
  EXPECT_EQ(value("spindle.time_constant_2"), 900.0);
  EXPECT_EQ(value("kinematic.B"), 0.697);
}

TEST(Numbers, GroupsMeanTheirParameters) {
  Model m = two_channels();
  m.free = {"gains", "offset"};
  EXPECT_THAT(free_names(m),
              ElementsAre("offset", "spindle.gain_1", "spindle.gain_2", "feed.gain_1"));
  m.free = {"scale"};
  EXPECT_THAT(free_names(m), ElementsAre("spindle.scale", "feed.scale"));
  m.free = {};
  EXPECT_THAT(free_names(m), Not(Contains("spindle.scale")));
  m.free = {"gians"};
  EXPECT_THAT([&] { (void)free_names(m); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("gains")));
}

/// What follows speed or feed faster than a body can is the law of instant displacement.
TEST(Numbers, HeldInputsHaveNoFastSections) {
  for (const record::Parameter& p : parameters(two_channels(), {2.0, 1e5})) {
    if (p.name == "spindle.time_constant_1") {
      EXPECT_EQ(p.lower, 2.0);
    }
    if (p.name == "feed.time_constant_1") {
      EXPECT_EQ(p.lower, 180.0);
    }
  }
}

TEST(CorrectionSubject, EveryNumberCanBeSetAndReadBack) {
  const CorrectionSubject subject(two_channels());
  for (const fit::Parameter& p : subject.parameters()) {
    const double other = p.unit == "s" ? 1234.5 : 0.25;
    const std::vector<fit::NamedValue> values{{p.name, other}};
    for (const fit::Parameter& now : subject.with_values(values)->parameters())
      if (now.name == p.name) {
        EXPECT_NEAR(now.value, other, 1e-12 * other) << p.name;
      }
  }
}

TEST(CorrectionSubject, ARecordSaysWhatMayBeMissing) {
  MadeRecord made(40000, 60);
  made.with("speed_rpm", [](double t) { return stepped_speed(t, 5000); })
      .with("front_temperature_C", [](double t) { return 20 + t / 1e4; })
      .with("motor_temperature_C", [](double t) { return 20 + t / 1e4; })
      .with("hall_ambient_temperature_C", [](double t) { return 20 + std::sin(t); })
      .with("rear_temperature_C", [](double) { return 20.0; })
      .with("x_feed_m_min", [](double t) { return t / 2e4; })
      .with("z_feed_m_min", [](double t) { return t / 1e4; })
      .with("displacement_z_um", [](double t) { return t / 1e4; });
  const auto subject = CorrectionSubject(two_channels()).informed_by(made.record);
  std::vector<std::string> ids;
  for (const fit::Candidate& c : subject->candidates()) ids.push_back(c.id);
  EXPECT_THAT(ids, ElementsAre("ambient-drift", "feed-axis-heat:z", "motor-heat", "offset-jump",
                               "second-time-constant", "second-time-constant:feed", "sensor-lag",
                               "slow-drift", "speed-dependent-time-constant", "thermal-asymmetry"));
  EXPECT_THAT(subject->lacks("cooling-switch", made.record), HasSubstr("coolant_on"));
  // Half of the record is the longest time constant, two rows the shortest.
  for (const fit::Parameter& p : subject->parameters())
    if (p.name == "spindle.time_constant_1") {
      EXPECT_NEAR(p.upper, 20000, 60);
      EXPECT_EQ(p.lower, 120);
    }
}

TEST(CorrectionSubject, AJumpIsNeverLookedForAtAChangeOfSpeed) {
  MadeRecord made(40000, 60);
  made.with("speed_rpm", [](double t) { return stepped_speed(t, 5000); })
      .with("front_temperature_C", [](double t) { return 20 + t / 1e4; })
      .with("x_feed_m_min", [](double) { return 1.0; })
      .with("displacement_z_um", [](double t) { return t / 1e4; });
  const auto subject = CorrectionSubject(two_channels()).informed_by(made.record);
  for (const fit::Candidate& c : subject->candidates())
    if (c.id == "offset-jump") {
      for (const double t : c.only[1])
        for (double change = 5000; change < 40000; change += 5000)
          EXPECT_GT(std::abs(t - change), 500.0);
    }
}

TEST(CorrectionSubject, PartsAreContiguousAndEqual) {
  MadeRecord made(8000, 10);
  made.with("displacement_z_um", [](double t) { return t; });
  Model m = two_channels();
  const std::vector<fit::Blocking> list = CorrectionSubject(m).blockings(made.record);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].blocks, 8);
  EXPECT_EQ(list[0].block.front(), 0);
  EXPECT_EQ(list[0].block.back(), 7);
  EXPECT_TRUE(std::is_sorted(list[0].block.begin(), list[0].block.end()));
  // A machine that began warm: its first part tells how warm, and is never held out.
  m.initial_state = InitialState::free;
  EXPECT_EQ(CorrectionSubject(m).blockings(made.record)[0].block.front(), -1);
}

/// Five runs of 8000 s; the room moves in all, the feed in the last one alone.
MadeRecord one_source_per_run(double runs) {
  MadeRecord made(8000 * runs - 10, 10);
  std::vector<double> run;
  for (const double t : made.time) run.push_back(std::floor(t / 8000));
  for (int k = 0; k < static_cast<int>(runs); ++k) made.record.runs.push_back(std::to_string(k));
  made.record.set(record::run, run);
  made.with("ambient_temperature_C", [](double t) { return 20 + std::sin(t / 700); })
      .with("x_feed_m_min", [=](double t) { return t < 8000 * (runs - 1) ? 0.0 : 5.0; })
      .with("displacement_z_um", [](double t) { return t; });
  return made;
}

TEST(CorrectionSubject, APartNeverHoldsAllThatAnInputDoes) {
  // Within the last of eight parts: each run has parts of its own.
  const MadeRecord made = one_source_per_run(10);
  const fit::Blocking b = CorrectionSubject(two_channels()).blockings(made.record).at(0);
  EXPECT_THAT(b.untold, testing::IsEmpty());
  for (int run = 0; run < 10; ++run)
    for (int part = 0; part < 8; ++part)
      EXPECT_EQ(b.block[static_cast<std::size_t>(800 * run + 100 * part + 50)], part);
}

TEST(CorrectionSubject, AnInputMovesWhereItLeavesItsReference) {
  // The axis heats in the last run; with the room its temperature swings in all of them.
  MadeRecord made = one_source_per_run(10);
  const auto base = [](double t) { return 20 + 4 * std::sin(t / 9000); };
  made.with("base_temperature_C", base).with("x_temperature_C", [&](double t) {
    return base(t) + (t < 72000 ? 0.0 : 8 * std::sin((t - 72000) / 3000));
  });
  Model m = two_channels();
  m.channels[0].input = {.name = "x_temperature_C",
                         .columns = {record::series_channel("x_temperature_C")},
                         .reference = record::series_channel("base_temperature_C")};
  made.with("x_feed_m_min", [](double) { return 1.0; });  // no other reason for parts of runs
  const fit::Blocking b = CorrectionSubject(m).blockings(made.record).at(0);
  for (int run = 0; run < 10; ++run)
    for (int part = 0; part < 8; ++part)
      EXPECT_EQ(b.block[static_cast<std::size_t>(800 * run + 100 * part + 50)], part);
}

TEST(CorrectionSubject, APartThatHoldsAllThatAnInputDoesIsNotHeldOut) {
  MadeRecord made(8000, 10);
  made.with("x_feed_m_min", [](double t) { return t > 5100 && t < 5900 ? 5.0 : 0.0; })
      .with("displacement_z_um", [](double t) { return t; });
  const fit::Blocking b = CorrectionSubject(two_channels()).blockings(made.record).at(0);
  EXPECT_THAT(b.untold, testing::ElementsAre("x feed"));
  EXPECT_EQ(b.block[550], -1);
  EXPECT_EQ(b.block[450], 4);
  EXPECT_EQ(b.block[650], 6);
}

TEST(CorrectionSubject, EveryRecordedTemperatureIsACandidate) {
  MadeRecord made(40000, 60);
  made.with("speed_rpm", [](double t) { return stepped_speed(t, 5000); })
      .with("front_temperature_C", [](double t) { return 20 + t / 1e4; })
      .with("table_temperature_C", [](double t) { return 20 + std::sin(t / 3000); })
      .with("door_temperature_C", [](double t) { return 20 + std::sin(t / 2000); })
      .with("motor_temperature_C", [](double t) { return 20 + std::cos(t / 3000); })
      .with("bolt_temperature_C", [](double) { return 20.0; })
      .with("displacement_z_um", [](double t) { return t / 1e4; });
  const auto subject = CorrectionSubject(two_channels()).informed_by(made.record);
  std::vector<std::string> ids;
  for (const fit::Candidate& c : subject->candidates())
    if (c.by_column) ids.push_back(c.id);
  EXPECT_THAT(ids, testing::ElementsAre("input:door_temperature_C", "input:table_temperature_C"));
}

TEST(CorrectionSubject, UnknownEffectsAreRefusedWithTheNearest) {
  const CorrectionSubject subject(two_channels());
  const auto add = [&](std::vector<std::string> ids) {
    return [&subject, ids] { (void)subject.with_candidates(ids); };
  };
  EXPECT_THAT(add({"slow-drfit"}), ThrowsMessage<std::invalid_argument>(HasSubstr("slow-drift")));
  EXPECT_THAT(add({"slow-drift", "slow-drift"}),
              ThrowsMessage<std::invalid_argument>(HasSubstr("twice")));
  EXPECT_THAT(add({"ambient-drift"}),
              ThrowsMessage<std::invalid_argument>(HasSubstr("temperature of the room")));
}

TEST(EffectCards, AreInOrderAndHaveASizeThatChangesNothing) {
  for (std::size_t k = 1; k < catalogue().size(); ++k)
    EXPECT_LT(catalogue()[k - 1].id, catalogue()[k].id);
  for (const EffectCard& card : catalogue()) {
    EXPECT_EQ(find_card(card.id), &card);
    if (!card.evidence) {
      EXPECT_FALSE(std::isnan(card.numbers[card.size].neutral)) << card.id;
    }
  }
}

}  // namespace
}  // namespace raceway::correction
