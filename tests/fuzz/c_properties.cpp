// SPDX-License-Identifier: MIT
// What must hold of batuta/c.h for any numbers whatever, as a libFuzzer target: each call answers
// or refuses, a refusal leaves what it was given as it was, and an answer has its shape.

#include "batuta/c/duel.h"

#include <array>
#include <cstddef>

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

/// The queries of one kind of number.
struct InFloat {
  using Scalar = float;
  using Closest = batuta_closest_f;
  using Search = batuta_search_f;
  using Contact = batuta_contact_f;
  static constexpr bool kIsBuilt = true;
  static constexpr auto kClosest = batuta_closest_points_f;
  static constexpr auto kClosestMany = batuta_closest_points_many_f;
  static constexpr auto kContact = batuta_time_of_contact_f;
  static constexpr auto kContactMany = batuta_time_of_contact_many_f;
  static constexpr auto kTwist = batuta_twist_between_f;
  static constexpr auto kTwistMany = batuta_twist_between_many_f;
};
struct InDouble {
  using Scalar = double;
  using Closest = batuta_closest_d;
  using Search = batuta_search_d;
  using Contact = batuta_contact_d;
  static constexpr bool kIsBuilt = BATUTA_WITH_DOUBLE == 1;
  static constexpr auto kClosest = batuta_closest_points_d;
  static constexpr auto kClosestMany = batuta_closest_points_many_d;
  static constexpr auto kContact = batuta_time_of_contact_d;
  static constexpr auto kContactMany = batuta_time_of_contact_many_d;
  static constexpr auto kTwist = batuta_twist_between_d;
  static constexpr auto kTwistMany = batuta_twist_between_many_d;
};

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

/// Bytes of an answer: what lies behind its last member is nobody's.
template <class T>
inline constexpr std::size_t kBytes = sizeof(T);
template <>
inline constexpr std::size_t kBytes<batuta_closest_d> = offsetof(batuta_closest_d, arbitrary) +
                                                        sizeof(std::int32_t);

/// Two queries, (A, B) and (B, A): as many as are answered one by one are answered together, with
/// the same numbers, and the others are left alone.
/// @param one  (index, out) asks for one  @param many  (out) asks for both
template <class T, class One, class Many>
void expect_alike(One one, Many many) {
  std::array<T, 2> together{untouched<T>(), untouched<T>()};
  std::array<T, 2> apart = together;
  std::size_t answered = 0;
  while (answered < apart.size() && one(answered, &apart[answered]) == BATUTA_OK) ++answered;
  require(many(together.data()) == answered, "many are answered up to the first that is refused");
  for (const std::size_t i : {0U, 1U}) {
    require(std::memcmp(&together[i], &apart[i], kBytes<T>) == 0, "many are as one by one");
  }
}

/// What is asked of two moving capsules, and of their poses.
template <class C>
struct Asked {
  using Scalar = typename C::Scalar;

  Asked(const Moving& A, const Moving& B, const batuta_search_f& asked)
      : search{Scalar(asked.duration), Scalar(asked.tolerance), asked.budget} {
    for (std::size_t i = 0; i < A.size(); ++i) {
      AB[i] = BA[i + A.size()] = Scalar(A[i]);
      BA[i] = AB[i + A.size()] = Scalar(B[i]);
    }
  }
  const Scalar* from(std::size_t i) const { return AB.data() + i * BATUTA_MOVING_NUMBERS; }
  const Scalar* to(std::size_t i) const { return BA.data() + i * BATUTA_MOVING_NUMBERS; }

  typename C::Search search;
  std::array<Scalar, 2 * BATUTA_MOVING_NUMBERS> AB{};  ///< A, then B: of moving[20]
  std::array<Scalar, 2 * BATUTA_MOVING_NUMBERS> BA{};
};

/// Seven numbers, a capsule or a pose, and seven others behind them.
template <class Scalar>
std::array<Scalar, 14> sevens(const Scalar* first, const Scalar* second) {
  std::array<Scalar, 14> both{};
  for (std::size_t i = 0; i < 7; ++i) {
    both[i] = first[i];
    both[i + 7] = second[i];
  }
  return both;
}
static_assert(BATUTA_CAPSULE_NUMBERS == 7 && BATUTA_POSE_NUMBERS == 7);

template <class C>
void check_closest(const Asked<C>& asked) {
  using Closest = typename C::Closest;
  const auto one = [&](std::size_t i, Closest* out) {
    return C::kClosest(asked.from(i), asked.to(i), out);
  };
  Closest closest;
  if (is_answered(closest, [&](Closest* out) { return one(0, out); })) {
    require(C::kIsBuilt, "only what is built answers");
    require(closest.distance >= 0 && std::isfinite(closest.gap), "a distance is one");
    require(closest.s >= 0 && closest.s <= 1 && closest.u >= 0 && closest.u <= 1, "on the axes");
  }
  const auto A = sevens(asked.from(0), asked.from(1));
  const auto B = sevens(asked.to(0), asked.to(1));
  expect_alike<Closest>(one,
                        [&](Closest* out) { return C::kClosestMany(A.data(), B.data(), 2, out); });
}

template <class C>
void check_contact(const Asked<C>& asked) {
  using Contact = typename C::Contact;
  const auto one = [&](std::size_t i, Contact* out) {
    return C::kContact(asked.from(i), asked.to(i), &asked.search, out);
  };
  Contact contact;
  if (is_answered(contact, [&](Contact* out) { return one(0, out); })) {
    require(C::kIsBuilt, "only what is built answers");
    require(contact.outcome >= BATUTA_FREE && contact.outcome <= BATUTA_BUDGET, "one of four");
    require(contact.evaluations <= asked.search.budget, "a search keeps to its budget");
    require(0 <= contact.t_free && contact.t_free <= contact.t_hit &&
                contact.t_free <= asked.search.duration,
            "free comes before contact, and within the duration");
  }
  expect_alike<Contact>(one, [&](Contact* out) {
    return C::kContactMany(asked.from(0), asked.to(0), 2, &asked.search, out);
  });
}

template <class C>
void check_twist(const Asked<C>& asked) {
  using Scalar = typename C::Scalar;
  using TwistNumbers = std::array<Scalar, BATUTA_TWIST_NUMBERS>;
  const auto one = [&](std::size_t i, TwistNumbers* out) {
    return C::kTwist(asked.from(i) + BATUTA_CAPSULE_NUMBERS, asked.to(i) + BATUTA_CAPSULE_NUMBERS,
                     asked.search.duration, out->data());
  };
  TwistNumbers twist{};
  if (is_answered(twist, [&](TwistNumbers* out) { return one(0, out); })) {
    require(C::kIsBuilt, "only what is built answers");
    for (const Scalar x : twist) require(std::isfinite(x), "a twist is finite");
  }
  const auto from =
      sevens(asked.from(0) + BATUTA_CAPSULE_NUMBERS, asked.from(1) + BATUTA_CAPSULE_NUMBERS);
  const auto to =
      sevens(asked.to(0) + BATUTA_CAPSULE_NUMBERS, asked.to(1) + BATUTA_CAPSULE_NUMBERS);
  expect_alike<TwistNumbers>(one, [&](TwistNumbers* out) {
    return C::kTwistMany(from.data(), to.data(), 2, asked.search.duration, out->data());
  });
}

template <class C>
void check_queries_in(const Moving& A, const Moving& B, const batuta_search_f& search) {
  const Asked<C> asked(A, B, search);
  check_closest(asked);
  check_contact(asked);
  check_twist(asked);
}

void check_queries(Bytes& bytes, Numbers from) {
  const Moving A = draw_moving(bytes, from);
  const Moving B = draw_moving(bytes, from);
  const batuta_search_f search = {bytes.number(from), bytes.number(from), bytes.word()};
  check_queries_in<InFloat>(A, B, search);
  check_queries_in<InDouble>(A, B, search);
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

std::uint64_t hash_of_duel(const batuta_duel& duel) {
  std::uint64_t hash = 0;
  require(batuta_duel_hash(&duel, &hash) == BATUTA_OK, "a duel has a hash");
  return hash;
}

/// A bout on guard, of a step and of touches that the bytes ask for, or of others where they ask
/// for what there is not. @returns how many touches it goes to
std::int32_t begin_duel(batuta_duel& duel, Bytes& bytes) {
  require(batuta_duel_init(&duel, sizeof duel, 1000, 1) == BATUTA_OK, "a duel begins");
  const std::uint64_t before = hash_of_duel(duel);
  const std::int32_t step_us = bytes.word();
  const std::int32_t touches = bytes.byte() - 2;
  const bool good = step_us >= BATUTA_SHORTEST_STEP_US && step_us <= BATUTA_LONGEST_STEP_US &&
                    touches >= 1 && touches <= BATUTA_MOST_TOUCHES;
  const std::int32_t status = batuta_duel_init(&duel, sizeof duel, step_us, touches);
  require(status == (good ? BATUTA_OK : BATUTA_INVALID_ARGUMENT), "a duel begins in its ranges");
  require(good || hash_of_duel(duel) == before, "a refusal leaves the duel as it was");
  return good ? touches : 1;
}

/// A stick with all axes in range, but for numbers of any kind.
batuta_stick draw_stick(Bytes& bytes, Numbers from) {
  const auto axis = [&] { return from == Numbers::kAny ? bytes.bits() : 2 * bytes.share() - 1; };
  batuta_stick stick{};
  for (float* const x : {&stick.x, &stick.y, &stick.feet_x, &stick.feet_y}) *x = axis();
  return stick;
}

bool is_in_range(const batuta_stick& stick) {
  for (const float x : {stick.x, stick.y, stick.feet_x, stick.feet_y}) {
    if (!(x >= -1 && x <= 1)) return false;
  }
  return true;
}

bool are_finite(const float* numbers, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(numbers[i])) return false;
  }
  return true;
}

/// What a duel that goes to so many touches may say of itself.
batuta_duel_state looked_at(const batuta_duel& duel, std::int32_t most_touches) {
  batuta_duel_state state;
  require(
      is_answered(state, [&](batuta_duel_state* out) { return batuta_duel_get_state(&duel, out); }),
      "a duel has a state");
  require(state.bout >= 0 && state.bout <= 4, "one of five");
  require(state.touches >= 0 && state.touches <= 2, "at most one touch each");
  require(state.exchange >= 1, "the first exchange is 1");
  require(std::isfinite(state.gap), "a gap is one");
  require(are_finite(&state.blade_W[0][0], 2 * BATUTA_CAPSULE_NUMBERS) &&
              are_finite(&state.body_W[0][0][0], 2 * BATUTA_BODY_PARTS * BATUTA_CAPSULE_NUMBERS),
          "blades and bodies are somewhere");
  for (const std::size_t side : {0U, 1U}) {
    require(state.score[side] >= 0 && state.score[side] <= most_touches, "a score is one");
    require(state.control[side] >= 0 && state.control[side] <= 1, "a control is a share");
    for (const float x : state.stick[side]) require(x >= -1 && x <= 1, "a stick is in its range");
  }
  return state;
}

/// One step with what the sticks say, or a refusal that changes nothing. @returns whether it went
/// on
bool step_duel(batuta_duel& duel, const batuta_stick* left, const batuta_stick* right,
               std::int32_t most_touches) {
  const batuta_duel_state before = looked_at(duel, most_touches);
  const std::uint64_t hash = hash_of_duel(duel);
  const bool good =
      (left == nullptr || is_in_range(*left)) && (right == nullptr || is_in_range(*right));
  const bool is_over = before.bout == 2 || before.bout == 3;
  const std::int32_t status = batuta_duel_step(&duel, left, right);
  if (status == BATUTA_OK) {
    require(good && !is_over, "a step takes sticks in their range, and ends with the bout");
    require(looked_at(duel, most_touches).steps == before.steps + 1, "a step is counted");
    return true;
  }
  require(status == (good ? BATUTA_UNAVAILABLE : BATUTA_INVALID_ARGUMENT), "refused for a reason");
  require(is_over || !good, "a bout goes on until it is over");
  require(hash_of_duel(duel) == hash, "a refusal leaves the duel as it was");
  return false;
}

void check_duel(Bytes& bytes, Numbers from) {
  constexpr int kMostSteps = 400;
  static batuta_duel duel;
  const std::int32_t most_touches = begin_duel(duel, bytes);
  int steps = 0;
  while (bytes.left() > 0 && steps < kMostSteps) {
    const int which = bytes.choice(4);
    batuta_stick left{};
    batuta_stick right{};
    if ((which & 1) != 0) left = draw_stick(bytes, from);
    if ((which & 2) != 0) right = draw_stick(bytes, from);
    const int again = bytes.choice(32);
    bool goes_on = step_duel(duel, (which & 1) != 0 ? &left : nullptr,
                             (which & 2) != 0 ? &right : nullptr, most_touches);
    for (int i = 0; i < again && goes_on; ++i) {
      goes_on = step_duel(duel, nullptr, nullptr, most_touches);
    }
    steps += again + 1;
  }
}

void check(Bytes bytes) {
  const Numbers from = bytes.numbers();
  switch (bytes.choice(3)) {
    case 0:
      return check_queries(bytes, from);
    case 1:
      return check_world(bytes, from);
    default:
      return check_duel(bytes, from);
  }
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  batuta::fuzz::check({data, size});
  return 0;
}
