// SPDX-License-Identifier: MIT
// What must hold of the searches for the first contact for any numbers whatever, as a libFuzzer
// target: what is proven free is free in double, what is called contact is one, and the same
// question asked otherwise has no other answer. Bounds: src/detection/advancement.md, "Rounding",
// moving_pair.md and stepping.md.

#include <algorithm>

#include "batuta/detection/search.hpp"
#include "batuta/detection/swept_volume.hpp"
#include "bytes.hpp"
#include "oracle.hpp"

namespace batuta::fuzz {
namespace {

using Moving = MovingCapsule<float>;
using Answer = SearchResult<float>;
using Options = AdvancementOptions<float>;

struct Question {
  Moving A;
  Moving B;
  Options options;
  Vec3<float> seed_AB = Vec3<float>::Zero();
  bool turns = true;
};

Moving draw_moving(Bytes& bytes, Numbers from, bool turns) {
  Moving moving;
  moving.capsule_B = {bytes.segment(from), bytes.radius(from)};
  moving.motion.X_WB = {bytes.vector(from), bytes.turn()};
  moving.motion.twist.v_W = bytes.vector(from);
  if (turns) moving.motion.twist.w_W = bytes.vector(from);
  return moving;
}

Question draw_question(Bytes& bytes, Numbers from) {
  Question question;
  question.turns = bytes.flag();
  question.A = draw_moving(bytes, from, question.turns);
  question.B = draw_moving(bytes, from, question.turns && bytes.flag());
  const float durations[] = {1, 0x1p-10F, 16, 0};
  const int which = bytes.choice(5);
  const float duration = which < 4 ? durations[which] : std::abs(bytes.number(from));
  question.A.motion.duration = duration;
  question.B.motion.duration = duration;
  question.options.budget = 1U + bytes.byte();
  question.options.contact_tolerance = bytes.flag() ? bytes.share() * 0x1p-10F : 1e-6F;
  if (bytes.flag()) question.seed_AB = bytes.vector(from);
  return question;
}

/// The frame of W and those of both bodies turned together: exact.
Moving turned(const Moving& moving) {
  Moving other = moving;
  other.capsule_B.axis = {cube_turned(moving.capsule_B.axis.a),
                          cube_turned(moving.capsule_B.axis.b)};
  other.motion.X_WB.p_W = cube_turned(moving.motion.X_WB.p_W);
  other.motion.X_WB.q_WB.vec() = cube_turned<float>(moving.motion.X_WB.q_WB.vec());
  other.motion.twist = {cube_turned(moving.motion.twist.v_W), cube_turned(moving.motion.twist.w_W)};
  return other;
}

/// A unit of length 2^-5 times as large, one of time 2^3: exact.
Moving in_other_units(const Moving& moving) {
  Moving other = moving;
  other.capsule_B.axis.a *= 0x1p5F;
  other.capsule_B.axis.b *= 0x1p5F;
  other.capsule_B.radius *= 0x1p5F;
  other.motion.X_WB.p_W *= 0x1p5F;
  other.motion.twist.v_W *= 0x1p8F;
  other.motion.twist.w_W *= 0x1p3F;
  other.motion.duration *= 0x1p-3F;
  return other;
}

Answer search(const Question& question, const MovingPair<float>& pair) {
  if (!question.turns) return search_translation(pair, question.options);
  return search_advancement(pair, question.options, question.seed_AB);
}

/// What the answer says of itself.
void check_shape(const Answer& answer, float duration, std::uint32_t most) {
  require(answer.evaluations <= most, "a search keeps to its budget");
  if (answer.outcome == Outcome::kInvalid) return;
  require(answer.t_free >= 0 && answer.t_free <= answer.t_hit, "free comes before contact");
  if (answer.outcome == Outcome::kTouching) require(answer.t_free == 0, "touching is at 0");
  if (answer.outcome == Outcome::kFree)
    require(answer.t_free == duration, "free is free all along");
  require(answer.t_free <= duration, "nothing is said of what comes after");
}

/// Claim 4, and what kContact and kTouching say of the gap; in double, to the same count of
/// roundings in units of its own.
void check_truth(const RealPair& real, const MovingPair<float>& pair, const Answer& answer,
                 const Options& options) {
  if (answer.outcome == Outcome::kInvalid) return;
  const double eps = detail::inflation_of(pair);
  const double real_eps = eps * kRoundOff<double> / kU;
  const double contact = static_cast<double>(contact_tolerance_of(pair, options)) + eps + real_eps;
  const double t_free = answer.t_free;
  if (answer.outcome == Outcome::kTouching) {
    return require(real.gap(0) <= contact,
                   "what touches at the start is within the contact_tolerance");
  }
  if (answer.outcome != Outcome::kBudget || t_free > 0) {
    require(real.least_gap(t_free) > -real_eps, "no contact before the proven end");
  }
  if (answer.outcome == Outcome::kContact) {
    require(real.gap(t_free) <= contact, "what is called contact is within the contact_tolerance");
  }
}

/// Two answers to one question, the second of a pair that is thicker by more than what the first
/// calls contact: it must have stopped where the first met.
void check_thicker(const Answer& thin, const Answer& thick) {
  if (thin.outcome == Outcome::kTouching) {
    require(thick.outcome == Outcome::kTouching || thick.t_free == 0, "thicker touches as well");
  }
  if (thin.outcome != Outcome::kContact || thick.outcome == Outcome::kInvalid) return;
  require(thick.outcome != Outcome::kFree && thick.t_free <= thin.t_free, "thicker meets no later");
}

/// A budget ends a search, and is good for nothing else.
void check_budget(const Question& question, const MovingPair<float>& pair, const Answer& answer) {
  Question longer = question;
  longer.options.budget *= 2;
  const Answer again = search(longer, pair);
  if (answer.outcome == Outcome::kBudget) {
    return require(again.t_free >= answer.t_free, "who searches on proves no less");
  }
  require(again.outcome == answer.outcome && again.t_free == answer.t_free &&
              again.t_hit == answer.t_hit && again.evaluations == answer.evaluations,
          "what is answered stays answered");
}

void check_other_ways(const Question& question, const MovingPair<float>& pair, const Answer& answer,
                      bool is_exact) {
  Question other = question;
  other.A = turned(question.A);
  other.B = turned(question.B);
  const Result<MovingPair<float>> turned_pair = make_moving_pair(other.A, other.B);
  if (turned_pair.ok()) {
    check_truth(RealPair(question.A, question.B), turned_pair.value,
                search(other, turned_pair.value), question.options);
  }
  const Result<MovingPair<float>> swapped = make_moving_pair(question.B, question.A);
  if (swapped.ok()) {
    check_truth(RealPair(question.A, question.B), swapped.value, search(question, swapped.value),
                question.options);
  }
  if (is_exact) {
    const MovingPair<float> same =
        make_moving_pair(in_other_units(question.A), in_other_units(question.B)).value;
    const Answer again = search(question, same);
    require(again.outcome == answer.outcome && again.t_free == 0x1p-3F * answer.t_free &&
                again.evaluations == answer.evaluations,
            "the same in other units, to the last bit");
  }
  Question thick = question;
  const float contact = contact_tolerance_of(pair, question.options) + detail::inflation_of(pair);
  thick.B.capsule_B.radius =
      (question.B.capsule_B.radius + 2 * contact) * (1 + 8 * kRoundOff<float>);
  const Result<MovingPair<float>> thick_pair = make_moving_pair(thick.A, thick.B);
  if (thick_pair.ok()) check_thicker(answer, search(thick, thick_pair.value));
}

/// kFree means: no overlap deeper than epsilon / 2; contact was seen, free before it. A gap errs by
/// (72 + 6 W T) u S.
void check_stepping(const RealPair& real, const MovingPair<float>& pair, Bytes& bytes) {
  SteppingOptions<float> options;
  options.unit = bytes.flag() ? EpsilonIn::kMetres : EpsilonIn::kThinnerRadius;
  options.epsilon = 0.01F + bytes.share();
  options.max_steps = 1U + bytes.byte();
  options.halvings = bytes.choice(30);
  const Answer answer = search_stepping(pair, options);
  check_shape(answer, pair.duration, options.max_steps + 31);
  if (answer.outcome == Outcome::kInvalid) return;
  const double turn = static_cast<double>(max_of(pair.A.turn_rate, pair.B.turn_rate)) *
                      static_cast<double>(pair.duration);
  const double slack = (72 + 6 * turn) * kU * static_cast<double>(pair.scale) + kLeast;
  if (answer.outcome == Outcome::kFree) {
    const float radius = min_of(pair.A.radius, pair.B.radius);
    const float unit = options.unit == EpsilonIn::kMetres ? 1 : radius;
    const double epsilon = static_cast<double>(options.epsilon) * static_cast<double>(unit);
    require(real.least_gap(static_cast<double>(answer.t_free)) >= -epsilon / 2 - slack,
            "stepping passes over nothing deeper than half of epsilon");
  }
  if (answer.outcome == Outcome::kContact) {
    require(real.gap(static_cast<double>(answer.t_hit)) <= slack, "stepping has seen the contact");
    require(real.gap(static_cast<double>(answer.t_free)) >= -slack, "and no contact before it");
  }
}

/// Whether a box holds an axis and its radius, but for what double loses.
bool holds(const Aabb<float>& box, const RealAxis& axis, double radius, double slack) {
  bool all = true;
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    all =
        all && static_cast<double>(box.high[at]) >= std::max(axis.a[k], axis.b[k]) + radius - slack;
    all =
        all && static_cast<double>(box.low[at]) <= std::min(axis.a[k], axis.b[k]) - radius + slack;
  }
  return all;
}

void check_swept(const Moving& moving, const RealPath& path, Bytes& bytes) {
  const Aabb<float> exact = swept_aabb(moving);
  const Aabb<float> coarse = detail::coarse_swept_aabb(moving);
  const auto duration = static_cast<double>(moving.motion.duration);
  for (int i = 0; i < 4; ++i) {
    const double t = i == 0 ? duration : duration * static_cast<double>(bytes.share());
    const double slack = 64 * kRoundOff<double> * path.lengths(t);
    require(holds(exact, path.at(t), path.radius(), slack), "a swept box holds its capsule");
    require(holds(coarse, path.at(t), path.radius(), slack), "a coarse box holds its capsule");
  }
}

/// Any numbers: the answer has its shape, whatever it is.
void check_any(const Question& question, const MovingPair<float>& pair) {
  check_shape(search(question, pair), pair.duration, question.options.budget);
  check_shape(search_stepping(pair, {0.5F, EpsilonIn::kMetres, 64, 24}), pair.duration, 64 + 25);
}

void check(Bytes bytes) {
  const Numbers from = bytes.numbers();
  const Question question = draw_question(bytes, from);
  const Result<MovingPair<float>> made = make_moving_pair(question.A, question.B);
  if (!made.ok()) return;
  const MovingPair<float>& pair = made.value;
  if (from == Numbers::kAny) return check_any(question, pair);

  const Answer answer = search(question, pair);
  const RealPair real{question.A, question.B};
  check_shape(answer, pair.duration, question.options.budget);
  check_truth(real, pair, answer, question.options);
  if (answer.outcome == Outcome::kInvalid) return;
  check_budget(question, pair, answer);
  check_other_ways(question, pair, answer, from == Numbers::kGrid);
  check_stepping(real, pair, bytes);
  check_swept(question.B, RealPath(question.B), bytes);
  const bool boxes_meet = overlaps(swept_aabb(question.A), swept_aabb(question.B));
  if (!boxes_meet) {
    require(real.least_gap(static_cast<double>(pair.duration)) > 0, "boxes apart, capsules apart");
  }
}

}  // namespace
}  // namespace batuta::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  batuta::fuzz::check({data, size});
  return 0;
}
