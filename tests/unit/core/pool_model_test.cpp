// SPDX-License-Identifier: MIT
// A pool against a model of it: a map from slots to what lives there, and every handle ever given
// out.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <vector>

#include "batuta/core/pool.hpp"

namespace batuta {
namespace {

constexpr int kSlots = 37;  // more than one word of the bitmap, the last one not full

struct Model {
  struct Named {
    Handle<int> handle;
    int value = 0;
    bool alive = false;
  };

  std::size_t lowest_free() const {
    std::size_t index = 0;
    while (objects.count(index) != 0) ++index;
    return index;
  }

  Pool<int, kSlots> pool{3};
  std::map<std::size_t, int> objects;
  std::vector<Named> given_out;
  int next_value = 0;
};

void make(Model& model) {
  const std::size_t expected = model.lowest_free();
  const int value = model.next_value++;
  const auto made = model.pool.make(value);
  RC_ASSERT(made.ok() == (expected < kSlots));
  if (!made.ok()) {
    RC_ASSERT(made.status == Status::kPoolFull);
    return;
  }
  RC_ASSERT(model.pool.index_of(made.value) == static_cast<int>(expected));
  model.objects[expected] = value;
  model.given_out.push_back({made.value, value, true});
}

void remove(Model& model, std::size_t pick) {
  if (model.given_out.empty()) return;
  auto& named = model.given_out[pick % model.given_out.size()];
  const int index = model.pool.index_of(named.handle);
  RC_ASSERT(model.pool.remove(named.handle) == (named.alive ? Status::kOk : Status::kStaleHandle));
  if (named.alive) model.objects.erase(static_cast<std::size_t>(index));
  named.alive = false;
}

void clear(Model& model) {
  model.pool.clear();
  model.objects.clear();
  for (auto& named : model.given_out) named.alive = false;
}

void compare(const Model& model) {
  RC_ASSERT(model.pool.size() == static_cast<int>(model.objects.size()));
  auto expected = model.objects.begin();
  for (auto it = model.pool.begin(); it != model.pool.end(); ++it, ++expected) {
    RC_ASSERT(it.index() == expected->first);
    RC_ASSERT(*it == expected->second);
  }
  RC_ASSERT(expected == model.objects.end());
  for (const auto& named : model.given_out) {
    const int* object = model.pool.get(named.handle);
    RC_ASSERT((object != nullptr) == named.alive);
    if (object != nullptr) RC_ASSERT(*object == named.value);
  }
}

RC_GTEST_PROP(PoolModel, AnyCalls_AgreeWithAMap, (const std::vector<std::uint16_t>& calls)) {
  Model model;
  for (const std::uint16_t call : calls) {
    const int kind = call % 16;
    if (kind < 10) {
      make(model);
    } else if (kind < 15) {
      remove(model, call / 16U);
    } else if (call / 16U % 8U == 0) {
      clear(model);
    }
    compare(model);
  }
}

TEST(PoolModel, LongRun_AgreesWithAMap) {
  Model model;
  std::uint32_t state = 12345;  // a linear congruential generator: the same on every platform
  int fullest = 0;
  for (int i = 0; i < 4000; ++i) {
    state = state * 1664525U + 1013904223U;
    const std::uint32_t draw = state >> 16U;
    const std::uint32_t share = i / 500 % 2 == 0 ? 10U : 6U;  // fills up, then runs empty
    draw % 16U < share ? make(model) : remove(model, draw / 16U * 7U);
    fullest = std::max(fullest, model.pool.size());
    if (i % 16 == 0) compare(model);
  }
  EXPECT_EQ(fullest, kSlots);
}

}  // namespace
}  // namespace batuta
