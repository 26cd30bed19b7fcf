#include "io/key_book.h"

#include <algorithm>

namespace raceway::io {
namespace {

thread_local KeyBook* open_book = nullptr;

}  // namespace

KeyBook::KeyBook() { open_book = this; }
KeyBook::~KeyBook() { open_book = nullptr; }
KeyBook* KeyBook::open() { return open_book; }

ModelKey& KeyBook::entry(std::string_view table, std::string_view name) {
  const auto found = std::find_if(keys_.begin(), keys_.end(), [&](const ModelKey& k) {
    return k.table == table && k.name == name;
  });
  if (found != keys_.end()) return *found;
  keys_.push_back({.table = std::string(table), .name = std::string(name), .unit = {}});
  return keys_.back();
}

}  // namespace raceway::io
