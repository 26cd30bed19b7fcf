#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "record/record.h"
#include "record/repeats.h"

namespace raceway::record {
namespace {

Record named(const std::string& source) {
  Record record{.source = source};
  record.set(speed, {100.0, 100.0});
  record.set(friction_torque, {1.0, 2.0});
  return record;
}

TEST(Joined, HasTheColumnsRowsAndRunsOfAll) {
  Record first = named("d/monday.csv"), second = named("d/friday.csv");
  first.set(preload, {5.0, 6.0});
  first.lines = {2, 3};
  second.lines = {7, 9};
  for (Record* r : {&first, &second}) {
    r->set(run, {0.0, 0.0});
    r->runs = {"1"};
  }
  const Record all = joined({first, second});
  EXPECT_EQ(all.rows(), 4U);
  EXPECT_EQ(all.source, "d/friday.csv, d/monday.csv");
  EXPECT_EQ(all.parts[1].name, "monday");
  EXPECT_EQ(all.parts[1].source, "d/monday.csv");
  EXPECT_TRUE(std::isnan(all.value(preload, 0)));
  EXPECT_EQ(all.value(preload, 3), 6.0);
  EXPECT_EQ(all.runs, (std::vector<std::string>{"1 of friday", "1 of monday"}));
  EXPECT_NE(all.run_of(0), all.run_of(2));
  EXPECT_EQ(all.part_of(1), 0U);
  EXPECT_EQ(all.part_of(2), 1U);
  EXPECT_EQ(all.place(3), "line 3 of monday");
  const std::size_t last[] = {3};
  EXPECT_EQ(all.picked(last).place(0), "line 3 of monday");
}

TEST(Joined, HasTheNotesOfAll) {
  Record first = named("a.csv"), second = named("b.csv");
  first.notes = {note::read_as("a.csv: one")};
  second.notes = {note::unused("b.csv: two"), note::left_out("b.csv: three")};
  const std::vector<Note> all = joined({second, first}).notes;
  EXPECT_EQ(texts(all), (std::vector<std::string>{"a.csv: one", "b.csv: two", "b.csv: three"}));
  EXPECT_EQ(all[2].code, &note::left_out);
}

TEST(Joined, HasRepeatsWithinARecordAlone) {
  EXPECT_EQ(find_repeats(joined({named("a.csv"), named("b.csv")})).size(), 2U);
}

TEST(Joined, NamesPartsWithTheirFolderWhereTheyWouldBeAlike) {
  const Record all = joined({named("a/rig.csv"), named("b/rig.csv")});
  EXPECT_EQ(all.parts[0].name, "a/rig");
  EXPECT_EQ(all.parts[1].name, "b/rig");
  EXPECT_THROW((void)joined({named("a.csv"), named("a.csv")}), std::invalid_argument);
  EXPECT_THROW((void)joined({named("a.csv")}), std::invalid_argument);
}

/// Of two factors that nobody knows none can be told.
TEST(Joined, RefusesReadingsThatAreKnownUpToAFactor) {
  Record first = named("a.csv");
  first.up_to_a_factor = true;
  EXPECT_TRUE(first.picked(std::vector<std::size_t>{0}).up_to_a_factor);
  EXPECT_THROW((void)joined({first, named("b.csv")}), std::invalid_argument);
}

TEST(Joined, KnowsADeviationThatAllKnow) {
  Record first = named("a.csv"), second = named("b.csv");
  first.set(torque_deviation, {0.1, 0.1}).known = true;
  second.set(torque_deviation, {0.2, 0.2}).known = true;
  EXPECT_TRUE(joined({first, second}).find(torque_deviation)->known);
  second.find(torque_deviation)->known = false;
  EXPECT_FALSE(joined({first, second}).find(torque_deviation)->known);
}

}  // namespace
}  // namespace raceway::record
