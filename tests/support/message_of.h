#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "text/error.h"

namespace raceway::tests {

/// The text of the InputError that `action` throws; "(no error)" if it does not.
template <typename Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const text::InputError& error) {
    return error.what();
  }
  return "(no error)";
}

}  // namespace raceway::tests
