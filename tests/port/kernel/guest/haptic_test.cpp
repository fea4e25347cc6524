// SPDX-License-Identifier: MIT
// A program in the emulated machine: SDL's own haptic test plays all effects that it finds, five
// seconds each, while the stick is moved and its motor's force is looked at from outside.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "checks.hpp"

namespace guest {
namespace {

constexpr const char* kTest = "/program";
constexpr int kLook = 10;           // ms between two looks
constexpr double kAmplitude = 0.5;  // of the way to the stop
constexpr double kPulse = 6.283;    // rad/s: a turn a second
constexpr double kFelt = 0.02;      // share of the motor's range
constexpr int kTurns = 1000;        // looks until the last force has gone

/// What the motor got while one effect played.
struct Felt {
  int playing = 0;
  double force = 0;
};

/// Up and down, and sideways, so that springs, dampers, and inertia have something to push back.
Movement swing(double time) {
  const double sine = kAmplitude * std::sin(kPulse * time);
  const double cosine = kAmplitude * std::cos(kPulse * time);
  return {{sine, cosine},
          {kPulse * cosine, -kPulse * sine},
          {-kPulse * kPulse * sine, -kPulse * kPulse * cosine}};
}

/// SDL's test as a process, and what it says.
class Player {
 public:
  Player() {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) give_up("there is no pipe");
    process_ = fork();
    if (process_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      dup2(ends[1], STDERR_FILENO);
      setenv("SDL_VIDEODRIVER", "dummy", 1);
      execl(kTest, kTest, static_cast<char*>(nullptr));
      _exit(127);
    }
    if (process_ < 0) give_up("the test does not start");
    ::close(ends[1]);
    file_ = ends[0];
    fcntl(file_, F_SETFL, O_NONBLOCK);
  }

  /// @returns the lines that have come since it was asked last
  std::vector<std::string> said() {
    std::array<char, 512> bytes{};
    for (ssize_t size = 0; (size = read(file_, bytes.data(), bytes.size())) > 0;) {
      text_.append(bytes.data(), static_cast<std::size_t>(size));
    }
    std::vector<std::string> lines;
    for (std::size_t end = 0; (end = text_.find('\n')) != std::string::npos;) {
      lines.push_back(text_.substr(0, end));
      text_.erase(0, end + 1);
    }
    return lines;
  }

  bool has_ended() { return has_ended_ || (has_ended_ = waitpid(process_, &status_, WNOHANG) > 0); }
  long code() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }

 private:
  pid_t process_ = -1;
  int file_ = -1;
  int status_ = 0;
  bool has_ended_ = false;
  std::string text_;
};

bool contains(const std::string& line, const char* words) {
  return line.find(words) != std::string::npos;
}

/// Until the test has ended: the stick's time goes as fast as the machine's.
/// @returns how many effects it has uploaded
long look_on(Line& line, Player& player, std::vector<Felt>& felt) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  long uploaded = 0;
  for (int moved = 0; !player.has_ended(); usleep(1000 * kLook)) {
    for (const std::string& words : player.said()) {
      std::printf("SDL: %s\n", words.c_str());
      if (contains(words, "   effect ")) ++uploaded;
      if (contains(words, "Playing effect ")) felt.emplace_back();
    }
    const auto passed = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin);
    const int step = static_cast<int>(passed.count()) - moved;
    const Line::Answer now = line.move(step, swing(1e-3 * moved));
    moved += step;
    if (felt.empty()) continue;
    felt.back().playing = std::max(felt.back().playing, now.playing);
    felt.back().force = std::max(felt.back().force, std::hypot(now.force.x, now.force.y));
  }
  return uploaded;
}

void play(Checks& checks) {
  checks.begin("SDL");
  Player player;
  std::vector<Felt> felt;
  const long uploaded = look_on(checks.line, player, felt);
  checks.number("uploaded", 9, uploaded);
  for (std::size_t i = 0; i < felt.size(); ++i) {
    const std::string name = "effect " + std::to_string(i);
    checks.number(name + " plays", 1, felt[i].playing);
    checks.number(name + " is felt", 1, felt[i].force > kFelt ? 1 : 0);
  }
  checks.number("exit code", 0, player.code());
  Line::Answer last = checks.line.look();
  for (int turn = 0; last.playing != 0 && turn < kTurns; ++turn) last = checks.line.move(1, {});
  checks.number("left", 0, last.playing);
  checks.force("at the end", {}, checks.line.move(1000, {}).force);
  checks.number("refused", 0, static_cast<long>(last.refused));
}

}  // namespace
}  // namespace guest

int main() {
  using namespace guest;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  Line line;
  Stick stick(line);  // the kernel has it
  stick.close();      // and nobody else plays on it
  Checks checks(line, stick);
  line.move(100, {});  // the stage's ramps open
  play(checks);
  std::puts("the end");
  return 0;
}
