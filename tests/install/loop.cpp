#include <cstdio>
#include <stdexcept>
#include <string>

#include "fit/add.h"
#include "fit/compare.h"
#include "fit/diagnose.h"
#include "io/subject.h"
#include "session/loop_question.h"
#include "session/open_input.h"

using namespace raceway;

/// What is to be known beside the answers.
struct OnStderr : session::Messages {
  void note(const std::string& line) override { std::fprintf(stderr, "note: %s\n", line.c_str()); }
  void warn(const std::string& line) override {
    std::fprintf(stderr, "warning: %s\n", line.c_str());
  }
};

/// RMS error of the friction torque of a model over a record [N m].
double error_of(const io::ModelFile& model, const record::Record& data) {
  return fit::compare(*io::make_subject(model.model), data).front().rmse;
}

/// Arguments: model, record to fit to, record that no fit sees.
int main(int count, char** arguments) try {
  if (count != 4) throw std::invalid_argument("three files are wanted");
  OnStderr said;
  const auto asked = session::ask(said, {arguments[1]}, {{arguments[2]}}, {});
  const record::Record test =
      session::open_data(said, {arguments[3]}, *io::make_subject(asked.file.model), {});
  const fit::Diagnosis found = fit::diagnose(*asked.subject, asked.data);
  std::printf("%s\n", found.headline.c_str());
  if (found.verdict != fit::Verdict::effect) return 1;

  const fit::AddResult added = fit::add(*asked.subject, found.sets.front(), asked.data);
  if (added.refused) return 1;
  const std::string text = session::fitted_texts(asked.file, added.calibration).texts.front();
  const io::ModelFile better = io::parse_model(text, "better.toml");
  for (const record::Parameter& p : added.calibration.parameters)
    std::printf("%s = %.4g\n", p.name.c_str(), p.value);
  std::printf("RMS error on rows no fit has seen: %.1f -> %.1f N mm\n",
              error_of(asked.file, test) / N_mm, error_of(better, test) / N_mm);
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
