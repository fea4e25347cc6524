// SPDX-License-Identifier: MIT
// The simulated stick keeps the contract of a port's devices.
#include "../contract_suite.hpp"
#include "shared/simulated/stick.hpp"

namespace batuta::test {
namespace {

class StickRig {
 public:
  static constexpr bool kHasSamples = true;

  StickRig() {
    port_simulated::StickSettings settings;
    settings.x.hand_stiffness = settings.y.hand_stiffness = 50;
    EXPECT_EQ(stick_.configure(settings), Status::kOk);
  }
  InputDevice& device() { return stick_.input(); }
  /// The hand wants to go beyond the rim, now and then.
  Microseconds next() {
    ++calls_;
    stick_.advance({calls_ % 300 < 150 ? 1.5 : -1.5, 0.5});
    return stick_.now();
  }

 private:
  port_simulated::SimulatedStick stick_;
  int calls_ = 0;
};

class MotorRig {
 public:
  MotorRig() { EXPECT_EQ(stick_.configure({}), Status::kOk); }
  ForceDevice& device() { return stick_.force(); }

 private:
  port_simulated::SimulatedStick stick_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Simulated, InputContract, ::testing::Types<StickRig>);
INSTANTIATE_TYPED_TEST_SUITE_P(Simulated, ForceContract, ::testing::Types<MotorRig>);

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(ClockContract);  // time passes by advance()

}  // namespace
}  // namespace batuta::test
