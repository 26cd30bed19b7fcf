#include "session/loop.h"

#include <cstdio>
#include <stdexcept>
#include <string>

using namespace raceway;

/// Prints notes and warnings on stderr.
struct OnStderr : session::Messages {
  void hear(const record::Note& note) override {
    std::fprintf(stderr, "%s: %s\n", name(note.kind()).data(), note.text.c_str());
  }
};

/// RMS error of the friction torque of a model over a record [N m].
double error_of(session::Messages& said, const session::Source& model, const std::string& record) {
  return session::compare(said, {model}, {record}, {}, {}).errors()[0][0].rmse;
}

/// Arguments: model, record for the fit, record that the fit does not use.
int main(int count, char** arguments) try {
  if (count != 4) throw std::invalid_argument("give three files");
  OnStderr said;
  const std::string model = arguments[1], train = arguments[2], test = arguments[3];
  const session::LoopQuestion asked = session::ask(said, model, {train}, {});
  const verdict::Diagnosis found = session::diagnose(asked);
  std::printf("%s\n", found.headline.c_str());
  if (found.verdict != verdict::Verdict::effect) return 1;

  const verdict::AddResult added = session::add(asked, found.sets.front());
  if (added.refused) return 1;
  const session::FittedTexts better = session::fitted_texts(asked, added.calibration);
  for (const record::Parameter& p : added.calibration.parameters)
    std::printf("%s = %.4g\n", p.name.c_str(), p.value);
  std::printf("RMS error on rows no fit has seen: %.1f -> %.1f N mm\n",
              error_of(said, model, test) / N_mm,
              error_of(said, {"better.toml", better.texts.front()}, test) / N_mm);
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
