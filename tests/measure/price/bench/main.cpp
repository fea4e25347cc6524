// SPDX-License-Identifier: MIT
// Measures the library on a file of queries: bench IN OUT EVERY STEPS. IN is a file of the digest
// (tests/target/digest), OUT gets the figures (samples.hpp), of the queries each EVERY-th is taken,
// of a bout the first STEPS steps.

#include "measure.hpp"
#include "platforms/cortex_m/semihosting.hpp"
#include "platforms/cortex_m/stack.hpp"
#include "ticks.hpp"

namespace batuta::price {
namespace {

digest::Input input;
SampleFile out;

std::uint32_t number(const char* text) {
  std::uint32_t value = 0;
  for (; *text >= '0' && *text <= '9'; ++text) {  // Bound: the length of the word
    value = 10 * value + static_cast<std::uint32_t>(*text - '0');
  }
  return value;
}

void take(const Task& task, const digest::ChunkHead& head) {
  cortex_m::repaint_stack();
  const std::size_t above = cortex_m::stack_used();
  switch (static_cast<digest::Chunk>(head.chunk)) {
    case digest::Chunk::kToc:
      price_search(task);
      break;
    case digest::Chunk::kDistance:
      price_segments(task);
      break;
    case digest::Chunk::kImpulse:
      price_impulses(task);
      break;
    case digest::Chunk::kBout:
      price_bout(task, head.parameter);
      break;
  }
  out.add(
      {Kind::kStack, head.chunk, static_cast<std::uint32_t>(cortex_m::stack_used() - above), {}});
}

int run(const digest::Words& words) {
  if (words.count != 4 || !input.open(words.word[0]) || !out.open(words.word[1])) return 2;
  start_ticks();
  out.add({Kind::kCalibration, kCalibrationInstructions, calibration_ticks(), {}});
  out.add({Kind::kReading, 0, reading_ticks(), {}});
  const Task task{input, out, number(words.word[2]), number(words.word[3])};
  digest::ChunkHead head;
  while (input.next(head)) take(task, head);  // Bound: the chunks of the file
  const bool read = input.ok();
  return out.close() && read ? 0 : 1;
}

}  // namespace
}  // namespace batuta::price

int main(int count, char** words) {
  batuta::semihosting::exit(batuta::price::run(batuta::digest::command_line(count, words)));
}
