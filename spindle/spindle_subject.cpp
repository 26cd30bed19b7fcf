#include "spindle/spindle_subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "model/row.h"
#include "record/spindle_channel.h"
#include "spindle/layout.h"
#include "spindle/record_rows.h"
#include "spindle/spindle.h"
#include "spindle/thermometer.h"
#include "spindle/warm_start.h"

namespace raceway::spindle {
namespace {

constexpr int parts_of_record = 8;  // of which each is held out

/// What a sensor of the displacement makes of it, beside what moves.
bool acts_on_reading(const effects::Effect& effect) {
  return effect.description->reading != nullptr;
}

/// A run of a record: its rows, and what they ran under.
struct RunRows {
  std::vector<std::size_t> rows{};
  std::vector<ProfileRow> profile{};
  std::optional<WarmStart> past{};  ///< where the run begins warm
  std::vector<double> read{};       ///< displacement, where its zero was set warm [m]
};

/// A run behind others of its record begins one row before its first: what lies between was not
/// recorded.
void begin_soon(RunRows& run, const fit::Record& record) {
  const std::size_t first = run.rows.front();
  if (run.profile.size() < 2 || first == 0 || record.part_of(first) != record.part_of(first - 1))
    return;
  const double begin = 2.0 * run.profile[0].time - run.profile[1].time;
  for (ProfileRow& row : run.profile) row.time -= begin;
}

/// Simulates a run from rest, or from the state in which its past left the spindle.
Run simulated(Simulator& simulator, const RunRows& run, std::span<const double> step_ends = {}) {
  if (!run.past) return simulator.simulate(run.profile, nullptr, step_ends);
  const State start = state_after(simulator, *run.past, run.profile);
  Run result = simulator.simulate(run.profile, &start, step_ends);
  // How warm it was when its zero was set no thermometer tells to a micrometre: the readings do.
  const std::size_t rows = std::min(result.moments.size(), run.read.size());
  double sum = 0.0, count = 0.0;
  for (std::size_t k = 0; k < rows; ++k)
    if (std::isfinite(run.read[k])) {
      sum += result.moments[k].displacement - run.read[k];
      count += 1.0;
    }
  if (count == 0.0) return result;
  for (Moment& moment : result.moments) moment.displacement -= sum / count;
  return result;
}

/// Runs in their order, each from rest at its first row.
std::vector<RunRows> runs_of(const fit::Record& record) {
  std::map<std::pair<std::size_t, int>, std::size_t> places;
  std::vector<RunRows> runs;
  for (std::size_t k = 0; k < record.rows(); ++k) {
    const auto [found, is_new] =
        places.emplace(std::pair(record.part_of(k), record.run_of(k)), runs.size());
    if (is_new) runs.emplace_back();
    runs[found->second].rows.push_back(k);
  }
  for (RunRows& run : runs) {
    run.profile = profile_of(runs.size() > 1 ? record.picked(run.rows) : record);
    begin_soon(run, record);
  }
  return runs;
}

/// Fills in the past of the first run of each part of a record. A later run begins where nobody
/// knows what lies between.
void find_pasts(const model::Model& model, const fit::Record& record, std::vector<RunRows>& runs) {
  if (model.spindle->network) return;
  for (RunRows& run : runs) {
    const std::size_t first = run.rows.front();
    if (first > 0 && record.part_of(first) == record.part_of(first - 1)) continue;
    run.past =
        find_warm_start(model, runs.size() > 1 ? record.picked(run.rows) : record, run.profile);
    if (!run.past || !run.past->zeroed) continue;
    for (const std::size_t row : run.rows)
      run.read.push_back(record.value(record::axial_displacement, row));
  }
}

/// What all simulations of a record share: its runs, and the time steps of the model as it was.
struct SpindleSeries {
  std::vector<RunRows> runs{};
  std::vector<std::vector<double>> step_ends{};  ///< by run; empty where that did not get through
};

std::shared_ptr<const SpindleSeries> series_of(const model::Model& model,
                                               const fit::Record& record) {
  auto series = std::make_shared<SpindleSeries>();
  series->runs = runs_of(record);
  find_pasts(model, record, series->runs);
  for (const RunRows& run : series->runs) {
    Simulator simulator(model);
    Run first = simulated(simulator, run);
    series->step_ends.push_back(first.report.converged() ? std::move(first.step_ends)
                                                         : std::vector<double>());
  }
  return series;
}

/// One spindle simulated again and again.
class SpindlePredictor : public fit::Predictor {
 public:
  SpindlePredictor(const model::Model& model, const fit::Record& record,
                   std::shared_ptr<const SpindleSeries> series,
                   std::vector<model::ParameterPlace> places)
      : model_(model), record_(record), series_(std::move(series)), places_(std::move(places)) {
    if (std::any_of(model_.effects.begin(), model_.effects.end(), acts_on_reading))
      rows_ = model::rows_of(record);
    for (const model::ParameterPlace& p : places_) {
      if (p.sensor()) moved_.push_back(*p.sensor());
      const bool reads =
          p.effect() >= 0 && acts_on_reading(model_.effects[static_cast<std::size_t>(p.effect())]);
      moves_heat_.push_back(!p.sensor() && !reads);
    }
    if (!moved_.empty()) look_around();
  }

  void readings(std::span<const double> values, std::span<double> out) override {
    std::vector<double> heat;
    for (std::size_t k = 0; k < places_.size(); ++k)
      if (moves_heat_[k]) heat.push_back(values[k]);
    try {
      for (std::size_t k = 0; k < places_.size(); ++k) places_[k].set(model_, values[k]);
      if (simulated_.empty() || heat != simulated_for_) simulate();
      simulated_for_ = std::move(heat);
    } catch (const std::invalid_argument&) {
      if (places_.empty()) throw;  // it is the model as it is that cannot be
      simulated_.clear();
      std::fill(out.begin(), out.end(), unset);
      return;
    }
    std::copy(simulated_.begin(), simulated_.end(), out.begin());
    // Heat does not know where a thermometer sits: it is read anew from the cells around it.
    for (const std::size_t s : moved_) read_there(s, out.subspan((1 + s) * record_.rows()));
    for (const effects::Effect& e : model_.effects) {
      if (!acts_on_reading(e)) continue;
      for (std::size_t row = 0; row < record_.rows(); ++row)
        out[row] += e.description->reading(
            {.value = simulated_[row], .point = rows_[row].point, .record = rows_[row].record},
            e.values);
    }
  }

 private:
  /// A thermometer in the middle of each cell of the bodies in which one moves.
  void look_around() {
    mesh_ = make_layout(model_, model_.spindle->cells).mesh;
    place_of_cell_.assign(mesh_.size(), 0);
    using Part = model::ThermometerPlace::Part;
    const auto part_of = [](Body body) {
      return body == Body::shaft ? Part::shaft : body == Body::housing ? Part::housing : Part::ring;
    };
    for (std::size_t k = 0; k < mesh_.size(); ++k) {
      const Cell& cell = mesh_.cells[k];
      if (cell.body == Body::spacer ||
          std::none_of(moved_.begin(), moved_.end(), [&](std::size_t sensor) {
            return model_.spindle->sensors[sensor].part == part_of(cell.body);
          }))
        continue;
      place_of_cell_[k] = probes_.size();
      probes_.push_back({.name = {},
                         .part = part_of(cell.body),
                         .position = 0.5 * (cell.start + cell.end),
                         .radius = cell.middle_radius()});
    }
  }

  /// Fills in what the sensor reads where it sits now.
  void read_there(std::size_t sensor, std::span<double> out) const {
    const Shares shares = thermometer(mesh_, model_.spindle->sensors[sensor]);
    for (std::size_t row = 0; row < record_.rows(); ++row) {
      out[row] = 0.0;
      for (const Share& s : shares)
        out[row] +=
            s.share *
            temperatures_[place_of_cell_[static_cast<std::size_t>(s.cell)] * record_.rows() + row];
    }
  }

  void simulate() {
    const std::size_t rows = record_.rows(), sensors = model_.spindle->sensors.size();
    std::vector<double> all((1 + sensors) * rows, unset);
    temperatures_.assign(probes_.size() * rows, unset);
    model::Model probed = model_;
    probed.spindle->sensors.insert(probed.spindle->sensors.end(), probes_.begin(), probes_.end());
    Simulator simulator(probed);
    for (std::size_t r = 0; r < series_->runs.size(); ++r) {
      const RunRows& run = series_->runs[r];
      Run result = simulated(simulator, run, series_->step_ends[r]);
      if (!result.report.converged() && !series_->step_ends[r].empty())
        result = simulated(simulator, run);  // too large a step for these values
      for (std::size_t i = 0; i < std::min(result.moments.size(), run.rows.size()); ++i) {
        const Moment& moment = result.moments[i];
        all[run.rows[i]] = moment.displacement;
        for (std::size_t s = 0; s < sensors; ++s)
          all[(1 + s) * rows + run.rows[i]] = moment.sensors[s];
        for (std::size_t c = 0; c < probes_.size(); ++c)
          temperatures_[c * rows + run.rows[i]] = moment.sensors[sensors + c];
      }
    }
    simulated_ = std::move(all);
  }

  model::Model model_;
  const fit::Record& record_;
  std::shared_ptr<const SpindleSeries> series_;
  std::vector<model::Row> rows_;  // of what effects on a reading see
  std::vector<model::ParameterPlace> places_;
  std::vector<bool> moves_heat_;
  std::vector<std::size_t> moved_{};               // sensors whose place is fitted
  Mesh mesh_{};                                    // where there are such
  std::vector<model::ThermometerPlace> probes_{};  // in the cells that they may read
  std::vector<std::size_t> place_of_cell_{};       // in probes_
  std::vector<double> temperatures_{};             // of these, by cell and row [K]
  std::vector<double> simulated_, simulated_for_;
};

}  // namespace

SpindleSubject::SpindleSubject(const model::Model& model) : ModelSubject(model) {
  if (!model.spindle) throw std::invalid_argument("the model is not a spindle");
}

SpindleSubject::SpindleSubject(const model::Model& model, std::vector<std::string> waiting)
    : ModelSubject(model, std::move(waiting)) {}

std::unique_ptr<model::ModelSubject> SpindleSubject::make(model::Model model,
                                                          std::vector<std::string> waiting) const {
  return std::unique_ptr<ModelSubject>(new SpindleSubject(model, std::move(waiting)));
}

std::vector<fit::Measured> SpindleSubject::measured() const {
  const model::Spindle& of = *model().spindle;
  std::vector<fit::Measured> list{with_tolerance({.channel = &record::axial_displacement,
                                                  .model_error = of.model_floor_displacement,
                                                  .begins = "room temperature throughout",
                                                  .approximate = true})};
  for (const model::ThermometerPlace& sensor : of.sensors)
    list.push_back(with_tolerance({.channel = &record::sensor_channel(sensor.name),
                                   .model_error = of.model_floor_temperature,
                                   .begins = "room temperature throughout",
                                   .approximate = true}));
  return list;
}

void SpindleSubject::require(const fit::Record& record) const {
  for (const record::Channel* needed : {&record::time, &record::speed})
    if (!record.complete(*needed))
      throw std::invalid_argument(
          fmt::format("{}: a spindle needs {} in every row, because it is simulated over time",
                      record.source, needed->name));
  const std::vector<fit::Measured> all = measured();
  if (std::none_of(all.begin(), all.end(),
                   [&](const fit::Measured& m) { return record.has(*m.channel); })) {
    std::vector<std::string_view> names;
    for (const fit::Measured& m : all) names.push_back(m.channel->name);
    throw std::invalid_argument(
        fmt::format("{}: has no column that the model predicts; the model predicts {}",
                    record.source, fmt::join(names, ", ")));
  }
  (void)runs_of(record);
}

std::shared_ptr<const void> SpindleSubject::prepare(const fit::Record& record) const {
  return series_of(active(), record);
}

std::unique_ptr<fit::Predictor> SpindleSubject::predictor(
    const fit::Record& record, const std::vector<std::string>& names,
    const std::shared_ptr<const void>& prepared) const {
  auto series = std::static_pointer_cast<const SpindleSeries>(prepared);
  if (!series) {
    auto alone = std::make_shared<SpindleSeries>();
    alone->runs = runs_of(record);
    find_pasts(active(), record, alone->runs);
    alone->step_ends.resize(alone->runs.size());
    series = std::move(alone);
  }
  return std::make_unique<SpindlePredictor>(active(), record, std::move(series), places(names));
}

std::vector<std::string> SpindleSubject::warm_starts(const fit::Record& record) const {
  std::vector<RunRows> runs = runs_of(record);
  find_pasts(active(), record, runs);
  std::vector<std::string> statements;
  for (const RunRows& run : runs)
    if (run.past) statements.push_back(run.past->statement());
  return statements;
}

std::vector<fit::Candidate> SpindleSubject::candidates() const {
  std::vector<fit::Candidate> list = ModelSubject::candidates();
  std::erase_if(list, [&](const fit::Candidate& c) {
    const effects::Description* const d = description(c.id);
    return d && d->condition && !d->as_mounted;
  });
  return list;
}

std::vector<std::string> SpindleSubject::catalogue() const {
  std::vector<std::string> ids = ModelSubject::catalogue();
  std::erase_if(ids, [&](const std::string& id) {
    const effects::Description* const d = description(id);
    return d && !d->for_shaft && !d->for_spindle;  // of a rig
  });
  return ids;
}

std::string SpindleSubject::lacks(const std::string& id, const fit::Record& record) const {
  if (std::string need = ModelSubject::lacks(id, record); !need.empty()) return need;
  const effects::Description* const d = description(id);
  if (d && d->condition && !d->as_mounted)
    return "a model of the bearing sets only, without [shaft] and [housing]: a spindle model "
           "already calculates heat and friction";
  if (d && d->spindle && model().spindle->network)
    return "a spindle model with the geometry of its parts instead of [network]";
  return {};
}

std::vector<fit::Blocking> SpindleSubject::blockings(const fit::Record& record) const {
  if (record.rows() < static_cast<std::size_t>(2 * parts_of_record)) return {};
  fit::Blocking blocking{.variable = "time", .block = {}, .blocks = parts_of_record};
  for (std::size_t k = 0; k < record.rows(); ++k)
    blocking.block.push_back(static_cast<int>(k * parts_of_record / record.rows()));
  return {std::move(blocking)};
}

model::Expected SpindleSubject::expected() const {
  model::Expected e;
  e.defaults = {{&record::speed, unset, ""}};
  e.measured = {&record::axial_displacement};
  e.signed_inputs = {&record::axial_load, &record::radial_load, &record::nose_moment};
  return e;
}

}  // namespace raceway::spindle
