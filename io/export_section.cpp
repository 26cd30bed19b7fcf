#include "io/export_section.h"

#include <algorithm>
#include <cmath>

#include "correction/simulation.h"
#include "record/series_channel.h"

namespace raceway::io {
namespace {

class ExportReader {
 public:
  ExportReader(const ModelTables& tables, const std::vector<correction::Model>& models)
      : s_(tables.section("export")) {
    for (const correction::Model& m : models) {
      axes_.emplace_back(m.displacement->name);
      for (const correction::Channel* c : correction::inputs_of(m)) inputs_.emplace_back(c->name);
    }
  }

  ControlSettings read() {
    s_.allow_only({"limit_um", "slew_um_s", "sign", "unit", "count_um", "axis", "plausible",
                   "fastest_per_s", "stuck_s", "smoothing_s", "on_fault", "hold_s", "fade_s",
                   "longest_gap_s", "clock_jump_s", "restart", "touch_off", "disabled",
                   "beyond_range"});
    ControlSettings all;
    number({"limit_um", "um", 1e-3, 1e6}, axes_, all.limit_um);
    number({"slew_um_s", "um/s", 1e-6, 1e6}, axes_, all.slew_um_s);
    number({"sign", "1", -1, 1}, axes_, all.sign);
    text("unit", {"um", "mm", "counts"}, all.unit);
    number({"count_um", "um", 1e-6, 1e6}, axes_, all.count_um);
    text("axis", {"x", "y", "z", "u", "v", "w"}, all.axis);
    limits("plausible", all.plausible);
    number({"fastest_per_s", "", 0, 1e9}, inputs_, all.fastest_per_s);
    number({"stuck_s", "s", 0, 1e9}, inputs_, all.stuck_s);
    number({"smoothing_s", "s", 0, 1e6}, inputs_, all.smoothing_s);
    all.on_fault = choice_or("on_fault", {"hold", "last-safe", "zero"}, all.on_fault);
    all.hold_s = number_or({"hold_s", "s", 0, 1e6}, all.hold_s);
    all.fade_s = number_or({"fade_s", "s", 0.1, 1e6}, all.fade_s);
    all.longest_gap_s = number_or({"longest_gap_s", "s", 1e-3, 1e6}, all.longest_gap_s);
    all.clock_jump_s = number_or({"clock_jump_s", "s", 1e-3, 1e9}, all.clock_jump_s);
    if (all.clock_jump_s < all.longest_gap_s)
      s_.fail(s_.find("clock_jump_s") ? "clock_jump_s" : "longest_gap_s",
              fmt::format("clock_jump_s = {:g} s: must be at least longest_gap_s = {:g} s",
                          all.clock_jump_s, all.longest_gap_s));
    all.restart = choice_or("restart", {"decay", "resume", "rest"}, all.restart);
    all.touch_off = choice_or("touch_off", {"keep", "clear"}, all.touch_off);
    all.disabled = choice_or("disabled", {"zero", "freeze"}, all.disabled);
    all.beyond_range = choice_or("beyond_range", {"linear", "hold"}, all.beyond_range);
    check_signs(all.sign);
    return all;
  }

 private:
  // Defaults are no defaults of the model: what a control runs says all of them.
  double number_or(const Key& key, double fallback) const {
    note_fallback(key.name, fmt::format("{:.10g}", fallback));
    return s_.number(key).value_or(fallback);
  }
  std::string choice_or(std::string_view key, const Names& allowed,
                        const std::string& fallback) const {
    note_fallback(key, fmt::format("\"{}\"", fallback));
    return s_.choice(key, allowed).value_or(fallback);
  }
  void note_fallback(std::string_view key, const std::string& value) const {
    if (KeyBook* const book = KeyBook::open()) book->entry(s_.name(), key).fallback = value;
  }

  /// The table of values by column, where the key has one; its columns are checked.
  [[nodiscard]] const toml::table* by_column(std::string_view key, const Names& known) const {
    const toml::node* const node = s_.find(key);
    if (!node || !node->is_table()) return nullptr;
    for (const auto& [column, _] : *node->as_table())
      if (std::find(known.begin(), known.end(), column.str()) == known.end())
        s_.fail(key, fmt::format("{} = {}: {} is none of {}{}", key, shown(*node), column.str(),
                                 &known == &axes_ ? "the displacements" : "the inputs",
                                 known.empty() ? "" : ": " + listed(known)));
    return node->as_table();
  }
  [[nodiscard]] Section section_of(std::string_view key, const toml::table& columns) const {
    return Section(s_.source(), fmt::format("export.{}", key), &columns);
  }

  void number(const Key& key, const Names& known, ByColumn<double>& value) {
    if (const toml::table* const columns = by_column(key.name, known)) {
      for (const auto& [column, _] : *columns)
        value.columns.emplace_back(
            column.str(),
            *section_of(key.name, *columns).number({column.str(), key.unit, key.lower, key.upper}));
      return;
    }
    value.all = number_or(key, value.all);
  }

  void text(std::string_view key, const Names& allowed, ByColumn<std::string>& value) {
    if (const toml::table* const columns = by_column(key, axes_)) {
      for (const auto& [column, _] : *columns)
        value.columns.emplace_back(column.str(),
                                   *section_of(key, *columns).choice(column.str(), allowed));
      return;
    }
    if (!value.all.empty())
      value.all = choice_or(key, allowed, value.all);
    else
      value.all = s_.choice(key, allowed).value_or("");
  }

  void limits(std::string_view key, ByColumn<ControlLimits>& value) {
    const toml::node* const node = s_.find(key);
    if (!node) return;
    const toml::table* const columns = by_column(key, inputs_);
    const auto read = [&](std::string_view name, const toml::node& at) {
      const toml::array* const pair = at.as_array();
      const auto low = pair && pair->size() == 2 ? pair->get(0)->value<double>() : std::nullopt,
                 high = pair && pair->size() == 2 ? pair->get(1)->value<double>() : std::nullopt;
      if (!low || !high || !(*low < *high) || !(std::abs(*low) <= 1e9 && std::abs(*high) <= 1e9))
        throw InputError(
            fmt::format("{}: {} = {}: must be [lowest, highest]", s_.place(&at), name, shown(at)),
            s_.at(key, &at));
      return ControlLimits{*low, *high};
    };
    if (!columns) {
      value.all = read(key, *node);
      return;
    }
    for (const auto& [column, at] : *columns)
      value.columns.emplace_back(column.str(), read(column.str(), at));
  }

  void check_signs(const ByColumn<double>& sign) const {
    const auto check = [&](double value) {
      if (value != 1.0 && value != -1.0)
        s_.fail("sign", fmt::format("sign = {:g}: must be 1 or -1", value));
    };
    check(sign.all);
    for (const auto& one : sign.columns) check(one.second);
  }

  Section s_;
  Names axes_, inputs_;
};

}  // namespace

ControlSettings read_export(const ModelTables& tables,
                            const std::vector<correction::Model>& models) {
  if (const toml::node* const node = tables.root().get("export"); node && !node->is_table())
    throw InputError(
        fmt::format("{}: export = {}: must be a table, [export]", tables.source(), shown(*node)),
        {.file = tables.source(), .key = "export"});
  return ExportReader(tables, models).read();
}

}  // namespace raceway::io
