#include "tests/spindle_study/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

namespace spindle_study {
namespace {

using nlohmann::json;
using Ids = std::vector<std::string>;

/// For a shell, whatever the folder is called.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Standard output of a command; throws with the end of what it complained of.
std::string output_of(const std::string& command, const std::filesystem::path& complaints) {
  std::FILE* pipe = popen((command + " 2>" + quoted(complaints.string())).c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot start " + command);
  std::string out;
  std::array<char, 4096> buffer;
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    out.append(buffer.data(), n);
  if (pclose(pipe) == 0) return out;
  std::ifstream in(complaints);
  std::string last, next;
  while (std::getline(in, next))
    if (!next.empty()) last = next;
  throw std::runtime_error(last.empty() ? "failed: " + command : last);
}

json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return json::parse(in);
}

/// Of `compare --json` on a record: the worst thermometer, and the displacement. With one channel
/// the document is that channel.
Errors errors_of(const json& comparison) {
  Errors e;
  const json channels =
      comparison.contains("channels") ? comparison.at("channels") : json::array({comparison});
  for (const json& c : channels) {
    if (!c.contains("rmse") || !c.at("rmse").is_number()) continue;
    const double rmse = c.at("rmse");
    const bool length = c.at("unit") == "um";
    double& place = length ? e.displacement : e.temperature;
    place = std::isnan(place) ? rmse : std::max(place, rmse);
  }
  return e;
}

}  // namespace

std::vector<Case> cases_in(const std::filesystem::path& folder,
                           const std::vector<const Class*>& wished) {
  std::vector<Case> cases;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::filesystem::path truth_file = entry.path() / "truth.json";
    if (!std::filesystem::exists(truth_file)) continue;
    const json truth = read_json(truth_file);
    Case c{.name = entry.path().filename().string(), .folder = entry.path()};
    c.hidden = !truth.at("hidden").empty();
    c.kind = c.hidden ? truth.at("hidden").begin().key() : "nothing";
    c.accept = truth.at("accept").get<Ids>();
    c.verdicts = truth.at("verdicts").get<Ids>();
    c.signal = truth.value("signal", nan);
    if (std::any_of(wished.begin(), wished.end(), [&](const Class* w) { return w->id == c.kind; }))
      cases.push_back(std::move(c));
  }
  std::sort(cases.begin(), cases.end(),
            [](const Case& a, const Case& b) { return a.name < b.name; });
  return cases;
}

bool Outcome::right() const {
  if (std::find(of.verdicts.begin(), of.verdicts.end(), verdict) == of.verdicts.end()) return false;
  if (of.accept.empty() || verdict == "nothing-missing") return true;
  return std::any_of(sets.begin(), sets.end(), [&](const Ids& set) {
    return set.size() == 1 &&
           std::find(of.accept.begin(), of.accept.end(), set.front()) != of.accept.end();
  });
}

bool Outcome::wrong_name() const {
  if (verdict != "effect" && verdict != "ambiguous" && verdict != "several-effects") return false;
  return std::none_of(sets.begin(), sets.end(), [&](const Ids& set) {
    return std::any_of(set.begin(), set.end(), [&](const std::string& id) {
      return std::find(of.accept.begin(), of.accept.end(), id) != of.accept.end();
    });
  });
}

Outcome judge(const Case& of, const std::string& raceway) {
  Outcome o{.of = of};
  try {
    const auto file = [&](const char* name) { return (of.folder / name).string(); };
    const std::string program = quoted(raceway) + " ";
    const auto run = [&](const std::string& arguments) {
      return output_of(program + arguments, of.folder / "complaints.txt");
    };
    const auto errors = [&](const std::string& model) {
      return errors_of(json::parse(
          run("compare " + quoted(model) + " " + quoted(file("test.csv")) + " --json")));
    };
    const auto begin = std::chrono::steady_clock::now();
    const json d = json::parse(run("diagnose " + quoted(file("model.toml")) + " " +
                                   quoted(file("train.csv")) + " --json --time-limit 3600"));
    o.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    o.verdict = d.at("verdict");
    o.sentence = d.at("sentence");
    o.sets = d.at("explanations").get<std::vector<Ids>>();
    for (const char* name : {"calibrated.toml", "added.toml"}) std::filesystem::remove(file(name));
    run("calibrate " + quoted(file("model.toml")) + " " + quoted(file("train.csv")) + " -o " +
        quoted(file("calibrated.toml")));
    o.before = errors(file("calibrated.toml"));
    if (o.sets.empty()) return o;
    std::string names;
    for (const std::string& id : o.sets.front()) names += " " + quoted(id);
    run("add " + quoted(file("model.toml")) + names + " --data " + quoted(file("train.csv")) +
        " -o " + quoted(file("added.toml")));
    o.after = errors(file("added.toml"));
  } catch (const std::exception& e) {
    o.failure = e.what();
  }
  return o;
}

std::vector<Outcome> judge_all(const std::vector<Case>& cases, const std::string& raceway,
                               unsigned threads, const std::function<void(const Outcome&)>& done) {
  std::vector<Outcome> outcomes(cases.size());
  std::atomic<std::size_t> next = 0;
  std::mutex telling;
  const auto work = [&] {
    for (std::size_t k = next++; k < cases.size(); k = next++) {
      outcomes[k] = judge(cases[k], raceway);
      const std::scoped_lock lock(telling);
      done(outcomes[k]);
    }
  };
  std::vector<std::thread> workers;
  for (unsigned k = 0; k < threads; ++k) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  return outcomes;
}

std::string line(const Outcome& o) {
  std::string sets;
  for (const Ids& set : o.sets)
    sets += fmt::format("{}{}", sets.empty() ? "" : " | ", fmt::join(set, "+"));
  std::string text = fmt::format("{:<26} signal {:6.2f}  {:<5} {:<17} {}  test {:.2f} K {:.2f} um",
                                 o.of.name, o.of.signal,
                                 o.right()        ? "right"
                                 : o.wrong_name() ? "WRONG"
                                                  : "-",
                                 o.verdict, sets, o.before.temperature, o.before.displacement);
  if (!std::isnan(o.after.displacement))
    text += fmt::format(" -> {:.2f} K {:.2f} um", o.after.temperature, o.after.displacement);
  if (!std::isnan(o.seconds)) text += fmt::format("  {:.0f} s", o.seconds);
  if (!o.failure.empty()) text += "  failed: " + o.failure;
  return text;
}

std::string table(const std::vector<Outcome>& outcomes) {
  struct Count {
    int cases = 0, right = 0, wrong = 0, missed = 0, failed = 0, added = 0;
    double kelvin = 0.0, micron = 0.0;
  };
  std::map<std::string, Count> by_kind;
  for (const Outcome& o : outcomes)
    for (const std::string& kind : {o.of.kind, std::string("~ all")}) {
      Count& c = by_kind[kind];
      ++c.cases;
      c.right += o.right();
      c.wrong += o.wrong_name();
      c.missed += o.of.hidden && o.verdict == "nothing-missing";
      c.failed += !o.failure.empty();
      if (std::isnan(o.after.displacement) || !o.right()) continue;
      ++c.added;
      c.kelvin += o.after.temperature * o.after.temperature;
      c.micron += o.after.displacement * o.after.displacement;
    }
  std::string text = fmt::format("{:<24}{:>6}{:>7}{:>12}{:>8}{:>8}{:>22}\n", "hidden", "cases",
                                 "right", "wrong name", "missed", "failed", "test with right name");
  for (const auto& [kind, c] : by_kind) {
    text += fmt::format("{:<24}{:>6}{:>7}{:>12}{:>8}{:>8}", kind, c.cases, c.right, c.wrong,
                        c.missed, c.failed);
    if (c.added > 0)
      text += fmt::format("{:>10.2f} K {:>7.2f} um", std::sqrt(c.kelvin / c.added),
                          std::sqrt(c.micron / c.added));
    text += "\n";
  }
  return text;
}

}  // namespace spindle_study
