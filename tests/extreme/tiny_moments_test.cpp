// SPDX-License-Identifier: MIT
// Weapons that hardly anything keeps from turning: a blow at a body may turn them faster than a
// motion can. They go along with the body then, and the bout goes on.
#include <array>
#include <cmath>
#include <memory>

#include "batuta/fencing/duel.hpp"
#include "hostile.hpp"

namespace batuta {
using namespace fencing;
namespace {

template <class S>
class TinyMoments : public testing::Test {};
TYPED_TEST_SUITE(TinyMoments, test::Scalars);

/// kg m^2: from a little less than a real weapon has down to far less than any has.
template <class S>
constexpr std::array<S, 7> kMoments = {S(1e-8),  S(1e-11), S(1e-13), S(1e-16),
                                       S(1e-20), S(1e-26), S(1e-32)};

TYPED_TEST(TinyMoments, WeaponIsRefusedOrFences) {
  using S = TypeParam;
  using DuelT = Duel<DuelScene<two_fencers, Advancement<S>>>;
  int fenced = 0;
  for (const S moment : kMoments<S>) {
    Fencer<S> fencer = first_fencer<S>();
    fencer.weapon.moments.x() = moment;
    auto settings = duel_settings<typename DuelT::StatedScene>();
    settings.touches = kMostTouches;
    const auto duel = std::make_unique<DuelT>();
    if (duel->configure(settings, fencer, fencer) != Status::kOk) continue;
    ++fenced;
    for (int k = 0; k < 3000; ++k) {
      InputSample left;
      left.time = static_cast<Microseconds>(1000 * k);
      left.sequence = static_cast<std::uint32_t>(k);
      left.x = std::sin(static_cast<float>(k) * 0.05F);
      left.y = 0.3F;
      left.feet_y = 1;
      InputSample right = left;
      right.x = std::sin(static_cast<float>(k) * 0.037F);
      ASSERT_EQ(duel->step(&left, &right), Status::kOk) << moment;
    }
  }
  EXPECT_GE(fenced, 3);
}

}  // namespace
}  // namespace batuta
