#include "cli/sensitivity_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/messages.h"
#include "cli/text_table.h"
#include "session/sensitivity.h"
#include "text/names.h"

namespace raceway::cli {
namespace {

constexpr std::size_t narrowest = 116;  // columns of a table that is one piece

std::string with_sign(double value) {
  return std::isfinite(value) && value > 0.0 ? "+" + number(value, 3) : number(value, 3);
}

std::string with_error(double value, double error) {
  if (!std::isfinite(value)) return "-";
  const double shown = std::fabs(value) < 0.0005 ? 0.0 : value;
  return fmt::format("{:.3f} +-{:.3f}", shown, error);
}

std::string remark(const results::LocalSensitivity& local) {
  std::string words;
  const auto add = [&](const char* more) {
    words += (words.empty() ? "" : ", ") + std::string(more);
  };
  if (local.kink) add("kink");
  if (local.steps_disagree && !local.kink) add("steps disagree");
  if (local.one_sided) add("to one side");
  if (!std::isfinite(local.derivative)) add("no derivative");
  return words;
}

/// A line of names in lines of the terminal.
void print_words(const std::string& words) {
  for (const std::string& line : filled(words, std::max(terminal_width(), narrowest)))
    fmt::print("{}\n", line);
}

/// Names behind the reason that they share.
void print_reasons(std::string_view what,
                   const std::vector<std::pair<std::string, std::string>>& reasons) {
  std::vector<std::string> told;
  for (const auto& [first, why] : reasons) {
    if (std::find(told.begin(), told.end(), why) != told.end()) continue;
    told.push_back(why);
    std::vector<std::string> names;
    for (const auto& [name, other] : reasons)
      if (other == why) names.push_back(name);
    print_words(fmt::format("{}: {} ({})", what, text::listed(names), why));
  }
}

constexpr std::size_t most_named = 12;
constexpr double least_share = 0.001;  // what a table lists, of the squares of the changes

void print_prediction(const results::Sensitivity& s, const results::PredictionSensitivity& p,
                      bool all) {
  fmt::print("{} = {} at {}\n\n", p.name, number(p.value), session::words_of_state(s, p.state));
  std::vector<TextTable::Column> heads{{"datum", "", true}, {"value", ""}, {"+-", ""}};
  for (const char* name : {"derivative", "% per %", "change", "share %"})
    heads.push_back({name, ""});
  if (p.global) {
    heads.push_back({"first order", ""});
    heads.push_back({"total", ""});
  }
  heads.push_back({"", "", true});
  TextTable table(heads);
  std::vector<std::string> left_out;
  for (const std::size_t k : p.order) {
    const results::VariedDatum& d = s.data[k];
    const results::LocalSensitivity& local = p.local[k];
    const auto at = std::find(s.sampled.begin(), s.sampled.end(), k);
    const fit::SobolIndex* const global =
        p.global && at != s.sampled.end()
            ? &p.global->inputs[static_cast<std::size_t>(at - s.sampled.begin())]
            : nullptr;
    const bool small = local.share < least_share && !(global && global->total >= least_share);
    if (small && !all) {
      left_out.push_back(d.name);
      continue;
    }
    std::vector<std::string> row{
        d.name,
        fmt::format("{:.6g}", d.value),
        fmt::format("{:.3g}", d.spread),
        number(local.derivative),
        number(local.elasticity, 3),
        with_sign(local.change),
        std::isnan(local.share) ? "-" : fmt::format("{:.1f}", 100.0 * local.share)};
    if (p.global) {
      row.push_back(global ? with_error(global->first, global->first_error) : "-");
      row.push_back(global ? with_error(global->total, global->total_error) : "-");
    }
    row.push_back(remark(local));
    table.add(row);
  }
  fmt::print("{}",
             table.text(std::max<std::size_t>(terminal_width(), narrowest + (p.global ? 30 : 0))));
  if (!left_out.empty())
    print_words(fmt::format(
        "not in the table, because each number causes less than 0.1 % of the sum of the squared "
        "changes of the prediction: {}",
        left_out.size() > most_named ? fmt::format("{} numbers (--all lists them)", left_out.size())
                                     : text::listed(left_out)));
  if (p.global) {
    double alone = 0.0;
    for (const fit::SobolIndex& one : p.global->inputs) alone += one.first;
    fmt::print(
        "prediction over all samples: mean {}, standard deviation {}; the numbers alone, without "
        "interactions, cause a share of {:.3f} of the variance of the prediction\n",
        number(p.global->mean), number(p.global->std, 3), alone);
  }
  for (const std::string& line : p.cannot_tell) fmt::print("{}\n", line);
}

}  // namespace

void print_sensitivity(const results::Sensitivity& s, bool all) {
  fmt::print("Influence of the numbers of {} on its predictions\n", s.model);
  for (const results::PredictionSensitivity& p : s.predictions) {
    fmt::print("\n");
    print_prediction(s, p, all);
  }
  fmt::print("\n");
  if (!s.does_not_enter.empty()) print_words("no influence: " + text::listed(s.does_not_enter));
  print_reasons("not varied", s.not_varied);
  print_reasons("not sampled", s.not_sampled);
}

}  // namespace raceway::cli
