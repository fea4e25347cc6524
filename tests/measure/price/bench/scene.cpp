// SPDX-License-Identifier: MIT
// Measures one scene: bench OUT RESTITUTION STEPS, the restitution in tenths. OUT gets a figure for
// each step of the run, and the bits in which it ended.

#include "../scene/scene.hpp"
#include "platforms/cortex_m/semihosting.hpp"
#include "samples.hpp"
#include "ticks.hpp"

namespace batuta::price {
namespace {

SampleFile out;

std::uint32_t number(const char* text) {
  std::uint32_t value = 0;
  for (; *text >= '0' && *text <= '9'; ++text) {  // Bound: the length of the word
    value = 10 * value + static_cast<std::uint32_t>(*text - '0');
  }
  return value;
}

void measure_step(std::uint32_t step) {
  Status status = Status::kOk;
  const std::uint32_t ticks = ticks_of([&] { status = price_scene_step(kPriceStep); });
  const auto answered = static_cast<std::uint32_t>(status);
  out.add({Kind::kSceneStep, step, ticks, {price_scene_contacts(), answered, 0}});
}

int run(const digest::Words& words) {
  if (words.count != 3 || !out.open(words.word[0])) return 2;
  start_ticks();
  out.add({Kind::kCalibration, kCalibrationInstructions, calibration_ticks(), {}});
  out.add({Kind::kReading, 0, reading_ticks(), {}});
  if (!price_scene_place(0.1F * static_cast<float>(number(words.word[1])))) return 3;
  const std::uint32_t steps = number(words.word[2]);
  for (std::uint32_t step = 0; step < steps; ++step) measure_step(step);  // Bound: steps
  out.add({Kind::kSceneState, price_scene_state(), 0, {}});
  return out.close() ? 0 : 1;
}

}  // namespace
}  // namespace batuta::price

int main(int count, char** words) {
  batuta::semihosting::exit(batuta::price::run(batuta::digest::command_line(count, words)));
}
