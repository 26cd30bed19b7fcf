#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <mutex>

#include "files/detail/table_columns.h"
#include "files/table_file.h"
#include "record/units.h"
#include "text/detail/csv_text.h"
#include "text/printable.h"
#include "text/twelve_digits.h"
#include "text/units.h"

namespace raceway::files {
namespace {

/// Tells grids apart: FNV-1a over the axes.
std::uint64_t fingerprint(const friction::TableAxes& axes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&hash](std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) {
      hash ^= (word >> (8 * byte)) & 0xff;
      hash *= 0x100000001b3ULL;
    }
  };
  for (const auto* axis : {&axes.speed, &axes.axial_load, &axes.radial_load, &axes.temperature}) {
    add(axis->size());
    for (const double value : *axis) add(std::bit_cast<std::uint64_t>(value));
  }
  return hash;
}

std::string slab_line(const friction::StribeckTable& table) {
  return fmt::format("{}{}/{}: {} of {} points, grid {:016x}", slab_mark, table.slab.index + 1,
                     table.slab.count, table.points(), table.axes.size(), fingerprint(table.axes));
}

std::string head(const friction::StribeckTable& table, std::string_view title,
                 std::string_view model_text) {
  fmt::memory_buffer out;
  const auto put = std::back_inserter(out);
  fmt::format_to(put, "# Stribeck table: {}\n# raceway {}\n", text::printable(title),
                 RACEWAY_VERSION);
  if (table.slab.count != 1) fmt::format_to(put, "{}\n", slab_line(table));
  text::append_model(out, model_text);
  for (const std::string_view name : leading_columns) fmt::format_to(put, "{},", name);
  for (const std::string& name : table.columns) {
    text::append_text(out, name);
    out.push_back(',');
  }
  fmt::format_to(put, "{}\n", status_column);
  return fmt::to_string(out);
}

/// Rows of a table as text. Cells of the axes, which come again and again, are made once.
class RowWriter {
 public:
  explicit RowWriter(const friction::StribeckTable& table)
      : table_(table),
        speed_(cells(table.axes.speed, [](double v) { return v / rpm; })),
        axial_load_(cells(table.axes.axial_load, [](double v) { return v; })),
        radial_load_(cells(table.axes.radial_load, [](double v) { return v; })),
        temperature_(cells(table.axes.temperature, [](double v) { return celsius(v); })) {
    for (const std::string& name : table.columns) factors_.push_back(text::column_unit(name));
  }

  [[nodiscard]] std::string rows(std::size_t begin, std::size_t end) const {
    fmt::memory_buffer out;
    out.reserve((end - begin) * (table_.columns.size() + 6) * typical_cell);
    for (std::size_t i = begin; i < end; ++i) append_row(out, i);
    return {out.data(), out.size()};
  }

 private:
  static constexpr std::size_t typical_cell = 14;

  template <typename InUnit>
  static std::vector<std::string> cells(const std::vector<double>& axis, InUnit in_unit) {
    std::vector<std::string> list;
    for (const double value : axis) list.push_back(fmt::format("{:.12g},", in_unit(value)));
    return list;
  }

  void append_row(fmt::memory_buffer& out, std::size_t i) const {
    std::size_t rest = table_.first() + i;  // speed runs fastest
    for (const auto* axis : {&speed_, &axial_load_, &radial_load_, &temperature_}) {
      const std::string& cell = (*axis)[rest % axis->size()];
      out.append(cell.data(), cell.data() + cell.size());
      rest /= axis->size();
    }
    text::append_value(out, table_.friction_moment[i] / N_mm);
    out.push_back(',');
    const auto row = table_.row(i);
    for (std::size_t k = 0; k < row.size(); ++k) {
      text::append_value(out, row[k] / factors_[k]);
      out.push_back(',');
    }
    const std::string_view status = bearing::name(table_.status[i]);
    out.append(status.data(), status.data() + status.size());
    out.push_back('\n');
  }

  const friction::StribeckTable& table_;
  std::vector<std::string> speed_, axial_load_, radial_load_, temperature_;  // with their comma
  std::vector<double> factors_;
};

}  // namespace

std::string table_text(const friction::StribeckTable& table, std::string_view title,
                       std::string_view model_text, const std::function<void(double)>& progress) {
  constexpr std::size_t piece = 4096;  // rows
  const RowWriter writer(table);
  std::vector<std::string> texts((table.points() + piece - 1) / piece);
  std::mutex progress_mutex;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t{0}, texts.size(), [&](std::size_t k) {
    texts[k] = writer.rows(k * piece, std::min((k + 1) * piece, table.points()));
    if (!progress) return;
    const std::lock_guard lock(progress_mutex);
    progress(static_cast<double>(++done) / static_cast<double>(texts.size()));
  });
  std::string text = head(table, title, model_text);
  std::size_t size = text.size();
  for (const std::string& rows : texts) size += rows.size();
  text.reserve(size);
  for (std::string& rows : texts) {
    text += rows;
    rows = {};  // two copies of a large table are enough for a moment
  }
  return text;
}

}  // namespace raceway::files
