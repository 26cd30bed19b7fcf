#include "fit/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fit/quantity.h"

namespace raceway::fit {

namespace {

std::string with_unit(double value, const std::string& unit) {
  return unit == "1" || unit.empty() ? fmt::format("{:.3g}", value)
                                     : fmt::format("{:.3g} {}", value, unit);
}

}  // namespace

std::string joined(const std::vector<std::string>& words, const char* last) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 == words.size() ? std::string(" ") + last + " " : ", ") + words[k];
  return text;
}

std::string p_text(double p) { return p < 1e-300 ? "p < 1e-300" : fmt::format("p = {:.1g}", p); }

std::string nothing_missing_text(const Diagnosis& d) {
  std::vector<DetectableSize> easy = d.would_have_been_found;
  std::erase_if(easy, [](const DetectableSize& e) { return !(e.share_of_reading < 0.2); });
  std::stable_sort(easy.begin(), easy.end(), [](const DetectableSize& a, const DetectableSize& b) {
    return a.share_of_reading < b.share_of_reading;
  });
  std::vector<std::string> found, hidden;
  for (std::size_t k = 0; k < easy.size() && k < 3; ++k)
    found.push_back(fmt::format("{} from {}", easy[k].id, with_unit(easy[k].size, easy[k].unit)));
  for (const NotTestable& n : d.not_testable)
    if (hidden.size() < 3) hidden.push_back(n.id);
  return fmt::format(
      "Nothing missing that these data can show (p = {:.2g}, alarm level 1 %).{}{}", d.p_value,
      found.empty() ? "" : " Would have been found: " + joined(found, "and") + ".",
      hidden.empty() ? "" : " Could not have been found: " + joined(hidden, "and") + ", ...");
}

std::string error_text(const Diagnosis& d) {
  const QuantityText quantity = text_of(d.baseline.quantity);
  std::string text = fmt::format("{:.3g} -> {:.3g} {}", d.rmse_before / quantity.factor,
                                 d.rmse_after / quantity.factor, quantity.unit);
  if (!d.hold_out.empty()) {
    double before = 0.0, after = 0.0;
    for (const HoldOut& h : d.hold_out) {
      before += h.rmse_before * h.rmse_before;
      after += h.rmse_after * h.rmse_after;
    }
    const double count = static_cast<double>(d.hold_out.size());
    text += fmt::format(", on held-out blocks {:.3g} -> {:.3g}",
                        std::sqrt(before / count) / quantity.factor,
                        std::sqrt(after / count) / quantity.factor);
  }
  return text;
}

std::string shift_text(const Diagnosis& d) {
  std::vector<std::string> texts;
  for (const BaseShift& b : d.base_shifts) {
    const double share = b.before / b.after - 1.0;
    if (std::isfinite(share) && std::abs(share) >= 0.01)
      texts.push_back(fmt::format("{} had been {:.0f} % too {}", b.name, 100.0 * std::abs(share),
                                  share > 0.0 ? "high" : "low"));
  }
  return texts.empty() ? "" : "; " + joined(texts, "and");
}

std::string measure_text(const Diagnosis& d) {
  std::vector<std::string> texts;
  const bool shaft = d.baseline.quantity == Quantity::axial_displacement;
  for (const SuggestedMeasurement& m : d.suggested_measurements)
    if (texts.size() < 3)
      texts.push_back(shaft ? fmt::format("{:.0f} rpm{} ({} times)", m.point.speed / rpm,
                                          std::isfinite(m.preload)
                                              ? fmt::format(" at a preload of {:.0f} N", m.preload)
                                              : "",
                                          m.repeats)
                            : fmt::format("{:.0f} rpm, {:.0f} N, {:.0f} C ({} times)",
                                          m.point.speed / rpm, m.point.axial_load,
                                          m.point.temperature - kelvin(0), m.repeats));
  std::string text;
  if (!texts.empty())
    text =
        fmt::format(" Measure: {}; predicted difference {:.0f}, by repeating what exists {:.0f}.",
                    fmt::join(texts, "; "), d.predicted_separation, d.separation_by_repetition);
  if (!d.records_needed.empty())
    text += " Record: " + fmt::format("{}.", fmt::join(d.records_needed, "; "));
  return text;
}

std::string difference_text(const DataSet& data, const HiddenInput& hidden) {
  const Row& low = data.rows[hidden.low];
  const Row& high = data.rows[hidden.high];
  return fmt::format("lines {} and {}: {:.0f} and {:.0f} N mm at {:.0f} and {:.0f} rpm", low.line,
                     high.line, low.measured / N_mm, high.measured / N_mm, low.point.speed / rpm,
                     high.point.speed / rpm);
}

}  // namespace raceway::fit
