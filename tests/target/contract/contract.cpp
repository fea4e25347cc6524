// SPDX-License-Identifier: MIT
// The contract suite on the board's own clock and force. The board has no stick: that of the test
// has a sample every 300 us of the board's time. `faulty`: devices that break the contract.
#include "contract_on_board.hpp"
#include "faulty_rigs.hpp"
#include "platforms/cortex_m/semihosting.hpp"
#include "platforms/cortex_m/systick.hpp"
#include "platforms/mps2/board.hpp"
#include "platforms/mps2/force.hpp"

namespace {

using namespace batuta;

constexpr Microseconds kPollUs = 100;

struct BoardClock {
  Clock& clock() { return clock_; }

 private:
  cortex_m::SysTickClock clock_;
};

struct BoardMotor {
  ForceDevice& device() { return force_; }

 private:
  mps2::Force force_;
};

class Swinging final : public InputDevice {
  Status do_read(Microseconds now, InputSample& sample) override {
    const Microseconds time = now - now % (3 * kPollUs);
    if (time == last_.time) return Status::kUnavailable;
    last_.time = time;
    last_.x = static_cast<float>(time % 1000) / 1000.0F;
    last_.y = -last_.x;
    ++last_.sequence;
    sample = last_;
    return Status::kOk;
  }

  InputSample last_;
};

class SwingingStick {
 public:
  static constexpr bool kHasSamples = true;
  InputDevice& device() { return device_; }
  /// Waits. Bound: kPollUs; a clock that stands still never returns.
  Microseconds next() {
    const Microseconds from = clock_.now();
    Microseconds now = from;
    while (now - from < kPollUs) now = clock_.now();
    return now;
  }

 private:
  cortex_m::SysTickClock clock_;
  Swinging device_;
};

bool is_faulty() {
  char line[128];
  char word[16];
  return semihosting::read_command_line(line, sizeof line) > 0 &&
         semihosting::word_of(line, 1, word, sizeof word) == 6;
}

void check_faulty(test::ContractOnBoard& contract) {
  using test::Fault;
  contract.clock<test::CountingClock<Fault::kGoesBack>>();
  contract.input<test::TickingStick<Fault::kNewTwice>>();
  contract.force<test::Lamp<Fault::kAllocates>>();
}

void check_board(test::ContractOnBoard& contract) {
  contract.clock<BoardClock>();
  contract.input<SwingingStick>();
  contract.force<BoardMotor>();
}

}  // namespace

int main() {
  cortex_m::start_systick(cortex_m::millisecond(mps2::kBoard.clock_hz));
  test::ContractOnBoard contract(semihosting::write);
  if (is_faulty()) {
    check_faulty(contract);
  } else {
    check_board(contract);
  }
  semihosting::exit(contract.end() ? 0 : 1);
}
