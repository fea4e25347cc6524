// SPDX-License-Identifier: MIT
// The six laws of src/world/world.md, as a libFuzzer target: the random scenes of tests/laws, drawn
// from the bytes of an input instead of a seed, and every law after every step, with all numbers
// that the library is built for.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "../laws/random_kinds.hpp"
#include "batuta/core/config.hpp"
#include "bytes.hpp"

namespace batuta::fuzz {
namespace {

/// Steps of a scene; and, where its first byte is kLong or more, so many that it may come to sleep.
constexpr int kLawSteps = 6;
constexpr int kLongLawSteps = 24;
constexpr int kLong = 208;

/// The scenes of one kind with one type of numbers.
struct Laws {
  const char* name;
  const char* numbers;
  test::Ran (*run)(const test::Choices&, int);
  test::OffFrame (*frame_breach)(const test::Choices&, int);
};

#if BATUTA_WITH_DOUBLE
using Kind = std::array<Laws, 2>;
#else
using Kind = std::array<Laws, 1>;
#endif

template <const test::RandomKind& kKind>
Kind kind(const char* name) {
  using Float = test::RandomLaws<float, kKind>;
#if BATUTA_WITH_DOUBLE
  using Double = test::RandomLaws<double, kKind>;
  return {{{name, "float", Float::run, Float::frame_breach},
           {name, "double", Double::run, Double::frame_breach}}};
#else
  return {{{name, "float", Float::run, Float::frame_breach}}};
#endif
}

/// In the order of their bytes.
constexpr std::size_t kKinds = 13;
const std::array<Kind, kKinds>& kinds() {
  static const std::array<Kind, kKinds> all = {{
      kind<test::kStraight>("straight"),
      kind<test::kSmallBalls>("small balls"),
      kind<test::kSmallCramped>("small cramped"),
      kind<test::kHeap>("heap"),
      kind<test::kDrift>("drift"),
      kind<test::kCramped>("cramped"),
      kind<test::kHands>("hands"),
      kind<test::kPaper>("paper"),
      kind<test::kPaperLed>("paper led"),
      kind<test::kPaperCramped>("paper cramped"),
      kind<test::kBlows>("blows"),
      kind<test::kBlowsCramped>("blows cramped"),
      kind<test::kBlowsLed>("blows led"),
  }};
  return all;
}

// What scenes did, for a search that is told nothing else of code that is not instrumented:
// libFuzzer keeps an input that reaches a new count.
constexpr std::size_t kHappenings = 7;
#ifdef __linux__
[[gnu::section("__libfuzzer_extra_counters"), gnu::used]]
#endif
std::uint8_t g_happened[kKinds * kHappenings];

void count(std::size_t kind, const test::Happened& happened) {
  const int counts[kHappenings] = {happened.collisions, happened.separations, happened.overlaps,
                                   happened.frozen,     happened.held,        happened.cut,
                                   happened.asleep};
  for (std::size_t i = 0; i < kHappenings; ++i) {
    g_happened[kHappenings * kind + i] = static_cast<std::uint8_t>(std::min(counts[i], 255));
  }
}

/// Whether nothing is passed over: how to look for what is left to be mended.
bool asks_all() {
  static const bool asks = std::getenv("BATUTA_FUZZ_OPEN_LAWS") != nullptr;
  return asks;
}

bool is_energy(const test::Breach& breach) {
  return breach.law.rfind("energy", 0) == 0;
}

// What is passed over, as narrow as it is known. The tests of tests/laws pass over none of it.

/// Stated (world.md, "Touching and parting"): a pair that its shift did not part goes on together.
/// It is counted, the step is not complete, and how deep it is is told.
bool is_frozen(const test::Found& found) {
  const test::Told& told = found.told;
  const test::Breach& breach = found.breach;
  return breach.law == "overlap" && told.frozen > 0 && breach.by <= told.deepest + breach.may_be;
}

/// Told, and not understood: where a contact or a pair has no room, two sink a little before they
/// go on together. A quarter of the margin beyond it, or beyond what the step tells.
bool is_out_of_room(const test::Found& found) {
  const test::Told& told = found.told;
  const test::Breach& breach = found.breach;
  const bool sinks = breach.law == "overlap" && !told.complete && told.held > 0;
  return sinks && breach.by <= std::max(told.deepest, breach.may_be) + breach.may_be / 4;
}

/// Not told as such, and not understood: where two that are in each other are shifted apart, one
/// that is in a third by no more than the margin may get into it by a quarter more.
bool is_shifted(const test::Found& found) {
  const test::Breach& breach = found.breach;
  const bool shifts = breach.law == "overlap" && found.told.separations > 0;
  return shifts && breach.by <= breach.may_be * 5 / 4;
}

/// Told, and not understood: the centre of a closed set is off its way where some of it go on
/// together for lack of room. As much as openings may shift somebody by.
bool is_off_centre(const test::Found& found) {
  const test::Told& told = found.told;
  const test::Breach& breach = found.breach;
  const bool is_cut = breach.law == "centre" && !told.complete && told.held > 0;
  return is_cut && breach.by <= breach.may_be + found.terms.opening;
}

/// Rounding of momenta in those who go on together. A step does not tell how many groups it made
/// and how often: four times what one would round.
bool is_rounding_of_groups(const test::Found& found) {
  const test::Breach& breach = found.breach;
  const bool is_momentum =
      breach.law == "momentum" || breach.law == "centre" || breach.law == "spin";
  return is_momentum && found.told.held > 0 && breach.by <= 4 * breach.may_be;
}

/// Told, and not understood: who goes on together for lack of room, or is frozen, may win energy. A
/// sixteenth of what bodies turn with, and eight times what an opening may give.
bool is_held(const test::Found& found) {
  const test::Told& told = found.told;
  const test::Breach& breach = found.breach;
  const bool wins = is_energy(breach) && !told.complete && told.held > 0;
  return wins && breach.by <= 8 * breach.may_be + found.terms.turning / 16;
}

/// Not told, and not in law 3: what sweeps leave of a velocity lifts what lies on two.
bool is_left_by_sweeps(const test::Found& found) {
  const test::Breach& breach = found.breach;
  return is_energy(breach) && breach.by <= breach.may_be + found.terms.left;
}

/// Stated (world.md, law 3): m g D where a gap is opened under a load. tests/laws asks for no more
/// than is missing to D / 2.
bool is_opened(const test::Found& found) {
  const test::Breach& breach = found.breach;
  return is_energy(breach) && found.terms.opening > 0 && breach.by <= found.terms.lifted;
}

/// Stated (world.md, law 3): m (g T)^2 / 2 where contacts last and one that is carried is struck
/// again within the step; and what a body with three unlike moments is off its flight when a blow
/// ends it. Of moments that are a little unlike tests/laws asks that it be nothing.
bool is_struck(const test::Found& found) {
  const test::Breach& breach = found.breach;
  const test::Real stated = found.terms.struck + found.terms.off_flight;
  return found.told.impulses > 0 && is_energy(breach) && breach.by <= breach.may_be + stated;
}

/// World.md, "Bent turns": who left its flight far from its ends comes back to its energy over
/// several flights. At most what a blow would have left of it, and half of what bodies turn with.
bool is_off_flight(const test::Found& found) {
  const test::Breach& breach = found.breach;
  const test::Real most = std::min(found.terms.off_flight, found.terms.turning / 2);
  return is_energy(breach) && breach.by <= breach.may_be + most;
}

/// Stated (world.md, law 3): a group of the paper's separation may part where its turn has won a
/// 1024th of its energy. At most so much for each separation of what bodies turn with.
bool is_separated(const test::Found& found) {
  const test::Told& told = found.told;
  const test::Breach& breach = found.breach;
  const test::Real stated = static_cast<test::Real>(told.separations) * found.terms.turning / 1024;
  const bool goes_together = told.separates && told.held > 0;
  return goes_together && is_energy(breach) && breach.by <= breach.may_be + stated;
}

bool is_passed_over(const test::Found& found) {
  if (asks_all()) return false;
  return is_frozen(found) || is_out_of_room(found) || is_shifted(found) || is_off_centre(found) ||
         is_rounding_of_groups(found) || is_held(found) || is_left_by_sweeps(found) ||
         is_opened(found) || is_struck(found) || is_off_flight(found) || is_separated(found);
}

/// All that it takes to play the scene again: written into a file, batuta_replay_laws runs it.
[[noreturn]] void end(const Laws& laws, const std::uint8_t* data, std::size_t size) {
  std::fprintf(stderr, "a law of motion was broken: %s, in %s; input, hexadecimal: ", laws.name,
               laws.numbers);
  for (std::size_t i = 0; i < size; ++i) std::fprintf(stderr, "%02x", unsigned{data[i]});
  std::fprintf(stderr, "\n");
  std::abort();
}

/// Whether a scene keeps the laws; what breaks one is told.
bool holds(const test::Ran& ran) {
  for (const test::Found& found : ran.found) {
    const test::Breach& breach = found.breach;
    if (is_passed_over(found)) continue;
    std::fprintf(stderr, "%s, %s: %Lg, at most %Lg; step %d\n", breach.law.c_str(),
                 breach.what.c_str(), breach.by, breach.may_be, found.step);
    return false;
  }
  return true;
}

/// Law 1. Passed over is how far contacts may open or close: the margin, and with it D, grows with
/// the way of a step, and which contacts press, and are opened or separated, may be decided by the
/// rounding of places. Law 1 has no such term.
bool holds_frame(const Laws& laws, const test::Choices& choices, int steps) {
  const test::OffFrame off = laws.frame_breach(choices, steps);
  if (off.by <= 0 || (!asks_all() && off.besides_gaps <= 0)) return true;
  std::fprintf(stderr, "frame: a velocity of all changes places by %Lg m\n", off.by);
  return false;
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace batuta;
  using namespace batuta::fuzz;
  if (size == 0) return 0;
  const test::Choices choices(data + 1, size - 1);
  const std::size_t kind = *data % kKinds;
  const int steps = *data < kLong ? kLawSteps : kLongLawSteps;
  for (const Laws& laws : kinds()[kind]) {
    const test::Ran ran = laws.run(choices, steps);
    count(kind, ran.happened);
    if (!holds(ran) || !holds_frame(laws, choices, steps)) end(laws, data, size);
  }
  return 0;
}
