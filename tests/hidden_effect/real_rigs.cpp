#include "tests/hidden_effect/real_rigs.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/hidden_effect/bars.h"

namespace hidden_effect {
namespace {

bool alarm(const Outcome& o) { return o.alarm(); }
bool found(const Outcome& o) { return o.alarm() && o.answer.verdict != "failed"; }
bool right(const Outcome& o) { return o.names_a_right(); }
bool is_exact(const Outcome& o) { return o.exact(); }
bool not_quiet(const Outcome& o) { return o.is({"effect", "several-effects"}); }
bool quiet(const Outcome& o) { return !o.alarm(); }
bool names_hidden(const Outcome& o) { return o.is({"effect", "ambiguous"}) && o.names_a_right(); }
bool single_wrong(const Outcome& o) { return o.is({"effect"}) && !o.names_a_right(); }
bool whole(const Outcome& o) { return o.is({"several-effects"}) && o.names_every_hidden(); }
bool excludes(const Outcome& o) {
  return o.is({"effect", "ambiguous"}) || (o.is({"several-effects"}) && !o.names_every_hidden());
}
bool says_size(const Outcome& o) { return o.size_held.has_value(); }
bool holds_size(const Outcome& o) { return *o.size_held; }
bool names_radial_load(const Outcome& o) {
  return o.answer.shape.find("radial_load") != std::string::npos;
}
bool names_data(const Outcome& o) { return o.names_data(); }

constexpr std::array<Demand, 2> few_alarms(double must, double good) {
  return {{{"false alarm", false, must, good, alarm},
           {"a datum that is right in the verdict", false, 5, 0, names_data}}};
}
constexpr auto quiet_2 = few_alarms(2, 1), quiet_3 = few_alarms(3, 1.5), quiet_4 = few_alarms(4, 2),
               quiet_5 = few_alarms(5, 2), quiet_5_3 = few_alarms(5, 3),
               quiet_20 = few_alarms(20, 5);
constexpr std::array<Demand, 2> logger_quiet{
    {{"nothing missing", true, 95, 98, quiet}, {"a single wrong name", false, 0, 0, not_quiet}}};
constexpr std::array<Demand, 2> logger_named{{{"the right name", true, 90, 98, names_hidden},
                                              {"a single wrong name", false, 0, 0, single_wrong}}};
constexpr std::array<Demand, 2> grows_much{
    {{"nothing missing", true, 85, 95, quiet}, {"a single wrong name", false, 0, 0, not_quiet}}};
constexpr std::array<Demand, 2> named{
    {{"names the card", true, 80, 95, right}, {"a single wrong name", false, 5, 0, single_wrong}}};
constexpr std::array<Demand, 2> radial_found{
    {{"found", true, 95, 99, found},
     {"the shape names the load", true, 95, 99, names_radial_load}}};
constexpr std::array<Demand, 2> in_verdict{{{"the right name in the verdict", true, 95, 99, right},
                                            {"a single wrong name", false, 5, 0, single_wrong}}};
constexpr std::array<Demand, 3> few_rows{{{"found", true, 90, 99, found},
                                          {"the right name in the verdict", true, 80, 95, right},
                                          {"a single wrong name", false, 5, 0, single_wrong}}};
constexpr std::array<Demand, 1> exactly{{{"effect", true, 90, 100, is_exact}}};
constexpr std::array<Demand, 1> all_found{{{"found", true, 98, 99, found}}};
constexpr std::array<Demand, 2> triple{
    {{"all three named", true, 50, 80, whole},
     {"fewer than three, as if that were all", false, 10, 2, excludes}}};

bool asked(const Outcome& o) { return !o.answer.questions.empty(); }
bool honest(const Outcome& o) {
  return o.is({"not-in-catalogue", "effect-like", "ambiguous", "several-effects"});
}
bool says_palmgren(const Outcome& o) { return o.answer.other_law == "palmgren"; }
bool says_skf(const Outcome& o) { return o.answer.other_law == "skf"; }
bool says_contact(const Outcome& o) { return o.answer.other_law == "contact"; }
bool says_a_law(const Outcome& o) { return !o.answer.other_law.empty(); }
bool shape_alone(const Outcome& o) {
  return o.is({"effect"}) && o.answer.names.front() == "gyroscopic-slip";
}
/// In the verdict, or in that with another law.
bool constant_found(const Outcome& o) {
  const auto names = [](const std::vector<std::string>& list, const char* id) {
    return std::find(list.begin(), list.end(), id) != list.end();
  };
  for (const char* id : {"seal-friction", "torque-offset"})
    if (names(o.answer.names, id) || names(o.answer.names_given_it, id)) return true;
  return false;
}

constexpr std::array<Demand, 3> quiet_lab{
    {{"false alarm", false, 2, 1, alarm},
     {"asked about a unit", false, 5, 1, asked},
     {"a datum that is right in the verdict", false, 5, 0, names_data}}};
constexpr std::array<Demand, 1> asked_first{
    {{"asked about before the verdict", true, 100, 100, asked}}};
constexpr std::array<Demand, 3> offered(bool (*says)(const Outcome&)) {
  return {{{"honest", true, 95, 100, honest},
           {"says which law explains the data", true, 80, 100, says},
           {"asked about a unit", false, 5, 1, asked}}};
}
constexpr auto offered_palmgren = offered(says_palmgren), offered_skf = offered(says_skf),
               offered_contact = offered(says_contact);
constexpr std::array<Demand, 2> no_law{
    {{"honest", true, 95, 100, honest}, {"a law is said to explain it", false, 5, 0, says_a_law}}};
constexpr std::array<Demand, 1> constant{{{"the constant is named", true, 70, 90, constant_found}}};
constexpr std::array<Demand, 2> data_named{{{"the right name in the verdict", true, 80, 95, right},
                                            {"a single wrong name", false, 0, 0, single_wrong}}};
constexpr std::array<Demand, 2> data_named_85{
    {{"the right name in the verdict", true, 85, 95, right},
     {"a single wrong name", false, 0, 0, single_wrong}}};
constexpr std::array<Demand, 1> sized{
    {{"if it is named, the interval holds its size", true, 90, 95, holds_size, says_size}}};
constexpr std::array<Demand, 2> oils_named{{{"the right name", true, 85, 95, names_hidden},
                                            {"a single wrong name", false, 0, 0, single_wrong}}};
constexpr std::array<Demand, 2> oils_quiet{
    {{"nothing missing", true, 85, 95, quiet}, {"a single wrong name", false, 0, 0, not_quiet}}};
constexpr std::array<Demand, 3> quiet_90{
    {{"nothing missing", true, 90, 98, quiet},
     {"a single wrong name", false, 0, 0, not_quiet},
     {"a datum that is right in the verdict", false, 5, 0, names_data}}};
constexpr std::array<Demand, 3> quiet_95{
    {{"nothing missing", true, 95, 98, quiet},
     {"a single wrong name", false, 0, 0, not_quiet},
     {"a datum that is right in the verdict", false, 5, 0, names_data}}};
constexpr std::array<Demand, 1> not_alone{{{"gyroscopic slip alone", false, 0, 0, shape_alone}}};

constexpr std::array<std::string_view, 1> slope{"viscosity-slope"}, gain{"temperature-gain"},
    offset{"temperature-offset"};
constexpr std::array<std::string_view, 2> preload{"set-preload", "load-offset"};
constexpr std::array<std::string_view, 1> cell{"load-cell-drift"}, creep{"torque-creep"},
    hysteresis{"speed-hysteresis"};
constexpr std::array<std::string_view, 4> supports{"support-bearings", "rig-viscous-drag",
                                                   "torque-offset", "seal-friction"};
constexpr std::array<std::string_view, 2> oil{"lubricant-viscosity", "viscosity-slope"};
constexpr std::span<const std::string_view> none{};

Setup on(Plan plan, Noise noise = Noise::independent, NoiseDetail detail = {}, int rows = 0,
         Mistake mistake = {}) {
  return {.plan = plan, .noise = noise, .detail = detail, .rows = rows, .mistake = mistake};
}

Setup hiding(Setup setup, std::vector<Wish> wishes) {
  setup.hidden = std::move(wishes);
  return setup;
}

std::vector<RealRig> make_real_rigs() {
  const Noise independent = Noise::independent;
  const auto few = [](int rows) { return on(Plan::factorial, independent, {}, rows); };
  const auto level = [](double share) {
    return on(Plan::factorial, independent, {.level = share});
  };
  const auto outliers = [](bool one_sided) {
    return on(Plan::factorial, Noise::outliers, {.outlier_share = 0.1, .one_sided = one_sided});
  };
  const auto offsets = [](Plan plan, double size, double within, bool declared) {
    return on(plan, Noise::run_offsets, {.level = within, .offset = size}, 0,
              {.runs_left_out = !declared});
  };
  const auto logs = [](double row, double correlation, double point, double warming) {
    Setup setup = on(Plan::one_stairs, independent, {}, 0, {.runs_left_out = true});
    setup.logger = {.rows = 40,
                    .row_scatter = row,
                    .correlation = correlation,
                    .point_scatter = point,
                    .warming = warming};
    return setup;
  };
  const auto grows = [](double lowest, double highest, bool straight) {
    return on(Plan::stairs, Noise::run_offsets,
              {.level = highest, .offset = 0.0, .at_lowest = lowest, .straight = straight});
  };
  // As a test lab works: 1 % of a row, 1 % of a run.
  const auto lab = [](BaseLaw law = {}, Believed believed = Believed::as_it_is,
                      Mistake mistake = {}) {
    Setup setup = on(Plan::lab, Noise::run_offsets, {.level = 0.01, .offset = 0.01}, 0, mistake);
    setup.law = law;
    setup.believed = believed;
    return setup;
  };
  const BaseLaw palmgren{}, skf{.formula = Formula::skf}, houpert{.formula = Formula::houpert},
      houpert_balls{.formula = Formula::houpert, .by_ball_loads = true}, contacts{.contacts = true};
  // The same with four loads, each of them in two runs.
  const auto twice = [](Mistake mistake, Plan plan = Plan::stairs) {
    return on(plan, Noise::run_offsets, {.level = 0.01, .offset = 0.01}, 0, mistake);
  };
  const auto wrong = [](Mistake mistake) {
    return on(Plan::factorial, independent, {}, 0, mistake);
  };
  return {
      {"noise 3 %", level(0.03), 4, none, quiet_2},
      {"noise 5 %", level(0.05), 4, none, quiet_2},
      {"16 rows", few(16), 6, none, quiet_3},
      {"20 rows", few(20), 6, none, quiet_3},
      {"30 rows", few(30), 6, none, quiet_3},
      {"std declared", wrong({.std_declared = true}), 4, none, quiet_2},
      {"8 rows, std declared", on(Plan::factorial, independent, {}, 8, {.std_declared = true}), 6,
       none, quiet_3},
      {"11 rows, std declared",
       hiding(on(Plan::factorial, independent, {}, 11, {.std_declared = true}),
              {{"windage", 0.15}}),
       4, none, few_rows},
      {"outliers 10 %", outliers(false), 4, none, quiet_4},
      {"outliers 10 %, one-sided", outliers(true), 4, none, quiet_4},
      {"run offsets 3 %", offsets(Plan::factorial, 0.03, 0.02, true), 4, none, quiet_4},
      {"run per load, 1 %", offsets(Plan::run_per_load, 0.01, 0.01, true), 4, none, quiet_5},
      {"run per load, 3 %", offsets(Plan::run_per_load, 0.03, 0.01, true), 4, none, quiet_5},
      {"3 run-ups per load, declared", offsets(Plan::run_ups, 0.03, 0.02, true), 4, none, quiet_5},
      {"3 run-ups per load, undeclared", offsets(Plan::run_ups, 0.03, 0.02, false), 4, none,
       quiet_20},
      {"in order, AR 0.9", on(Plan::in_order, Noise::autoregressive, {.correlation = 0.9}), 4, none,
       quiet_5_3},
      {"temperature scatters 1 K", wrong({.sensor_scatter = 1.0}), 4, none, quiet_5_3},
      {"temperature scatters 1.5 K", wrong({.sensor_scatter = 1.5}), 4, none, quiet_5_3},
      {"oil card 6.4 for 5.9", wrong({.viscosity_40 = 32.0, .viscosity_100 = 6.4}), 2, slope,
       named},
      {"oil grade 46 for 32", wrong({.viscosity_40 = 46.0, .viscosity_100 = 6.8}), 2, oil, named},
      {"sensor sees 60 % of the rise", wrong({.rise_seen = 0.6}), 2, gain, named},
      {"sensor 5 K low", wrong({.sensor_offset = -5.0}), 2, offset, named},
      {"sensor 5 K high", wrong({.sensor_offset = 5.0}), 2, offset, named},
      {"radial load 10 %", hiding(on(Plan::radial), {{"radial-drag", 0.1}}), 3, none, radial_found},
      {"20 000 rows", hiding(on(Plan::cycling), {{"lubricant-drag", 0.1}}), 1, none, exactly},
      {"inlet heating 2 %", hiding(on(Plan::factorial), {{"inlet-shear-heating", 0.02}}), 2, none,
       in_verdict},
      {"inlet heating 3 %", hiding(on(Plan::factorial), {{"inlet-shear-heating", 0.03}}), 2, none,
       in_verdict},
      {"as large as stated", on(Plan::factorial), 10, none, all_found, true},
      {"three effects",
       hiding(on(Plan::factorial),
              {{"spin-friction", 0.1}, {"windage", 0.08}, {"film-self-heating", 0.1}}),
       2, none, triple},
      // At the end, so that the others keep their seeds.
      {"lab stairs, 1 % and 1 % per run", offsets(Plan::stairs, 0.01, 0.01, true), 8, none,
       quiet_2},
      {"logger, rows correlated 15 s", logs(0.01, 15.0, 0.0, 0.0), 8, none, logger_quiet},
      {"logger, 15 s, states 1.5 %", logs(0.01, 15.0, 0.015, 0.0), 8, none, logger_quiet},
      {"logger, white rows, states 1 %", logs(0.02, 0.0, 0.01, 0.0), 8, none, logger_quiet},
      {"logger, warms by 3 K at each state", logs(0.01, 15.0, 0.01, 3.0), 8, none, logger_quiet},
      {"logger, drag 10 %", hiding(logs(0.01, 15.0, 0.0, 0.0), {{"lubricant-drag", 0.1}}), 4, none,
       logger_named},
      {"logger, drag 10 %, states 1.5 %",
       hiding(logs(0.01, 15.0, 0.015, 0.0), {{"lubricant-drag", 0.1}}), 4, none, logger_named},
      {"scatter 0.4 to 5 %, a power of speed", grows(0.004, 0.05, false), 8, none, grows_much},
      {"scatter 0.4 to 5 %, straight", grows(0.004, 0.05, true), 8, none, grows_much},
      {"scatter 0.5 to 2 %", grows(0.005, 0.02, false), 8, none, logger_quiet},
      {"scatter 0.5 to 2 %, straight", grows(0.005, 0.02, true), 8, none, logger_quiet},
      {"lab plan", lab(), 8, none, quiet_lab},
      {"lab plan, F read as C", lab({}, Believed::as_it_is, {.in_fahrenheit = true}), 3, none,
       asked_first},
      {"lab plan, kgf read as N", lab({}, Believed::as_it_is, {.in_kilograms = true}), 3, none,
       asked_first},
      {"law palmgren, is skf", lab(skf), 3, none, offered_skf},
      {"law palmgren, is of contacts", lab(contacts, Believed::palmgren), 3, none, offered_contact},
      {"law palmgren, is none of ours", lab(houpert), 3, none, no_law},
      {"law skf, is palmgren", lab(palmgren, Believed::skf), 3, none, offered_palmgren},
      {"law skf, is of contacts", lab(contacts, Believed::skf), 3, none, offered_contact},
      {"law contact, is palmgren", lab(palmgren, Believed::contacts), 1, none, offered_palmgren},
      {"law contact, is skf", lab(skf, Believed::contacts), 1, none, offered_skf},
      {"none of ours and a constant of 30 %", hiding(lab(houpert), {{"torque-offset", 0.3}}), 3,
       none, constant},
      {"preload grows with speed", hiding(lab(), {{"ring-growth-stiffening", 0.1}}), 3, none,
       not_alone},
      {"pair in O", twice({.pair_preload = 1500.0}), 3, preload, data_named},
      {"pair in O, preload grows with speed",
       twice({.pair_preload = 1500.0, .preload_grows = true}), 3, preload, data_named},
      {"load cell drifts 0.4 %/K", twice({.cell_drift = 0.004}), 3, cell, data_named},
      {"support bearings in the reading", twice({.support_constant = 0.1, .support_viscous = 0.2}),
       3, supports, data_named_85},
      {"zero creeps over each day", twice({.creep = 0.06}), 3, creep, data_named_85},
      {"zero reset before each run, undeclared", twice({.runs_left_out = true, .reset = 0.03}), 3,
       none, quiet_90},
      {"single pass, no run, no clock",
       twice({.runs_left_out = true, .clock_left_out = true}, Plan::one_stairs), 8, none, quiet_95},
      {"speeds up and down, hysteresis", twice({.hysteresis = 0.04}, Plan::up_and_down), 3,
       hysteresis, data_named_85},
      {"speeds up and down", twice({}, Plan::up_and_down), 8, none, quiet_lab},
      {"two oils, drag 10 %",
       hiding(twice({.second_oil = true}, Plan::one_stairs), {{"lubricant-drag", 0.1}}), 3, none,
       oils_named},
      {"two oils, nothing missing", twice({.second_oil = true}, Plan::one_stairs), 3, none,
       oils_quiet},
      {"none of ours, of ball loads", lab(houpert_balls), 3, none, no_law},
      {"none of ours, of ball loads, and a constant of 30 %",
       hiding(lab(houpert_balls), {{"torque-offset", 0.3}}), 3, none, constant},
      {"lab plan, load offset 10 %", hiding(lab(), {{"load-offset", 0.1}}), 3, none, sized},
      {"lab plan, spin friction 10 %", hiding(lab(), {{"spin-friction", 0.1}}), 3, none, sized},
      {"logger, load offset 10 %", hiding(logs(0.01, 15.0, 0.0, 0.0), {{"load-offset", 0.1}}), 3,
       none, sized},
      {"logger, spin friction 10 %", hiding(logs(0.01, 15.0, 0.0, 0.0), {{"spin-friction", 0.1}}),
       3, none, sized},
  };
}

}  // namespace

std::span<const RealRig> real_rigs() {
  static const std::vector<RealRig> all = make_real_rigs();
  return all;
}

const RealRig& real_rig(std::string_view id) {
  for (const RealRig& r : real_rigs())
    if (r.id == id) return r;
  throw std::out_of_range("no kind of rig " + std::string(id));
}

}  // namespace hidden_effect
