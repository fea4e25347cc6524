// SPDX-License-Identifier: MIT
// What becomes of an output while somebody else does something: a signal on whatever thread, a
// neighbour in its folder. The moment is the one after the file beside it was made.
#include "programs/files/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>

namespace batuta::host {
namespace {

/// What happens when a file has just been made. Empty: nothing.
std::function<void(const std::string& path)> just_made;

/// A folder of a test's own.
class OutputFileTest : public testing::Test {
 protected:
  OutputFileTest() {
    std::string name = testing::TempDir() + "batuta_output_XXXXXX";
    folder_ = ::mkdtemp(name.data());
  }
  ~OutputFileTest() override {
    just_made = {};
    std::filesystem::remove_all(folder_);
  }
  std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }
  int files() const {
    return static_cast<int>(std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

 private:
  std::filesystem::path folder_;
};

std::string contents(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Begins an output; a signal comes when its file has just been made. Does not return.
[[noreturn]] void begin_and_be_ended(const std::string& path, bool has_second_thread, int number) {
  constexpr int kNotEnded = 3;
  constexpr unsigned kSoon_us = 300000;
  just_made = [number](const std::string&) {
    (void)::kill(::getpid(), number);
    (void)::usleep(kSoon_us);  // for another thread to take it
  };
  std::thread second;
  if (has_second_thread) {
    second = std::thread([] {
      for (;;) (void)::pause();  // Bound: until the program is ended
    });
  }
  OutputFile out;
  (void)out.open(path);
  ::_exit(kNotEnded);
}

TEST_F(OutputFileTest, ASignalThatComesWhenItsFileHasJustBeenMade_LeavesNothingBeside) {
  for (const bool has_second_thread : {false, true}) {
    for (const int number : {SIGTERM, SIGHUP, SIGALRM}) {
      const pid_t child = ::fork();
      ASSERT_GE(child, 0);
      if (child == 0) begin_and_be_ended(in_folder("out"), has_second_thread, number);
      int status = 0;
      ASSERT_EQ(::waitpid(child, &status, 0), child);
      EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == number) << status;
      EXPECT_EQ(files(), 0) << has_second_thread << number;
    }
  }
}

TEST_F(OutputFileTest, ALinkThatANeighbourPutsInPlaceOfItsFile_IsNotWrittenThrough) {
  const std::string treasure = in_folder("treasure");
  std::ofstream(treasure) << "not to be lost";
  just_made = [&](const std::string& path) {
    std::filesystem::remove(path);
    std::filesystem::create_symlink(treasure, path);
  };
  OutputFile out;
  EXPECT_EQ(out.open(in_folder("out")), "");
  out.stream() << "new";
  (void)out.commit();
  EXPECT_EQ(contents(treasure), "not to be lost");
}

TEST_F(OutputFileTest, ItTakesItsPlaceWhenItIsWhole) {
  const std::string path = in_folder("out");
  std::ofstream(path) << "old, and longer than what is new";
  OutputFile out;
  ASSERT_EQ(out.open(path), "");
  out.stream() << "new" << std::flush;
  EXPECT_EQ(contents(path), "old, and longer than what is new");
  EXPECT_EQ(files(), 2) << "it stands beside";
  ASSERT_EQ(out.commit(), "");
  EXPECT_EQ(contents(path), "new");
  EXPECT_EQ(files(), 1);
}

}  // namespace
}  // namespace batuta::host

// The linker takes this instead of the C library's.
extern "C" int open(const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  const auto file = static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
  const bool is_made = file >= 0 && (flags & O_EXCL) != 0;
  if (is_made && batuta::host::just_made) batuta::host::just_made(path);
  return file;
}
