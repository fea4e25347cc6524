// SPDX-License-Identifier: MIT
#pragma once
// The kinds of random scenes, and what a scene of one of them breaks: compiled once
// (random_runs.hpp) for the tests and for the fuzzers.

#include "batuta/world/scene_options.hpp"
#include "choices.hpp"
#include "six_laws.hpp"

namespace batuta::test {

/// What tells one type of random scene from another.
struct RandomKind {
  RestingContact resting = RestingContact::kSettling;
  bool gravity = false;
  bool sleep = false;
  bool is_led = false;    ///< controllers
  bool is_tight = false;  ///< hardly any room, so that bodies are welded
  bool turns = true;
  bool is_small = false;  ///< Engine::kSmall
  int bodies = 40;
  int parts = 1;
};

using Rests = RestingContact;
// resting, gravity, sleep, is_led, is_tight, turns, is_small, bodies, parts
inline constexpr RandomKind kHeap = {
    Rests::kSettling, true, true, false, false, true, false, 40, 2};
inline constexpr RandomKind kDrift = {
    Rests::kSettling, false, false, false, false, true, false, 12, 3};
inline constexpr RandomKind kCramped = {
    Rests::kSettling, true, false, false, true, true, false, 40, 1};
inline constexpr RandomKind kHands = {
    Rests::kSettling, true, true, true, false, true, false, 12, 2};
inline constexpr RandomKind kPaper = {
    Rests::kSeparation, false, false, false, false, true, false, 12, 2};
inline constexpr RandomKind kPaperLed = {
    Rests::kSeparation, true, false, true, false, true, false, 8, 1};
inline constexpr RandomKind kPaperCramped = {
    Rests::kSeparation, true, false, false, true, true, false, 12, 2};
inline constexpr RandomKind kBlows = {Rests::kNone, false, false, false, false, true, false, 40, 1};
inline constexpr RandomKind kBlowsCramped = {Rests::kNone, true,  false, false, true,
                                             true,         false, 12,    2};
inline constexpr RandomKind kBlowsLed = {Rests::kNone, true,  false, true, false,
                                         true,         false, 12,    1};
inline constexpr RandomKind kStraight = {Rests::kNone, true,  false, false, false,
                                         false,        false, 12,    1};
inline constexpr RandomKind kSmallBalls = {Rests::kNone, true, false, false, false,
                                           false,        true, 8,     1};
inline constexpr RandomKind kSmallCramped = {Rests::kNone, false, false, false, true,
                                             false,        true,  8,     1};

/// A breach, when it was, what the step told, and what a step like it may do besides.
struct Found {
  Breach breach;
  int step = 0;
  Told told;
  Terms terms;
};

/// What a scene did, summed over its steps.
struct Happened {
  int collisions = 0;
  int separations = 0;
  int overlaps = 0;  ///< at the start of a search
  int frozen = 0;
  int held = 0;  ///< steps in which somebody went on together with another
  int cut = 0;   ///< steps that were not complete
  int asleep = 0;
};

struct Ran {
  std::vector<Found> found;
  Happened happened;
};

/// How far relative places went apart beyond what may be: at most 0.
struct OffFrame {
  Real by = 0;
  Real besides_gaps = 0;  ///< and beyond what contacts open and close by then
};

/// Scenes of one kind, whose numbers are S.
template <class S, const RandomKind& kKind>
struct RandomLaws {
  static Ran run(const Choices& choices, int steps);
  /// Law 1: the same scene at rest and flying along. Compared until the third contact, because each
  /// amplifies rounding; and only where nothing holds anybody.
  static OffFrame frame_breach(const Choices& choices, int steps);
};

}  // namespace batuta::test
