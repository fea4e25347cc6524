// SPDX-License-Identifier: MIT
// Against the other end of a pty, as an emulated board is.

#include "programs/serial/serial_port.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <vector>

namespace batuta::host {
namespace {

/// A line that keeps what it cannot do, and succeeds, as termios(3) has it.
struct WeakLine {
  speed_t fastest = B4000000;
  bool has_seven_bits = false;
};
WeakLine weak_line;

using Bytes = std::vector<std::uint8_t>;

/// What is on its way comes late on a busy machine: a limit for a test that fails. Of what must not
/// come a while shows most: on a busy machine it shows less, and nothing that is not there.
int patience_ms(bool on_its_way) {
  return on_its_way ? 60000 : 200;
}

/// A pty: its master here, its slave's path for the port. In the mode of a terminal at first, which
/// echoes and translates.
class Pty {
 public:
  Pty() {
    std::array<char, 256> name{};
    int slave = -1;
    EXPECT_EQ(openpty(&master_, &slave, name.data(), nullptr, nullptr), 0);
    path_ = name.data();
    ::close(slave);
  }
  ~Pty() { hang_up(); }
  Pty(const Pty&) = delete;
  Pty& operator=(const Pty&) = delete;

  const std::string& path() const { return path_; }
  void hang_up() {
    if (master_ >= 0) ::close(master_);
    master_ = -1;
  }
  void write(const Bytes& bytes) const {
    EXPECT_EQ(::write(master_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  /// What comes until there are so many, and then nothing more for a while.
  Bytes read(std::size_t count_at_least) const {
    Bytes all;
    pollfd wanted{master_, POLLIN, 0};
    while (::poll(&wanted, 1, patience_ms(all.size() < count_at_least)) > 0 &&
           (wanted.revents & POLLIN) != 0) {
      std::array<std::uint8_t, 512> some{};
      const ssize_t count = ::read(master_, some.data(), some.size());
      if (count <= 0) break;
      all.insert(all.end(), some.begin(), some.begin() + count);
    }
    return all;
  }

 private:
  int master_ = -1;
  std::string path_;
};

Bytes every_byte() {
  Bytes bytes(256);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

Bytes read_for_a_while(SerialPort& port, std::size_t count_at_least) {
  Bytes all;
  while (port.wait_readable(patience_ms(all.size() < count_at_least))) {
    std::array<std::uint8_t, 100> some{};
    const int count = port.read(some.data(), static_cast<int>(some.size()));
    if (count <= 0) break;
    all.insert(all.end(), some.begin(), some.begin() + count);
  }
  return all;
}

TEST(SerialPort, EveryByte_ComesThroughBothWaysUntranslated) {
  const Pty pty;
  const OpenedSerialPort opened = SerialPort::open(pty.path());
  ASSERT_NE(opened.port, nullptr) << opened.error;
  const Bytes all = every_byte();
  pty.write(all);
  EXPECT_EQ(read_for_a_while(*opened.port, all.size()), all);
  EXPECT_EQ(opened.port->write(all.data(), 256), 256);
  EXPECT_EQ(pty.read(all.size()), all);
}

TEST(SerialPort, NothingThere_NeverBlocks) {
  const Pty pty;
  const OpenedSerialPort opened = SerialPort::open(pty.path());
  ASSERT_NE(opened.port, nullptr) << opened.error;
  std::array<std::uint8_t, 4> bytes{};
  EXPECT_EQ(opened.port->read(bytes.data(), 4), 0);
  EXPECT_FALSE(opened.port->wait_readable(0));
  EXPECT_FALSE(opened.port->wait_readable(-5));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(opened.port->wait_readable(30));
  const auto waited = std::chrono::steady_clock::now() - start;
  EXPECT_GE(waited, std::chrono::milliseconds(25));
}

TEST(SerialPort, NobodyReads_TakesSomeAndThenNone) {
  const Pty pty;
  const OpenedSerialPort opened = SerialPort::open(pty.path());
  ASSERT_NE(opened.port, nullptr) << opened.error;
  const Bytes block(4096, 0x55);
  std::size_t taken = 0;
  int last = 1;
  for (int i = 0; i < 1000 && last > 0; ++i) {
    last = opened.port->write(block.data(), static_cast<int>(block.size()));
    taken += static_cast<std::size_t>(last);
  }
  EXPECT_EQ(last, 0);
  EXPECT_EQ(pty.read(taken).size(), taken);
}

TEST(SerialPort, OtherEndGone_SaysSo) {
  Pty pty;
  const OpenedSerialPort opened = SerialPort::open(pty.path());
  ASSERT_NE(opened.port, nullptr) << opened.error;
  pty.hang_up();
  std::array<std::uint8_t, 4> bytes{};
  EXPECT_TRUE(opened.port->wait_readable(1000));
  EXPECT_EQ(opened.port->read(bytes.data(), 4), -1);
  EXPECT_EQ(opened.port->write(bytes.data(), 4), 0);
}

TEST(SerialPort, BytesFromBefore_AreThrownAway) {
  const Pty pty;
  const int early = ::open(pty.path().c_str(), O_RDWR | O_NOCTTY);
  pty.write({1, 2, 3, '\n'});
  const OpenedSerialPort opened = SerialPort::open(pty.path());
  ASSERT_NE(opened.port, nullptr) << opened.error;
  EXPECT_TRUE(read_for_a_while(*opened.port, 0).empty());
  ::close(early);
}

TEST(SerialPort, LinesSettings_ArePutBack) {
  const Pty pty;
  const int watcher = ::open(pty.path().c_str(), O_RDWR | O_NOCTTY);
  termios before{};
  termios after{};
  ASSERT_EQ(tcgetattr(watcher, &before), 0);
  { const OpenedSerialPort opened = SerialPort::open(pty.path()); }
  ASSERT_EQ(tcgetattr(watcher, &after), 0);
  EXPECT_EQ(before.c_lflag, after.c_lflag);
  EXPECT_EQ(before.c_oflag, after.c_oflag);
  ::close(watcher);
}

/// On top of what cfmakeraw() clears: what a modem's or a terminal's program may have left on.
TEST(SerialPort, NoByteStopsTheLine_WhateverItWasLeftWith) {
  const Pty pty;
  const int watcher = ::open(pty.path().c_str(), O_RDWR | O_NOCTTY);
  termios line{};
  ASSERT_EQ(tcgetattr(watcher, &line), 0);
  const tcflag_t left_on = IXOFF | IXON | IXANY | INPCK;
  line.c_iflag |= left_on;
  ASSERT_EQ(tcsetattr(watcher, TCSANOW, &line), 0);
  {
    const OpenedSerialPort opened = SerialPort::open(pty.path());
    ASSERT_NE(opened.port, nullptr) << opened.error;
    ASSERT_EQ(tcgetattr(watcher, &line), 0);
    EXPECT_EQ(line.c_iflag & left_on, 0U);
  }
  ASSERT_EQ(tcgetattr(watcher, &line), 0);
  EXPECT_EQ(line.c_iflag & left_on, left_on) << "put back";
  ::close(watcher);
}

TEST(SerialPort, ARateThatTheLineCannotDo_IsRefused) {
  const Pty pty;
  const auto error_of = [&](int baud) { return SerialPort::open(pty.path(), baud).error; };
  weak_line.fastest = B115200;
  EXPECT_EQ(error_of(115200), "");
  EXPECT_EQ(error_of(3000000), pty.path() + ": the line cannot do 3000000 baud; it is at 115200");
  weak_line = {};
  EXPECT_EQ(error_of(3000000), "");
}

TEST(SerialPort, BitsThatTheLineCannotDo_AreRefused) {
  const Pty pty;
  weak_line.has_seven_bits = true;
  EXPECT_EQ(SerialPort::open(pty.path()).error,
            pty.path() + ": the line cannot do eight bits without parity at 115200 baud");
  weak_line = {};
}

TEST(SerialPort, WhatIsNoSerialLine_IsRefusedWithAReason) {
  EXPECT_EQ(SerialPort::open("/nowhere/tty").error, "/nowhere/tty: no such file");
  EXPECT_EQ(SerialPort::open("/dev/null").error, "/dev/null: not a serial line");
  const std::string folder = ::testing::TempDir();
  EXPECT_NE(SerialPort::open(folder).port == nullptr, false);
  EXPECT_EQ(SerialPort::open(folder).error.rfind(folder + ": cannot be opened: ", 0), 0U);
  const Pty pty;
  EXPECT_EQ(SerialPort::open(pty.path(), 12345).error, pty.path() + ": unknown rate of 12345 baud");
}

TEST(SerialPort, NoPermission_IsRefusedWithAReason) {
  if (::geteuid() == 0) GTEST_SKIP() << "the superuser may open anything";
  const std::string path = ::testing::TempDir() + "batuta_closed";
  std::ofstream(path).put('x');
  std::filesystem::permissions(path, std::filesystem::perms::none);
  EXPECT_EQ(SerialPort::open(path).error.rfind(path + ": no permission", 0), 0U);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace batuta::host

// The linker takes these instead of the C library's.
extern "C" int tcsetattr(int file, int /*when*/, const termios* settings) noexcept {
  using batuta::host::weak_line;
  termios able = *settings;
  if (cfgetospeed(&able) > weak_line.fastest) cfsetspeed(&able, weak_line.fastest);
  const auto really =
      reinterpret_cast<int (*)(int, int, const termios*)>(::dlsym(RTLD_NEXT, "tcsetattr"));
  return really(file, TCSANOW, &able);
}
extern "C" int tcgetattr(int file, termios* settings) noexcept {
  const auto really = reinterpret_cast<int (*)(int, termios*)>(::dlsym(RTLD_NEXT, "tcgetattr"));
  const int answer = really(file, settings);
  // The kernel's ptys have eight bits whatever they are told.
  if (batuta::host::weak_line.has_seven_bits) {
    settings->c_cflag = (settings->c_cflag & ~static_cast<tcflag_t>(CSIZE)) | CS7;
  }
  return answer;
}
