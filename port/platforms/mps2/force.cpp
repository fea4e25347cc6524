// SPDX-License-Identifier: MIT
#include "platforms/mps2/force.hpp"

#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/registers.hpp"
#include "platforms/mps2/board.hpp"

namespace batuta::mps2 {
namespace {

constexpr cortex_m::Register kLeds{kBoard.fpgaio};

volatile std::int32_t level[2];

std::int32_t in_units(float share) {
  constexpr float kUnits = 32768.0F;
  return static_cast<std::int32_t>(share * kUnits);
}

void show(std::int32_t x, std::int32_t y) {
  level[0] = x;
  level[1] = y;
  kLeds.write((x != 0 ? 1U : 0U) | (y != 0 ? 2U : 0U));
}

}  // namespace

Status Force::do_write(const ForceCommand& command) {
  show(in_units(command.x), in_units(command.y));
  return Status::kOk;
}

ForceLevel force_level() {
  return {level[0], level[1]};
}

}  // namespace batuta::mps2

void batuta_board_force_off() {
  batuta::mps2::show(0, 0);
}
