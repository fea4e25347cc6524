// SPDX-License-Identifier: MIT
// Bad input of every function of batuta/c.h: a status, and what was is as it was.

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cstring>
#include <limits>
#include <memory>

#include "batuta/c/duel.h"

namespace batuta {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::array<float, BATUTA_CAPSULE_NUMBERS> kCapsule = {0, 0, 0, 1, 0, 0, 0.1F};
constexpr std::array<float, BATUTA_MOVING_NUMBERS> kMoving = {0, 0, 0, 1, 0, 0, 0.1F,  // capsule
                                                              0, 0, 5, 1, 0, 0, 0,     // pose
                                                              1, 0, 0, 0, 0, 1};       // twist
constexpr batuta_search_f kSearch = {1, 1e-6F, 64};
constexpr batuta_material kSteel = {7850, 0.5F, 0.5F};
constexpr batuta_stick kStick = {0, 0, 0, 0};

/// Bytes that no answer leaves alone.
template <class T>
T untouched() {
  T made;
  std::memset(static_cast<void*>(&made), 0x5a, sizeof made);
  return made;
}
template <class T>
bool is_untouched(const T& object) {
  const T same = untouched<T>();
  return std::memcmp(&object, &same, sizeof same) == 0;
}

/// Expects the status of a call with an object to be filled, and the object as it was.
template <class T, class Call>
void expect_refused(Call call, std::int32_t status = BATUTA_INVALID_ARGUMENT) {
  T out = untouched<T>();
  EXPECT_EQ(call(&out), status);
  EXPECT_TRUE(is_untouched(out));
}

TEST(BadInputFromC, ClosestPoints) {
  const auto ask = [](const float* A, const float* B) {
    expect_refused<batuta_closest_f>(
        [=](batuta_closest_f* out) { return batuta_closest_points_f(A, B, out); });
  };
  ask(nullptr, kCapsule.data());
  ask(kCapsule.data(), nullptr);
  EXPECT_EQ(batuta_closest_points_f(kCapsule.data(), kCapsule.data(), nullptr),
            BATUTA_INVALID_ARGUMENT);
  for (std::size_t i = 0; i < kCapsule.size(); ++i) {
    for (const float bad : {kNaN, kInfinity, std::numeric_limits<float>::max()}) {
      auto spoilt = kCapsule;
      spoilt[i] = bad;
      ask(spoilt.data(), kCapsule.data());
      ask(kCapsule.data(), spoilt.data());
    }
  }
  auto negative = kCapsule;
  negative[6] = -0.1F;
  ask(negative.data(), kCapsule.data());
  EXPECT_EQ(batuta_closest_points_many_f(nullptr, kCapsule.data(), 1, nullptr), 0U);
}

TEST(BadInputFromC, TimeOfContact) {
  const auto ask = [](const float* A, const float* B, const batuta_search_f* search) {
    expect_refused<batuta_contact_f>(
        [=](batuta_contact_f* out) { return batuta_time_of_contact_f(A, B, search, out); });
  };
  ask(nullptr, kMoving.data(), &kSearch);
  ask(kMoving.data(), nullptr, &kSearch);
  ask(kMoving.data(), kMoving.data(), nullptr);
  EXPECT_EQ(batuta_time_of_contact_f(kMoving.data(), kMoving.data(), &kSearch, nullptr),
            BATUTA_INVALID_ARGUMENT);
  for (std::size_t i = 0; i < kMoving.size(); ++i) {
    for (const float bad : {kNaN, kInfinity}) {
      auto spoilt = kMoving;
      spoilt[i] = bad;
      ask(spoilt.data(), kMoving.data(), &kSearch);
      ask(kMoving.data(), spoilt.data(), &kSearch);
    }
  }
  auto turned_nowhere = kMoving;
  turned_nowhere[10] = 0;
  ask(turned_nowhere.data(), kMoving.data(), &kSearch);
  auto spinning = kMoving;
  spinning[19] = 2600;  // rad in the second that is asked for
  ask(spinning.data(), kMoving.data(), &kSearch);
  for (const batuta_search_f& bad : {batuta_search_f{-1, 1e-6F, 64},
                                     {kNaN, 1e-6F, 64},
                                     {1, -1, 64},
                                     {1, 2, 64},
                                     {1, kNaN, 64},
                                     {1, 1e-6F, 4097}}) {
    ask(kMoving.data(), kMoving.data(), &bad);
  }
  EXPECT_EQ(batuta_time_of_contact_many_f(kMoving.data(), kMoving.data(), 1, nullptr, nullptr), 0U);
}

TEST(BadInputFromC, TwistBetween) {
  const float* const pose = kMoving.data() + BATUTA_CAPSULE_NUMBERS;
  using Numbers = std::array<float, BATUTA_TWIST_NUMBERS>;
  const auto ask = [](const float* from, const float* to, float duration) {
    expect_refused<Numbers>(
        [=](Numbers* out) { return batuta_twist_between_f(from, to, duration, out->data()); });
  };
  ask(nullptr, pose, 1);
  ask(pose, nullptr, 1);
  for (const float bad : {0.0F, -1.0F, kNaN, kInfinity}) ask(pose, pose, bad);
  const std::array<float, BATUTA_POSE_NUMBERS> no_turn = {0, 0, 0, 0, 0, 0, 0};
  ask(no_turn.data(), pose, 1);
  const std::array<float, BATUTA_POSE_NUMBERS> far = {-3e38F, 0, 0, 1, 0, 0, 0};
  const std::array<float, BATUTA_POSE_NUMBERS> far_too = {3e38F, 0, 0, 1, 0, 0, 0};
  ask(far.data(), far_too.data(), 1);
  EXPECT_EQ(batuta_twist_between_f(pose, pose, 1, nullptr), BATUTA_INVALID_ARGUMENT);
}

/// Rounds upward while it lives.
class Upward {
 public:
  Upward() { std::fesetround(FE_UPWARD); }
  ~Upward() { std::fesetround(FE_TONEAREST); }
  Upward(const Upward&) = delete;
  Upward(Upward&&) = delete;
  Upward& operator=(const Upward&) = delete;
  Upward& operator=(Upward&&) = delete;
};

TEST(BadArithmeticFromC, IsUnavailable) {
  const float* const A = kMoving.data();
  const float* const pose = A + BATUTA_CAPSULE_NUMBERS;
  using Numbers = std::array<float, BATUTA_TWIST_NUMBERS>;
  const auto world = std::make_unique<batuta_world>();
  const auto duel = std::make_unique<batuta_duel>();
  const auto begun = std::make_unique<batuta_duel>();
  ASSERT_EQ(batuta_duel_init(begun.get(), sizeof *begun, 1000, 5), BATUTA_OK);
  batuta_opponent fencer;
  const Upward upward;
  expect_refused<batuta_closest_f>(
      [=](batuta_closest_f* out) { return batuta_closest_points_f(A, A, out); },
      BATUTA_UNAVAILABLE);
  expect_refused<batuta_contact_f>(
      [=](batuta_contact_f* out) { return batuta_time_of_contact_f(A, A, &kSearch, out); },
      BATUTA_UNAVAILABLE);
  expect_refused<Numbers>(
      [=](Numbers* out) { return batuta_twist_between_f(pose, pose, 1, out->data()); },
      BATUTA_UNAVAILABLE);
  EXPECT_EQ(batuta_world_init(world.get(), sizeof *world), BATUTA_UNAVAILABLE);
  EXPECT_EQ(batuta_duel_init(duel.get(), sizeof *duel, 1000, 5), BATUTA_UNAVAILABLE);
  EXPECT_EQ(batuta_duel_set_distance(begun.get(), 4), BATUTA_UNAVAILABLE);
  EXPECT_EQ(batuta_opponent_init(&fencer, sizeof fencer, BATUTA_CLUB, 1), BATUTA_UNAVAILABLE);
}

class BadStorageFromC : public testing::Test {
 protected:
  /// Every function but init() with storage in which there is none.
  static void expect_no_world(batuta_world* world) {
    const std::array<float, 3> gravity = {0, 0, -1};
    std::int32_t number = 7;
    EXPECT_EQ(batuta_world_set_gravity(world, gravity.data()), BATUTA_INVALID_ARGUMENT);
    EXPECT_EQ(batuta_world_add(world, kMoving.data(), &kSteel, &number), BATUTA_INVALID_ARGUMENT);
    EXPECT_EQ(number, 7);
    EXPECT_EQ(batuta_world_remove(world, 0), BATUTA_INVALID_ARGUMENT);
    EXPECT_EQ(batuta_world_step(world, 1e-3F), BATUTA_INVALID_ARGUMENT);
    EXPECT_EQ(batuta_world_complete(world), 0);
    EXPECT_EQ(batuta_world_event_count(world), 0);
    expect_refused<batuta_body>([=](batuta_body* o) { return batuta_world_body(world, 0, o); });
    expect_refused<batuta_event>([=](batuta_event* o) { return batuta_world_event(world, 0, o); });
    expect_refused<std::uint64_t>([=](std::uint64_t* o) { return batuta_world_hash(world, o); });
  }
  static void expect_no_duel(batuta_duel* duel) {
    EXPECT_EQ(batuta_duel_step(duel, &kStick, nullptr), BATUTA_INVALID_ARGUMENT);
    expect_refused<batuta_duel_state>(
        [=](batuta_duel_state* o) { return batuta_duel_get_state(duel, o); });
    expect_refused<std::uint64_t>([=](std::uint64_t* o) { return batuta_duel_hash(duel, o); });
  }

  std::unique_ptr<batuta_world> world = std::make_unique<batuta_world>();  // zeros
  std::unique_ptr<batuta_duel> duel = std::make_unique<batuta_duel>();
};

TEST_F(BadStorageFromC, WithoutInit) {
  expect_no_world(nullptr);
  expect_no_world(world.get());
  expect_no_duel(nullptr);
  expect_no_duel(duel.get());
}

TEST_F(BadStorageFromC, OfAnotherKind) {
  ASSERT_EQ(batuta_duel_init(reinterpret_cast<batuta_duel*>(world.get()), sizeof *world, 1000, 5),
            BATUTA_OK);
  expect_no_world(world.get());
  ASSERT_EQ(batuta_world_init(world.get(), sizeof *world), BATUTA_OK);
  expect_no_duel(reinterpret_cast<batuta_duel*>(world.get()));
}

TEST_F(BadStorageFromC, TooSmallOrNotAligned) {
  EXPECT_EQ(batuta_world_init(nullptr, sizeof *world), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_world_init(world.get(), batuta_world_size() - 1), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_duel_init(nullptr, sizeof *duel, 1000, 5), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_duel_init(duel.get(), batuta_duel_size() - 1, 1000, 5), BATUTA_INVALID_ARGUMENT);
  void* const odd = world->bytes + 1;
  EXPECT_EQ(batuta_duel_init(static_cast<batuta_duel*>(odd), sizeof *duel, 1000, 5),
            BATUTA_INVALID_ARGUMENT);
  const batuta_world zeros{};
  EXPECT_EQ(std::memcmp(world.get(), &zeros, sizeof zeros), 0);
  expect_no_duel(static_cast<batuta_duel*>(odd));
}

class BadCallFromC : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(batuta_world_init(world.get(), sizeof *world), BATUTA_OK);
    std::int32_t number = -1;
    ASSERT_EQ(batuta_world_add(world.get(), kMoving.data(), &kSteel, &number), BATUTA_OK);
    ASSERT_EQ(batuta_duel_init(duel.get(), sizeof *duel, 1000, 5), BATUTA_OK);
  }
  std::uint64_t hash_of_world() const {
    std::uint64_t told = 0;
    EXPECT_EQ(batuta_world_hash(world.get(), &told), BATUTA_OK);
    return told;
  }
  std::uint64_t hash_of_duel() const {
    std::uint64_t told = 0;
    EXPECT_EQ(batuta_duel_hash(duel.get(), &told), BATUTA_OK);
    return told;
  }
  void expect_not_added(const float* moving, const batuta_material* material) {
    std::int32_t number = 7;
    EXPECT_EQ(batuta_world_add(world.get(), moving, material, &number), BATUTA_INVALID_ARGUMENT);
    EXPECT_EQ(number, 7);
  }

  std::unique_ptr<batuta_world> world = std::make_unique<batuta_world>();
  std::unique_ptr<batuta_duel> duel = std::make_unique<batuta_duel>();
};

TEST_F(BadCallFromC, World) {
  const auto before = hash_of_world();
  expect_not_added(nullptr, &kSteel);
  expect_not_added(kMoving.data(), nullptr);
  EXPECT_EQ(batuta_world_add(world.get(), kMoving.data(), &kSteel, nullptr),
            BATUTA_INVALID_ARGUMENT);
  for (std::size_t i = 0; i < kMoving.size(); ++i) {
    auto spoilt = kMoving;
    spoilt[i] = kNaN;
    expect_not_added(spoilt.data(), &kSteel);
  }
  for (const batuta_material& bad : {batuta_material{0, 0.5F, 0.5F},
                                     {-1, 0.5F, 0.5F},
                                     {kNaN, 0.5F, 0.5F},
                                     {1, -0.1F, 0.5F},
                                     {1, 1.1F, 0.5F},
                                     {1, kNaN, 0.5F},
                                     {1, 0.5F, -1},
                                     {1, 0.5F, kNaN}}) {
    expect_not_added(kMoving.data(), &bad);
  }
  const std::array<float, 3> no_gravity = {0, kNaN, 0};
  EXPECT_EQ(batuta_world_set_gravity(world.get(), no_gravity.data()), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_world_set_gravity(world.get(), nullptr), BATUTA_INVALID_ARGUMENT);
  for (const float dt : {0.0F, -1.0F, kNaN, kInfinity}) {
    EXPECT_EQ(batuta_world_step(world.get(), dt), BATUTA_INVALID_ARGUMENT);
  }
  for (const std::int32_t number : {-1, 1, std::int32_t{BATUTA_WORLD_BODIES}, 65536}) {
    EXPECT_EQ(batuta_world_remove(world.get(), number), BATUTA_STALE_HANDLE);
    expect_refused<batuta_body>(
        [&](batuta_body* out) { return batuta_world_body(world.get(), number, out); },
        BATUTA_STALE_HANDLE);
    expect_refused<batuta_event>(
        [&](batuta_event* out) { return batuta_world_event(world.get(), number, out); });
  }
  EXPECT_EQ(batuta_world_body(world.get(), 0, nullptr), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_world_hash(world.get(), nullptr), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(hash_of_world(), before);
}

TEST_F(BadCallFromC, Duel) {
  const auto before = hash_of_duel();
  for (const batuta_stick& bad :
       {batuta_stick{1.1F, 0, 0, 0}, {0, kNaN, 0, 0}, {0, 0, -2, 0}, {0, 0, 0, kInfinity}}) {
    EXPECT_EQ(batuta_duel_step(duel.get(), &bad, nullptr), BATUTA_INVALID_ARGUMENT);
    EXPECT_EQ(batuta_duel_step(duel.get(), &kStick, &bad), BATUTA_INVALID_ARGUMENT);
  }
  for (const std::int32_t step_us :
       {-1, 0, BATUTA_SHORTEST_STEP_US - 1, BATUTA_LONGEST_STEP_US + 1}) {
    EXPECT_EQ(batuta_duel_init(duel.get(), sizeof *duel, step_us, 5), BATUTA_INVALID_ARGUMENT);
  }
  for (const std::int32_t touches : {-1, 0, BATUTA_MOST_TOUCHES + 1, 256 + 5}) {
    EXPECT_EQ(batuta_duel_init(duel.get(), sizeof *duel, 1000, touches), BATUTA_INVALID_ARGUMENT);
  }
  EXPECT_EQ(batuta_duel_get_state(duel.get(), nullptr), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(batuta_duel_hash(duel.get(), nullptr), BATUTA_INVALID_ARGUMENT);
  EXPECT_EQ(hash_of_duel(), before);
}

}  // namespace
}  // namespace batuta
