// SPDX-License-Identifier: MIT
// A bout with the forces on its sticks, given what no device and no caller should give.
#include "batuta/haptics/stepped_bout.hpp"

#include <memory>

#include "hostile.hpp"

namespace batuta {
using namespace fencing;
using namespace haptics;
namespace {

InputSample sample_at(std::uint32_t step, float x, float y) {
  InputSample sample;
  sample.time = step * 1000U;
  sample.x = x;
  sample.y = y;
  sample.sequence = step;
  return sample;
}

TEST(SteppedBout, HostileBoutSettings_AreRefusedAndTheBoutGoesOn) {
  const auto bout = std::make_unique<SteppedBout>();
  ASSERT_EQ(bout->start({}), Status::kOk);
  const InputSample sample = sample_at(0, 0.5F, 0.5F);
  ASSERT_EQ(bout->step(&sample, nullptr), Status::kOk);
  StickForces forces;
  for (const float number : test::kHostile<float>) {
    BoutSettings settings;
    settings.distance = number;
    ForceSettings force;
    force.full_scale = number;
    SCOPED_TRACE(number);
    if (!(number > 0) || !is_finite(number)) {
      EXPECT_EQ(validate(force), Status::kInvalidArgument);
      EXPECT_EQ(forces.configure(force), Status::kInvalidArgument);
      EXPECT_EQ(bout->start(settings), Status::kInvalidArgument);
      settings.distance = 2;
      settings.force = force;
      EXPECT_EQ(bout->start(settings), Status::kInvalidArgument);
      EXPECT_EQ(bout->steps(), 1U);
    } else if (validate(force) == Status::kOk) {
      EXPECT_TRUE(is_finite(force.gain().x()));
      EXPECT_EQ(forces.configure(force), Status::kOk);
    }
  }
}

// Whatever a device says, a motor is told a share of what it has.
TEST(SteppedBout, HostileSamples_LeaveEachForceWithinItsRange) {
  const auto bout = std::make_unique<SteppedBout>();
  BoutSettings settings;
  settings.touches = 99;
  ASSERT_EQ(bout->start(settings), Status::kOk);
  bool felt = false;
  std::uint32_t step = 0;
  for (int round = 0; round < 40; ++round) {
    for (const float number : test::kHostile<float>) {
      const float sway = 0.5F * static_cast<float>(step % 200) / 200.0F;
      const InputSample good = sample_at(step, 0, sway);
      const InputSample bad = step % 2 == 0 ? sample_at(step, number, 0) : sample_at(7, 0, number);
      if (bout->step(&good, step % 5 == 0 ? &bad : nullptr) != Status::kOk) break;
      ++step;
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const StickForce& force = bout->forces().of(side);
        ASSERT_TRUE(force.share.cwiseAbs().maxCoeff() <= 1.0F) << "step " << step;  // no NaN either
        ASSERT_TRUE(force.allowed >= 0 && force.allowed <= 1);
        felt = felt || force.share.norm() > 0;
      }
    }
  }
  EXPECT_GT(step, 500U);
  EXPECT_TRUE(felt);
}

}  // namespace
}  // namespace batuta
