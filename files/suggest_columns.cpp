#include "files/suggest_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "files/detail/column_proposal.h"
#include "files/detail/column_source.h"
#include "files/detail/signal_channels.h"
#include "record/series_channel.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Role;

/// Words in headers, English and German; between blanks.
struct Words {
  const Channel* channel;
  std::string_view words;
};

const std::array vocabulary{
    Words{&record::speed, "drehzahl speed drehfrequenz rpm n omega"},
    Words{&record::axial_load,
          "axialkraft axiallast axial_load axial_force thrust fa f_a kraft_axial last load force "
          "kraft f"},
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

/// How well a column goes with a channel; nothing where it cannot hold it.
std::optional<ColumnProposal> proposal(const text::CsvTable& table, std::size_t column,
                                       const Words& words) {
  const std::size_t named = longest_word_in(plain_name(table.header[column]), words.words);
  if (named == 0) return std::nullopt;
  std::optional<ColumnProposal> p = column_as(table, column, *words.channel);
  // Any sensor has a signal.
  if (!p || (*words.channel == torque_signal && !p->unit)) return std::nullopt;
  p->score += named;
  return p;
}

/// The only temperature of a file is that of the lubricant, whatever ring it was taken at: without
/// one the viscosity of all rows is that at the temperature of the model.
void take_lone_temperature(std::vector<ColumnProposal>& chosen) {
  std::vector<ColumnProposal*> temperatures;
  for (ColumnProposal& p : chosen)
    if (record::is_temperature(*p.channel)) temperatures.push_back(&p);
  if (temperatures.size() != 1 || *temperatures.front()->channel == record::temperature) return;
  ColumnProposal& lone = *temperatures.front();
  lone.remark = fmt::format("the only temperature of the file ({}), used for the viscosity",
                            lone.channel->words);
  lone.channel = &record::temperature;
}

/// Each channel and each column once, the best matches first.
std::vector<ColumnProposal> proposals(const text::CsvTable& table,
                                      const model::ModelSubject& subject) {
  std::vector<ColumnProposal> all, chosen;
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
  std::stable_sort(all.begin(), all.end(), [](const ColumnProposal& a, const ColumnProposal& b) {
    return a.score > b.score;
  });
  for (const ColumnProposal& p : all)
    if (std::none_of(chosen.begin(), chosen.end(), [&](const ColumnProposal& c) {
          return c.column == p.column || *c.channel == *p.channel;
        }))
      chosen.push_back(p);
  take_lone_temperature(chosen);
  return chosen;
}

/// What the record needs and no column was found for.
std::vector<std::string> missing_lines(const model::ModelSubject& subject,
                                       const std::vector<ColumnProposal>& chosen) {
  const auto found = [&](const Channel& channel) {
    return std::any_of(chosen.begin(), chosen.end(),
                       [&](const ColumnProposal& p) { return *p.channel == channel; });
  };
  std::vector<std::string> lines;
  const bool coast_down = subject.expected().coast_down && found(record::time);
  for (const fit::Measured& m : subject.measured())
    if (!found(*m.channel) && !coast_down &&
        !(*m.channel == record::friction_torque && found(torque_signal)))
      lines.push_back(fmt::format("# {} = \"...\"  # not found, but needed", m.channel->name));
  for (const model::Expected::Default& d : subject.expected().defaults) {
    if (found(*d.channel)) continue;
    lines.push_back(
        std::isnan(d.value)
            ? fmt::format("# {} = \"...\"  # not found, but needed: give a column{}",
                          d.channel->name,
                          *d.channel == record::speed ? "" : ", or a number for all rows")
            : fmt::format("# {} = {:.6g}  # not found; {} gives {:.6g}", d.channel->name,
                          d.channel->in_unit(d.value), d.from, d.channel->in_unit(d.value)));
  }
  return lines;
}

std::string text_of(const text::CsvTable& table, const model::ModelSubject& subject) {
  const std::vector<ColumnProposal> chosen = proposals(table, subject);
  std::vector<ColumnProposal> in_order;
  for (const Channel* channel : file_channels())
    for (const ColumnProposal& p : chosen)
      if (*p.channel == *channel) in_order.push_back(p);
  return proposed_columns({{&table, in_order}}, missing_lines(subject, chosen));
}

}  // namespace

std::string suggested_columns(const Source& source, const model::ModelSubject& subject) {
  return text_of(read_measurements(source, {}), subject);
}

}  // namespace raceway::files
