#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

#include "cli/process.h"
#include "text/printable.h"

namespace raceway::cli {

void write_message(std::string_view text) {
  const std::string safe = text::printable(text, "\n\t");
  std::fwrite(safe.data(), 1, safe.size(), stderr);
  std::fflush(stderr);
}

std::string stdout_problem() {
  errno = 0;
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return {};
  return stdout_problem(errno);
}

std::string stdout_problem(int error) {
  return "stdout could not be written" +
         (error == 0 ? "" : std::string(": ") + std::strerror(error));
}

}  // namespace raceway::cli
