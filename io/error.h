#pragma once

#include <stdexcept>

namespace raceway::io {

/// Something a user wrote is wrong. The message is complete and meant to be shown as it stands:
/// `FILE:LINE: key or column = value: what is wrong or allowed range`. It may have several lines.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace raceway::io
