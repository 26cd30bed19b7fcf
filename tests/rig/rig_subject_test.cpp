#include "rig/rig_subject.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "effects/catalogue.h"
#include "effects/formula.h"
#include "model/prediction.h"
#include "tests/support/shafts.h"

namespace raceway::fit {
namespace {

using rig::RigSubject;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;

DataSet plan() { return factorial_plan({500, 2000, 6000, 12000}, {100, 400, 900}, {30, 60}); }

std::vector<std::string> ids(const std::vector<Candidate>& candidates) {
  std::vector<std::string> list;
  for (const Candidate& c : candidates) list.push_back(c.id);
  return list;
}

std::vector<std::string> names(const Subject& subject) {
  std::vector<std::string> list;
  for (const Parameter& p : subject.parameters()) list.push_back(p.name);
  return list;
}

effects::Effect drag_of_mine(double size) {
  return effects::make_effect({.id = "of-mine",
                               .title = {},
                               .torque_Nmm = "c * (speed_rpm/1000)^k",
                               .parameters = {{"c", "N mm", size}, {"k", "1", 1.5}}});
}

/// An effect of the user's own that stands first, then spin friction.
Model with_mine(double size) {
  Model model = synthetic_model();
  model.effects.push_back(drag_of_mine(size));
  return with_effect(std::move(model), "spin-friction", {0.06});
}

std::string refusal(const Subject& subject, const std::vector<std::string>& wanted) {
  try {
    (void)subject.with_candidates(wanted);
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

std::vector<double> readings(Predictor& predictor, const std::vector<double>& values,
                             std::size_t rows) {
  std::vector<double> out(rows);
  predictor.readings(values, out);
  return out;
}

TEST(RigSubject, PredictsManyRowsAsItPredictsFew) {
  std::vector<double> speeds;
  for (int k = 0; k < 5000; ++k) speeds.push_back(500.0 + 3.0 * k);
  const RigSubject subject(with_effect(synthetic_model(), "spin-friction", {0.06}));
  const Record record = factorial_plan(speeds, {400}, {40});
  const std::vector<double> whole =
      readings(*subject.predictor(record, {}, nullptr), {}, record.rows());
  EXPECT_THAT(whole, Each(testing::Gt(0.0)));
  EXPECT_EQ(predict(subject, record), whole);
}

TEST(RigSubject, CountsWhatIsFreeAmongTheCandidatesAgain) {
  EXPECT_EQ(RigSubject(with_mine(3.0)).without_free_candidates(), nullptr) << "nothing is free";
  Model model = with_mine(3.0);
  model.free = {"f0", "of-mine.c", "spin-friction.friction_coefficient"};
  const auto bare = RigSubject(model).without_free_candidates();
  ASSERT_NE(bare, nullptr);
  EXPECT_THAT(bare->free(), ElementsAre("f0"));
  EXPECT_THAT(ids(bare->candidates()), IsSupersetOf({"of-mine", "spin-friction"}));
  EXPECT_THAT(names(*bare), Not(Contains("of-mine.c")));
  // Switched on again it stands where it stood.
  const std::vector<std::string> both{"of-mine", "spin-friction"};
  EXPECT_EQ(names(*bare->with_candidates(both)), names(RigSubject(model)));
}

TEST(RigSubject, PredictsTheReadingsOfItsModel) {
  Model model =
      with_effect(with_effect(synthetic_model(), "spin-friction", {0.06}), "torque-offset", {20.0});
  model.rig.bearings = 2;
  const Record record = plan();
  const std::vector<double> predicted = predict(RigSubject(model), record);
  const std::vector<FrictionPrediction> rows = predict_rows(model, record);
  ASSERT_EQ(predicted.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    EXPECT_NEAR(predicted[i], rows[i].reading, 1e-9 * rows[i].reading);
}

/// Rows remember what a number leaves alone, and it does not show.
TEST(RigSubject, DoesNotDependOnWhatWasAskedBefore) {
  Model model = synthetic_model();
  const std::vector<std::string> on{"spin-friction",   "thermal-preload", "shear-thinning",
                                    "misalignment",    "lubricant-drag",  "torque-gain",
                                    "viscous-exponent"};
  std::vector<std::string> wanted{"f0", "z", "y"};
  for (const std::string& id : on) {
    const effects::Description& d = *effects::find(id);
    model = with_effect(std::move(model), id, effects::initial_values(d));
    for (const effects::Parameter& p : d.parameters)
      wanted.push_back(id + "." + std::string(p.name));
  }
  const RigSubject subject(model);
  const Record record = plan();
  const auto prepared = subject.prepare(record);
  const auto predictor = subject.predictor(record, wanted, prepared);
  std::vector<double> values;
  for (const Parameter& p : find_parameters(subject, wanted)) values.push_back(p.start);
  for (std::size_t k = 0; k <= wanted.size(); ++k) {
    if (k > 0) values[k - 1] = values[k - 1] * 1.05 + 1e-3;
    if (k % 3 == 2) std::swap(values[0], values[k - 1]);  // some at once
    const std::vector<double> remembered = readings(*predictor, values, record.rows());
    const std::vector<double> fresh =
        readings(*subject.predictor(record, wanted, nullptr), values, record.rows());
    std::vector<NamedValue> named;
    for (std::size_t j = 0; j < wanted.size(); ++j) named.push_back({wanted[j], values[j]});
    const std::vector<double> set = predict(*subject.with_values(named), record);
    for (std::size_t i = 0; i < record.rows(); ++i) {
      EXPECT_NEAR(remembered[i], fresh[i], 1e-8 * fresh[i]) << k << " row " << i;
      EXPECT_NEAR(set[i], fresh[i], 1e-8 * fresh[i]) << k << " row " << i;
    }
  }
}

TEST(RigSubject, SharesTheBalancesOfARecordAmongPredictorsOfManyThreads) {
  const RigSubject subject(synthetic_model());
  const Record record = plan(), other = factorial_plan({3000}, {200, 300}, {40});
  const auto prepared = subject.prepare(record);
  const std::vector<std::string> spin{"spin-friction"};
  const auto with = subject.with_candidates(spin);
  const std::vector<double> alone = predict(*with, record);
  std::vector<std::vector<double>> found(8);
  tbb::parallel_for(std::size_t{0}, found.size(), [&](std::size_t k) {
    found[k] = readings(*with->predictor(record, {}, prepared), {}, record.rows());
  });
  EXPECT_THAT(found, Each(found.front()));
  for (std::size_t i = 0; i < alone.size(); ++i)
    EXPECT_NEAR(found[0][i], alone[i], 1e-9 * alone[i]);
  // Of another record they are no help, and no harm.
  EXPECT_EQ(readings(*with->predictor(other, {}, prepared), {}, other.rows()),
            predict(*with, other));
}

TEST(RigSubject, HasAllThatMayBeMissingOnceAndInOrder) {
  const RigSubject subject(with_effect(synthetic_model(), "spin-friction", {0.06}));
  const std::vector<Candidate> candidates = subject.candidates();
  const std::vector<std::string> list = ids(candidates);
  EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
  EXPECT_EQ(std::adjacent_find(list.begin(), list.end()), list.end());
  EXPECT_THAT(list, IsSupersetOf({"windage", "torque-offset", "thermal-preload"}));
  EXPECT_THAT(list, Not(Contains("spin-friction")));
  EXPECT_THAT(list, Not(Contains("shaft-contraction")));
  EXPECT_THAT(subject.catalogue(), IsSupersetOf({"spin-friction", "shaft-contraction"}));
  for (const Candidate& c : candidates) {
    SCOPED_TRACE(c.id);
    ASSERT_LT(c.size, c.parameters.size());
    const Parameter& size = c.parameters[c.size];
    EXPECT_TRUE(std::isfinite(size.neutral));
    EXPECT_TRUE(size.name.starts_with(c.id + "."));
    EXPECT_FALSE(c.short_name(c.size).empty());
    EXPECT_FALSE(c.of_the_user);
    for (const Parameter& p : c.parameters) {
      EXPECT_EQ(p.start, p.initial);
      EXPECT_GT(p.scale, 0.0);
      EXPECT_LE(p.plausible_upper, p.upper);
    }
    EXPECT_EQ(c.base_law, c.id == "viscous-exponent" || c.id == "load-exponent");
  }
}

TEST(RigSubject, SwitchesCandidatesOnAtTheirInitialValues) {
  const RigSubject subject(synthetic_model());
  const std::vector<std::string> wanted{"windage", "spin-friction"};
  const auto with = subject.with_candidates(wanted);
  const std::vector<effects::Effect>& effects = model_of(*with).effects;
  ASSERT_EQ(effects.size(), 2U);
  EXPECT_EQ(effects[0].description->id, "windage");
  EXPECT_EQ(effects[1].values, effects::initial_values(*effects[1].description));
  EXPECT_THAT(names(*with), ElementsAre("f0", "z", "y", "windage.torque_at_10000_rpm_Nmm",
                                        "spin-friction.friction_coefficient"));
  EXPECT_THAT(ids(with->candidates()), Not(Contains("windage")));
  EXPECT_THAT(model_of(subject).effects, IsEmpty());
}

TEST(RigSubject, RefusesWhatIsNoCandidate) {
  const RigSubject subject(with_effect(synthetic_model(), "spin-friction", {0.06}));
  EXPECT_EQ(refusal(subject, {"spin-friction"}),
            "spin-friction: the model already has this effect");
  EXPECT_EQ(refusal(subject, {"law:palmgren"}), "law:palmgren: the model already has this law");
  EXPECT_EQ(refusal(subject, {"windage", "windage"}), "windage is listed twice");
  EXPECT_EQ(refusal(subject, {"shaft-contraction"}),
            "shaft-contraction: this effect does not change the measured friction torque");
  EXPECT_THAT(refusal(subject, {"windge"}),
              HasSubstr("unknown effect \"windge\"; nearest: windage"));
}

TEST(RigSubject, KeepsAnEffectOfTheUsersOwnInWaitingUntilItIsTried) {
  const Model model = with_mine(0.0);
  const RigSubject subject(model);
  const Record record = plan();
  EXPECT_THAT(names(subject), Not(Contains("of-mine.c")));
  EXPECT_THAT(subject.catalogue(), Contains("of-mine"));
  const std::vector<Candidate> candidates = subject.candidates();
  const auto mine = std::find_if(candidates.begin(), candidates.end(),
                                 [](const Candidate& c) { return c.id == "of-mine"; });
  ASSERT_NE(mine, candidates.end());
  EXPECT_TRUE(mine->of_the_user);
  EXPECT_EQ(mine->short_name(mine->size), "c");
  EXPECT_EQ(predict(subject, record),
            predict(RigSubject(with_effect(synthetic_model(), "spin-friction", {0.06})), record));
  // Tried, it is where its file has it, and so are all others.
  const std::vector<std::string> wanted{"of-mine"};
  const auto with = subject.with_candidates(wanted);
  const std::vector<NamedValue> size{{"of-mine.c", 3.0},
                                     {"spin-friction.friction_coefficient", 0.05}};
  const Model tried = model_of(*with->with_values(size));
  EXPECT_EQ(tried.effects[0].values, (std::vector{3.0, 1.5}));
  EXPECT_EQ(tried.effects[1].values, (std::vector{0.05}));
  for (const Subject* const s : std::initializer_list<const Subject*>{&subject, with.get()})
    EXPECT_EQ(find_parameters(*s, {"spin-friction.friction_coefficient"})[0].addresses,
              std::vector<std::string>{"effect.1.friction_coefficient"});
  EXPECT_THAT(ids(with->candidates()), Not(Contains("of-mine")));
  EXPECT_GT(predict(*with->with_values(size), record)[3], predict(subject, record)[3]);
}

TEST(RigSubject, HasAnEffectOfTheUsersOwnThatIsInUseOrFree) {
  EXPECT_THAT(names(RigSubject(with_mine(2.0))), Contains("of-mine.c"));
  Model free = with_mine(0.0);
  free.free = {"f0", "of-mine.c"};
  EXPECT_THAT(names(RigSubject(free)), Contains("of-mine.c"));
  EXPECT_THAT(RigSubject(free).free(), ElementsAre("f0", "of-mine.c"));
  EXPECT_THAT(RigSubject(synthetic_model()).free(), ElementsAre("f0", "z"));
}

TEST(RigSubject, SaysWhatAnEffectLacks) {
  const RigSubject subject(synthetic_model());
  const Record record = plan();
  EXPECT_THAT(subject.lacks("torque-time-drift", record), HasSubstr("time_s"));
  EXPECT_THAT(subject.lacks("windage", record), IsEmpty());
  EXPECT_THAT(subject.lacks("shaft-contraction", record), HasSubstr("axial displacement"));
  const Record one_load = factorial_plan({500, 2000}, {100}, {30});
  EXPECT_THAT(subject.lacks_levels("spin-friction", one_load), HasSubstr("more than one load"));
}

TEST(RigSubject, HasTheToleranceOfItsModel) {
  Model model = synthetic_model();
  EXPECT_TRUE(std::isnan(RigSubject(model).measured()[0].tolerance));
  model.tolerances = {{"axial_displacement_um", 1.0 * um}, {"friction_torque_Nmm", 5.0 * N_mm}};
  const std::vector<Measured> measured = RigSubject(model).measured();
  ASSERT_EQ(measured.size(), 1U);
  EXPECT_EQ(*measured[0].channel, record::friction_torque);
  EXPECT_EQ(measured[0].tolerance, 5.0 * N_mm);
  EXPECT_EQ(measured[0].floor, 0.05);
}

TEST(RigSubject, TakesTorqueAlone) {
  const RigSubject subject(synthetic_model());
  EXPECT_NO_THROW(subject.require(plan()));
  DataSet shaft = plan();
  shaft.quantity = Quantity::axial_displacement;
  EXPECT_THROW(subject.require(shaft), std::invalid_argument);
  EXPECT_THROW(RigSubject{two_against_one()}, std::invalid_argument);
}

TEST(RigSubject, SaturatesWithACubicThatTakesInAVaryingRadialLoad) {
  const RigSubject subject(synthetic_model());
  DataSet data = plan();
  const Saturation s = subject.saturation(data);
  EXPECT_EQ(s.surface.inputs.size(), 3U);
  EXPECT_EQ(s.surface.terms.size(), 15U);
  EXPECT_THAT(s.levels, ElementsAre(&record::speed, &record::axial_load));
  EXPECT_TRUE(s.levels_before_candidates && s.proportional);
  // The floor of a logarithm: a hundredth of the largest.
  data.rows[0].point.axial_load = 0.0;
  EXPECT_NEAR(subject.saturation(data).surface.inputs[1].values[0], std::log(9.0), 1e-12);
  for (std::size_t i = 0; i < data.rows.size(); ++i)
    data.rows[i].point.radial_load = i % 2 == 0 ? 50.0 : 200.0;
  const Saturation with_radial = subject.saturation(data);
  EXPECT_EQ(with_radial.surface.inputs.size(), 4U);
  EXPECT_EQ(with_radial.surface.terms.size(), 19U);
  for (const std::vector<int>& term : with_radial.surface.terms) EXPECT_EQ(term.size(), 4U);
  EXPECT_THAT(with_radial.levels, Contains(&record::radial_load));
}

TEST(RigSubject, SaturatesWithWhateverElseVaries) {
  const RigSubject subject(synthetic_model());
  Record record = plan();
  const std::size_t inputs = subject.saturation(record).surface.inputs.size();
  const std::size_t levels = subject.saturation(record).levels.size();
  std::vector<double> preload, warm;
  for (std::size_t i = 0; i < record.rows(); ++i) {
    preload.push_back(i % 2 == 0 ? 200.0 : 400.0);
    warm.push_back(kelvin(30.0 + static_cast<double>(i % 7)));
  }
  record.set(record::preload, preload);
  record.set(record::outer_ring_temperature, warm);
  const fit::Saturation s = subject.saturation(record);
  EXPECT_EQ(s.surface.inputs.size(), inputs + 2);
  EXPECT_EQ(s.levels.size(), levels + 1);  // a ring temperature is nobody's setting
  for (const std::vector<int>& term : s.surface.terms) EXPECT_EQ(term.size(), inputs + 2);
  // The same everywhere: nothing to look for.
  record.set(record::preload, std::vector<double>(record.rows(), 200.0));
  EXPECT_EQ(subject.saturation(record).surface.inputs.size(), inputs + 1);
}

TEST(RigSubject, ProposesPointsWithinWhatWasMeasured) {
  const RigSubject subject(synthetic_model());
  const std::vector<Axis> axes = subject.axes(plan());
  ASSERT_EQ(axes.size(), 4U);
  EXPECT_EQ(axes[0].levels.size(), 7U);
  EXPECT_NEAR(axes[0].levels.front(), 500 * rpm, 1e-9);
  EXPECT_NEAR(axes[0].levels.back(), 12000 * rpm, 1e-9);
  EXPECT_EQ(axes[1].levels.size(), 5U);
  EXPECT_EQ(axes[2].levels, std::vector{0.0});
  EXPECT_FALSE(axes[2].told);
  EXPECT_EQ(axes[3].levels.size(), 4U);
  EXPECT_EQ(subject.words(std::vector<Setting>{{&record::speed, 995 * rpm},
                                               {&record::axial_load, 100.0},
                                               {&record::temperature, kelvin(40)}}),
            "995 rpm, 100 N, 40 C");
  EXPECT_EQ(subject.words(std::vector<Setting>{{&record::speed, 995 * rpm},
                                               {&record::axial_load, 100.0},
                                               {&record::radial_load, 50.0},
                                               {&record::temperature, kelvin(40)}}),
            "995 rpm, 100 N, 40 C, 50 N radial load");
}

TEST(RigSubject, WritesAFormulaForOneBearingOfTheRig) {
  Model model = synthetic_model();
  model.rig.bearings = 2;
  const std::optional<Formula> formula = RigSubject(model).formula(plan());
  ASSERT_TRUE(formula.has_value());
  EXPECT_EQ(formula->factor, 2.0 * N_mm);
  ASSERT_EQ(formula->inputs.size(), 3U);
  EXPECT_NEAR(formula->inputs[0].values[0], 500.0, 1e-9);
  EXPECT_EQ(formula->inputs[1].values[0], 100.0);
  EXPECT_NEAR(formula->inputs[2].values[0],
              model.lubricant.kinematic_viscosity(kelvin(30)) / mm2_per_s, 1e-9);
}

TEST(RigSubject, TellsAReaderWhatTheModelStandsInFor) {
  Model model = synthetic_model();
  model.rig.radial_load = 7.0;
  const Expected expected = RigSubject(model).expected();
  const auto value = [&](const record::Channel& channel) {
    for (const Expected::Default& d : expected.defaults)
      if (*d.channel == channel) return d.value;
    return -1.0;
  };
  EXPECT_TRUE(std::isnan(value(record::axial_load))) << "has to be given";
  EXPECT_EQ(value(record::radial_load), 7.0);
  EXPECT_EQ(value(record::temperature), kelvin(40));
  EXPECT_FALSE(expected.coast_down);
  model.rig.inertia = 0.85;
  EXPECT_TRUE(RigSubject(model).expected().coast_down);
}

TEST(RigSubject, OnACoastDownTheAirDragsOnTheRotorOnce) {
  // c (n/10 000 rpm)^1.8 at that speed is c; all else of the model is the same.
  model::Model model = synthetic_model();
  model.effects.push_back({.description = effects::find("windage"), .values = {60.0}});
  model::Model still = model;
  still.effects.clear();
  const bearing::OperatingPoint point{.speed = 10000 * rpm, .axial_load = 100.0};
  for (const int bearings : {1, 2, 5})
    for (const int kind : {0, 1, 2}) {
      for (model::Model* m : {&model, &still}) {
        m->rig.bearings = bearings;
        m->rig.inertia = kind == 1 ? 0.85 : unset;
        m->rig.unknown_inertia = kind == 2;
      }
      const double air = model::predict_friction(model, point).reading -
                         model::predict_friction(still, point).reading;
      EXPECT_NEAR(air, (kind == 0 ? bearings : 1) * 60.0 * N_mm, 1e-9) << bearings << kind;
    }
}

}  // namespace
}  // namespace raceway::fit
