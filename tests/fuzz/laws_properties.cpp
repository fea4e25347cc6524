// SPDX-License-Identifier: MIT
// The six laws of src/world/world.md, as a libFuzzer target: the random scenes of tests/laws, drawn
// from the bytes of an input instead of a seed, and every law after every step.

#include <cstdlib>

#include "../laws/random_kinds.hpp"
#include "bytes.hpp"

namespace batuta::fuzz {
namespace {

constexpr int kLawSteps = 6;

/// Laws that a kind of scene is known to break sometimes. They are asked only where the environment
/// has BATUTA_FUZZ_OPEN_LAWS, which is how to look for what is left to be mended. What is mended is
/// taken out.
enum class Open : std::uint8_t {
  kNothing,
  /// What lies on two others may rise by what gravity gives it in a step, m (g T)^2 of energy
  /// (world.md, "The fall").
  kEnergyOfLoads,
  kAnything,  ///< bodies that turn: not all laws are kept by all scenes yet, and none is run
};

bool asks_all() {
  static const bool asks = std::getenv("BATUTA_FUZZ_OPEN_LAWS") != nullptr;
  return asks;
}

/// Summed m (g T)^2, J.
template <class SceneT>
test::Real energy_of_loads(test::RandomRun<SceneT>& run) {
  const auto fall = static_cast<test::Real>(run.gravity().norm() * run.dt());
  test::Real energy = 0;
  for (const test::SeenBody& body : run.seen()) energy += body.mass * fall * fall;
  return energy;
}

template <const test::RandomKind& kKind>
void check(const test::Choices& choices, Open open) {
  using SceneT = test::RandomScene<float, kKind>;
  if (open == Open::kAnything && !asks_all()) return;
  test::RandomRun<SceneT> run{choices};
  for (const test::Found& found : test::run_scene(run, kLawSteps)) {
    const test::Breach& breach = found.breach;
    const bool is_known = open == Open::kEnergyOfLoads && breach.law == "energy" &&
                          breach.by <= breach.may_be + energy_of_loads(run);
    if (is_known && !asks_all()) continue;
    std::fprintf(stderr, "%s, %s: %Lg, at most %Lg; step %d\n", breach.law.c_str(),
                 breach.what.c_str(), breach.by, breach.may_be, found.step);
    require(false, "a law of motion");
  }
  require(test::frame_breach<SceneT>(choices, kLawSteps) <= 0, "a velocity of all changes nothing");
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace batuta;
  using fuzz::Open;
  if (size == 0) return 0;
  const test::Choices choices(data + 1, size - 1);
  switch (*data % 13) {
    case 0:
      fuzz::check<test::kStraight>(choices, Open::kEnergyOfLoads);
      break;
    case 1:
      fuzz::check<test::kSmallBalls>(choices, Open::kEnergyOfLoads);
      break;
    case 2:
      fuzz::check<test::kSmallCramped>(choices, Open::kNothing);
      break;
    case 3:
      fuzz::check<test::kHeap>(choices, Open::kAnything);
      break;
    case 4:
      fuzz::check<test::kDrift>(choices, Open::kAnything);
      break;
    case 5:
      fuzz::check<test::kCramped>(choices, Open::kAnything);
      break;
    case 6:
      fuzz::check<test::kHands>(choices, Open::kAnything);
      break;
    case 7:
      fuzz::check<test::kPaper>(choices, Open::kAnything);
      break;
    case 8:
      fuzz::check<test::kPaperLed>(choices, Open::kAnything);
      break;
    case 9:
      fuzz::check<test::kPaperCramped>(choices, Open::kAnything);
      break;
    case 10:
      fuzz::check<test::kBlows>(choices, Open::kAnything);
      break;
    case 11:
      fuzz::check<test::kBlowsCramped>(choices, Open::kAnything);
      break;
    default:
      fuzz::check<test::kBlowsLed>(choices, Open::kAnything);
      break;
  }
  return 0;
}
