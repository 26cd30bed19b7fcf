#include "cli/diagnosis_errors_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "cli/diagnosis_effects_text.h"
#include "cli/error_text.h"
#include "cli/text_bars.h"
#include "cli/text_table.h"

namespace raceway::cli {
namespace {

/// Returns the errors of one channel as bars against the noise, and against the tolerance where
/// that decides. `brief` has noise and tolerance in its heading.
std::string ladder_text(const verdict::Diagnosis& d, const verdict::ChannelDiagnosis& c,
                        bool brief) {
  constexpr std::size_t bar_width = 40;
  const record::Channel& of = c.channel();
  const double tolerance = d.tolerance_limited() ? c.tolerance : unset;
  const bool tolerated = !std::isnan(tolerance);
  const auto shown = [&](double error) {
    return brief ? " " + error_text(error, of, error_digits) : std::string();
  };
  const std::string title =
      d.channels.size() > 1 ? fmt::format("RMS error of {}", of.words) : "RMS error";
  const std::string marks = "| noise" + shown(c.noise.rms) +
                            (tolerated ? ", : tolerance" + shown(tolerance) : std::string());
  TextTable ladder(
      brief ? std::vector<TextTable::Column>{{fmt::format("{} [{}]", title, error_unit(of)), "",
                                              true},
                                             {"", ""},
                                             {marks, "", true}}
            : std::vector<TextTable::Column>{
                  {title, "", true}, {"", error_unit(of)}, {"", marks, true}});
  std::vector<std::pair<const char*, double>> rungs{{"before", c.rmse_before}};
  if (c.rmse_after < c.rmse_before) rungs.emplace_back("after", c.rmse_after);
  if (tolerated) {
    rungs.emplace_back("held out, before", c.rmse_held_out_before);
    rungs.emplace_back("held out, after", c.rmse_held_out_after);
    std::erase_if(rungs, [](const auto& rung) { return std::isnan(rung.second); });
  }
  double widest = std::fmax(0.0, tolerance);
  for (const auto& [_, error] : rungs) widest = std::max(widest, error);
  for (const auto& [name, error] : rungs)
    ladder.add({name, error_text(error, of, error_digits),
                bar(error, widest, bar_width, c.noise.rms, tolerance)});
  if (!brief) ladder.add({"noise", error_text(c.noise.rms, of, error_digits), ""});
  if (tolerated && !brief) ladder.add({"tolerance", error_text(tolerance, of, error_digits), ""});
  return ladder.text(terminal_width());
}

/// One line for each channel. `brief` has fewer columns and at most four channels: those that err
/// most against their noise or their tolerance.
std::string channels_text(const verdict::Diagnosis& d, bool brief) {
  const bool tolerated = d.tolerance_limited();
  std::vector<const verdict::ChannelDiagnosis*> shown;
  for (const verdict::ChannelDiagnosis& c : d.channels) shown.push_back(&c);
  constexpr std::size_t most = 4;
  if (brief && shown.size() > most) {
    const auto share = [&](const verdict::ChannelDiagnosis* c) {
      return c->rmse_before / (tolerated ? c->tolerance : c->noise.rms);
    };
    std::stable_sort(shown.begin(), shown.end(),
                     [&](const auto* a, const auto* b) { return share(a) > share(b); });
    shown.resize(most);
  }
  std::vector<TextTable::Column> columns{{"RMS error", "", true}, {"before", ""}, {"after", ""}};
  if (tolerated && !brief) columns.push_back({"held out,", "before"});
  if (tolerated)
    columns.push_back(brief ? TextTable::Column{"held out", ""}
                            : TextTable::Column{"held out,", "after"});
  if (!brief || !tolerated) columns.push_back({"noise", ""});
  if (tolerated) columns.push_back({"tolerance", ""});
  columns.push_back({"unit", "", true});
  TextTable table(columns);
  for (const verdict::ChannelDiagnosis* const channel : shown) {
    const verdict::ChannelDiagnosis& c = *channel;
    const record::Channel& of = c.channel();
    const auto text = [&](double error) { return error_text(error, of, error_digits); };
    std::vector<std::string> row{std::string(of.words), text(c.rmse_before), text(c.rmse_after)};
    if (tolerated && !brief) row.push_back(text(c.rmse_held_out_before));
    if (tolerated) row.push_back(text(c.rmse_held_out_after));
    if (!brief || !tolerated) row.push_back(text(c.noise.rms));
    if (tolerated) row.push_back(text(c.tolerance));
    row.emplace_back(error_unit(of));
    table.add(std::move(row));
  }
  return table.text(terminal_width());
}

}  // namespace

std::string errors_text(const verdict::Diagnosis& d, bool brief) {
  if (d.channels.size() >= many_channels) return channels_text(d, brief);
  std::string text;
  for (const verdict::ChannelDiagnosis& c : d.channels) text += ladder_text(d, c, brief);
  return text;
}

}  // namespace raceway::cli
