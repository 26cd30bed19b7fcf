#include "c/raceway.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "c/message_text.h"
#include "c/model_handle.h"
#include "session/solve_states.h"
#include "text/error.h"
#include "text/number_range.h"

namespace {

using namespace raceway;
using c::guarded;
using c::Reply;
using session::NumberArray;

constexpr double most_states = 1e8;  // as of a table of the command
constexpr std::array names{"speed_rpm", "axial_load_N", "radial_load_N", "temperature_C"};
constexpr std::ptrdiff_t step = sizeof(double);

/// Throws text::InputError for NULL.
template <typename T>
T& required(T* pointer, const char* name) {
  if (pointer == nullptr) throw text::InputError(fmt::format("{} is NULL", name), {.key = name});
  return *pointer;
}

void require_count(double count) {
  if (count > most_states)
    throw text::InputError(fmt::format(
        "{:.10g} states are given; at most {:.0e} are allowed in one call", count, most_states));
}

using Arrays = std::array<const double*, 4>;  // in the order of `names`

session::StateArrays in_a_row(std::size_t count, const Arrays& data, const int* strides) {
  require_count(static_cast<double>(count));
  std::array<NumberArray, 4> arrays;
  for (std::size_t k = 0; k < arrays.size(); ++k) {
    const std::ptrdiff_t stride = strides ? strides[k] : 1;
    if (data[k] != nullptr && stride >= 0)
      arrays[k] = {reinterpret_cast<const char*>(data[k]), {stride * step}};
  }
  return {.shape = {count},
          .speed_rpm = arrays[0],
          .axial_load_N = arrays[1],
          .radial_load_N = arrays[2],
          .temperature_C = arrays[3]};
}

using Axis = std::span<const double>;

/// Throws text::InputError with the place on the axis.
void check_axis(std::size_t k, Axis axis, bool shaft) {
  const std::array ranges{text::speed_range, shaft ? text::signed_load_range : text::load_range,
                          text::load_range, text::temperature_range};
  for (std::size_t i = 0; i < axis.size(); ++i)
    text::require_range(axis[i], ranges[k], fmt::format("{}[{}]", names[k], i));
}

/// A grid over axes that may be empty, the first running fastest.
session::StateArrays grid(const std::array<Axis, 4>& axes, bool shaft) {
  double points = 1.0;
  for (const Axis& axis : axes)
    points *= static_cast<double>(std::max<std::size_t>(axis.size(), 1));
  require_count(points);
  session::StateArrays states;
  std::array<NumberArray, 4> arrays;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    check_axis(k, axes[k], shaft);
    states.shape.insert(states.shape.begin(), std::max<std::size_t>(axes[k].size(), 1));
    if (axes[k].empty()) continue;
    arrays[k] = {reinterpret_cast<const char*>(axes[k].data()), {0, 0, 0, 0}};
    arrays[k].strides[axes.size() - 1 - k] = step;
  }
  states.speed_rpm = arrays[0];
  states.axial_load_N = arrays[1];
  states.radial_load_N = arrays[2];
  states.temperature_C = arrays[3];
  return states;
}

/// Hands statuses out, and gives what the function returns; where some have not converged, says how
/// many of each kind.
int put_status(std::span<const bearing::SolveStatus> status, int* out, c::MessageText& said) {
  std::array<std::size_t, RACEWAY_STATUS_NOT_RUN + 1> count{}, first{};
  for (std::size_t i = 0; i < status.size(); ++i) {
    const int number = c::status_number(status[i]);
    if (out != nullptr) out[i] = number;
    if (count[static_cast<std::size_t>(number)]++ == 0) first[static_cast<std::size_t>(number)] = i;
  }
  int result = RACEWAY_DONE;
  for (std::size_t k = 1; k < count.size(); ++k) {
    if (count[k] == 0) continue;
    said.say(record::note::not_converged(
        fmt::format("{} of {} states have not converged: {}; the first has index {}", count[k],
                    status.size(), raceway_status_name(static_cast<int>(k)), first[k])));
    result = RACEWAY_NOT_CONVERGED;
  }
  return result;
}

int solve(const raceway_model& model, const session::StateArrays& states, const int* columns,
          std::size_t column_count, double* values, int* status, Reply& reply) {
  if (states.size() > 0) required(values, "values");
  c::MessageText said;
  const session::SolvedStates solved = session::solve_states(
      said, model.file, states, c::column_names(model, columns, column_count));
  std::copy(solved.values.begin(), solved.values.end(), values);
  const int result = put_status(solved.status, status, said);
  reply.put(said.text());
  return result;
}

Axis axis(const double* values, std::size_t count, const char* name) {
  return count == 0 ? Axis{} : Axis{&required(values, name), count};
}

}  // namespace

const char* raceway_version() { return RACEWAY_VERSION; }

const char* raceway_status_name(int status) {
  using bearing::SolveStatus;
  for (const SolveStatus known :
       {SolveStatus::converged, SolveStatus::no_equilibrium, SolveStatus::iteration_limit,
        SolveStatus::singular, SolveStatus::not_finite, SolveStatus::not_run})
    if (c::status_number(known) == status) return bearing::name(known).data();  // literals
  return "unknown";
}

raceway_model* raceway_create(const char* toml_text, const char* source_name, char* message,
                              size_t message_size) {
  Reply reply(message, message_size);
  return guarded<raceway_model*>(reply, nullptr, [&] {
    const std::string text = &required(toml_text, "toml_text");
    return c::open_handle({source_name ? source_name : "model", text});
  });
}

raceway_model* raceway_create_from_file(const char* path, char* message, size_t message_size) {
  Reply reply(message, message_size);
  return guarded<raceway_model*>(reply, nullptr, [&] {
    const std::string name = &required(path, "path");
    if (name == "-")
      throw text::InputError("-: the C library does not read standard input; name a file",
                             {.file = name});
    return c::open_handle(session::Source(name));
  });
}

void raceway_free(raceway_model* model) { delete model; }

const char* raceway_messages(const raceway_model* model) {
  return model ? model->messages.c_str() : "";
}

size_t raceway_column_count(const raceway_model* model) {
  return model ? model->columns.size() : 0;
}

const char* raceway_column_name(const raceway_model* model, size_t column) {
  return column < raceway_column_count(model) ? model->columns[column].c_str() : nullptr;
}

int raceway_column_index(const raceway_model* model, const char* name) {
  if (model == nullptr || name == nullptr) return -1;
  const auto found = std::find(model->columns.begin(), model->columns.end(), name);
  return found == model->columns.end() ? -1 : static_cast<int>(found - model->columns.begin());
}

int raceway_solve(const raceway_model* model, size_t count, const double* speed_rpm,
                  const double* axial_load_N, const double* radial_load_N,
                  const double* temperature_C, const int* strides, const int* columns,
                  size_t column_count, double* values, int* status, char* message,
                  size_t message_size) {
  Reply reply(message, message_size);
  return guarded<int>(reply, RACEWAY_WRONG_INPUT, [&] {
    return solve(required(model, "model"),
                 in_a_row(count, {speed_rpm, axial_load_N, radial_load_N, temperature_C}, strides),
                 columns, column_count, values, status, reply);
  });
}

int raceway_table(const raceway_model* model, const double* speed_rpm, size_t speed_count,
                  const double* axial_load_N, size_t axial_load_count, const double* radial_load_N,
                  size_t radial_load_count, const double* temperature_C, size_t temperature_count,
                  const int* columns, size_t column_count, double* values, int* status,
                  char* message, size_t message_size) {
  Reply reply(message, message_size);
  return guarded<int>(reply, RACEWAY_WRONG_INPUT, [&] {
    const raceway_model& asked = required(model, "model");
    const std::array axes{axis(speed_rpm, speed_count, names[0]),
                          axis(axial_load_N, axial_load_count, names[1]),
                          axis(radial_load_N, radial_load_count, names[2]),
                          axis(temperature_C, temperature_count, names[3])};
    return solve(asked, grid(axes, asked.file.model.shaft.has_value()), columns, column_count,
                 values, status, reply);
  });
}

int raceway_predict(const raceway_model* model, size_t count, const double* speed_rpm,
                    const double* axial_load_N, const double* radial_load_N,
                    const double* temperature_C, const int* strides, double* readings_Nmm,
                    int* status, char* message, size_t message_size) {
  Reply reply(message, message_size);
  return guarded<int>(reply, RACEWAY_WRONG_INPUT, [&] {
    if (count > 0) required(readings_Nmm, "readings_Nmm");
    c::MessageText said;
    const session::PredictedStates predicted = session::predict_states(
        said, required(model, "model").file,
        in_a_row(count, {speed_rpm, axial_load_N, radial_load_N, temperature_C}, strides));
    std::copy(predicted.reading_Nmm.begin(), predicted.reading_Nmm.end(), readings_Nmm);
    const int result = put_status(predicted.status, status, said);
    reply.put(said.text());
    return result;
  });
}
