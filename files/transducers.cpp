#include "files/detail/transducers.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "record/series_channel.h"
#include "text/error.h"
#include "text/names.h"
#include "text/number_text.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/transducer_section.h"

namespace raceway::files {
namespace {

using record::Channel;

constexpr Key transducer_keys[]{
    {"DISPLACEMENT", a_table, unset,
     "displacement_NAME_um or displacement_NAME_urad = { TRANSDUCER_um = factor, ... }: the "
     "displacement is the sum of factor times reading. Unit of a factor: um/um for a length, "
     "urad/um (= 1/m) for an angle. The column of a transducer can have any unit of length"},
};

constexpr double largest_factor = 1e6;

std::string words(const Combination& c) {
  std::string text;
  for (const Combination::Term& t : c.terms) {
    const std::string size = fmt::format("{:.6g} ", std::abs(t.factor));
    text += text.empty() ? (t.factor < 0.0 ? "-" : "") : t.factor < 0.0 ? " - " : " + ";
    text += (size == "1 " ? "" : size) + std::string(t.transducer->name);
  }
  return text;
}

std::vector<const Channel*> transducers_of(const std::vector<Combination>& list) {
  std::vector<const Channel*> all;
  for (const Combination& c : list)
    for (const Combination::Term& t : c.terms)
      if (std::find(all.begin(), all.end(), t.transducer) == all.end()) all.push_back(t.transducer);
  return all;
}

class TransducerReader {
 public:
  explicit TransducerReader(const Section& section) : s_(section) {}

  std::vector<Combination> read() {
    std::map<unsigned, std::pair<const toml::key*, const toml::node*>> lines;  // as in the file
    for (const auto& [key, node] : *s_.table())
      lines.emplace(key.source().begin.line * 1000U + key.source().begin.column,
                    std::pair(&key, &node));
    for (const auto& [_, line] : lines) add(std::string(line.first->str()), *line.second);
    require_use();
    require_rank();
    return std::move(list_);
  }

 private:
  void add(const std::string& name, const toml::node& node) {
    const Channel* const displacement = record::series_channel(name);
    if (!displacement || displacement->role != record::Role::measured)
      s_.fail(name, fmt::format("[transducers] {}: must be a column displacement_NAME_um or "
                                "displacement_NAME_urad",
                                name));
    if (!node.is_table() || node.as_table()->empty())
      s_.fail(name, fmt::format("[transducers] {} = {}: must be transducers with their factors, "
                                "such as {{ x1_um = 0.5, x2_um = 0.5 }}",
                                name, text::shown(node)));
    Combination made{.displacement = displacement, .place = s_.at(name)};
    for (const auto& [key, factor] : *node.as_table()) {
      const Channel* const transducer = record::transducer_channel(key.str());
      if (!transducer)
        s_.fail(name, fmt::format("[transducers] {}: {}: the name of a transducer must end in _um, "
                                  "such as x1_um; its column can have another unit of length",
                                  name, key.str()));
      const auto value = factor.value<double>();
      if (!factor.is_number() || !(std::abs(*value) <= largest_factor))
        s_.fail(name, fmt::format("[transducers] {}: {} = {}: must be a number from {} to {} {}/um",
                                  name, key.str(), text::shown(factor), -largest_factor,
                                  largest_factor, displacement->unit));
      made.terms.push_back({transducer, *value * displacement->factor / transducer->factor});
    }
    list_.push_back(std::move(made));
  }

  void require_use() const {
    for (const Channel* transducer : transducers_of(list_)) {
      const bool used = std::any_of(list_.begin(), list_.end(), [&](const Combination& c) {
        return std::any_of(c.terms.begin(), c.terms.end(), [&](const Combination::Term& t) {
          return t.transducer == transducer && t.factor != 0.0;
        });
      });
      if (!used)
        throw text::InputError(fmt::format("{}: [transducers] {}: all factors of this transducer "
                                           "are 0, so it is not used; remove it",
                                           s_.place(), transducer->name),
                               s_.at());
    }
  }

  /// Rows by Gram and Schmidt: one that the rows before it leave nothing of follows from them.
  void require_rank() const {
    constexpr double nothing = 1e-9;
    const std::vector<const Channel*> all = transducers_of(list_);
    std::vector<Eigen::VectorXd> before;
    Names names;
    for (const Combination& c : list_) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(all.size()));
      for (const Combination::Term& t : c.terms)
        row[std::find(all.begin(), all.end(), t.transducer) - all.begin()] += t.factor;
      const double size = row.norm();
      for (int twice = 0; twice < 2; ++twice)
        for (const Eigen::VectorXd& other : before) row -= other.dot(row) * other;
      if (!(row.norm() > nothing * size))
        throw text::InputError(
            fmt::format("{}: [transducers] {} {}: the {} transducers cannot separate this "
                        "displacement from the others",
                        c.place.text(), c.displacement->name,
                        size == 0.0
                            ? "has only factors of 0"
                            : fmt::format("is a linear combination of {}", text::listed(names)),
                        all.size()),
            c.place);
      before.push_back(row.normalized());
      names.emplace_back(c.displacement->name);
    }
  }

  const Section& s_;
  std::vector<Combination> list_;
};

}  // namespace

std::vector<KeyTable> transducer_tables() { return {{"transducers", transducer_keys}}; }

std::vector<Combination> read_transducers(const ModelTables& tables) {
  if (const toml::node* const node = tables.root().get("transducers"); node && !node->is_table())
    throw text::InputError(fmt::format("{}: transducers = {}: must be a table, [transducers]",
                                       tables.source(), text::shown(*node)),
                           {.file = tables.source(), .key = "transducers"});
  const Section s = tables.section("transducers");
  return s.given() ? TransducerReader(s).read() : std::vector<Combination>();
}

std::optional<NamedChannel> ColumnMap::find_transducer(std::string_view name) const {
  if (transducers.empty()) return std::nullopt;
  return named_channel(name, transducers_of(transducers));
}

std::vector<const Combination*> combinations_for(const ColumnMap& map,
                                                 const std::vector<const Channel*>& wanted) {
  std::vector<const Combination*> list;
  for (const Combination& c : map.transducers)
    if (wanted.empty() || std::any_of(wanted.begin(), wanted.end(),
                                      [&](const Channel* w) { return *w == *c.displacement; }))
      list.push_back(&c);
  return list;
}

void combine_transducers(record::Record& record, const ColumnMap& map,
                         const std::vector<const Channel*>& wanted) {
  const std::vector<const Channel*> all = transducers_of(map.transducers);
  if (std::none_of(all.begin(), all.end(), [&](const Channel* t) { return record.has(*t); }))
    return;
  for (const Combination* c : combinations_for(map, wanted)) {
    std::vector<double> sum(record.rows(), 0.0);
    for (const Combination::Term& t : c->terms) {
      const std::span<const double> read = record.values(*t.transducer);
      for (std::size_t row = 0; row < sum.size(); ++row) sum[row] += t.factor * read[row];
    }
    record.set(*c->displacement, std::move(sum));
    record.notes.push_back(record::note::read_as(
        fmt::format("{} is calculated as {}, by [transducers]", c->displacement->name, words(*c)),
        {.file = record.source, .key = std::string(c->displacement->name)}));
  }
  std::erase_if(record.columns, [&](const record::Column& column) {
    return std::find(all.begin(), all.end(), column.channel) != all.end();
  });
}

std::string transducers_text(const ColumnMap& map) {
  if (map.transducers.empty()) return {};
  std::string text = "[transducers]  # factors in um/um; for angles in urad/um\n";
  for (const Combination& c : map.transducers) {
    Names terms;
    for (const Combination::Term& t : c.terms)
      terms.push_back(fmt::format("{} = {}", t.transducer->name,
                                  text::toml_float(text::with_15_digits(
                                      t.factor * t.transducer->factor / c.displacement->factor))));
    text += fmt::format("{} = {{ {} }}\n", c.displacement->name, fmt::join(terms, ", "));
  }
  return text;
}

}  // namespace raceway::files
