#include "text/input_file.h"

#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/support/message_of.h"

namespace raceway::text {
namespace {

using testing::HasSubstr;

class NamedPipe {
 public:
  NamedPipe() : path_(testing::TempDir() + "raceway_pipe_" + std::to_string(::getpid())) {
    std::remove(path_.c_str());
    if (::mkfifo(path_.c_str(), 0600) != 0) throw std::runtime_error("no pipe");
  }
  ~NamedPipe() { std::remove(path_.c_str()); }
  NamedPipe(const NamedPipe&) = delete;
  NamedPipe& operator=(const NamedPipe&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

TEST(InputFile, APipeIsReadOnceAProgramWritesIntoIt) {
  const NamedPipe pipe;
  std::thread late([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    std::ofstream out(pipe.path());
    out << "a,b\n" << std::flush;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    out << "1,2\n";
  });
  EXPECT_EQ(read_text(pipe.path()), "a,b\n1,2\n");
  late.join();
}

TEST(InputFile, APipeIntoWhichNobodyWritesIsRefused) {
  const NamedPipe pipe;
  EXPECT_THAT(tests::message_of([&] { (void)read_text(pipe.path()); }),
              HasSubstr("is a pipe, and no program writes to it; name a file instead"));
}

}  // namespace
}  // namespace raceway::text
