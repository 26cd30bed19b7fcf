#include "session/solve_states.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "files/plausible.h"
#include "fit/problem.h"
#include "model/prediction.h"
#include "record/digits.h"
#include "session/bands.h"
#include "session/judged.h"
#include "session/operating_point.h"
#include "session/shaft_answers.h"
#include "session/solve_point.h"
#include "session/table_columns.h"
#include "text/error.h"
#include "text/names.h"
#include "text/number_range.h"
#include "text/units.h"

namespace raceway::session {
namespace {

constexpr std::size_t block_size = 256;  // states of one task

/// Walks through the elements of an array in the order of the shape.
class Walk {
 public:
  Walk(const NumberArray& array, const std::vector<std::size_t>& shape, std::size_t first)
      : array_(array), shape_(shape), index_(shape.size()) {
    for (std::size_t d = shape.size(); d-- > 0; first /= shape[d]) index_[d] = first % shape[d];
    for (std::size_t d = 0; d < shape.size(); ++d)
      offset_ += static_cast<std::ptrdiff_t>(index_[d]) * array.strides[d];
  }
  double next() {
    double value;
    std::memcpy(&value, array_.data + offset_, sizeof value);  // may stand unaligned
    for (std::size_t d = shape_.size(); d-- > 0;) {
      offset_ += array_.strides[d];
      if (++index_[d] < shape_[d]) break;
      offset_ -= static_cast<std::ptrdiff_t>(shape_[d]) * array_.strides[d];
      index_[d] = 0;
    }
    return value;
  }
  /// "[3, 2]" of the element that next() gives; empty of a single number.
  [[nodiscard]] std::string place() const {
    return index_.empty() ? std::string() : fmt::format("[{}]", fmt::join(index_, ", "));
  }

 private:
  const NumberArray& array_;
  const std::vector<std::size_t>& shape_;
  std::vector<std::size_t> index_;
  std::ptrdiff_t offset_ = 0;
};

using Field = double bearing::OperatingPoint::*;

struct Input {
  std::string_view name;
  NumberArray StateArrays::*array;
  text::NumberRange range;
  Field field;
  double unit, offset;  // to SI
};

const std::vector<Input>& inputs() {
  using Point = bearing::OperatingPoint;
  static const std::vector<Input> all{
      {"speed_rpm", &StateArrays::speed_rpm, text::speed_range, &Point::speed, rpm, 0.0},
      {"axial_load_N", &StateArrays::axial_load_N, text::load_range, &Point::axial_load, 1.0, 0.0},
      {"radial_load_N", &StateArrays::radial_load_N, text::load_range, &Point::radial_load, 1.0,
       0.0},
      {"temperature_C", &StateArrays::temperature_C, text::temperature_range, &Point::temperature,
       1.0, celsius_zero},
      {"moment_y_Nmm", &StateArrays::moment_y_Nmm, text::moment_range, &Point::moment_y, N_mm, 0.0},
      {"moment_z_Nmm", &StateArrays::moment_z_Nmm, text::moment_range, &Point::moment_z, N_mm,
       0.0}};
  return all;
}

/// The same number for the whole array.
bool is_constant(const NumberArray& array) {
  return std::all_of(array.strides.begin(), array.strides.end(),
                     [](std::ptrdiff_t stride) { return stride == 0; });
}

void check(Messages& messages, const Input& input, const StateArrays& states,
           const model::Model& model) {
  const NumberArray& array = states.*input.array;
  if (!array.given() || states.size() == 0) return;
  text::NumberRange range = input.range;
  if (model.shaft && input.array == &StateArrays::axial_load_N) range = text::signed_load_range;
  const double endless = std::numeric_limits<double>::infinity();
  const double most =
      input.array == &StateArrays::speed_rpm ? model::possible_speeds(model).upper / rpm : endless;
  const double least = input.array == &StateArrays::temperature_C
                           ? celsius(model::possible_temperatures(model.lubricant).lower)
                           : -endless;
  const std::size_t count = is_constant(array) ? 1 : states.size();
  Walk walk(array, states.shape, 0);
  bool said = input.array != &StateArrays::temperature_C;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = walk.next();
    const auto name = [&] {
      return std::string(input.name) +
             (count == 1 ? std::string() : Walk(array, states.shape, i).place());
    };
    if (!(value >= range.lower && value <= range.upper)) text::require_range(value, range, name());
    if (value > most) require_possible_speed(model, value * rpm, name());
    if (value < least) require_possible_temperature(model, kelvin(value), name());
    if (said) continue;
    const std::string note = files::looks_like_kelvin(input.name, value);
    said = !note.empty();
    if (said) messages.say(record::note::odd_value(note, {.key = std::string(input.name)}));
  }
}

/// True of an array with a number that is not zero.
bool acts(const NumberArray& array, const StateArrays& states) {
  if (!array.given()) return false;
  Walk walk(array, states.shape, 0);
  for (std::size_t i = 0; i < states.size(); ++i)
    if (walk.next() != 0.0) return true;
  return false;
}

/// What holds where an array is not given, of arrays that are in order.
bearing::OperatingPoint checked(Messages& messages, const files::ModelFile& file,
                                const StateArrays& states) {
  if (!states.speed_rpm.given())
    throw text::InputError("speed_rpm is missing", {.key = "speed_rpm"});
  require_loads(messages, file,
                {.axial_load = states.axial_load_N.given(),
                 .acting_axial_load = acts(states.axial_load_N, states),
                 .radial_load = states.radial_load_N.given(),
                 .moments = states.moment_y_Nmm.given() || states.moment_z_Nmm.given()},
                Wording::arguments);
  const bearing::OperatingPoint otherwise = point_of(file.model);
  for (const Input& input : inputs()) check(messages, input, states, file.model);
  return otherwise;
}

/// Which of all columns are wanted, in the order asked.
std::vector<std::size_t> chosen(const std::vector<std::string>& all,
                                const std::vector<std::string>& wanted) {
  std::vector<std::size_t> places(wanted.empty() ? all.size() : 0);
  std::iota(places.begin(), places.end(), std::size_t{0});
  for (const std::string& name : wanted) {
    const auto found = std::find(all.begin(), all.end(), name);
    if (found == all.end())
      throw text::InputError(
          fmt::format("{}: unknown result; must be one of {}", name, text::listed(all)),
          {.key = name});
    places.push_back(static_cast<std::size_t>(found - all.begin()));
  }
  return places;
}

/// The points of one task, and what becomes of them.
class Block {
 public:
  Block(const StateArrays& states, const bearing::OperatingPoint& otherwise, std::size_t first,
        std::size_t count)
      : points_(count, otherwise) {
    for (const Input& input : inputs()) {
      const NumberArray& array = states.*input.array;
      if (!array.given()) continue;
      Walk walk(array, states.shape, first);
      for (bearing::OperatingPoint& point : points_)
        point.*input.field = walk.next() * input.unit + input.offset;
    }
  }
  /// Row by row, torque before the columns.
  void solve(const model::Model& model, std::size_t columns, const model::Band* band) {
    values_.assign(points_.size() * columns, unset);
    results_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i)
      results_[i].columns = std::span(values_).subspan(i * columns, columns);
    fill_table_line(model, points_, results_, Columns::of_states);
    if (band) fill_band(model, *band, points_, results_);
  }
  [[nodiscard]] const std::vector<bearing::OperatingPoint>& points() const { return points_; }
  [[nodiscard]] const friction::TablePoint& result(std::size_t i) const { return results_[i]; }

 private:
  std::vector<bearing::OperatingPoint> points_;
  std::vector<double> values_;
  std::vector<friction::TablePoint> results_;
};

/// Calls `solve(first, count)` for all states in blocks, on all cores.
template <typename Solve>
void for_blocks(std::size_t size, const Solve& solve) {
  const std::size_t blocks = (size + block_size - 1) / block_size;
  tbb::parallel_for(
      std::size_t{0}, blocks,
      [&](std::size_t b) { solve(b * block_size, std::min(block_size, size - b * block_size)); },
      tbb::simple_partitioner{});
}

/// What an effect must have of every row beside speed, loads and temperature; empty if nothing.
std::string beyond_a_state(const effects::Description& effect) {
  for (const effects::Need need : effect.needs)
    if (need == effects::Need::time || need == effects::Need::ring_temperatures)
      return std::string(effects::text(need));
  for (const record::Channel* channel : effect.channels)
    if (*channel != record::speed && *channel != record::axial_load &&
        *channel != record::radial_load && *channel != record::temperature)
      return effects::text(*channel);
  return {};
}

void require_rig(const files::ModelFile& file) {
  if (file.model.shaft)
    throw text::InputError(file.source +
                               ": the model has an [arrangement]; readings can be predicted only "
                               "for a single bearing on a rig",
                           {.file = file.source, .key = "arrangement"});
  for (const effects::Effect& effect : file.model.effects)
    if (const std::string more = beyond_a_state(*effect.description); !more.empty())
      throw text::InputError(fmt::format("{}: the effect {} needs {}, but a state has only speed, "
                                         "loads, moments and temperature",
                                         file.source, effect.description->id, more),
                             {.file = file.source, .key = std::string(effect.description->id)});
}

}  // namespace

std::size_t StateArrays::size() const {
  return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

std::vector<std::string> state_columns(const model::Model& model) {
  std::vector<std::string> names = table_columns(model, Columns::of_states);
  names.insert(names.begin(), "friction_torque_Nmm");
  return names;
}

bearing::OperatingPoint single_state(Messages& messages, const files::ModelFile& file,
                                     const StateArrays& states) {
  const bearing::OperatingPoint otherwise = checked(messages, file, states);
  if (states.size() != 1)
    throw text::InputError(
        fmt::format("exactly one state is required, but {} are given", states.size()));
  return Block(states, otherwise, 0, 1).points().front();
}

SolvedStates solve_states(Messages& messages, const files::ModelFile& file,
                          const StateArrays& states, const std::vector<std::string>& columns,
                          const std::atomic<bool>* cancelled, const model::Band* band) {
  const bearing::OperatingPoint otherwise = checked(messages, file, states);
  std::vector<std::string> all = state_columns(file.model), wanted = columns;
  if (band)
    for (const std::string& name : band_columns(file.model)) {
      all.push_back(name);
      if (!columns.empty()) wanted.push_back(name);
    }
  const std::vector<std::size_t> places = chosen(all, wanted);
  const std::size_t size = states.size();
  SolvedStates solved;
  std::vector<double> units;
  for (const std::size_t place : places) {
    solved.columns.push_back(all[place]);
    units.push_back(text::column_unit(all[place]));
  }
  solved.values.resize(places.size() * size);
  solved.status.resize(size);
  const JudgedColumns judged(file.model, {all.begin() + 1, all.end()});
  std::vector<model::Judge> found(size / block_size + 1, model::Judge(file.model));
  for_blocks(size, [&](std::size_t first, std::size_t count) {
    if (cancelled && cancelled->load()) throw fit::Cancelled();
    Block block(states, otherwise, first, count);
    block.solve(file.model, all.size() - 1, band);
    for (std::size_t i = 0; i < count; ++i)
      judged.look(block.points()[i], block.result(i).columns, found[first / block_size]);
    for (std::size_t i = 0; i < count; ++i) {
      const friction::TablePoint& result = block.result(i);
      solved.status[first + i] = result.status;
      for (std::size_t c = 0; c < places.size(); ++c)
        solved.values[c * size + first + i] =
            (places[c] == 0 ? result.friction_moment : result.columns[places[c] - 1]) / units[c];
    }
  });
  model::Judge all_blocks(file.model);
  for (const model::Judge& block : found) all_blocks.add(block);
  messages.say(said_of(all_blocks.findings()));
  return solved;
}

SolvedStates solve_state(Messages& messages, const files::ModelFile& file,
                         const StateArrays& states, const model::Band* band) {
  const model::Model& model = file.model;
  const bearing::OperatingPoint point = single_state(messages, file, states);
  SolvedStates solved{.columns = state_columns(model), .values = {}, .status = {}};
  if (band)
    for (std::string& name : band_columns(model)) solved.columns.push_back(std::move(name));
  solved.values.assign(solved.columns.size(), unset);
  friction::TablePoint result{.columns = std::span(solved.values).subspan(1)};
  const PointAnswer answer = solve_point(model, point);
  if (answer.shaft)
    fill_shaft_state(model, *answer.shaft, result);
  else
    fill_state(model, point, answer.friction, result);
  result.status = answer.status;
  messages.say(notes_on_point(model, point, answer));
  if (band) fill_band(model, *band, {&point, 1}, {&result, 1});
  solved.values.front() = result.friction_moment;
  solved.status = {result.status};
  for (std::size_t c = 0; c < solved.columns.size(); ++c)
    solved.values[c] =
        record::with_digits(solved.values[c] / text::column_unit(solved.columns[c]), 15);
  return solved;
}

PredictedStates predict_states(Messages& messages, const files::ModelFile& file,
                               const StateArrays& states) {
  require_rig(file);
  const bearing::OperatingPoint otherwise = checked(messages, file, states);
  const std::size_t size = states.size();
  PredictedStates predicted{std::vector<double>(size), std::vector<bearing::SolveStatus>(size)};
  for_blocks(size, [&](std::size_t first, std::size_t count) {
    const Block block(states, otherwise, first, count);
    std::vector<model::FrictionPrediction> predictions(count);
    model::predict_sweep(file.model, block.points(), predictions);
    for (std::size_t i = 0; i < count; ++i) {
      const model::FrictionPrediction& p = predictions[i];
      predicted.reading_Nmm[first + i] = p.reading / N_mm;
      predicted.status[first + i] =
          p.status() == bearing::SolveStatus::converged && std::isnan(p.reading)
              ? bearing::SolveStatus::not_finite
              : p.status();
    }
  });
  return predicted;
}

}  // namespace raceway::session
