// SPDX-License-Identifier: MIT
#include "ensemble.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include "reference.hpp"

namespace batuta::test {
namespace {

constexpr std::uint64_t kSeed = 1;

void mix_in(std::uint64_t& digest, float x) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  digest = (digest ^ bits) * 0x100000001b3;  // FNV-1a by words
}

void mix_in(std::uint64_t& digest, const MovingCapsule<float>& m) {
  for (int i = 0; i < 3; ++i) {  // Bound: three coordinates
    mix_in(digest, m.capsule_B.axis.a[i]);
    mix_in(digest, m.capsule_B.axis.b[i]);
    mix_in(digest, m.motion.X_WB.p_W[i]);
    mix_in(digest, m.motion.twist.v_W[i]);
    mix_in(digest, m.motion.twist.w_W[i]);
  }
  for (int i = 0; i < 4; ++i) mix_in(digest, m.motion.X_WB.q_WB.coeffs()[i]);
  mix_in(digest, m.capsule_B.radius);
  mix_in(digest, m.motion.duration);
}

std::uint64_t digest_of(Family family, std::uint64_t seed, std::uint64_t first, int count) {
  std::uint64_t digest = 0xcbf29ce484222325;
  for (int i = 0; i < count; ++i) {  // Bound: count
    const Query q = make_query(family, seed, first + static_cast<std::uint64_t>(i));
    mix_in(digest, q.A);
    mix_in(digest, q.B);
  }
  return digest;
}

TEST(Ensemble, EveryFamily_HasItsOwnNameAndQueries) {
  std::set<std::string> names;
  std::set<std::uint64_t> digests;
  for (const Family family : kFamilies) {
    names.insert(name(family));
    digests.insert(digest_of(family, kSeed, 0, 4));
  }
  EXPECT_EQ(names.size(), kFamilyCount);
  EXPECT_EQ(digests.size(), kFamilyCount);
}

TEST(Ensemble, Query_DependsOnSeedAndIndexAlone) {
  for (const Family family : kFamilies) {
    const std::uint64_t once = digest_of(family, kSeed, 1'000'000'007, 1);
    digest_of(family, kSeed, 5, 3);
    EXPECT_EQ(digest_of(family, kSeed, 1'000'000'007, 1), once) << name(family);
    EXPECT_NE(digest_of(family, kSeed, 1'000'000'008, 1), once) << name(family);
    EXPECT_NE(digest_of(family, kSeed + 1, 1'000'000'007, 1), once) << name(family);
  }
}

TEST(Ensemble, AllFamilies_SameBitsOnEveryPlatform) {
  std::uint64_t digest = 0;
  for (const Family family : kFamilies) digest = digest * 31 + digest_of(family, kSeed, 0, 1000);
  EXPECT_EQ(digest, std::uint64_t{17101376962046960100U})
      << "the queries of every report change with this number";
}

TEST(Ensemble, EveryQuery_IsValidInBothScalars) {
  for (const Family family : kFamilies) {
    bool turning = false;
    for (std::uint64_t i = 0; i < 1000; ++i) {  // Bound: 1000 queries
      const Query q = make_query(family, kSeed, i);
      ASSERT_EQ(q.A.motion.duration, q.B.motion.duration);
      EXPECT_NEAR(q.A.motion.X_WB.q_WB.norm(), 1, 1e-6F);
      EXPECT_TRUE(make_moving_pair(cast<float>(q.A), cast<float>(q.B)).ok()) << name(family) << i;
      EXPECT_TRUE(make_moving_pair(cast<double>(q.A), cast<double>(q.B)).ok()) << name(family) << i;
      turning = turning || q.A.motion.twist.w_W.norm() > 0 || q.B.motion.twist.w_W.norm() > 0;
    }
    EXPECT_EQ(turning, turns(family)) << name(family);
  }
}

TEST(Ensemble, EveryFamily_IsAboutHalfContactsAndStartsApart) {
  for (const Family family : kFamilies) {
    constexpr int kQueries = 1000;
    int free = 0;
    int overlapping = 0;
    for (std::uint64_t i = 0; i < kQueries; ++i) {  // Bound: kQueries
      const Query q = make_query(family, kSeed, i);
      const Reference<double> truth(q.A, q.B);
      overlapping += truth.gap(0) <= 0 ? 1 : 0;
      free += truth.march(1e-9 * truth.scale()).verdict == Verdict::kFree ? 1 : 0;
    }
    EXPECT_GT(free, 0.25 * kQueries) << name(family);
    EXPECT_LT(free, 0.6 * kQueries) << name(family);
    EXPECT_LT(overlapping, 0.1 * kQueries) << name(family);
  }
}

}  // namespace
}  // namespace batuta::test
