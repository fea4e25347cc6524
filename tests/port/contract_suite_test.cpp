// SPDX-License-Identifier: MIT
// The contract suite on devices made for it, so that its tests are known to run with samples, too.

#include "contract_suite.hpp"

namespace batuta::test {
namespace {

/// A device that has a new sample every third millisecond.
class Ticking final : public InputDevice {
  Status do_read(Microseconds now, InputSample& sample) override {
    const std::uint32_t sequence = now / 3000;
    if (sequence == last_) return Status::kUnavailable;
    last_ = sequence;
    sample.time = sequence * 3000;
    sample.x = static_cast<float>(sequence % 3) - 1;
    sample.y = -sample.x;
    sample.sequence = sequence;
    return Status::kOk;
  }

  std::uint32_t last_ = 0;
};

struct TickingStick {
  static constexpr bool kHasSamples = true;
  InputDevice& device() { return device_; }
  Microseconds next() { return now_ += 1000; }

 private:
  Ticking device_;
  Microseconds now_ = 0;
};

class Lamp final : public ForceDevice {
  Status do_write(const ForceCommand& command) override {
    EXPECT_LE(std::abs(command.x), 1.0F);
    EXPECT_LE(std::abs(command.y), 1.0F);
    return Status::kOk;
  }
};

struct LampRig {
  ForceDevice& device() { return device_; }

 private:
  Lamp device_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Ticking, InputContract, ::testing::Types<TickingStick>);
INSTANTIATE_TYPED_TEST_SUITE_P(Lamp, ForceContract, ::testing::Types<LampRig>);

}  // namespace
}  // namespace batuta::test
