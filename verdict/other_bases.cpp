#include "verdict/detail/other_bases.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raceway::verdict {

CalibratedBase calibrate_other_base(const Evidence& evidence, fit::OtherBase base) {
  const fit::Problem& given = evidence.problem;
  CalibratedBase result{.base = std::move(base)};
  if (!result.base.subject) {
    result.not_testable = "needs " + result.base.lacks;
    return result;
  }
  fit::Problem problem{.subject = result.base.subject,
                       .record = given.record,
                       .observed = given.observed,
                       .base = {},
                       .candidates = {},
                       .prepared = result.base.subject->prepare(*given.record),
                       .cancelled = given.cancelled};
  for (const record::Parameter& p : fit::find_parameters(*problem.subject, problem.subject->free()))
    problem.base.push_back(p.name);
  Explanation& e = result.explanation;
  e.response = fit::response_with(problem, {});
  e.parameters = e.response.parameters;
  const Eigen::VectorXd start = e.response.start();
  if (!e.response.at(start).allFinite()) {
    result.not_testable = "a model with this base law predicts none of the rows";
    return result;
  }
  e.response.find_affine_form();
  std::vector<Eigen::VectorXd> starts{start};
  if (!e.response.affine)
    for (const double part : {0.8, 1.25, 0.5}) starts.emplace_back(part * start);
  e.fit = fit::fit_response(e.response, evidence.whitening, given.measured(), starts);
  const auto further =
      static_cast<double>(e.parameters.size()) - static_cast<double>(given.base.size());
  e.gain = evidence.base.misfit - e.fit.misfit -
           further * std::log(static_cast<double>(given.observed.size()));
  return result;
}

std::vector<CalibratedBase> calibrate_other_bases(const Evidence& evidence) {
  std::vector<CalibratedBase> list;
  for (fit::OtherBase& base : evidence.problem.subject->other_bases())
    list.push_back(calibrate_other_base(evidence, std::move(base)));
  const auto gain = [](const CalibratedBase& b) {
    return b.not_testable.empty() && b.explanation.fit.converged ? b.explanation.gain : -HUGE_VAL;
  };
  std::stable_sort(list.begin(), list.end(), [&](const CalibratedBase& a, const CalibratedBase& b) {
    return a.base.fitted_form != b.base.fitted_form ? b.base.fitted_form : gain(a) > gain(b);
  });
  return list;
}

std::shared_ptr<const fit::Subject> fitted_subject(const CalibratedBase& found) {
  std::vector<record::NamedValue> values;
  const Explanation& e = found.explanation;
  for (std::size_t k = 0; k < e.parameters.size(); ++k)
    values.push_back({e.parameters[k].name, e.fit.values[static_cast<Eigen::Index>(k)]});
  return found.base.subject->with_values(values);
}

}  // namespace raceway::verdict
