// SPDX-License-Identifier: MIT
// The fencing firmware on an MPS2 board. The board has neither stick nor motor: the stick's samples
// come over UART 0, the force is a pair of words and two LEDs.

#include "batuta/core/arithmetic.hpp"
#include "platforms/cortex_m/fault.hpp"
#include "platforms/cortex_m/systick.hpp"
#include "platforms/mps2/board.hpp"
#include "platforms/mps2/force.hpp"
#include "platforms/mps2/uart.hpp"
#include "shared/firmware/stated_rival.hpp"

namespace {

using namespace batuta;

constexpr std::uint32_t kBitsPerSecond = 1'000'000;
constexpr std::uint32_t kUartRate = 1;             // second detail of a failed start: no such rate
constexpr std::uint32_t kApplicationSettings = 2;  // refused by the application
constexpr std::uint32_t kArithmetic = 3;           // this program was compiled with other flags

[[noreturn]] void give_up(std::uint32_t reason) {
  cortex_m::enter_safe_state(cortex_m::FaultCode::kStartUp,
                             static_cast<std::uint32_t>(cortex_m::StartUpFailure::kApplication),
                             reason);
}

firmware::LastFault last_fault() {
  const cortex_m::FaultRecord record = cortex_m::take_last_fault();
  return {static_cast<std::uint32_t>(record.code), {record.detail[0], record.detail[1]}};
}

/// Everything that the program owns.
struct Fencing {
  cortex_m::SysTickClock clock;
  mps2::Uart uart;
  mps2::Force force;
  firmware::StatedApplication application{{clock, uart, nullptr, &force}, last_fault()};
};

Fencing bout;

}  // namespace

int main() {
  if (!rounds_each_operation<float>()) give_up(kArithmetic);
  cortex_m::start_systick(cortex_m::millisecond(mps2::kBoard.clock_hz));
  if (!bout.uart.start(kBitsPerSecond)) give_up(kUartRate);
  if (bout.application.start({}, firmware::kStatedRival) != Status::kOk)
    give_up(kApplicationSettings);
  std::uint32_t tick = cortex_m::period_count();
  while (true) {
    tick = cortex_m::next_period(tick);
    bout.application.tick(tick);
  }
}
