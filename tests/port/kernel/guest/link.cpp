// SPDX-License-Identifier: MIT

#include "link.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace guest {
namespace {

constexpr unsigned kVendor = 0x1209;
constexpr int kFiles = 32;
/// A turn looks and then sleeps for a millisecond; what is waited for takes some tens.
constexpr int kTurns = 30000;

int error_of(int result) {
  return result < 0 ? errno : 0;
}

template <std::size_t kBytes>
bool bit(const std::array<unsigned char, kBytes>& bits, int number) {
  const auto at = static_cast<std::size_t>(number);
  return ((bits[at / 8] >> (at % 8)) & 1) != 0;
}

/// The stick among the kernel's input files. @returns its file, open | -1
int find() {
  for (int i = 0; i < kFiles; ++i) {
    const std::string path = "/dev/input/event" + std::to_string(i);
    const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) continue;
    input_id id{};
    int effects = 0;
    const bool is = ioctl(file, EVIOCGID, &id) == 0 && id.bustype == BUS_USB &&
                    id.vendor == kVendor && ioctl(file, EVIOCGEFFECTS, &effects) == 0 &&
                    effects > 0;
    if (is) return file;
    ::close(file);
  }
  return -1;
}

}  // namespace

void give_up(const char* what) {
  std::printf("gave up: %s\n", what);
  std::fflush(stdout);
  std::exit(1);
}

Line::Line() : file_(open("/dev/ttyS1", O_RDWR | O_NOCTTY)) {
  termios raw{};
  if (file_ < 0 || tcgetattr(file_, &raw) != 0) give_up("there is no second serial line");
  cfmakeraw(&raw);
  cfsetspeed(&raw, B115200);
  if (tcsetattr(file_, TCSANOW, &raw) != 0) give_up("the second serial line is not raw");
}

Line::Answer Line::ask(const std::string& command) {
  const std::string line = command + "\n";
  if (::write(file_, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
    give_up("the second serial line takes nothing");
  }
  std::string text;
  for (char letter = 0; letter != '\n'; text += letter) {
    if (read(file_, &letter, 1) != 1) give_up("the device does not answer");
  }
  Answer answer;
  const int fields = std::sscanf(text.c_str(), "%lf %lf %d %u %u", &answer.force.x, &answer.force.y,
                                 &answer.playing, &answer.gains, &answer.refused);
  if (fields != 5) give_up(("what the device answers: " + text).c_str());
  return answer;
}

Line::Answer Line::move(int milliseconds, const Movement& m) {
  std::array<char, 200> command{};
  std::snprintf(command.data(), command.size(), "move %d %g %g %g %g %g %g %x", milliseconds,
                m.from.x, m.from.y, m.velocity.x, m.velocity.y, m.acceleration.x, m.acceleration.y,
                m.buttons);
  return ask(command.data());
}

Stick::Stick(Line& line) : line_(line) {
  for (int turn = 0; file_ < 0; ++turn, usleep(1000)) {
    if (turn == kTurns) give_up("the kernel shows no stick with force feedback");
    file_ = find();
  }
}

int Stick::effects() const {
  int count = 0;
  ioctl(file_, EVIOCGEFFECTS, &count);
  return count;
}

std::string Stick::name() const {
  std::array<char, 100> name{};
  ioctl(file_, EVIOCGNAME(name.size() - 1), name.data());
  return name.data();
}

bool Stick::has(int type, int code) const {
  std::array<unsigned char, KEY_MAX / 8 + 1> bits{};
  ioctl(file_, EVIOCGBIT(type, bits.size()), bits.data());
  return bit(bits, code);
}

int Stick::axis(int code) const {
  input_absinfo axis{};
  ioctl(file_, EVIOCGABS(code), &axis);
  return axis.value;
}

bool Stick::pressed(int key) const {
  std::array<unsigned char, KEY_MAX / 8 + 1> bits{};
  ioctl(file_, EVIOCGKEY(bits.size()), bits.data());
  return bit(bits, key);
}

int Stick::upload(ff_effect& effect) const {
  return error_of(ioctl(file_, EVIOCSFF, &effect));
}

int Stick::erase(int id) const {
  return error_of(ioctl(file_, EVIOCRMFF, id));
}

int Stick::write(int code, int value) const {
  input_event event{};
  event.type = EV_FF;
  event.code = static_cast<unsigned short>(code);
  event.value = value;
  return error_of(static_cast<int>(::write(file_, &event, sizeof event)));
}

int Stick::gain(unsigned value) {
  gain_ = value;
  settle();
  return 0;
}

void Stick::settle() {
  const unsigned before = line_.look().gains;
  if (write(FF_GAIN, static_cast<int>(gain_)) != 0) give_up("the kernel takes no gain");
  for (int turn = 0; line_.look().gains == before; ++turn, usleep(1000)) {
    if (turn == kTurns) give_up("a gain does not come to the device");
  }
}

void Stick::close() {
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

}  // namespace guest
