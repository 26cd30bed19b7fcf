#include "fit/several_records.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace raceway::fit {

namespace {

constexpr std::size_t fewest_held_out = 3;  // records: of two, one says nothing of the other

/// The rows of one record among those of a joined one.
struct Piece {
  std::size_t record = 0;
  std::vector<std::size_t> rows{};
  Record piece{};
  std::shared_ptr<const void> prepared{};
};

/// What predictors of one joined record share.
using Pieces = std::vector<Piece>;

Pieces cut(const Record& record) {
  Pieces pieces;
  for (std::size_t k = 0; k < std::max<std::size_t>(1, record.parts.size()); ++k) {
    Piece piece{.record = k};
    for (std::size_t i = 0; i < record.rows(); ++i)
      if (record.part_of(i) == k) piece.rows.push_back(i);
    if (piece.rows.empty()) continue;
    piece.piece = record.picked(piece.rows);
    if (!record.parts.empty()) piece.piece.source = record.parts[k].source;
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Each record by a predictor of its own, asked anew only where one of its values has changed.
class SeveralPredictor : public Predictor {
 public:
  struct Member {
    const Piece* piece = nullptr;
    std::unique_ptr<Predictor> predictor{};
    std::vector<std::size_t> taken{};  ///< of all values, those of this record
    std::vector<double> values{}, found{};
    bool known = false;
  };

  SeveralPredictor(std::shared_ptr<const Pieces> pieces, std::vector<Member> members,
                   std::size_t channels)
      : pieces_(std::move(pieces)), members_(std::move(members)), channels_(channels) {}

  void readings(std::span<const double> values, std::span<double> out) override {
    const std::size_t rows = out.size() / std::max<std::size_t>(1, channels_);
    for (Member& m : members_) {
      ask(m, values);
      const std::vector<std::size_t>& own = m.piece->rows;
      for (std::size_t c = 0; c < channels_; ++c)
        for (std::size_t i = 0; i < own.size(); ++i)
          out[c * rows + own[i]] = m.found[c * own.size() + i];
    }
  }

 private:
  void ask(Member& m, std::span<const double> values) const {
    std::vector<double> own;
    for (const std::size_t k : m.taken) own.push_back(values[k]);
    if (m.known && own == m.values) return;
    m.found.resize(channels_ * m.piece->rows.size());
    m.known = false;
    m.predictor->readings(own, m.found);
    m.values = std::move(own);
    m.known = true;
  }

  std::shared_ptr<const Pieces> pieces_;
  std::vector<Member> members_;
  std::size_t channels_;
};

}  // namespace

SeveralRecords::SeveralRecords(std::shared_ptr<const Subject> model, const Record& record,
                               std::vector<std::string> own)
    : model_(std::move(model)), own_(std::move(own)) {
  for (const record::Part& part : record.parts) records_.push_back(part.name);
  for (const Parameter& p : find_parameters(*model_, own_))
    values_.emplace_back(records_.size(), p.start);
}

std::string SeveralRecords::name_of(const Place& place) const {
  return own_[place.own] + "@" + records_[place.record];
}

std::optional<SeveralRecords::Place> SeveralRecords::place_of(const std::string& name) const {
  for (std::size_t k = 0; k < own_.size(); ++k)
    for (std::size_t r = 0; r < records_.size(); ++r)
      if (name == name_of({k, r})) return Place{k, r};
  return std::nullopt;
}

std::string SeveralRecords::name_in(std::size_t record, const std::string& name) const {
  const std::optional<Place> place = place_of(name);
  if (!place) return name;
  return place->record == record ? own_[place->own] : std::string();
}

std::unique_ptr<Subject> SeveralRecords::model_of(std::size_t record) const {
  std::vector<NamedValue> values;
  for (std::size_t k = 0; k < own_.size(); ++k) values.push_back({own_[k], values_[k][record]});
  return model_->with_values(values);
}

std::unique_ptr<SeveralRecords> SeveralRecords::with_model(
    std::shared_ptr<const Subject> model) const {
  std::unique_ptr<SeveralRecords> copy(new SeveralRecords(*this));
  copy->model_ = std::move(model);
  return copy;
}

std::vector<Measured> SeveralRecords::measured() const { return model_->measured(); }

void SeveralRecords::require(const Record& record) const {
  for (const Piece& piece : cut(record)) model_->require(piece.piece);
}

bool SeveralRecords::has_memory() const { return model_->has_memory(); }

std::shared_ptr<const void> SeveralRecords::prepare(const Record& record) const {
  auto pieces = std::make_shared<Pieces>(cut(record));
  for (Piece& piece : *pieces) piece.prepared = model_of(piece.record)->prepare(piece.piece);
  return pieces;
}

std::unique_ptr<Predictor> SeveralRecords::predictor(
    const Record& record, const std::vector<std::string>& names,
    const std::shared_ptr<const void>& prepared) const {
  (void)find_parameters(*this, names);
  const auto pieces = std::static_pointer_cast<const Pieces>(
      prepared ? prepared : std::make_shared<const Pieces>(cut(record)));
  std::vector<SeveralPredictor::Member> members;
  for (const Piece& piece : *pieces) {
    SeveralPredictor::Member m{.piece = &piece};
    std::vector<std::string> taken;
    for (std::size_t k = 0; k < names.size(); ++k)
      if (std::string name = name_in(piece.record, names[k]); !name.empty()) {
        m.taken.push_back(k);
        taken.push_back(std::move(name));
      }
    m.predictor = model_of(piece.record)->predictor(piece.piece, taken, piece.prepared);
    members.push_back(std::move(m));
  }
  return std::make_unique<SeveralPredictor>(pieces, std::move(members), measured().size());
}

std::unique_ptr<Subject> SeveralRecords::informed_by(const Record& record) const {
  auto informed = model_->informed_by(record);
  return informed ? with_model(std::move(informed)) : nullptr;
}

std::vector<Parameter> SeveralRecords::parameters() const {
  std::vector<Parameter> list;
  for (const Parameter& p : model_->parameters()) {
    const auto at = std::find(own_.begin(), own_.end(), p.name);
    if (at == own_.end()) {
      list.push_back(p);
      continue;
    }
    const auto k = static_cast<std::size_t>(at - own_.begin());
    for (std::size_t r = 0; r < records_.size(); ++r) {
      Parameter own = p;
      own.name = name_of({k, r});
      own.start = own.value = values_[k][r];
      list.push_back(std::move(own));
    }
  }
  return list;
}

std::vector<std::string> SeveralRecords::free() const {
  std::vector<std::string> names = model_->free();
  for (const std::string& name : own_)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  std::vector<std::string> list;
  for (const std::string& name : names) {
    const auto at = std::find(own_.begin(), own_.end(), name);
    if (at == own_.end()) {
      list.push_back(name);
      continue;
    }
    for (std::size_t r = 0; r < records_.size(); ++r)
      list.push_back(name_of({static_cast<std::size_t>(at - own_.begin()), r}));
  }
  return list;
}

std::unique_ptr<Subject> SeveralRecords::with_values(std::span<const NamedValue> values) const {
  std::vector<NamedValue> shared;
  std::unique_ptr<SeveralRecords> copy = with_model(model_);
  for (const NamedValue& v : values) {
    (void)find_parameters(*this, {v.name});
    if (const auto place = place_of(v.name))
      copy->values_[place->own][place->record] = v.value;
    else
      shared.push_back(v);
  }
  copy->model_ = model_->with_values(shared);
  return copy;
}

std::vector<Candidate> SeveralRecords::candidates() const { return model_->candidates(); }

std::vector<std::string> SeveralRecords::catalogue() const { return model_->catalogue(); }

std::unique_ptr<Subject> SeveralRecords::with_candidates(std::span<const std::string> ids) const {
  return with_model(model_->with_candidates(ids));
}

std::unique_ptr<Subject> SeveralRecords::without_free_candidates() const {
  auto bare = model_->without_free_candidates();
  if (!bare) return nullptr;
  const std::vector<Parameter> left = bare->parameters();
  std::unique_ptr<SeveralRecords> copy = with_model(std::move(bare));
  // What a record had of its own of an effect that waits again goes with it.
  for (std::size_t k = own_.size(); k-- > 0;)
    if (std::none_of(left.begin(), left.end(),
                     [&](const Parameter& p) { return p.name == own_[k]; })) {
      copy->own_.erase(copy->own_.begin() + static_cast<std::ptrdiff_t>(k));
      copy->values_.erase(copy->values_.begin() + static_cast<std::ptrdiff_t>(k));
    }
  return copy;
}

std::unique_ptr<Subject> SeveralRecords::with_shape(const std::string& id,
                                                    const Shape& shape) const {
  auto with = model_->with_shape(id, shape);
  return with ? with_model(std::move(with)) : nullptr;
}

std::unique_ptr<SeveralRecords> SeveralRecords::with_data_of_each_record(
    const Record& record) const {
  if (own_.empty()) return nullptr;
  std::vector<std::string> ids;
  std::vector<const Parameter*> numbers;
  const std::vector<Candidate> all = model_->candidates();
  for (const Candidate& c : all) {
    if (!c.of_each_record || !lacks(c.id, record).empty() || !lacks_levels(c.id, record).empty())
      continue;
    ids.push_back(c.id);
    for (const Parameter& p : c.parameters) numbers.push_back(&p);
  }
  if (ids.empty()) return nullptr;
  std::unique_ptr<SeveralRecords> copy = with_model(model_->with_candidates(ids));
  for (const Parameter* const p : numbers) {
    copy->own_.push_back(p->name);
    copy->values_.emplace_back(records_.size(), std::isnan(p->neutral) ? p->start : p->neutral);
  }
  return copy;
}

std::vector<OtherBase> SeveralRecords::other_bases() const {
  std::vector<OtherBase> list = model_->other_bases();
  for (OtherBase& base : list) {
    if (!base.subject) continue;
    const std::vector<Parameter> known = base.subject->parameters();
    for (const std::string& own : own_)
      if (std::none_of(known.begin(), known.end(),
                       [&](const Parameter& p) { return p.name == own; }))
        base.lacks =
            own +
            " as a parameter, because the fit gives each record its own value of this parameter";
    base.subject =
        base.lacks.empty() ? std::shared_ptr<const Subject>(with_model(base.subject)) : nullptr;
  }
  return list;
}

std::string SeveralRecords::rules_out(const std::string& id) const { return model_->rules_out(id); }

std::string SeveralRecords::correction(const std::string& id,
                                       std::span<const double> values) const {
  return model_->correction(id, values);
}

std::string SeveralRecords::lacks(const std::string& id, const Record& record) const {
  return model_->lacks(id, record);
}

std::string SeveralRecords::lacks_levels(const std::string& id, const Record& record) const {
  return model_->lacks_levels(id, record);
}

Saturation SeveralRecords::saturation(const Record& record) const {
  Saturation result = model_->saturation(record);
  Surface& surface = result.surface;
  const std::size_t inputs = surface.inputs.size();
  // One record is the others' reference.
  for (std::size_t k = 1; k < records_.size(); ++k) {
    std::vector<double> is(record.rows());
    for (std::size_t i = 0; i < is.size(); ++i) is[i] = record.part_of(i) == k ? 1.0 : 0.0;
    surface.inputs.push_back({std::move(is), 0.5});
  }
  for (std::vector<int>& term : surface.terms) term.resize(surface.inputs.size(), 0);
  for (std::size_t k = inputs; k < surface.inputs.size(); ++k)
    for (std::size_t beside = 0; beside <= inputs; ++beside) {
      std::vector<int> term(surface.inputs.size(), 0);
      term[k] = 1;
      if (beside < inputs) term[beside] = 1;
      surface.terms.push_back(std::move(term));
    }
  return result;
}

std::vector<const Channel*> SeveralRecords::scattering(const Record& record) const {
  return model_->scattering(record);
}

std::vector<Factor> SeveralRecords::factors(const Record& record) const {
  return model_->factors(record);
}

std::optional<Formula> SeveralRecords::formula(const Record& record) const {
  return model_->formula(record);
}

std::vector<Blocking> SeveralRecords::blockings(const Record& record) const {
  std::vector<Blocking> list = model_->blockings(record);
  std::vector<std::size_t> part(record.rows());
  for (std::size_t i = 0; i < part.size(); ++i) part[i] = record.part_of(i);
  const std::set<std::size_t> parts(part.begin(), part.end());
  if (own_.empty()) {
    if (parts.size() >= fewest_held_out)
      list.push_back({.variable = std::string(record::part.variable),
                      .block = {part.begin(), part.end()},
                      .blocks = static_cast<int>(records_.size())});
    return list;
  }
  std::erase_if(list, [&](const Blocking& b) {
    std::vector<std::set<int>> blocks(records_.size());
    for (std::size_t i = 0; i < part.size(); ++i) blocks[part[i]].insert(b.block[i]);
    return std::any_of(blocks.begin(), blocks.end(),
                       [](const std::set<int>& of_record) { return of_record.size() == 1; });
  });
  return list;
}

std::string SeveralRecords::doubt(const Record& record, std::span<const double> predicted) const {
  return model_->doubt(record, predicted);
}

std::vector<Axis> SeveralRecords::axes(const Record& record) const { return model_->axes(record); }

std::string SeveralRecords::words(std::span<const Setting> point) const {
  return model_->words(point);
}

std::vector<std::string> SeveralRecords::records_needed(
    const Record& record, const std::vector<std::vector<std::string>>& rivals,
    const std::vector<std::string>& not_testable) const {
  return model_->records_needed(record, rivals, not_testable);
}

}  // namespace raceway::fit
