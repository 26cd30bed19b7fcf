#include <algorithm>
#include <cmath>
#include <map>

#include "correction/catalogue.h"
#include "correction/numbers.h"
#include "correction/own_effect.h"
#include "files/correction_file.h"
#include "files/model_file.h"
#include "text/format_number.h"
#include "text/number_text.h"

// Last: see text/detail/toml_text.h.
#include "files/detail/correction_trust.h"
#include "files/detail/marked_values.h"
#include "files/detail/model_tables.h"
#include "files/detail/table_lines.h"

// Changes a correction file and leaves all else as the user wrote it.
namespace raceway::files {
namespace {

using correction::DrivenChannel;
using correction::Effect;
using correction::Model;

std::string section_text(const Model& m, const DrivenChannel& c, const correction::Section& s) {
  return fmt::format("{{ {}_{} = {}, time_constant_s = {} }}", correction::in_unit_of(m, "gain_um"),
                     c.input.key_unit(),
                     text::toml_float(text::with_15_digits(s.gain * c.input.factor() / um)),
                     text::toml_float(text::with_15_digits(s.time_constant)));
}

std::string sections_text(const Model& m, const DrivenChannel& c) {
  std::vector<std::string> parts;
  for (const correction::Section& s : c.sections) parts.push_back(section_text(m, c, s));
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

std::string columns_text(const std::vector<const record::Channel*>& columns) {
  std::vector<std::string> names;
  for (const record::Channel* c : columns) names.push_back(fmt::format("\"{}\"", c->name));
  return names.size() == 1 ? names.front() : fmt::format("[{}]", fmt::join(names, ", "));
}

/// Text pieces by line and column of TOML.
class Editor {
 public:
  explicit Editor(std::string text) : text_(std::move(text)) {
    line_end_ = text_.find("\r\n") != text_.npos ? "\r\n" : "\n";
  }

  [[nodiscard]] std::string take() { return std::move(text_); }

  [[nodiscard]] toml::table parsed() const { return text::parse_toml(text_, "model"); }

  /// The model of that index, its table found anew in the text as it is now.
  template <typename Use>
  void with_table(std::size_t index, const Use& use) {
    const toml::table root = parsed();
    const toml::node* node = root.get("correction");
    if (node->is_array()) node = node->as_array()->get(index);
    use(*node->as_table());
  }

  void replace(const toml::node& node, const std::string& by) {
    const std::size_t begin = text::byte_of(text_, node.source().begin),
                      end = text::byte_of(text_, node.source().end);
    text_.replace(begin, end - begin, by);
    text_ = without_mark(std::move(text_), begin + by.size());
  }

  /// A block of lines behind all of the model of that index: at the end of the file, or before the
  /// next model and the comment above it.
  void append(std::size_t index, const std::string& block) {
    std::size_t at = text_.size();
    const toml::table root = parsed();
    const toml::array* const list = root.get("correction")->as_array();
    if (list && index + 1 < list->size()) {
      at = with_comment_above(text_, table_begin(*list->get(index + 1)->as_table()));
    }
    std::string lines;
    if (at > 0 && text_[at - 1] != '\n') lines += line_end_;
    if (at == text_.size()) lines += line_end_;
    for (const char c : block) lines += c == '\n' ? line_end_ : std::string(1, c);
    if (at < text_.size()) lines += line_end_;
    text_.insert(at, lines);
  }

  [[nodiscard]] std::size_t table_begin(const toml::table& table) const {
    return text::line_start(text_, table.source().begin.line);
  }

  /// Takes out a table of a model, in brackets or in braces, with the blank line before it.
  void remove(const toml::table& owner, std::string_view key) {
    const auto entry = owner.find(key);
    const toml::table& table = *entry->second.as_table();
    std::size_t begin = text::line_start(
        text_, table.is_inline() ? entry->first.source().begin.line : table.source().begin.line);
    std::size_t end = text_.find('\n', text::line_start(text_, last_line(table)));
    end = end == text_.npos ? text_.size() : end + 1;
    if (std::string_view(text_).substr(0, begin).ends_with(line_end_ + line_end_))
      begin -= line_end_.size();
    text_.erase(begin, end - begin);
  }

 private:
  std::string text_, line_end_;
};

std::string effect_text(const Effect& e, const Model& m) {
  std::string text = fmt::format("[[correction.effect]]\nid = \"{}\"\n", e.id);
  const correction::EffectKind& kind = correction::kind_of(e);
  if (!e.where.empty())
    text += fmt::format("{} = \"{}\"\n", correction::find_channel(m, e.where) ? "channel" : "axis",
                        e.where);
  if (!e.columns.empty()) text += fmt::format("input = {}\n", columns_text(e.columns));
  if (e.window) text += window_text(*e.window);
  for (std::size_t k = 0; k < e.values.size(); ++k) {
    if (kind.may_end_before(k) && e.values[k] == 0.0) break;
    text += fmt::format("{} = {}\n", correction::key_of(e, k, m),
                        text::toml_float(text::with_15_digits(e.values[k])));
  }
  return text;
}

std::string channel_text(const Model& m, const DrivenChannel& c) {
  std::string text = fmt::format("[[correction.channel]]\nname = \"{}\"\ninput = {}\n", c.name,
                                 columns_text(c.input.columns));
  if (c.input.exponent != 1.0)
    text +=
        fmt::format("exponent = {}\n", text::toml_float(text::with_15_digits(c.input.exponent)));
  if (c.input.reference) text += fmt::format("reference = \"{}\"\n", c.input.reference->name);
  if (c.input.window) text += window_text(*c.input.window);
  if (!c.sections.empty()) text += fmt::format("sections = {}\n", sections_text(m, c));
  if (c.printed) {
    const auto list = [](const std::vector<double>& numbers, double unit) {
      std::vector<std::string> texts;
      for (const double n : numbers)
        texts.push_back(text::toml_float(text::with_15_digits(n / unit)));
      return fmt::format("[{}]", fmt::join(texts, ", "));
    };
    text += fmt::format("numerator = {}\ndenominator = {}\n",
                        list(c.printed->numerator, um / c.input.factor()),
                        list(c.printed->denominator, 1.0));
  }
  if (c.feedthrough != 0.0)
    text +=
        fmt::format("{}_{} = {}\n", correction::in_unit_of(m, "feedthrough_um"), c.input.key_unit(),
                    text::toml_float(text::with_15_digits(c.feedthrough * c.input.factor() / um)));
  return text;
}

/// Channels that the file has, with other sections.
void write_sections(Editor& editor, std::size_t index, const Model& old, const Model& now) {
  for (std::size_t c = 0; c < old.channels.size() && c < now.channels.size(); ++c) {
    const DrivenChannel& channel = now.channels[c];
    if (channel.element || channel.printed) continue;
    editor.with_table(index, [&](const toml::table& table) {
      const toml::table& of = *table.get("channel")->as_array()->get(c)->as_table();
      if (const toml::node* const sections = of.get("sections")) {
        const std::string text = sections_text(now, channel);
        if (sections_text(old, old.channels[c]) != text) editor.replace(*sections, text);
      }
    });
  }
}

/// Numbers that stand outside of sections.
void write_numbers(std::string& text, std::size_t index, bool listed, const Model& old,
                   const Model& now) {
  const std::vector<record::Parameter> was = correction::parameters(old);
  std::vector<KeyValue> changes;
  for (const record::Parameter& p : correction::parameters(now)) {
    const std::string& address = p.addresses.front();
    if (address.find(".sections.") != address.npos) continue;
    const auto before =
        std::find_if(was.begin(), was.end(), [&](const auto& w) { return w.name == p.name; });
    if (before == was.end() || before->value == p.value) continue;
    std::string key = address;
    if (listed)
      key = fmt::format("correction.{}{}", index, address.substr(std::string("correction").size()));
    changes.push_back({key, text::with_15_digits(p.value)});
  }
  text = with_values(text, changes);
}

void remove_trust(Editor& editor, std::size_t index) {
  for (const std::string_view key :
       {"trust", "residual", "covariance", "together", "still_s", "range"})
    editor.with_table(index, [&](const toml::table& table) {
      if (table.contains(key)) editor.remove(table, key);
    });
}

/// The keys of [correction] itself.
std::string head_text(const Model& m) {
  std::string text = fmt::format("displacement = \"{}\"\n", m.displacement->name);
  const auto add = [&](std::string_view key, double value) {
    if (std::isfinite(value))
      text += fmt::format("{} = {}\n", key, text::toml_float(text::with_15_digits(value / um)));
  };
  add(correction::in_unit_of(m, "tolerance_um"), m.tolerance);
  add(correction::in_unit_of(m, "measurement_std_um"), m.measured_std);
  add(correction::in_unit_of(m, "offset_um"), m.offset);
  if (std::isfinite(m.sampling))
    text += fmt::format("sampling_s = {}\n", text::toml_float(text::with_15_digits(m.sampling)));
  return text;
}

}  // namespace

std::string window_text(const correction::Window& window) {
  std::vector<std::string> points;
  for (const double p : window.points)
    points.push_back(std::isinf(p)
                         ? (p < 0.0 ? "-inf" : "inf")
                         : text::toml_float(text::with_15_digits(window.column->in_unit(p))));
  return fmt::format("window = {{ column = \"{}\", points = [{}], acts_on = \"{}\" }}\n",
                     window.column->name, fmt::join(points, ", "),
                     window.of_input ? "input" : "displacement");
}

std::string new_corrections(const std::vector<Model>& models, const std::string& comment) {
  std::string text = fmt::format("# {}\n{}", comment, text::format_line);
  for (const Model& m : models) {
    text += models.size() > 1 ? "\n[[correction]]\n" : "[correction]\n";
    text += head_text(m);
    for (const DrivenChannel& c : m.channels) text += "\n" + channel_text(m, c);
    if (const std::string trust = trust_text(m); !trust.empty()) text += "\n" + trust;
  }
  (void)parse_correction(text, "model");  // it reads back
  return text;
}

std::string with_corrections(const CorrectionFile& file, const std::vector<Model>& models) {
  std::string text = file.text;
  const bool marked = text.starts_with(text::utf8_mark);
  if (marked) text.erase(0, text::utf8_mark.size());
  const bool listed = text::parse_toml(text, "model").get("correction")->is_array();
  for (std::size_t index = 0; index < models.size(); ++index) {
    const Model& old = file.models[index];
    const Model& now = models[index];
    write_numbers(text, index, listed, old, now);
    Editor editor(std::move(text));
    write_sections(editor, index, old, now);
    const std::string trust = trust_text(now);
    const bool is_new = trust != trust_text(old);
    if (is_new) remove_trust(editor, index);
    for (std::size_t c = old.channels.size(); c < now.channels.size(); ++c)
      editor.append(index, channel_text(now, now.channels[c]));
    for (std::size_t e = old.effects.size(); e < now.effects.size(); ++e)
      editor.append(index, effect_text(now.effects[e], now));
    if (is_new && !trust.empty()) editor.append(index, trust);
    text = editor.take();
  }
  if (models.size() == 1 && !models.front().free.empty() && file.models.front().free.empty())
    text +=
        fmt::format("\n[calibration]\nfree = [\"{}\"]\n", fmt::join(models.front().free, "\", \""));
  (void)parse_correction(text, file.source, file.files);  // it reads back
  if (marked) text.insert(0, text::utf8_mark);
  return text;
}

}  // namespace raceway::files
