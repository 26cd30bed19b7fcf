#include "tests/correction_study/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "tests/correction_study/recording.h"

namespace correction_study {
namespace {

constexpr int machines_tried = 40, sizes_tried = 5;
constexpr double larger = 1.5;           // from one size to the next
constexpr double matters = 2.0;          // error of the base over the tolerance, at least
constexpr double rival_apart = 1.35;     // error of a rival over that of the right class
constexpr double single_apart = 1.4;     // error of one effect of a pair over that of both
constexpr double pair_apart = 1.25;      // error of another pair over that of the right one
constexpr double outside_apart = 0.6;    // error of any effect over that of the base
constexpr double least_tolerance = 0.6;  // [um]

/// Effects that a rival is looked for among: those with a column or a bend of their own.
constexpr std::array rivals{
    "ambient-drift",     "motor-heat", "second-time-constant",   "feed-axis-heat",
    "cooling-switch",    "sensor-lag", "kinematic-displacement", "speed-dependent-time-constant",
    "thermal-asymmetry", "slow-drift"};

/// Those of them that may be half of a pair.
constexpr std::array halves{"ambient-drift",  "motor-heat", "second-time-constant",
                            "feed-axis-heat", "sensor-lag", "kinematic-displacement",
                            "slow-drift"};

/// Other names for the same: nothing in a record tells them apart for sure.
std::vector<std::string> accepted(const Class& wished) {
  std::vector<std::string> out;
  if (wished.outside) return out;
  out.assign(wished.hidden.begin(), wished.hidden.end());
  if (wished.id == "sensor-lag") out.push_back("second-time-constant");
  if (wished.id == "thermal-asymmetry") out.push_back("speed-dependent-time-constant");
  return out;
}

std::vector<std::string> right_verdicts(const Class& wished) {
  if (wished.hidden.empty()) return {"nothing-missing"};
  if (wished.outside) return {"not-in-catalogue", "effect-like"};
  if (wished.hidden.size() > 1) return {"several-effects"};
  // Evidence without a parameter: no fit takes it away.
  if (wished.id == "sensor-quantisation" || is_wrong_data(wished))
    return {"effect", "ambiguous", "effect-like"};
  return {"effect", "ambiguous"};
}

double rounded_up(double value) { return std::ceil(10.0 * value - 1e-9) / 10.0; }

/// A seed of its own for each class, seed, machine and purpose.
std::uint64_t seed_of(const Class& wished, unsigned seed, int machine, int purpose) {
  std::uint64_t h = 1469598103934665603ULL;  // FNV-1a
  const auto mix = [&](std::uint64_t v) { h = (h ^ v) * 1099511628211ULL; };
  for (const char c : wished.id) mix(static_cast<unsigned char>(c));
  mix(seed);
  mix(static_cast<std::uint64_t>(machine));
  mix(static_cast<std::uint64_t>(purpose));
  return h;
}

Fit right_fit(const Class& wished, const Setup& setup, const Floors& floors, const Signals& train,
              const Signals& test, std::uint64_t seed) {
  if (wished.hidden.empty()) return floors.base();
  if (wished.outside) return floors.with_hidden();
  if (wished.id != "sensor-quantisation" && !is_wrong_data(wished))
    return floors.with(wished.hidden).value();
  Setup fine = setup;
  fine.quantum = 0.1;
  fine.exchanged_with.clear();
  fine.loose_to = fine.loose_from;
  Signals fine_train = signals(fine, record(fine, false, seed));
  fine_train.displacement = train.displacement;
  Signals fine_test = signals(fine, record(fine, true, seed + 1));
  fine_test.displacement = test.displacement;
  return Floors(setup.base, fine_train, fine_test).base();
}

std::string model_text(const Setup& setup, const Truth& truth, Random& random) {
  const Base& base = setup.base;
  const std::string unit = base.power ? "W" : "K";
  std::string out = fmt::format(
      "[correction]\nname = \"{}\"\ndisplacement = \"displacement_z_um\"\ntolerance_um = {:.1f}\n",
      truth.id, truth.tolerance);
  if (setup.noise_declared) out += fmt::format("measurement_std_um = {:.2f}\n", setup.noise);
  out += "\n[[correction.channel]]\nname = \"spindle\"\n";
  out += base.power ? fmt::format(
                          "input = \"power_W\"\nfriction_table = \"friction_table.csv\"\n"
                          "axial_load_N = {:.0f}\n"
                          "temperature_C = \"front_bearing_temperature_C\"\n",
                          setup.plain.load)
                    : "input = \"front_bearing_temperature_C\"\n";
  // Start values, as rough as a user has them.
  const auto section = [&](double gain, double tau) {
    return fmt::format("{{ gain_um_{} = {:.2g}, time_constant_s = {:.0f} }}", unit,
                       random.about(gain, 0.5), 10.0 * std::round(0.1 * random.about(tau, 0.5)));
  };
  out += "sections = [" + section(base.power ? 0.15 : 4.0, 2000.0);
  if (base.sections > 1) out += ", " + section(base.power ? 0.05 : 1.0, 14000.0);
  out += "]\n";
  if (base.feedthrough) out += "feedthrough_um_K = 5.0\n";
  if (base.ambient) {
    const std::string one = "\"ambient_temperature_C\"";
    const std::string two = "[\"ambient_1_temperature_C\", \"ambient_2_temperature_C\"]";
    out += fmt::format(
        "\n[[correction.channel]]\nname = \"ambient\"\ninput = {}\n"
        "sections = [{{ gain_um_K = {:.2g}, time_constant_s = {:.0f} }}]\n",
        setup.columns.ambient == 1 ? one : two, random.about(-2.0, 0.5),
        10.0 * std::round(0.1 * random.about(12000.0, 0.5)));
  }
  return out + "\n[calibration]\nfree = [\"gains\", \"time_constants\", \"offset\"]\n";
}

double rms(const std::vector<double>& values) {
  double mean = 0.0, square = 0.0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  for (const double v : values) square += (v - mean) * (v - mean);
  return std::sqrt(square / static_cast<double>(values.size()));
}

constexpr std::string_view too_small = "too small";

/// The same of two effects at once, where one does not do.
std::string judge_pairs(const Class& wished, const Floors& floors, Truth& truth) {
  const double limit = wished.outside ? 1.2 * truth.tolerance : pair_apart * truth.right.train;
  for (std::size_t i = 0; i < halves.size(); ++i)
    for (std::size_t j = i + 1; j < halves.size(); ++j) {
      const std::vector<std::string_view> pair{halves[i], halves[j]};
      if (std::is_permutation(pair.begin(), pair.end(), wished.hidden.begin(), wished.hidden.end()))
        continue;
      const std::optional<Fit> fit = floors.with(pair);
      if (!fit) continue;
      const std::string name = fmt::format("{}+{}", pair[0], pair[1]);
      truth.rivals[name] = fit->train;
      if (fit->train < limit) return name + " is near";
    }
  return {};
}

/// Errors of all that an answer may weigh; why none is clearly right, or nothing.
std::string judge(const Class& wished, const Floors& floors, Truth& truth) {
  truth.base = floors.base();
  if (wished.hidden.empty()) return {};
  if (std::min(truth.base.train, truth.base.test) < matters * truth.tolerance)
    return std::string(too_small);
  if (is_wrong_data(wished)) return {};  // what else comes near may stand beside it
  const double limit = wished.outside ? outside_apart * truth.base.train
                       : wished.hidden.size() > 1
                           ? std::max(single_apart * truth.right.train, 1.15 * truth.tolerance)
                           : rival_apart * truth.right.train;
  for (const std::string_view id : rivals) {
    const bool other =
        wished.hidden.size() > 1 || wished.outside ||
        std::find(truth.accept.begin(), truth.accept.end(), id) == truth.accept.end();
    if (!other) continue;
    const std::optional<Fit> fit = floors.with({id});
    if (!fit) continue;
    truth.rivals[std::string(id)] = fit->train;
    if (fit->train < limit) return std::string(id) + " is near";
  }
  if (wished.outside || wished.hidden.size() > 1) return judge_pairs(wished, floors, truth);
  return {};
}

}  // namespace

Rig make_rig(const Class& wished, unsigned seed) {
  std::map<std::string, int> flaws;
  for (int machine = 0; machine < machines_tried; ++machine) {
    double size = Random(seed_of(wished, seed, machine, 3)).between(0.55, 1.2);
    for (int attempt = 0; attempt < sizes_tried; ++attempt, size *= larger) {
      const auto of = [&](int purpose) { return seed_of(wished, seed, machine, purpose); };
      Rig rig{.setup = draw_setup(wished, of(0), size)};
      const Recording train = record(rig.setup, false, of(1));
      const Recording test = record(rig.setup, true, of(1) + 1);
      Signals seen = signals(rig.setup, train), seen_later = signals(rig.setup, test);
      if (wished.outside || wished.id == "offset-jump") {
        seen.hidden = hidden_part(rig.setup, false);
        seen_later.hidden = hidden_part(rig.setup, true);
      }
      const Floors floors(rig.setup.base, seen, seen_later);
      Truth& truth = rig.truth;
      truth.id = fmt::format("{}-{}", wished.id, seed);
      truth.hidden.assign(wished.hidden.begin(), wished.hidden.end());
      truth.accept = accepted(wished);
      truth.verdicts = right_verdicts(wished);
      truth.noise = rig.setup.noise;
      truth.right = right_fit(wished, rig.setup, floors, seen, seen_later, of(1));
      Random random(of(2));
      truth.tolerance = std::max(
          least_tolerance,
          rounded_up(random.between(1.4, 1.8) * std::max(truth.right.train, truth.right.test)));
      const std::string flaw = judge(wished, floors, truth);
      if (!flaw.empty()) ++flaws[flaw];
      if (flaw == too_small) continue;
      if (!flaw.empty()) break;
      truth.hidden_rms = wished.hidden.empty() ? 0.0 : rms(hidden_part(rig.setup, false));
      truth.clean_test = test.clean;
      rig.model_toml = model_text(rig.setup, truth, random);
      if (rig.setup.base.power) rig.friction_table_csv = friction_table(rig.setup);
      rig.record_csv = train.csv();
      rig.test_csv = test.csv();
      return rig;
    }
  }
  std::string all;
  for (const auto& [flaw, times] : flaws) all += fmt::format(", {} ({})", flaw, times);
  throw std::runtime_error(fmt::format("{}, seed {}: none of {} machines shows it{}", wished.id,
                                       seed, machines_tried, all));
}

std::string truth_json(const Rig& rig) {
  using nlohmann::ordered_json;
  const Truth& t = rig.truth;
  const auto number = [](double v) { return std::round(1e3 * v) / 1e3; };
  const auto fit = [&](const Fit& f) {
    return ordered_json{{"train", number(f.train)}, {"test", number(f.test)}};
  };
  ordered_json out{{"id", t.id},
                   {"hidden", t.hidden},
                   {"accept", t.accept},
                   {"verdicts", t.verdicts},
                   {"noise_um", number(t.noise)}};
  const auto record = [&](const PlanWish& wish, const std::vector<PlannedRow>& plan) {
    return ordered_json{{"rows", plan.size()}, {"hours", wish.hours}, {"runs", wish.runs}};
  };
  out["base"] = {{"tolerance_um", number(t.tolerance)},
                 {"input", rig.setup.base.power ? "power" : "temperature"},
                 {"sections", rig.setup.base.sections},
                 {"ambient", rig.setup.base.ambient}};
  out["train"] = record(rig.setup.train_wish, rig.setup.train);
  out["train"]["hidden_rms_um"] = number(t.hidden_rms);
  out["test"] = record(rig.setup.test_wish, rig.setup.test);
  for (const double u : t.clean_test) out["test"]["clean_displacement_z_um"].push_back(number(u));
  ordered_json near = ordered_json::array();
  for (const auto& [id, error] : t.rivals)
    near.push_back({{"effect", id}, {"train", number(error)}});
  out["decidable"] = {{"tolerance_um", number(t.tolerance)},
                      {"base", fit(t.base)},
                      {"right", fit(t.right)},
                      {"rivals", near},
                      {"floor_um", number(t.right.test)}};
  return out.dump(1) + "\n";
}

void write_rig(const Rig& rig, const std::filesystem::path& folder) {
  const std::filesystem::path to = folder / rig.truth.id;
  std::filesystem::create_directories(to);
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream out(to / name, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error("cannot write " + (to / name).string());
  };
  write("model.toml", rig.model_toml);
  write("train.csv", rig.record_csv);
  write("test.csv", rig.test_csv);
  write("truth.json", truth_json(rig));
  if (!rig.friction_table_csv.empty()) write("friction_table.csv", rig.friction_table_csv);
}

}  // namespace correction_study
