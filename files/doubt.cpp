#include "files/doubt.h"

#include <fmt/format.h>

#include <optional>

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

}  // namespace

Doubt other_temperature(const record::Channel& channel, double from, double to,
                        std::string_view unit) {
  const text::Unit& other = *text::find_unit(unit, text::Dimension::temperature);
  return {.text = fmt::format("{} of {:.4g} to {:.4g} C looks like {}: {:.3g} to {:.3g} C?",
                              channel.name, from, to, unit == "K" ? "kelvin" : "fahrenheit",
                              celsius(other.to_SI(from)), celsius(other.to_SI(to))),
          .units = {{&channel, other.suffix}}};
}

std::vector<record::Note> asked_about(const std::vector<Doubt>& doubts, const Source& source,
                                      const ReadOptions& options) {
  std::vector<record::Note> warnings;
  std::string questions;
  text::Place place{.file = source.name};
  text::CsvTable table;
  std::optional<Recognised> columns;  // only looked for where something is asked
  for (const Doubt& doubt : doubts) {
    if (!doubt.units.empty() && !columns) {
      table = read_measurements(source, options);
      columns = recognise(table, options.columns, options.over_time, options.of_spindle);
    }
    std::string answers;
    bool answered = false, stamped = false;
    for (const Doubt::Guess& guess : doubt.units) {
      const ColumnSource* const column = columns->find(*guess.channel);
      if (!column) continue;
      answered = answered || column->unit_stated;
      stamped = stamped || is_stamped(table, *column);
      if (answers.empty() && questions.empty()) place.key = column->name;
      answers += (answers.empty() ? "" : " or ") + answer_by(guess, column->name);
    }
    if (stamped) continue;  // dates have no unit
    if (answers.empty() || answered)
      warnings.push_back(record::note::unit(doubt.text, {.file = source.name}));
    else
      questions += fmt::format(
          "{}{}: {} Say so in [columns]: {}. If the file is right, state its unit there.",
          questions.empty() ? "" : "\n", source.name, doubt.text, answers);
  }
  if (!questions.empty()) throw text::InputError(questions, place);
  return warnings;
}

}  // namespace raceway::files
