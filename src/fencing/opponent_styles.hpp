// SPDX-License-Identifier: MIT
#pragma once
// The numbers that set the opponents' skills apart, and the lines in which all of them attack;
// opponent.md says what they were chosen for.

#include "batuta/fencing/opponent.hpp"

namespace batuta::fencing::detail {

/// What sets the skills apart: probabilities are of one decision.
struct Style {
  std::int32_t hesitation_us;  ///< between a decision and the hand, beyond the eye's delay
  std::int32_t lunge_us;       ///< its lunge, and
  std::int32_t extension_us;   ///< the extension before it
  float scatter;               ///< of a stick's place, along each axis
  float alarm_reach;           ///< m before its trunk at which a coming guard is an attack
  float measure;               ///< m between the trunks that it keeps
  float range;                 ///< m between the trunks within which it attacks
  float defends;               ///< answers an attack at all
  float retreats;              ///< of these, by a step back
  float counters;              ///< of these, by an attack of its own
  float reads;                 ///< sees the line of an attack
  float ripostes;              ///< after a parry
  float attacks;               ///< begins an attack, of the looks within range
  float hurries;               ///< the same, where the rival made none for kQuietLooks
  float pursues;               ///< the same, while the rival's attack is just over
  float stops;                 ///< of the looks at a rival who walks in
  float beats;                 ///< of its attacks, begun by a beat
  float feints;                ///< of its attacks, begun by an extension in another line
  float learns;                ///< goes by the rival's habits where it cannot read a line
  float takes;                 ///< goes for a blade that is held out, of the looks at it
  float foresight;             ///< s for which it thinks on two who come together, to attack
  bool meets;                  ///< knows what to do about a rival who rushes in
};

inline constexpr int kQuietLooks = 270;  ///< 4 s

inline constexpr std::array<Style, 3> kStyles = {{
    {90000, 250000, 150000, 0.12F, 0.62F, 2.7F, 2.9F, 0.25F, 0.3F, 0.15F, 0.45F,
     0.5F,  0.026F, 0.026F, 0.01F, 0.0F,  0.2F, 0.0F, 0.0F,  0.0F, 0.1F,  false},
    {22000, 160000, 85000, 0.05F, 0.57F, 3.1F,  3.2F, 0.97F, 0.05F, 0.04F, 0.75F,
     1.0F,  0.02F,  0.02F, 0.14F, 0.04F, 0.21F, 0.1F, 0.5F,  1.0F,  0.24F, true},
    {0,    140000, 90000,  0.02F, 0.58F, 2.95F, 3.1F, 1.0F, 0.4F, 0.04F, 1.0F,
     1.0F, 0.004F, 0.015F, 0.9F,  0.05F, 0.0F,  0.0F, 1.0F, 1.0F, 0.24F, true},
}};

inline const Style& style_of(Skill skill) {
  return kStyles[static_cast<std::size_t>(skill)];
}

/// Begun by oneself, or an answer that goes to the rival.
inline bool is_attack(Intent intent) {
  return intent == Intent::kAttack || intent == Intent::kBeat || intent == Intent::kCounter ||
         intent == Intent::kRiposte;
}

/// The line that a blade in this one leaves open.
inline int across(int line) {
  return static_cast<int>(Opponent::kLines) - 1 - line;
}

/// A line: where the stick lunges into it, how it extends there before, what closes it, and the
/// line of the riposte from there.
struct Line {
  Vec2<float> lunge;
  Vec2<float> extension;
  Vec2<float> parry;
  int riposte;
};

inline Vec2<float> at(float x, float y) {
  return {x, y};
}

/// High inside, low inside, low outside, high outside, as the library's map has them (map.md).
inline Line line_of(int index) {
  switch (index) {
    case 0:
      return {at(-1, 1), at(-0.5F, 0.5F), at(-1, 0), 1};
    case 1:
      return {at(-0.5F, 1), at(-0.25F, 0.5F), at(-1, -1), 1};
    case 2:
      return {at(0.5F, 1), at(0.25F, 0.5F), at(1, -1), 0};
    default:
      return {at(1, 1), at(0.5F, 0.5F), at(1, 0), 1};
  }
}

}  // namespace batuta::fencing::detail
