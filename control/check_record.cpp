#include "control/check_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "correction/effect_kind.h"
#include "correction/quantum.h"
#include "correction/range.h"
#include "correction/series.h"
#include "correction/simulation.h"
#include "files/series_file.h"
#include "record/digits.h"
#include "record/series_channel.h"
#include "record/units.h"
#include "text/number_text.h"

namespace raceway::control {
namespace {

using Rows = std::vector<ControlCheck::Row>;

/// As what drives the plan has them: no farther than the models have seen.
double held(const ControlInput& in, double value) {
  if (std::isnan(in.lowest)) return value;
  if (!in.by_amount) return std::clamp(value, in.lowest, in.highest);
  return std::copysign(std::min(std::abs(value), in.highest), value);
}

/// The rows as they are read again: a control gets no digit that `correct` does not get.
record::Record record_of(const ControlPlan& plan, const Rows& rows) {
  std::string text = "time_s";
  std::vector<const record::Channel*> needed;
  for (const ControlInput& in : plan.inputs) {
    text += "," + in.column;
    needed.push_back(record::series_channel(in.column));
  }
  text += "\n";
  for (const ControlCheck::Row& r : rows)
    text += fmt::format("{:.15g}{}{:.15g}\n", r.time_s, r.inputs.empty() ? "" : ",",
                        fmt::join(r.inputs, ","));
  return files::read_series({"check record", text}, {}, needed);
}

/// Fills in the displacements; ends before the first row at which a model cannot say one.
ControlCheck filled_in(const ControlPlan& plan, const std::vector<correction::Model>& models,
                       Rows rows) {
  if (rows.size() < 2) return {};
  const record::Record record = record_of(plan, rows);
  const correction::Series series(record);
  std::size_t good = rows.size();
  for (correction::Model m : models) {
    std::erase_if(m.effects,
                  [](const correction::Effect& e) { return correction::card_of(e).of_reading; });
    std::vector<double> y(record.rows());
    correction::simulate(m, series, y);
    for (const correction::Beyond::Part& p : correction::beyond_range(m, series).parts)
      if (!p.column && !p.together()) good = std::min(good, p.first);
    for (std::size_t k = 0; k < good; ++k) {
      if (!std::isfinite(y[k])) good = k;
      if (k < good) rows[k].displacements_um.push_back(y[k] / um);
    }
  }
  rows.resize(good);
  return {good < 2 ? Rows{} : std::move(rows)};
}

}  // namespace

ControlCheck check_of(const ControlPlan& plan, const std::vector<correction::Model>& models,
                      const record::Record& record, std::size_t most_rows) {
  Rows rows;
  for (std::size_t k = 0; k < std::min(record.rows(), most_rows); ++k) {
    if (record.run_of(k) != record.run_of(0)) break;
    ControlCheck::Row row{.time_s = text::with_15_digits(record.value(record::time, k))};
    for (const ControlInput& in : plan.inputs) {
      const record::Channel& c = *record::series_channel(in.column);
      row.inputs.push_back(held(in, text::with_15_digits(c.in_unit(record.value(c, k)))));
    }
    rows.push_back(std::move(row));
  }
  return filled_in(plan, models, std::move(rows));
}

std::vector<std::string> coarse_sensors(const ControlPlan& plan, const record::Record& record) {
  constexpr double noticed_um = 0.5;
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < plan.inputs.size(); ++k) {
    const ControlInput& in = plan.inputs[k];
    const record::Channel& c = *record::series_channel(in.column);
    if (!in.temperature || in.smoothing_s > 0.0) continue;
    const double step_K = correction::quantum_of(c, record.values(c));
    for (const ControlAxis& a : plan.axes) {
      double per_K = 0.0;
      const auto add = [&](std::size_t drive, double gain) {
        const ControlDrive& d = plan.drives[drive];
        if (d.kind != ControlDrive::Kind::rise) return;
        const auto times = std::count(d.inputs.begin(), d.inputs.end(), k);
        per_K += gain * (static_cast<double>(times) / static_cast<double>(d.inputs.size()) -
                         (d.reference == k ? 1.0 : 0.0));
      };
      for (const ControlFeedthrough& f : a.feedthroughs) add(f.drive, f.gain);
      for (const ControlSection& s : a.sections) add(s.drive, s.direct * s.gain);
      if (!(std::abs(per_K) * step_K >= noticed_um)) continue;
      notes.push_back(fmt::format(
          "{} has steps of {:.3g} K, and each step moves {} by {:.3g} {} immediately; [export] "
          "smoothing_s = {{ {} = 60 }} smooths the steps",
          in.column, step_K, a.column, std::abs(per_K) * step_K, unit_of(a), in.column));
    }
  }
  return notes;
}

std::vector<std::string> allow_still_sensors(ControlPlan& plan, const record::Record& record) {
  std::vector<std::string> notes;
  for (ControlInput& in : plan.inputs) {
    const record::Channel& channel = *record::series_channel(in.column);
    const std::span<const double> values = record.values(channel);
    const double step = in.temperature ? correction::quantum_of(channel, values) : unset;
    const std::string where = std::isnan(step)
                                  ? record.source
                                  : fmt::format("{} (resolution {:.3g} K)", record.source, step);
    std::string note =
        allow_to_stand(in, correction::longest_still(record, values).longest, plan.settings, where);
    if (!note.empty()) notes.push_back(std::move(note));
  }
  return notes;
}

ControlCheck made_up_check(const ControlPlan& plan, const std::vector<correction::Model>& models) {
  constexpr int count = 60;
  double slowest = 600.0, sampling = 0.0;
  for (const ControlAxis& a : plan.axes)
    for (const ControlSection& s : a.sections) slowest = std::max(slowest, s.time_constant_s);
  for (const correction::Model& m : models)
    for (const correction::DrivenChannel& c : m.channels)
      if (c.printed) sampling = c.printed->sampling;
  const double step = sampling > 0.0 ? sampling : std::round(2.0 * slowest / count);
  // Of a speed that draws more power than a model has seen, less.
  for (double share = 1.0; share > 0.01; share *= 0.5) {
    Rows rows;
    double time = 0.0;
    for (int k = 0; k < count; ++k) {
      // An uneven clock, and a gap after two thirds; as it was printed, where it was.
      if (k > 0) time += sampling > 0.0 ? step : step * (k == 40 ? 8.0 : 0.5 + 0.25 * (k % 5));
      ControlCheck::Row row{.time_s = text::with_15_digits(time)};
      for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
        const ControlInput& in = plan.inputs[i];
        const double place = static_cast<double>(i + 1), turn = 2.0 * pi * k / count;
        if (in.column == "coolant_on") {
          row.inputs.push_back(k % 20 < 12 ? 1.0 : 0.0);
        } else if (in.temperature) {
          const double low = std::isnan(in.lowest) ? 20.0 : in.lowest,
                       high = std::isnan(in.highest) ? 35.0 : in.highest;
          row.inputs.push_back(record::with_digits(
              low + (high - low) * 0.5 * (1.0 - std::cos(turn * (1.0 + 0.3 * place))), 6));
        } else {
          const double high =
              std::isnan(in.highest) ? (in.unit == "rpm" ? 6000.0 : 10.0) : in.highest;
          const double low = in.by_amount || std::isnan(in.lowest) ? 0.0 : in.lowest;
          const int block = (k / 6 + static_cast<int>(i)) % 5;
          row.inputs.push_back(record::with_digits(share * (low + (high - low) * 0.25 * block), 6));
        }
        row.inputs.back() = held(in, row.inputs.back());
      }
      rows.push_back(std::move(row));
    }
    ControlCheck check = filled_in(plan, models, std::move(rows));
    if (check.rows.size() == count || share < 0.02) return check;
  }
  return {};
}

}  // namespace raceway::control
