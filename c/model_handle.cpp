#include "c/model_handle.h"

#include <fmt/format.h>

#include <memory>

#include "c/message_text.h"
#include "session/open_input.h"
#include "session/solve_states.h"
#include "text/error.h"

namespace raceway::c {

raceway_model* open_handle(const session::Source& source) {
  MessageText said;
  files::ModelFile file = session::open_model(said, source, session::Accepts::rig_or_shaft);
  session::warn_of_ignored_data(said, file);
  std::vector<std::string> columns = session::state_columns(file.model);
  return new raceway_model{std::move(file), said.text(), std::move(columns)};
}

int status_number(bearing::SolveStatus status) {
  using bearing::SolveStatus;
  switch (status) {
    case SolveStatus::converged:
      return RACEWAY_STATUS_CONVERGED;
    case SolveStatus::no_equilibrium:
      return RACEWAY_STATUS_NO_EQUILIBRIUM;
    case SolveStatus::iteration_limit:
      return RACEWAY_STATUS_ITERATION_LIMIT;
    case SolveStatus::singular:
      return RACEWAY_STATUS_SINGULAR;
    case SolveStatus::not_finite:
      return RACEWAY_STATUS_NOT_FINITE;
    case SolveStatus::not_run:
      break;
  }
  return RACEWAY_STATUS_NOT_RUN;
}

std::vector<std::string> column_names(const raceway_model& model, const int* columns,
                                      std::size_t count) {
  std::vector<std::string> names;
  if (columns == nullptr) return names;
  for (std::size_t i = 0; i < count; ++i) {
    if (columns[i] < 0 || static_cast<std::size_t>(columns[i]) >= model.columns.size())
      throw text::InputError(fmt::format("columns[{}] = {}: must be from 0 to {}", i, columns[i],
                                         model.columns.size() - 1),
                             {.key = "columns"});
    names.push_back(model.columns[static_cast<std::size_t>(columns[i])]);
  }
  return names;
}

}  // namespace raceway::c
