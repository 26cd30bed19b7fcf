#include "correction/effects/exchanged_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "correction/leaps.h"
#include "correction/simulation.h"
#include "record/series_channel.h"

namespace raceway::correction {

namespace {

struct Exchange {
  const Channel *a, *b;
};

/// Pairs of temperatures of which one drives the model. Sensors whose mean drives a channel are of
/// one place.
std::vector<Exchange> exchanges(const Model& model, std::span<const Channel* const> temperatures) {
  const std::vector<const Channel*> used = inputs_of(model);
  const auto has = [](const std::vector<const Channel*>& list, const Channel* c) {
    return std::find(list.begin(), list.end(), c) != list.end();
  };
  std::vector<Exchange> list;
  for (std::size_t i = 0; i < temperatures.size(); ++i)
    for (std::size_t j = i + 1; j < temperatures.size(); ++j) {
      const Channel *a = temperatures[i], *b = temperatures[j];
      if (!has(used, a) && !has(used, b)) continue;
      if (std::none_of(model.channels.begin(), model.channels.end(), [&](const DrivenChannel& c) {
            return has(c.input.columns, a) && has(c.input.columns, b);
          }))
        list.push_back({a, b});
    }
  return list;
}

}  // namespace

std::vector<Effect> ExchangedColumns::possible(const Surroundings& in) const {
  std::vector<const Channel*> temperatures;
  for (const Channel* c : in.varying)
    if (record::is_temperature(*c)) temperatures.push_back(c);
  if (exchanges(in.model, temperatures).empty()) return {};
  return {at()};
}

std::vector<fit::Fault> ExchangedColumns::faults(const FittedRecord& in) const {
  const record::Record& record = in.series.record();
  std::vector<const Channel*> temperatures;
  for (const record::Column& c : record.columns)
    if (record::is_temperature(*c.channel) && record.varies(*c.channel) &&
        leaping_rows(record, *c.channel).empty())  // others stand in for a bad one
      temperatures.push_back(c.channel);
  std::vector<fit::Fault> list;
  for (const auto& [a, b] : exchanges(in.model, temperatures)) {
    auto without = std::make_shared<record::Record>(record);
    std::swap(without->find(*a)->values, without->find(*b)->values);
    list.push_back({.id = std::string(exchanged_card.id),
                    .certain = false,
                    .datum = fmt::format("the columns {} and {}", a->name, b->name),
                    .correction = "each column has the values of the other column",
                    .without = std::move(without)});
  }
  return list;
}

}  // namespace raceway::correction
