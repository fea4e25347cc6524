// SPDX-License-Identifier: MIT
// The step of the bridge compiled for this machine, to hold that of WebAssembly against: both fence
// the same bouts, attack against parry. Prints us for each step, the least of several runs.
//   batuta_web_bench [STEPS]

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" {
int web_start(int touches, int record);
void web_choose(int side, int script);
int web_step();
std::uint64_t web_hash();
}

namespace {

constexpr int kRuns = 7;
constexpr int kSteps = 40000;
constexpr int kTouches = 1;
constexpr int kOk = 0;

/// us for each step
double run(int steps) {
  const auto before = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) {
    if (web_step() != kOk) (void)web_start(kTouches, 0);
  }
  const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - before;
  return spent.count() / steps;
}

}  // namespace

int main(int count, char** words) {
  const int steps = count > 1 ? std::atoi(words[1]) : kSteps;
  constexpr int kParry = 1;
  constexpr int kAttack = 2;
  web_choose(0, kAttack);
  web_choose(1, kParry);
  double least = 1e9;
  for (int i = 0; i < kRuns; ++i) {
    (void)web_start(kTouches, 0);
    least = std::min(least, run(steps));
  }
  std::printf("%.3f %016llx\n", least, static_cast<unsigned long long>(web_hash()));
}
