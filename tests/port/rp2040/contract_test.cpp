// SPDX-License-Identifier: MIT
// The contract suite on this port's devices, on a fake of the Pico SDK's functions.

#include "contract_suite.hpp"

#include "fake_pico.hpp"
#include "platforms/rp2040/board.hpp"
#include "platforms/rp2040/drivers/pico_force.hpp"
#include "platforms/rp2040/drivers/pico_stick.hpp"

namespace batuta::test {
namespace {

using rp2040::test::fake_pico;

/// A stick in motion, read at no round times; its wire is off now and then.
class PicoStickRig {
 public:
  static constexpr bool kHasSamples = true;

  PicoStickRig() {
    fake_pico() = {};
    EXPECT_EQ(stick_.start(rp2040::kStickAxis), Status::kOk);
  }
  InputDevice& device() { return stick_; }
  Microseconds next() {
    ++turn_;
    const bool off = turn_ % 300 == 0;
    fake_pico().counts = {static_cast<std::uint16_t>(off ? 0U : 64U + turn_ * 37U % 3900U),
                          static_cast<std::uint16_t>(64U + turn_ * 53U % 3900U), 0, 0};
    return now_ += 700;
  }

 private:
  rp2040::PicoStick stick_;
  Microseconds now_ = 0xFFFFFF00U;  // it wraps
  std::uint32_t turn_ = 0;
};

class PicoForceRig {
 public:
  PicoForceRig() {
    fake_pico() = {};
    force_.configure();
    EXPECT_EQ(force_.arm(), Status::kOk);
  }
  ForceDevice& device() { return force_; }

 private:
  rp2040::PicoForce force_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(PicoStick, InputContract, ::testing::Types<PicoStickRig>);
INSTANTIATE_TYPED_TEST_SUITE_P(PicoForce, ForceContract, ::testing::Types<PicoForceRig>);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ClockContract);  // the clock is the SDK's

}  // namespace
}  // namespace batuta::test
