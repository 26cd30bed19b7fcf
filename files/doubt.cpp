#include "files/doubt.h"

#include <fmt/format.h>

#include <utility>

#include "files/detail/column_source.h"
#include "record/units.h"
#include "text/error.h"
#include "text/names.h"
#include "text/units.h"

namespace raceway::files {
namespace {

/// `speed_rpm = { column = "n", unit = "1_s" }`
std::string answer_by(const Doubt::Guess& guess, const std::string& header) {
  return fmt::format("{} = {{ column = {}, unit = \"{}\" }}", guess.channel->name,
                     text::in_quotes(header), guess.unit);
}

/// A file of a record, and what its columns are.
struct Read {
  text::CsvTable table;
  Recognised columns;
};

std::vector<Read> read_again(const Source& source, ReadOptions options) {
  options.of_several = !source.beside.empty();
  std::vector<Read> files;
  const auto add = [&](const Source& one) {
    text::CsvTable table = read_measurements(one, options);
    Recognised columns = recognise(table, options);
    files.push_back({std::move(table), std::move(columns)});
  };
  add(source);
  for (const Source& other : source.beside) add(other);
  return files;
}

}  // namespace

Doubt other_temperature(const record::Channel& channel, double from, double to,
                        std::string_view unit) {
  const text::Unit& other = *text::find_unit(unit, text::Dimension::temperature);
  return {.text = fmt::format(
              "{} goes from {:.4g} to {:.4g} C: are the values in {}, that is {:.3g} to {:.3g} C?",
              channel.name, from, to, unit == "K" ? "kelvin" : "fahrenheit",
              celsius(other.to_SI(from)), celsius(other.to_SI(to))),
          .units = {{&channel, other.suffix}}};
}

record::Record in_other_unit(record::Record data, const record::Channel& channel,
                             const text::Unit& unit) {
  for (double& v : data.find(channel)->values) v = unit.to_SI(channel.in_unit(v));
  return data;
}

std::vector<record::Note> asked_about(const std::vector<Doubt>& doubts, const Source& source,
                                      const ReadOptions& options) {
  std::vector<record::Note> warnings;
  std::string questions;
  text::Place place{.file = source.name};
  std::vector<Read> files;  // only read where something is asked
  const auto column_of = [&](const record::Channel& channel, bool& stamped) {
    const ColumnSource* column = nullptr;
    for (const Read& file : files) {
      column = file.columns.find(channel);
      if (!column) continue;
      stamped = stamped || is_stamped(file.table, *column);
      break;
    }
    return column;
  };
  const auto add = [&](std::string question) {
    questions += (questions.empty() ? "" : "\n") + source.name + ": " + std::move(question);
  };
  for (const Doubt& doubt : doubts) {
    if ((!doubt.units.empty() || doubt.reversed) && files.empty())
      files = read_again(source, options);
    std::string answers;
    bool answered = false, stamped = false;
    if (doubt.reversed)
      if (const ColumnSource* const column = column_of(*doubt.reversed, stamped);
          column && column->cells.factor == 1.0) {
        if (questions.empty()) place.key = column->name;
        const std::string unit =
            column->cells.unit ? fmt::format(", unit = \"{}\"", column->cells.unit->suffix) : "";
        add(fmt::format("{}. Reverse the sign in [columns]: {} = {{ column = {}{}, factor = -1 }}",
                        doubt.text, doubt.reversed->name, text::in_quotes(column->name), unit));
        continue;
      }
    for (const Doubt::Guess& guess : doubt.units) {
      const ColumnSource* const column = column_of(*guess.channel, stamped);
      if (!column) continue;
      answered = answered || column->unit_stated;
      if (answers.empty() && questions.empty()) place.key = column->name;
      answers += (answers.empty() ? "" : " or ") + answer_by(guess, column->name);
    }
    if (stamped) continue;  // dates have no unit
    if (answers.empty() || answered)
      warnings.push_back(
          record::note::unit(doubt.text + (doubt.reversed ? "; set factor = -1 in [columns]" : ""),
                             {.file = source.name}));
    else
      add(
          fmt::format("{} If so, set the unit in [columns]: {}. If the values are right as they "
                      "are, set their present unit in [columns].",
                      doubt.text, answers));
  }
  if (!questions.empty()) throw text::InputError(questions, place);
  return warnings;
}

}  // namespace raceway::files
