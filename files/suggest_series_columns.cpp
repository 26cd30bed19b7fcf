#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "correction/simulation.h"
#include "files/detail/column_proposal.h"
#include "files/detail/column_source.h"
#include "files/detail/series_columns.h"
#include "files/suggest_columns.h"
#include "record/series_channel.h"
#include "text/names.h"

namespace raceway::files {
namespace {

using record::Channel;
using record::Role;

/// Columns of records over time that are alike: what may stand between `begin` and `end` of our
/// name is a name of the user's, or nothing.
struct SeriesKind {
  std::string_view begin, end;
  std::string_view words;        ///< of headers, English and German
  std::string_view single = {};  ///< our name without one, where there is such a column
};

constexpr std::array series_kinds{
    SeriesKind{"", "", "zeit time zeitstempel timestamp datum date uhrzeit t", "time_s"},
    SeriesKind{"", "", "run run_id versuch lauf messreihe versuch_nr", "run_id"},
    SeriesKind{"", "", "coolant_on coolant k\u00fchlmittel kuehlmittel kss k\u00fchlung kuehlung",
               "coolant_on"},
    SeriesKind{"displacement_", "_um",
               "verlagerung verschiebung displacement dehnung growth drift probe taster weg"},
    SeriesKind{"displacement_", "_urad", "kippung neigung winkel tilt pitch yaw angle rotation"},
    SeriesKind{"offset_", "_um", "korrektur kompensation correction compensation offset"},
    SeriesKind{"", "_temperature_C", "temperatur temperature temp t"},
    SeriesKind{"", "_feed_m_min", "vorschub feed feedrate"},
    SeriesKind{"", "_speed_rpm", "drehzahl speed drehfrequenz rpm n", "speed_rpm"}};

/// Words of names, with what a German file has for them.
constexpr std::array<std::string_view, 20> series_words{
    "front vorn vorne vorderes vorderer",
    "rear back hinten hinteres hinterer",
    "bearing lager",
    "spindle spindel",
    "ambient room air umgebung raum halle luft",
    "base bed bett sockel gestell",
    "motor",
    "coolant k\u00fchlmittel kuehlmittel k\u00fchlwasser kuehlwasser",
    "oil \u00f6l oel",
    "column st\u00e4nder staender",
    "head kopf",
    "nut mutter",
    "inlet vorlauf zulauf eintritt",
    "outlet return r\u00fccklauf ruecklauf austritt",
    "housing geh\u00e4use gehaeuse",
    "left links",
    "right rechts",
    "top upper oben",
    "bottom lower unten",
    "table tisch"};

std::vector<std::string_view> parts_of_name(std::string_view name) {
  std::vector<std::string_view> parts = text::split(name, '_');
  std::erase(parts, std::string_view());
  return parts;
}

/// A word in all languages that are known; itself where it is in none.
std::string_view synonyms_of(std::string_view word) {
  for (const std::string_view words : series_words)
    for (const std::string_view one : text::split(words, ' '))
      if (one == word) return words;
  return word;
}

const SeriesKind* kind_of(const Channel& channel) {
  for (const SeriesKind& kind : series_kinds) {
    if (channel.name == kind.single) return &kind;
    if (!kind.end.empty() && channel.name.starts_with(kind.begin) &&
        channel.name.ends_with(kind.end))
      return &kind;
  }
  return nullptr;
}

/// The part of a channel's name that is the user's: "front_bearing".
std::string_view own_name(const Channel& channel, const SeriesKind& kind) {
  if (channel.name == kind.single) return {};
  std::string_view name = channel.name;
  name.remove_prefix(kind.begin.size());
  name.remove_suffix(kind.end.size());
  return name;
}

/// "T3" and "T_front" are temperatures.
bool is_numbered_temperature(std::string_view name) {
  return name.size() > 1 && name.front() == 't' &&
         std::all_of(name.begin() + 1, name.end(),
                     [](unsigned char c) { return c >= '0' && c <= '9'; });
}

/// A column of the file that is of a kind.
struct SeriesColumn {
  const SeriesKind* kind;
  ColumnProposal as;  ///< its channel is any of that kind
  std::string name;   ///< as longest_word_in() looks into it
};

/// A channel of the kind, to try a column by.
const Channel& any_of_kind(const SeriesKind& kind) {
  return *record::series_channel(kind.single.empty() ? fmt::format("{}any{}", kind.begin, kind.end)
                                                     : std::string(kind.single));
}

bool is_switch(const text::CsvTable& table, std::size_t column) {
  const std::vector<double> values = numbers_in(table, column);
  return !values.empty() &&
         std::all_of(values.begin(), values.end(), [](double v) { return v == 0.0 || v == 1.0; });
}

/// The kind that a column goes with best.
std::optional<SeriesColumn> column_of_series(const text::CsvTable& table, std::size_t column) {
  std::optional<SeriesColumn> best;
  const std::string name = plain_name(table.header[column]);
  for (const SeriesKind& kind : series_kinds) {
    std::optional<ColumnProposal> p = column_as(table, column, any_of_kind(kind));
    if (!p) continue;
    std::size_t named = longest_word_in(name, kind.words);
    if (kind.end == "_temperature_C" && is_numbered_temperature(name)) named = name.size();
    // An angle of any name may be the position of an axis.
    if (named == 0 && (!p->unit || kind.end == "_urad")) continue;
    if (kind.single == "coolant_on" && !is_switch(table, column)) continue;
    p->score += named;
    if (!best || p->score > best->as.score) best = SeriesColumn{&kind, *std::move(p), name};
  }
  return best;
}

/// How much of a name of ours is in a name of theirs.
std::size_t likeness(std::string_view ours, std::string_view theirs) {
  std::size_t sum = 0;
  for (const std::string_view part : parts_of_name(ours))
    sum += longest_word_in(theirs, synonyms_of(part));
  return sum;
}

/// Letters and digits alone, for a name of ours.
std::string ascii_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> letters{
      std::pair{"\u00e4", "ae"}, {"\u00f6", "oe"}, {"\u00fc", "ue"}, {"\u00df", "ss"}};
  std::string result;
  while (!name.empty()) {
    const auto known = std::find_if(letters.begin(), letters.end(),
                                    [&](const auto& l) { return name.starts_with(l.first); });
    if (known != letters.end()) {
      result += known->second;
      name.remove_prefix(known->first.size());
      continue;
    }
    const bool plain = std::isalnum(static_cast<unsigned char>(name.front())) != 0;
    if (plain || (!result.empty() && result.back() != '_')) result += plain ? name.front() : '_';
    name.remove_prefix(1);
  }
  while (result.ends_with('_')) result.pop_back();
  return result;
}

/// What their name says beside the kind: "lager_vorn" of "temperatur_lager_vorn".
std::string name_beside_kind(const SeriesColumn& c) {
  std::string name;
  for (const std::string_view part : parts_of_name(c.name))
    if (longest_word_in(part, c.kind->words) != part.size()) name += fmt::format("_{}", part);
  name = ascii_name(name);
  return name.empty() ? ascii_name(c.name) : name;
}

/// "raumluft", "t_amb"; not "arbeitsraum", which is in the machine.
bool is_of_room(const std::string& name) {
  constexpr std::array<std::string_view, 6> words{"ambient",  "room", "air",
                                                  "umgebung", "raum", "halle"};
  const std::vector<std::string_view> parts = parts_of_name(name);
  return std::any_of(parts.begin(), parts.end(), [&](std::string_view part) {
    return part == "amb" || part == "luft" ||
           std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return part.starts_with(word); });
  });
}

class SeriesProposals {
 public:
  /// `found`: channels of the other files of the record.
  SeriesProposals(const text::CsvTable& table, const std::vector<correction::Model>& models,
                  const ColumnMap& given, std::vector<const Channel*> found)
      : table_(table), given_(given), found_(std::move(found)) {
    want(record::time);
    for (const correction::Model& m : models) want(*m.displacement);
    for (const correction::Model& m : models) {
      has_inputs_ = has_inputs_ || !m.channels.empty() || m.kinematic;
      for (const Channel* c : correction::inputs_of(m)) want(*c);
    }
    for (const ColumnRule& rule : given.rules) std::erase(wanted_, rule.channel);
    for (const Channel* c : found_) std::erase(wanted_, c);
    for (std::size_t c = 0; c < table.header.size(); ++c) {
      if (given.find(table.header[c]) || given.find_transducer(table.header[c])) continue;
      if (auto column = column_of_series(table, c))
        columns_.push_back(*std::move(column));
      else
        take_as_recorded(c);
    }
  }

  std::vector<ColumnProposal> proposed() {
    take_our_names();
    take_by_likeness();
    take_the_only_ones();
    name_the_rest();
    std::vector<ColumnProposal> in_order;
    for (const SeriesKind& kind : series_kinds)
      for (const ColumnProposal& p : chosen_)
        if (kind_of(*p.channel) == &kind) in_order.push_back(p);
    in_order.insert(in_order.end(), recorded_.begin(), recorded_.end());
    return in_order;
  }

  /// Quantities that the models need, and for which no column was found.
  [[nodiscard]] const std::vector<const Channel*>& missing() const { return wanted_; }

 private:
  void want(const Channel& channel) {
    if (std::find(wanted_.begin(), wanted_.end(), &channel) == wanted_.end())
      wanted_.push_back(&channel);
  }

  void choose(std::size_t column, const Channel& channel, std::string remark = {}) {
    ColumnProposal p = columns_[column].as;
    p.channel = &channel;
    p.remark = std::move(remark);
    chosen_.push_back(std::move(p));
    columns_.erase(columns_.begin() + static_cast<std::ptrdiff_t>(column));
    std::erase(wanted_, &channel);
  }

  /// A power, a load or the like, which is known by its name and unit alone.
  void take_as_recorded(std::size_t column) {
    const auto named = named_series_channel(table_.header[column]);
    if (!named || !named->channel->is_input()) return;
    recorded_.push_back({.channel = named->channel, .column = column, .has_our_name = true});
    std::erase(wanted_, named->channel);
  }

  /// A header that is one of our names already. "Spindle speed (rpm)" is not: the speed of the
  /// spindle has no name of its own.
  void take_our_names() {
    for (std::size_t c = columns_.size(); c-- > 0;) {
      const std::string& header = table_.header[columns_[c].as.column];
      const auto named = named_series_channel(header);
      if (!named) continue;
      const Channel& channel = *named->channel;
      const bool may_be_single =
          !columns_[c].kind->single.empty() && channel.name != header &&
          channel.name != columns_[c].kind->single &&
          std::find(wanted_.begin(), wanted_.end(), &channel) == wanted_.end();
      if (may_be_single) continue;
      choose(c, channel);
      chosen_.back().has_our_name = true;
    }
  }

  /// The column and the channel that are most alike first.
  void take_by_likeness() {
    while (true) {
      std::size_t most = 0, column = 0;
      const Channel* channel = nullptr;
      for (const Channel* w : wanted_)
        for (std::size_t c = 0; c < columns_.size(); ++c) {
          const SeriesKind* const kind = kind_of(*w);
          if (columns_[c].kind != kind) continue;
          const std::string_view own = own_name(*w, *kind);
          // The time, and the speed of the spindle, have no name of their own.
          const std::size_t like =
              own.empty() ? columns_[c].as.score : likeness(own, columns_[c].name);
          if (like > most) most = like, column = c, channel = w;
        }
      if (!channel) return;
      choose(column, *channel);
    }
  }

  /// A channel and a column that are left alone of their kind.
  void take_the_only_ones() {
    for (const SeriesKind& kind : series_kinds) {
      std::vector<std::size_t> columns;
      for (std::size_t c = 0; c < columns_.size(); ++c)
        if (columns_[c].kind == &kind) columns.push_back(c);
      const auto is_of = [&](const Channel* w) { return kind_of(*w) == &kind; };
      if (columns.size() != 1 || std::count_if(wanted_.begin(), wanted_.end(), is_of) != 1)
        continue;
      const Channel& channel = **std::find_if(wanted_.begin(), wanted_.end(), is_of);
      choose(columns.front(), channel, "the only remaining column of this quantity");
    }
  }

  /// Columns that the model does not ask for, by names of their own.
  void name_the_rest() {
    while (!columns_.empty()) {
      const SeriesColumn& c = columns_.front();
      const auto taken = [&](std::string_view name) {
        return std::any_of(chosen_.begin(), chosen_.end(),
                           [&](const ColumnProposal& p) { return p.channel->name == name; }) ||
               std::any_of(found_.begin(), found_.end(),
                           [&](const Channel* other) { return other->name == name; });
      };
      std::string name(c.kind->single);
      if (c.kind->end == "_temperature_C" && is_of_room(c.name)) name = "room_temperature_C";
      if (name.empty() || (taken(name) && !c.kind->end.empty())) {
        const std::string own = name_beside_kind(c);
        name = fmt::format("{}{}{}", c.kind->begin, own, c.kind->end);
        for (int k = 2; taken(name); ++k)
          name = fmt::format("{}{}_{}{}", c.kind->begin, own, k, c.kind->end);
      }
      const Channel* const channel = record::series_channel(name);
      if (!channel || taken(name)) {
        columns_.erase(columns_.begin());
        continue;
      }
      choose(0, *channel, has_inputs_ ? "the model does not use this column" : "");
    }
  }

  const text::CsvTable& table_;
  const ColumnMap& given_;
  std::vector<const Channel*> found_;
  bool has_inputs_ = false;
  std::vector<const Channel*> wanted_{};
  std::vector<SeriesColumn> columns_{};  ///< not chosen yet
  std::vector<ColumnProposal> chosen_{}, recorded_{};
};

}  // namespace

std::string suggested_columns(const Source& source, const std::vector<correction::Model>& models) {
  return series_columns(tables_of(source, {.over_time = true}), models, {}).text;
}

std::vector<text::CsvTable> tables_of(const Source& source, const ReadOptions& options) {
  std::vector<text::CsvTable> tables{read_measurements(source, options)};
  for (const Source& other : source.beside) tables.push_back(read_measurements(other, options));
  return tables;
}

SeriesColumns series_columns(const std::vector<text::CsvTable>& tables,
                             const std::vector<correction::Model>& models, const ColumnMap& given) {
  std::vector<ProposedFile> files;
  std::vector<const Channel*> found, missing;
  bool ours = true;
  for (const text::CsvTable& table : tables) {
    SeriesProposals of_table(table, models, given, found);
    files.push_back({&table, of_table.proposed()});
    for (const ColumnProposal& p : files.back().proposals) {
      ours = ours && p.has_our_name;
      // Each file has a time of its own.
      if (!(*p.channel == record::time)) found.push_back(p.channel);
    }
    missing = of_table.missing();
  }
  std::vector<std::string> lines;
  for (const Channel* c : missing)
    lines.push_back(fmt::format("# {} = \"...\"  # not found, but needed", c->name));
  const bool says_more = !given.rules.empty() || given.decimal_mark != '\0' || given.date_order;
  return {proposed_columns(files, lines, given), ours && !says_more};
}

}  // namespace raceway::files
