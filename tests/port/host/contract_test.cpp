// SPDX-License-Identifier: MIT
// The contract suite on the host's devices.
#include <memory>

#include "contract_suite.hpp"
#include "platforms/host/clock.hpp"
#include "programs/devices/replay_device.hpp"
#include "programs/devices/script_device.hpp"
#include "programs/live/live_force.hpp"

namespace batuta::test {
namespace {

/// A recording with irregular times, read on a clock of its own.
class ReplayRig {
 public:
  static constexpr bool kHasSamples = true;

  ReplayRig() : device_(recording(), "test") {}
  InputDevice& device() { return device_; }
  Microseconds next() { return now_ += 700; }

 private:
  static host::Recording recording() {
    host::Recording recording;
    for (std::uint32_t i = 0; i < 2000; ++i) {
      InputSample sample;
      sample.time = 900 * i + i * i % 601;
      sample.x = static_cast<float>(i % 200) / 100.0F - 1.0F;
      sample.y = 1.0F - static_cast<float>(i % 100) / 50.0F;
      sample.sequence = i;
      recording.samples.push_back(sample);
    }
    return recording;
  }

  host::ReplayDevice device_;
  Microseconds now_ = 0;
};

class ScriptRig {
 public:
  static constexpr bool kHasSamples = true;

  InputDevice& device() { return device_; }
  Microseconds next() { return now_ += 700; }

 private:
  host::ScriptDevice device_{*host::script_named("attack")};
  Microseconds now_ = 0;
};

/// A live force with its thread; the device behind it takes everything.
class LiveForceRig {
 public:
  ForceDevice& device() { return device_; }

 private:
  class Willing final : public host::ForceBackend {
   public:
    host::ForceKind open() override { return host::ForceKind::kForce; }
    host::Rendered render(const host::Feel& /*feel*/) override { return host::Rendered::kDone; }
    void close() override {}
    host::ForceKind kind() const override { return host::ForceKind::kForce; }
    bool is_there() override { return true; }
  };

  host::LiveForce device_{std::make_unique<Willing>(), {}};
};

struct ClockRig {
  Clock& clock() { return clock_; }
  HostClock clock_;
};

INSTANTIATE_TYPED_TEST_SUITE_P(Replay, InputContract, ::testing::Types<ReplayRig>);
INSTANTIATE_TYPED_TEST_SUITE_P(Script, InputContract, ::testing::Types<ScriptRig>);
INSTANTIATE_TYPED_TEST_SUITE_P(Host, ClockContract, ::testing::Types<ClockRig>);
INSTANTIATE_TYPED_TEST_SUITE_P(Live, ForceContract, ::testing::Types<LiveForceRig>);

}  // namespace
}  // namespace batuta::test
