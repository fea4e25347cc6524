// SPDX-License-Identifier: MIT
// What must hold of batuta/c.h for any numbers whatever, as a libFuzzer target: each call answers
// or refuses, a refusal leaves what it was given as it was, and an answer has its shape.

#include "batuta/c.h"

#include <array>

#include "bytes.hpp"

namespace batuta::fuzz {
namespace {

using Moving = std::array<float, BATUTA_MOVING_NUMBERS>;

Moving draw_moving(Bytes& bytes, Numbers from) {
  Moving moving{};
  for (float& x : moving) x = bytes.number(from);
  if (from != Numbers::kAny) moving[6] = std::abs(moving[6]);
  return moving;
}

/// An answer to be filled, of bytes that no answer leaves alone.
template <class T>
T untouched() {
  T made;
  std::memset(static_cast<void*>(&made), 0x5A, sizeof made);
  return made;
}

/// The status of a call that fills `out`, which is as it was where the call refuses.
template <class T, class Call>
bool is_answered(T& out, Call call) {
  out = untouched<T>();
  const T before = out;
  const std::int32_t status = call(&out);
  if (status == BATUTA_OK) return true;
  require(status >= BATUTA_INVALID_ARGUMENT && status <= BATUTA_UNAVAILABLE, "a status is one");
  require(std::memcmp(&out, &before, sizeof out) == 0, "a refusal leaves the answer as it was");
  return false;
}

void check_queries(Bytes& bytes, Numbers from) {
  const Moving A = draw_moving(bytes, from);
  const Moving B = draw_moving(bytes, from);
  const batuta_search_f search = {bytes.number(from), bytes.number(from), bytes.word()};
  batuta_closest_f closest;
  if (is_answered(closest, [&](batuta_closest_f* out) {
        return batuta_closest_points_f(A.data(), B.data(), out);
      })) {
    require(closest.distance >= 0 && std::isfinite(closest.gap), "a distance is one");
    require(closest.s >= 0 && closest.s <= 1 && closest.u >= 0 && closest.u <= 1, "on the axes");
  }
  batuta_contact_f contact;
  if (is_answered(contact, [&](batuta_contact_f* out) {
        return batuta_time_of_contact_f(A.data(), B.data(), &search, out);
      })) {
    require(contact.outcome >= BATUTA_FREE && contact.outcome <= BATUTA_BUDGET, "one of four");
    require(contact.evaluations <= search.budget, "a search keeps to its budget");
    require(
        0 <= contact.t_free && contact.t_free <= contact.t_hit && contact.t_free <= search.duration,
        "free comes before contact, and within the duration");
  }
  std::array<float, BATUTA_TWIST_NUMBERS> twist{};
  if (is_answered(twist, [&](auto* out) {
        return batuta_twist_between_f(A.data() + BATUTA_CAPSULE_NUMBERS,
                                      B.data() + BATUTA_CAPSULE_NUMBERS, search.duration,
                                      out->data());
      })) {
    for (const float x : twist) require(std::isfinite(x), "a twist is finite");
  }
}

std::uint64_t hash_of_world(const batuta_world& world) {
  std::uint64_t hash = 0;
  require(batuta_world_hash(&world, &hash) == BATUTA_OK, "a world has a hash");
  return hash;
}

/// One call that may change the world. @returns its status
std::int32_t change(batuta_world& world, Bytes& bytes, Numbers from) {
  switch (bytes.choice(4)) {
    case 0: {
      const Moving moving = draw_moving(bytes, from);
      const batuta_material material = {bytes.number(from), bytes.share(), bytes.number(from)};
      std::int32_t number = -1;
      const std::int32_t status = batuta_world_add(&world, moving.data(), &material, &number);
      require((status == BATUTA_OK) == (number >= 0 && number < BATUTA_WORLD_BODIES), "a number");
      return status;
    }
    case 1:
      return batuta_world_remove(&world, bytes.choice(20) - 2);
    case 2: {
      const Vec3<float> gravity_W = bytes.vector(from);
      return batuta_world_set_gravity(&world, gravity_W.data());
    }
    default:
      return batuta_world_step(&world, bytes.flag() ? 0x1p-9F : bytes.number(from));
  }
}

void look_at(const batuta_world& world) {
  for (std::int32_t number = -1; number <= BATUTA_WORLD_BODIES; ++number) {
    batuta_body body;
    (void)is_answered(body,
                      [&](batuta_body* out) { return batuta_world_body(&world, number, out); });
  }
  const std::int32_t count = batuta_world_event_count(&world);
  require(count >= 0 && count <= BATUTA_WORLD_EVENTS, "a count of events");
  batuta_event event;
  for (std::int32_t index = -1; index <= count; ++index) {
    const bool is_there = is_answered(
        event, [&](batuta_event* out) { return batuta_world_event(&world, index, out); });
    require(is_there == (index >= 0 && index < count), "as many events as are counted");
  }
}

void check_world(Bytes& bytes, Numbers from) {
  static batuta_world world;
  require(batuta_world_init(&world, sizeof world) == BATUTA_OK, "a world begins");
  while (bytes.left() > 0) {
    const std::uint64_t before = hash_of_world(world);
    if (change(world, bytes, from) != BATUTA_OK) {
      require(hash_of_world(world) == before, "a refusal leaves the world as it was");
    }
    look_at(world);
  }
}

void check(Bytes bytes) {
  const Numbers from = bytes.numbers();
  if (bytes.flag()) {
    check_world(bytes, from);
  } else {
    check_queries(bytes, from);
  }
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  batuta::fuzz::check({data, size});
  return 0;
}
