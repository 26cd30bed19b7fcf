#include "session/tolerance.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>
#include <vector>

#include "correction/correction_subject.h"
#include "files/subject.h"
#include "text/csv.h"
#include "text/error.h"
#include "text/number_text.h"

namespace raceway::session {
namespace {

struct Amount {
  double value = unset;
  std::string unit = {};
};

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw text::InputError(fmt::format("--tolerance: {}: {}", text::quoted(text), why),
                         {.key = "--tolerance"});
}

/// "2 N mm" is 2 and "Nmm".
Amount parsed(const std::string& text) {
  Amount t;
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data() + begin, last, t.value);
  if (error != std::errc() || end == last)
    refuse(text, "write a number and its unit, such as 2Nmm or 2um,0.5K");
  if (!std::isfinite(t.value) || t.value <= 0.0) refuse(text, "must be a number above 0");
  t.unit.assign(end, last);
  std::erase(t.unit, ' ');
  return t;
}

std::string allowed(const std::vector<fit::Measured>& measured) {
  std::vector<std::string> units;
  for (const fit::Measured& m : measured)
    units.push_back(fmt::format("{} ({})", text::difference_unit(*m.channel), m.channel->words));
  return fmt::format("{}", fmt::join(units, ", "));
}

}  // namespace

void Tolerance::set(const std::vector<fit::Measured>& measured, const std::string& source,
                    std::string_view table, const Set& take) const {
  std::vector<std::string> taken;
  if (text.empty()) return;
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ',');) {
    const Amount given = parsed(item);
    if (std::find(taken.begin(), taken.end(), given.unit) != taken.end())
      refuse(item, fmt::format("two tolerances in {} are given; keep one", given.unit));
    taken.push_back(given.unit);
    bool known = false;
    for (const fit::Measured& m : measured) {
      const record::Channel& channel = *m.channel;
      if (text::difference_unit(channel) != given.unit) continue;
      known = true;
      if (!std::isnan(m.tolerance))
        refuse(item, fmt::format("{} is already given under [{}] of {}; remove one of the two",
                                 text::tolerance_key(channel), table, source));
      take(channel, given.value * channel.factor);
    }
    if (!known)
      refuse(item, fmt::format("{} predicts no quantity in {}; allowed: {}", source, given.unit,
                               allowed(measured)));
  }
}

void Tolerance::set(files::ModelFile& file) const {
  if (text.empty()) return;
  set(files::measurable(file.model), file.source, "loop",
      [&](const record::Channel& channel, double value) {
        file.model.tolerances.push_back({std::string(channel.name), value});
      });
}

void Tolerance::set(correction::Model& model, const std::string& source) const {
  set(correction::CorrectionSubject(model).measured(), source, "correction",
      [&](const record::Channel&, double value) { model.tolerance = value; });
}

}  // namespace raceway::session
