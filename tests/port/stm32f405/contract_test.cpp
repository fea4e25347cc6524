// SPDX-License-Identifier: MIT
// The contract suite on this port's devices, with plain memory for registers.

#include "contract_suite.hpp"

#include "adc_rig.hpp"
#include "platforms/stm32f405/drivers/bridge_force.hpp"

namespace batuta::test {
namespace {

/// A stick in motion, read a little faster than it converts; its wire is off now and then.
class AdcStickRig {
 public:
  static constexpr bool kHasSamples = true;

  AdcStickRig() { rig_.connect(); }
  InputDevice& device() { return rig_.stick; }
  Microseconds next() {
    now_ += 700;
    if (elapsed_us(rig_.now, now_) < 0) return rig_.now;
    ++turn_;
    const bool off = turn_ % 300 == 0;
    rig_.convert(static_cast<std::uint16_t>(off ? 0U : 64U + turn_ * 37U % 3900U),
                 static_cast<std::uint16_t>(64U + turn_ * 53U % 3900U));
    return rig_.now;
  }

 private:
  stm32f405::test::AdcRig rig_;
  Microseconds now_ = stm32f405::Connection::kReturnAfter * stm32f405::kWindowUs;
  std::uint32_t turn_ = 0;
};

class BridgeRig {
 public:
  BridgeRig() {
    force_.configure(8400);
    (void)force_.arm();
  }
  ForceDevice& device() { return force_; }

 private:
  stm32f405::Tim timer_{};
  stm32f405::BridgeForce force_{timer_};
};

INSTANTIATE_TYPED_TEST_SUITE_P(AdcStick, InputContract, ::testing::Types<AdcStickRig>);
INSTANTIATE_TYPED_TEST_SUITE_P(Bridge, ForceContract, ::testing::Types<BridgeRig>);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ClockContract);  // the clock is SysTick's

}  // namespace
}  // namespace batuta::test
