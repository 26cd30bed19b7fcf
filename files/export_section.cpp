#include "files/detail/export_section.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "correction/simulation.h"
#include "record/series_channel.h"

namespace raceway::files {
namespace {

const correction::ControlSettings usual_control;
const Key control_keys[]{
    {"limit_um", between(1e-3, 1e6, "um"), usual_control.limit_um.all,
     "largest offset in both directions; one value for all axes, or { COLUMN = ... } for each "
     "displacement"},
    {"slew_um_s", between(1e-6, 1e6, "um/s"), usual_control.slew_um_s.all,
     "highest slew rate of an offset; one value for all axes, or { COLUMN = ... } for each "
     "displacement"},
    {"limit_urad", between(1e-3, 1e6, "urad"), usual_control.limit_um.all,
     "largest angle offset in both directions; one value for all angles, or { COLUMN = ... } for "
     "each displacement"},
    {"slew_urad_s", between(1e-6, 1e6, "urad/s"), usual_control.slew_um_s.all,
     "highest slew rate of an angle offset; one value for all angles, or { COLUMN = ... } for each "
     "displacement"},
    {"sign", between(-1, 1), usual_control.sign.all,
     "sign in offset = sign * displacement, 1 or -1; with -1, the axis moves against the "
     "displacement; one value for all axes, or { COLUMN = ... } for each displacement"},
    {"unit", one_of("um|mm|counts"), usual_control.unit.all,
     "unit of the offset; with counts, the offset is a whole number of steps of count_um; one "
     "value for all axes, or { COLUMN = ... } for each displacement"},
    {"count_um", between(1e-6, 1e6, "um"), usual_control.count_um.all,
     "size of one count; one value for all axes, or { COLUMN = ... } for each displacement"},
    {"unit_of_angles", one_of("urad|mrad|rad|deg|counts"), "urad",
     "unit of an angle offset; with counts, the offset is a whole number of steps of count_urad; "
     "one value for all angles, or { COLUMN = ... } for each displacement"},
    {"count_urad", between(1e-6, 1e6, "urad"), usual_control.count_um.all,
     "size of one count of an angle offset; one value for all angles, or { COLUMN = ... } for each "
     "displacement"},
    {"axis", one_of("x|y|z|u|v|w|a|b|c"),
     "the LETTER in the column displacement_LETTER_um or displacement_LETTER_urad",
     "LinuxCNC axis that the offset moves"},
    {"plausible", a_list,
     "temperatures: [-40, 150] C; other inputs: up to 10 times the largest amount in "
     "[correction.range]",
     "[lowest, highest] plausible value of an input in its unit; one pair for all temperatures, or "
     "{ COLUMN = [...] } for any input"},
    {"fastest_per_s", between(0, 1e9), usual_control.fastest_per_s.all,
     "largest change of an input per second, in the unit of the input; 0 means no limit; one "
     "number for all temperatures, or { COLUMN = ... } for any input"},
    {"stuck_s", between(0, 1e9, "s"), usual_control.stuck_s.all,
     "longest time without a change of an input; 0 means no limit; one number for all "
     "temperatures, or { COLUMN = ... } for any input"},
    {"smoothing_s", between(0, 1e6, "s"), usual_control.smoothing_s.all,
     "time constant of a low-pass filter on an input, for sensors with a coarse resolution. Only "
     "the parts of the correction without lag use the filtered input. One number for all inputs, "
     "or { COLUMN = ... }"},
    {"on_fault", one_of("hold|last-safe|zero"), usual_control.on_fault,
     "reaction to a faulty input after hold_s: hold (use its last value), last-safe (fade to the "
     "last offset from good inputs) or zero (fade to 0)"},
    {"hold_s", between(0, 1e6, "s"), usual_control.hold_s,
     "time for which the program uses the last good value of a faulty input"},
    {"fade_s", between(0.1, 1e6, "s"), usual_control.fade_s,
     "time in which an offset fades if a fault lasts longer than hold_s, and in which the offset "
     "returns when the fault has ended"},
    {"longest_gap_s", between(1e-3, 1e6, "s"), usual_control.longest_gap_s,
     "longest normal time between two calls of the exported program; after a longer gap, offsets "
     "move at most as far as in this time, and the program raises an alarm"},
    {"clock_jump_s", between(1e-3, 1e9, "s"), usual_control.clock_jump_s,
     "limit of the time between two calls of the exported program; if more time passes without a "
     "restart, the program assumes that the clock was changed, and the offsets keep their values"},
    {"restart", one_of("decay|resume|rest"), usual_control.restart,
     "state of the lags of the correction after the control was off for longer than longest_gap_s: "
     "decay (assume speeds and feeds of 0 in this time), resume (assume that no time has passed) "
     "or rest (start from a machine at rest)"},
    {"touch_off", one_of("keep|clear"), usual_control.touch_off,
     "offset after a touch-off: keep the applied offset, or clear it to 0; later offsets are "
     "measured from this value"},
    {"disabled", one_of("zero|freeze"), usual_control.disabled,
     "offsets when the correction is disabled: zero (go to 0 at their slew rate) or freeze (keep "
     "their values)"},
    {"beyond_range", one_of("linear|hold"), usual_control.beyond_range,
     "treatment of inputs outside [correction.range] in sections: linear (extrapolate) or hold "
     "(use the limit of the range); other parts of the correction always use the limit"},
};

class ExportReader {
 public:
  ExportReader(const ModelTables& tables, const std::vector<correction::Model>& models)
      : s_(tables.section("export", {control_keys})) {
    for (const correction::Model& m : models) {
      axes_.emplace_back(m.displacement->name);
      (record::is_angle(*m.displacement) ? angles_ : lengths_).push_back(axes_.back());
      for (const correction::Channel* c : correction::inputs_of(m)) inputs_.emplace_back(c->name);
    }
  }

  correction::ControlSettings read() {
    correction::ControlSettings all;
    of_displacements("limit_um", "limit_urad", all.limit_um, all.limit_um.all);
    of_displacements("slew_um_s", "slew_urad_s", all.slew_um_s, all.slew_um_s.all);
    number("sign", axes_, all.sign);
    of_displacements("unit", "unit_of_angles", all.unit, std::string("urad"));
    of_displacements("count_um", "count_urad", all.count_um, all.count_um.all);
    text("axis", axes_, all.axis);
    limits("plausible", all.plausible);
    number("fastest_per_s", inputs_, all.fastest_per_s);
    number("stuck_s", inputs_, all.stuck_s);
    number("smoothing_s", inputs_, all.smoothing_s);
    all.on_fault = s_.choice("on_fault").value_or(all.on_fault);
    // Defaults are no defaults of the model: what a control runs says all of them.
    all.hold_s = s_.value("hold_s");
    all.fade_s = s_.value("fade_s");
    all.longest_gap_s = s_.value("longest_gap_s");
    all.clock_jump_s = s_.value("clock_jump_s");
    if (all.clock_jump_s < all.longest_gap_s)
      s_.fail(s_.find("clock_jump_s") ? "clock_jump_s" : "longest_gap_s",
              fmt::format("clock_jump_s = {:g} s: must be at least longest_gap_s = {:g} s",
                          all.clock_jump_s, all.longest_gap_s));
    all.restart = s_.choice("restart").value_or(all.restart);
    all.touch_off = s_.choice("touch_off").value_or(all.touch_off);
    all.disabled = s_.choice("disabled").value_or(all.disabled);
    all.beyond_range = s_.choice("beyond_range").value_or(all.beyond_range);
    check_signs(all.sign);
    return all;
  }

 private:
  /// The table of values by column, where the key has one; its columns are checked.
  [[nodiscard]] const toml::table* by_column(std::string_view key, const Names& known) const {
    const toml::node* const node = s_.find(key);
    if (!node || !node->is_table()) return nullptr;
    for (const auto& [column, _] : *node->as_table())
      if (std::find(known.begin(), known.end(), column.str()) == known.end())
        s_.fail(key,
                fmt::format("{} = {}: {} is none of {}{}", key, text::shown(*node), column.str(),
                            &known == &inputs_ ? "the inputs" : "the displacements",
                            known.empty() ? "" : ": " + text::listed(known)));
    return node->as_table();
  }

  /// A value of all columns, or a table of values by column; `one` reads a key of a table.
  template <typename T, typename One>
  void read(std::string_view key, const Names& known, correction::ByColumn<T>& value,
            const One& one) {
    const toml::table* const columns = by_column(key, known);
    if (!columns) {
      value.all = one(s_, key);
      return;
    }
    const Section of_columns(s_.source(), fmt::format("export.{}", key), columns);
    for (const auto& [column, _] : *columns)
      value.columns.emplace_back(column.str(), one(of_columns, column.str()));
  }
  void number(std::string_view name, const Names& known, correction::ByColumn<double>& value) {
    const Key& key = s_.key(name);
    read(name, known, value, [&](const Section& s, std::string_view at) {
      return s.number(key.as(at, key.form.unit)).value_or(value.all);
    });
  }
  void text(std::string_view name, const Names& known, correction::ByColumn<std::string>& value) {
    const Names choices = s_.key(name).form.choices();
    read(name, known, value, [&](const Section& s, std::string_view at) {
      return s.choice(at, choices).value_or(value.all);
    });
  }
  void one(std::string_view name, const Names& known, correction::ByColumn<double>& value) {
    number(name, known, value);
  }
  void one(std::string_view name, const Names& known, correction::ByColumn<std::string>& value) {
    text(name, known, value);
  }
  /// A key of lengths and its like of angles; the values of angles stand by their column.
  template <typename T>
  void of_displacements(std::string_view of_length, std::string_view of_angle,
                        correction::ByColumn<T>& value, T usual) {
    for (const auto& [key, known, kind] :
         {std::tuple{of_length, &lengths_, "a length"}, std::tuple{of_angle, &angles_, "an angle"}})
      if (s_.find(key) && known->empty())
        s_.fail(key, fmt::format("{}: the model has no displacement that is {}", key, kind));
    one(of_length, lengths_, value);
    correction::ByColumn<T> angles{usual, {}};
    one(of_angle, angles_, angles);
    for (const std::string& column : angles_) value.columns.emplace_back(column, angles.of(column));
  }

  void limits(std::string_view key, correction::ByColumn<correction::ControlLimits>& value) {
    read(key, inputs_, value, [&](const Section& s, std::string_view name) {
      const toml::node* const at = s.find(name);
      if (!at) return value.all;
      const toml::array* const pair = at->as_array();
      const auto low = pair && pair->size() == 2 ? pair->get(0)->value<double>() : std::nullopt,
                 high = pair && pair->size() == 2 ? pair->get(1)->value<double>() : std::nullopt;
      if (!low || !high || !(*low < *high) || !(std::abs(*low) <= 1e9 && std::abs(*high) <= 1e9))
        throw text::InputError(
            fmt::format(
                "{}: {} = {}: must be [lowest, highest], in ascending order and from -1e9 to 1e9",
                s_.place(at), name, text::shown(*at)),
            s_.at(key, at));
      return correction::ControlLimits{*low, *high};
    });
  }

  void check_signs(const correction::ByColumn<double>& sign) const {
    const auto check = [&](double value) {
      if (value != 1.0 && value != -1.0)
        s_.fail("sign", fmt::format("sign = {:g}: must be 1 or -1", value));
    };
    check(sign.all);
    for (const auto& one : sign.columns) check(one.second);
  }

  Section s_;
  Names axes_, lengths_, angles_, inputs_;  ///< columns
};

}  // namespace

std::vector<KeyTable> export_tables() { return {{"export", control_keys}}; }

correction::ControlSettings read_export(const ModelTables& tables,
                                        const std::vector<correction::Model>& models) {
  if (const toml::node* const node = tables.root().get("export"); node && !node->is_table())
    throw text::InputError(fmt::format("{}: export = {}: must be a table, [export]",
                                       tables.source(), text::shown(*node)),
                           {.file = tables.source(), .key = "export"});
  return ExportReader(tables, models).read();
}

}  // namespace raceway::files
