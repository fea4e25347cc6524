// SPDX-License-Identifier: MIT
// What start-up owes to main().
#include <cstddef>
#include <cstdint>

#include "batuta/geometry/segment.hpp"
#include "checks.hpp"
#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/stack.hpp"

namespace {

using namespace batuta;

volatile std::uint32_t initialised[3] = {1, 0x12345678U, 0xFFFFFFFFU};
volatile std::uint32_t cleared[100];

/// Known only at run time, so that its constructor has to run before main().
struct Constructed {
  Constructed() : sum(initialised[0] + initialised[1]), runs(runs_before++) {}
  std::uint32_t sum;
  std::uint32_t runs;
  static std::uint32_t runs_before;
};
std::uint32_t Constructed::runs_before = 5;
Constructed first;
Constructed second;

void check_variables(Checks& check) {
  check.that(initialised[1] == 0x12345678U && initialised[2] == 0xFFFFFFFFU, "data is copied");
  std::uint32_t any = 0;
  for (const volatile std::uint32_t& word : cleared) any |= word;
  check.that(any == 0, "bss is cleared");
  check.that(first.sum == 0x12345679U && second.sum == first.sum, "constructors run");
  check.that(first.runs == 5 && second.runs == 6, "each constructor once, in order");
}

void check_arithmetic(Checks& check) {
  volatile float third = 1.0F / 3.0F;
  volatile float big = 3e7F;
  check.that(big * third == 1e7F, "float multiplies");
  volatile float tiny = 1e-38F;
  check.that(tiny / 16.0F > 0.0F, "subnormal numbers are kept");
  volatile float zero = 0.0F;
  check.that(1.0F / zero > big, "division by zero is infinite");
}

void check_library(Checks& check) {
  const Segment<float> along_x{{-1, 0, 0}, {1, 0, 0}};
  const Segment<float> above{{0, -1, 3}, {0, 1, 3}};
  check.that(closest_points(along_x, above).distance == 3.0F, "the library computes a distance");
}

[[gnu::noinline]] void use_stack() {
  volatile std::uint8_t deep[2000];
  for (volatile std::uint8_t& byte : deep) byte = 1;
}

void check_stack(Checks& check) {
  cortex_m::repaint_stack();
  const std::size_t before = cortex_m::stack_used();
  use_stack();
  const std::size_t after = cortex_m::stack_used();
  check.that(before > 0 && before < 1000, "little stack is used at first");
  check.that(after > before + 1000 && after < before + 2200, "2000 bytes of stack are seen");
  check.that(cortex_m::stack_size() == 0x4000, "the stack has its default size");
  cortex_m::repaint_stack();
  check.that(cortex_m::stack_used() < after, "repainting forgets");
}

void check_command_line(Checks& check) {
  char line[512];
  char word[16];
  check.that(semihosting::read_command_line(line, sizeof line) > 0, "there is a command line");
  check.that(semihosting::word_of(line, 1, word, sizeof word) == 3 && word[2] == 'e', "argument 1");
  check.that(semihosting::word_of(line, 2, word, sizeof word) == 5 && word[1] == ',', "argument 2");
  check.that(semihosting::word_of(line, 3, word, sizeof word) == -1, "no argument 3");
  check.that(semihosting::word_of(line, 2, word, 5) == -1, "an argument that does not fit");
  check.that(semihosting::read_command_line(line, 4) == -1, "a line that does not fit");
}

void check_file(Checks& check) {
  using semihosting::File;
  const char* name = "boot_test.bin";
  const char out[] = "0123456789";
  char in[16] = {};
  File file;
  check.that(!file.open("no/such/file", File::Mode::kRead) && file.read(in, 1) == -1, "no file");
  check.that(file.open(name, File::Mode::kWrite) && file.write(out, 10) == 10, "file is written");
  check.that(file.close() && file.open(name, File::Mode::kRead), "file is closed and opened");
  check.that(file.read(in, 4) == 4 && in[3] == '3', "file is read");
  check.that(file.read(in, 16) == 6 && in[5] == '9', "file is read to its end");
  check.that(file.read(in, 16) == 0, "after the end nothing comes");
}

void check_fault_record(Checks& check) {
  using namespace cortex_m;
  record_fault(FaultCode::kMainReturned, 5, 6);
  check.that(last_fault().code == FaultCode::kMainReturned, "the last code is one");
  check.that(take_last_fault().detail[1] == 6, "a record has its details");
  check.that(take_last_fault().code == FaultCode::kNone, "a record is told once");
  record_fault(static_cast<FaultCode>(7), 5, 6);
  check.that(take_last_fault().code == FaultCode::kNone, "a code that does not exist is no record");
}

}  // namespace

int main() {
  Checks check;
  check.that(cortex_m::last_fault().code == cortex_m::FaultCode::kNone, "no fault at power-on");
  check_fault_record(check);
  check_variables(check);
  check_arithmetic(check);
  check_library(check);
  check_stack(check);
  check_command_line(check);
  check_file(check);
  check.end();
}
