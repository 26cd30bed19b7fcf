#pragma once

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "effects/catalogue.h"
#include "tests/support/synthetic.h"

/// Models of shafts.
namespace raceway::fit {

/// Two bearings of synthetic_model() at the tool against one, O, rigid, 600 N.
inline Model two_against_one(Model model = synthetic_model()) {
  const auto one = std::make_shared<const bearing::Bearing>(model.bearing);
  model.shaft = Shaft{bearing::Arrangement({.front = {{one}, {one}},
                                            .rear = {{one}},
                                            .preload = bearing::PreloadForce{600},
                                            .distance = 100 * mm})};
  return model;
}

/// The same with balls of another material.
inline Model two_against_one_with(const bearing::Material& balls) {
  Model model = synthetic_model();
  model.bearing = bearing::Bearing(model.bearing.geometry(), balls, model.bearing.rings());
  return two_against_one(std::move(model));
}

/// The same on springs that keep their force.
inline Model two_against_one_on_springs() {
  Model model = two_against_one();
  bearing::ArrangementDesign design = model.shaft->arrangement.design();
  design.mounting = bearing::Mounting::spring;
  model.shaft->arrangement = bearing::Arrangement(std::move(design));
  return model;
}

/// The model with an effect beside those it has.
inline Model with_effect(Model model, std::string_view id, std::vector<double> values) {
  model.effects.push_back({.description = effects::find(id, model.form()),
                           .values = std::move(values),
                           .owner = nullptr});
  return model;
}

}  // namespace raceway::fit
