// SPDX-License-Identifier: MIT
#include "programs/duel/trace.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace batuta::host {
namespace {

TracePoint point_at(float time, float x) {
  return {time, Vec3<float>(x, 0, 0)};
}

TEST(Trace, LeavesOutWhatIsFinerThanItsSpacing) {
  const auto trace = std::make_unique<Trace>();
  trace->add(point_at(0, 0));
  trace->add(point_at(1, 0.9F * trace->spacing()));
  EXPECT_EQ(trace->size(), 1U);
  trace->add(point_at(2, 1.1F * trace->spacing()));
  EXPECT_EQ(trace->size(), 2U);
}

TEST(Trace, StaysInItsMemory_AndKeepsTheWholeWay) {
  const auto trace = std::make_unique<Trace>();
  constexpr int kPoints = 100'000;
  for (int i = 0; i < kPoints; ++i) {
    trace->add(point_at(static_cast<float>(i), static_cast<float>(i % 1000) * 0.001F));
  }
  EXPECT_LE(trace->size(), Trace::kCapacity);
  EXPECT_GT(trace->size(), Trace::kCapacity / 10);
  EXPECT_EQ((*trace)[0].time, 0.0F);
  EXPECT_GT((*trace)[trace->size() - 1].time, kPoints - 2000.0F);
  for (std::size_t i = 1; i < trace->size(); ++i) {
    EXPECT_LT((*trace)[i - 1].time, (*trace)[i].time);
    EXPECT_GE(((*trace)[i].p_W - (*trace)[i - 1].p_W).norm(), trace->spacing());
  }
}

}  // namespace
}  // namespace batuta::host
