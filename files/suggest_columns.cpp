#include "files/suggest_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "files/detail/column_source.h"
#include "files/detail/signal_channels.h"
#include "text/missing_cell.h"
#include "text/names.h"
#include "text/timestamp.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Role;

/// Words in headers, English and German; between blanks. A word of one or two letters must stand
/// alone.
struct Words {
  const Channel* channel;
  std::string_view words;
};

const std::array vocabulary{
    Words{&record::speed, "drehzahl speed drehfrequenz rpm n omega"},
    Words{&record::axial_load,
          "axialkraft axiallast axial_load axial_force thrust fa f_a kraft_axial last load force "
          "kraft"},
    Words{&record::radial_load,
          "radialkraft radiallast radial_load radial_force fr f_r kraft_radial"},
    Words{&record::temperature,
          "temperatur temperature temp \u00f6ltemperatur oeltemperatur lagertemperatur "
          "oil_temperature t_oil t_oel t"},
    Words{&record::inner_ring_temperature,
          "innenring temperatur_innenring inner_ring t_ir t_i innenringtemperatur"},
    Words{&record::outer_ring_temperature,
          "au\u00dfenring aussenring outer_ring t_or t_a temperatur_au\u00dfenring "
          "temperatur_aussenring"},
    Words{&record::preload, "vorspannkraft vorspannung preload fv f_v"},
    Words{&record::time, "zeit time zeitstempel timestamp datum date uhrzeit t"},
    Words{&record::run, "versuch lauf messreihe messung run run_id test_id versuch_nr"},
    Words{&record::friction_torque,
          "reibmoment reibungsmoment friction_torque friction drehmoment torque moment mr m_r m"},
    Words{&record::axial_displacement,
          "verlagerung verschiebung axialverschiebung displacement weg position"},
    Words{&torque_signal,
          "torque_signal drehmomentsignal momentsignal reibmoment drehmoment torque moment signal "
          "dms dehnungsmessstreifen strain_gauge br\u00fccke bruecke bridge"}};

/// Small letters, everything between words as "_".
std::string plain(std::string_view text) {
  std::string result = text::lower_case(text);
  for (char& c : result)
    if (c == ' ' || c == '-' || c == '.' || c == ',') c = '_';
  return result;
}

/// Letters of the longest word that is in the name, 0 for none.
std::size_t match(std::string_view name, std::string_view words) {
  std::size_t longest = 0;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    const std::string_view word = words.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t at = name.find(word);
    if (at == name.npos || word.size() <= longest) continue;
    const bool alone = (at == 0 || name[at - 1] == '_') &&
                       (at + word.size() == name.size() || name[at + word.size()] == '_');
    if (word.size() > 2 || alone) longest = word.size();
  }
  return longest;
}

struct Proposal {
  const Channel* channel;
  std::size_t column;
  const text::Unit* unit;    ///< null where none was found
  std::string unknown_unit;  ///< as the file states it; empty where it states none, or a known one
  bool excel_date = false, stamped = false;
  std::size_t score;
};

bool all_cells(const text::CsvTable& table, std::size_t column, auto&& holds) {
  bool any = false;
  for (std::size_t row = 0; row < std::min<std::size_t>(table.rows(), 20); ++row) {
    const std::string cell = table.shown(row, column);
    if (text::is_missing(cell)) continue;
    if (!holds(cell)) return false;
    any = true;
  }
  return any;
}

/// How well a column goes with a channel; nothing where it cannot hold it.
std::optional<Proposal> proposal(const text::CsvTable& table, std::size_t column,
                                 const Words& words) {
  const text::HeaderParts parts = text::header_parts(table.header[column]);
  const text::Unit* const own = unit_of(*words.channel);
  const std::string_view below =
      column < table.units.size() ? std::string_view(table.units[column]) : std::string_view();
  const std::string_view written = parts.unit.empty() ? below : parts.unit;
  const bool some_unit = text::find_unit(written) != nullptr;
  Proposal p{.channel = words.channel,
             .column = column,
             .unit = own ? text::find_unit(written, own->dimension) : nullptr,
             .unknown_unit = {},
             .score = match(plain(parts.name), words.words)};
  if (own && parts.unit.empty() && !p.unit)
    p.unit = text::unit_at_end(table.header[column], own->dimension);
  if (own && !p.unit && !some_unit) p.unknown_unit = std::string(written);
  // A unit of another kind: "Last [mm]" is no load.
  if (p.score == 0 || (some_unit && !p.unit)) return std::nullopt;
  // Any sensor has a signal.
  if (*words.channel == torque_signal && !p.unit) return std::nullopt;
  const bool numbers = all_cells(table, column, [&](std::string_view cell) {
    return text::parse_number(cell, table.separator != ',').problem.empty();
  });
  if (words.channel->role == Role::time) {
    p.stamped = all_cells(table, column, text::is_time);
    p.excel_date = !p.unit && all_cells(table, column, [&](std::string_view cell) {
      const double days = text::parse_number(cell, table.separator != ',').value;
      return days > 20000 && days < 80000;
    });
    if (p.stamped || p.excel_date) p.score += 10;
    if (!numbers && !p.stamped) return std::nullopt;
  } else if (words.channel->role != Role::run && !numbers) {
    return std::nullopt;
  }
  if (p.unit) p.score += 20;
  return p;
}

/// Each channel and each column once, the best matches first.
std::vector<Proposal> proposals(const text::CsvTable& table, const model::ModelSubject& subject) {
  std::vector<Proposal> all, chosen;
  for (const Words& words : vocabulary) {
    const auto measured = subject.measured();
    const bool predicted =
        words.channel->role != Role::measured ||
        std::any_of(measured.begin(), measured.end(), [&](const fit::Measured& m) {
          return *m.channel == *words.channel ||
                 (*m.channel == record::friction_torque && *words.channel == torque_signal);
        });
    for (std::size_t c = 0; predicted && c < table.header.size(); ++c)
      if (const auto p = proposal(table, c, words)) all.push_back(*p);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Proposal& a, const Proposal& b) { return a.score > b.score; });
  for (const Proposal& p : all)
    if (std::none_of(chosen.begin(), chosen.end(), [&](const Proposal& c) {
          return c.column == p.column || *c.channel == *p.channel;
        }))
      chosen.push_back(p);
  return chosen;
}

std::string line_of(const text::CsvTable& table, const Proposal& p) {
  const std::string header = text::in_quotes(table.header[p.column]);
  const text::Unit* const own = unit_of(*p.channel);
  if (p.excel_date)
    return fmt::format("{} = {{ column = {}, unit = \"excel\" }}", p.channel->name, header);
  if (p.stamped || !own) return fmt::format("{} = {}", p.channel->name, header);
  if (!p.unknown_unit.empty())
    return fmt::format(
        "# {} = {{ column = {}, unit = \"...\" }}  # the file has {}, which is not known: {}?",
        p.channel->name, header, text::in_quotes(p.unknown_unit),
        text::listed_units(own->dimension));
  // A unit that stands here counts as said by the user, and is not asked about again.
  if (!p.unit)
    return fmt::format("{} = {}  # no unit in the file: read in {}", p.channel->name, header,
                       own->suffix);
  return fmt::format("{} = {{ column = {}, unit = \"{}\" }}", p.channel->name, header,
                     p.unit->suffix);
}

/// What the record needs and no column was found for.
std::vector<std::string> missing_lines(const model::ModelSubject& subject,
                                       const std::vector<Proposal>& chosen) {
  const auto found = [&](const Channel& channel) {
    return std::any_of(chosen.begin(), chosen.end(),
                       [&](const Proposal& p) { return *p.channel == channel; });
  };
  std::vector<std::string> lines;
  const bool coast_down = subject.expected().coast_down && found(record::time);
  for (const fit::Measured& m : subject.measured())
    if (!found(*m.channel) && !coast_down &&
        !(*m.channel == record::friction_torque && found(torque_signal)))
      lines.push_back(fmt::format("# {} = \"...\"  # not found, and needed", m.channel->name));
  for (const model::Expected::Default& d : subject.expected().defaults) {
    if (found(*d.channel)) continue;
    lines.push_back(
        std::isnan(d.value)
            ? fmt::format("# {} = \"...\"  # not found, and needed: a column{}", d.channel->name,
                          *d.channel == record::speed ? "" : ", or a number for all rows")
            : fmt::format("# {} = {:.6g}  # not found: a column or a number; {} says {:.6g}",
                          d.channel->name, d.channel->in_unit(d.value), d.from,
                          d.channel->in_unit(d.value)));
  }
  return lines;
}

std::string text_of(const text::CsvTable& table, const model::ModelSubject& subject) {
  const std::vector<Proposal> chosen = proposals(table, subject);
  std::string text = fmt::format(
      "# Columns of {}, proposed by their words and units: look through it.\n"
      "# For --columns FILE, or to be put into the model.\n[columns]\n",
      std::filesystem::path(table.source).filename().string());
  for (const Channel* channel : file_channels())
    for (const Proposal& p : chosen)
      if (*p.channel == *channel) text += line_of(table, p) + "\n";
  for (const std::string& line : missing_lines(subject, chosen)) text += line + "\n";
  std::vector<std::string> others;
  for (std::size_t c = 0; c < table.header.size(); ++c)
    if (std::none_of(chosen.begin(), chosen.end(),
                     [&](const Proposal& p) { return p.column == c; }))
      others.push_back(text::in_quotes(table.header[c]));
  if (!others.empty()) text += "# not used: " + text::listed(others) + "\n";
  return text;
}

}  // namespace

std::string suggested_columns(const Source& source, const model::ModelSubject& subject) {
  return text_of(read_measurements(source, {}), subject);
}

}  // namespace raceway::files
