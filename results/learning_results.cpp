#include "results/learning_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "record/digits.h"
#include "results/detail/correction_objects.h"
#include "results/detail/fit_objects.h"
#include "text/detail/json_text.h"
#include "text/number_text.h"

namespace raceway::results {
namespace {

using correction::Learning;

text::json place_of(const record::Record& record, std::size_t row) {
  return {{"line", record.line(row)}, {"time_s", record.value(record::time, row)}};
}

text::json readings_of(const Learning& l, const record::Record& record) {
  text::json list = text::json::array();
  for (const correction::OfferedReading& r : l.readings) {
    text::json one = place_of(record, r.row);
    one.update({{"reading_um", r.reading / um},
                {"predicted_um", r.predicted / um},
                {"std_um", r.std / um},
                {"learnt", r.learnt},
                {"zeroed", r.zeroed},
                {"good_for_s", r.good_for}});
    list.push_back(std::move(one));
  }
  return list;
}

text::json gains_of(const Learning& l) {
  text::json list = text::json::array();
  for (const correction::LearntGain& g : l.gains) {
    const double unit = g.is_lag ? um : 1.0;
    list.push_back({{"name", g.name},
                    {"kind", g.is_lag ? "lag" : "gain"},
                    {"value", g.value / unit},
                    {"std", g.std / unit},
                    {"unit", g.is_lag ? "um" : "1"},
                    {"at_bound", g.at_bound}});
  }
  return list;
}

text::json object_of(const Learnt& one, const record::Record& record) {
  const Learning& l = one.learning;
  const auto learnt =
      std::count_if(l.readings.begin(), l.readings.end(), [](const auto& r) { return r.learnt; });
  const auto all = static_cast<std::ptrdiff_t>(l.readings.size());
  text::json due = text::json::array();
  for (const correction::IdentificationDue& d : l.due) {
    due.push_back(place_of(record, d.row));
    due.back()["reason"] = d.reason;
  }
  const text::json object = {{"displacement", one.displacement->name},
                             {"readings_learnt", learnt},
                             {"readings_refused", all - learnt},
                             {"between_readings",
                              {{"readings", l.error.readings},
                               {"rmse_first_zero_um", l.error.first / um},
                               {"rmse_last_zero_um", l.error.zeroed / um},
                               {"rmse_learnt_um", l.error.learnt / um}}},
                             {"tolerance_um", l.tolerance / um},
                             {"rows_beyond_tolerance", l.rows_beyond_tolerance},
                             {"next_reading_due_s", l.next_reading},
                             {"next_reading_ever_due", !std::isinf(l.next_reading)},
                             {"identification_due", std::move(due)},
                             {"misfit_um", l.misfit / um},
                             {"reading_std_um", l.reading_std / um},
                             {"level", l.level},
                             {"gains", gains_of(l)},
                             {"readings", readings_of(l, record)}};
  return in_unit_of(*one.displacement, object);
}

}  // namespace

std::string learnt_text(const record::Record& record, const std::vector<Learnt>& learnt) {
  std::string result = "time_s";
  for (const Learnt& one : learnt)
    for (const std::string_view name : {"predicted", "std", "residual", "reading"})
      result += learnt.size() > 1   ? fmt::format(",{}_{}", name, one.displacement->name)
                : name == "reading" ? std::string(",reading")
                                    : fmt::format(",{}_{}", name, one.displacement->unit);
  result += '\n';
  const auto cell = [&](double value) {
    result += ',';
    if (std::isfinite(value)) result += fmt::format("{}", record::with_digits(value / um, 9));
  };
  std::vector<std::size_t> next(learnt.size(), 0);  // of the offered readings
  for (std::size_t row = 0; row < record.rows(); ++row) {
    result += fmt::format("{}", text::with_15_digits(record.value(record::time, row)));
    for (std::size_t k = 0; k < learnt.size(); ++k) {
      const Learning& l = learnt[k].learning;
      cell(l.predicted[row]);
      cell(l.std[row]);
      cell(record.value(*learnt[k].displacement, row) - l.predicted[row]);
      result += ',';
      if (next[k] < l.readings.size() && l.readings[next[k]].row == row)
        result += l.readings[next[k]++].learnt ? "learnt" : "refused";
    }
    result += '\n';
  }
  return result;
}

std::string learnt_json(const std::string& model_file, const record::Record& record,
                        const std::vector<Learnt>& learnt,
                        const std::vector<record::Note>& messages) {
  text::json document = {{"model", model_file}, {"data", data_of(record)}, {"rows", record.rows()}};
  text::json axes = text::json::array();
  for (const Learnt& one : learnt) axes.push_back(object_of(one, record));
  document.update(axes.at(0));
  if (axes.size() > 1) document["axes"] = std::move(axes);
  text::put_notes(document, "messages", messages);
  return text::text(document);
}

}  // namespace raceway::results
