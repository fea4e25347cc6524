// SPDX-License-Identifier: MIT
#include "batuta/fencing/target.hpp"

#include "batuta/detection/swept_volume.hpp"

namespace batuta::fencing {
namespace {

/// Where the walk goes on when it leaves out a bone and all that it carries: behind the last of
/// them.
constexpr std::array<std::uint8_t, kBodyParts> bones_behind() {
  std::array<std::uint8_t, kBodyParts> behind{};
  for (std::size_t i = 0; i < behind.size(); ++i) {  // Bound: kBodyParts
    behind[i] = static_cast<std::uint8_t>(i + 1);
  }
  for (std::size_t i = behind.size() - 1; i > 0; --i) {  // Bound: kBodyParts
    const auto parent = static_cast<std::size_t>(kBodyParent[i]);
    if (behind[parent] < behind[i]) behind[parent] = behind[i];
  }
  return behind;
}

constexpr bool parents_come_first() {
  for (std::size_t i = 1; i < kBodyParent.size(); ++i) {  // Bound: kBodyParts
    if (kBodyParent[i] < 0 || static_cast<std::size_t>(kBodyParent[i]) >= i) return false;
  }
  return kBodyParent[0] == -1;
}
static_assert(parents_come_first(), "kBodyParent: a bone is carried by an earlier one");

constexpr std::array<std::uint8_t, kBodyParts> kBehind = bones_behind();

/// How far an end of a bone may leave the straight way of its step, as a share of the chord between
/// its axes at start and end: pi^2 / 32, and 1/2 where the axes differ in length, rounded up
/// (target.md).
template <class Scalar>
inline constexpr Scalar kBulge = Scalar(0.81);

/// The rounding of shapes and of the twist between them, as a share of the coordinates (target.md).
template <class Scalar>
inline constexpr Scalar kShapeOutward = 64 * kRoundOff<Scalar>;

/// What the hull of both ends of a bone's step has to grow by to hold it in between, m.
template <class Scalar>
Scalar margin_between(const Segment<Scalar>& start, const Segment<Scalar>& end) {
  const Vec3<Scalar> d0 = start.direction();
  const Vec3<Scalar> d1 = end.direction();
  const bool turns_far = !(d0.dot(d1) >= Scalar(0));
  const Scalar chord = (d1 - d0).cwiseAbs().sum();
  const Scalar size = start.a.cwiseAbs().sum() + start.b.cwiseAbs().sum() + end.a.cwiseAbs().sum() +
                      end.b.cwiseAbs().sum();
  return (turns_far ? Scalar(1) : kBulge<Scalar>)*chord + kShapeOutward<Scalar> * size;
}

/// The constant twist of the shortest turn that carries one capsule into another of the same
/// length. The body's frame sits in the middle of the capsule with the axes of W; a turn about the
/// capsule's own axis would not show.
template <class Scalar>
MovingCapsule<Scalar> between(const Capsule<Scalar>& start_W, const Capsule<Scalar>& end_W,
                              Scalar dt) {
  const Vec3<Scalar> p0 = start_W.axis.at(Scalar(0.5));
  MovingCapsule<Scalar> moving;
  moving.capsule_B = {{start_W.axis.a - p0, start_W.axis.b - p0}, start_W.radius};
  moving.motion.X_WB = {p0, Quat<Scalar>::Identity()};
  moving.motion.duration = dt;
  if (!(dt > Scalar(0))) return moving;

  const Vec3<Scalar> d0 = start_W.axis.direction();
  const Vec3<Scalar> d1 = end_W.axis.direction();
  moving.motion.twist.v_W = (end_W.axis.at(Scalar(0.5)) - p0) / dt;
  const Vec3<Scalar> normal = d0.cross(d1);
  const Scalar sine = normal.norm();
  if (sine > Scalar(0)) {
    moving.motion.twist.w_W =
        (batuta::detail::arc_tangent(sine, d0.dot(d1)) / (sine * dt)) * normal;
  }
  return moving;
}

/// The part of a motion from `from` on, `duration` long.
template <class Scalar>
Motion<Scalar> piece_of(const Motion<Scalar>& motion, Scalar from, Scalar duration) {
  return {pose_at(motion, min_of(from, motion.duration)), motion.twist, duration};
}

}  // namespace

template <class Scalar>
void Target<Scalar>::place(const BodyShape<Scalar>& shape_W) {
  shape_W_ = shape_W;
  go_to(shape_W, Scalar(0));
}

template <class Scalar>
void Target<Scalar>::move_to(const BodyShape<Scalar>& shape_W, Scalar dt) {
  BATUTA_ASSERT(is_finite(dt) && dt > Scalar(0));
  go_to(shape_W, dt);
}

template <class Scalar>
void Target<Scalar>::go_to(const BodyShape<Scalar>& shape_W, Scalar dt) {
  start_W_ = shape_W_;
  shape_W_ = shape_W;
  dt_ = dt;
  for (std::size_t i = 0; i < kParts; ++i) {  // Bound: kBodyParts
    hulls_[i] = own_hull(i);
  }
  for (std::size_t i = kParts - 1; i > 0; --i) {  // Bound: kBodyParts
    const auto parent = static_cast<std::size_t>(kBodyParent[i]);
    hulls_[parent] = merge(hulls_[parent], hulls_[i]);
  }
}

/// Holds the part alone during the whole step.
template <class Scalar>
typename Target<Scalar>::Hull Target<Scalar>::own_hull(std::size_t part) const {
  const Capsule<Scalar>& start = start_W_[part];
  const Capsule<Scalar>& end = shape_W_[part];
  return batuta::detail::kdop_of<Scalar, kTargetK>(start, end,
                                                   margin_between(start.axis, end.axis));
}

template <class Scalar>
MovingCapsule<Scalar> Target<Scalar>::part(BodyPart part) const {
  const auto i = static_cast<std::size_t>(part);
  BATUTA_ASSERT(i < kParts);
  return between(start_W_[i], shape_W_[i], dt_);
}

/// The wanted parts that the blade's swept volume meets.
template <class Scalar>
PartMask Target<Scalar>::parts_reached(const MovingCapsule<Scalar>& blade, PartMask wanted) const {
  PartMask reached = 0;
  const Hull swept = batuta::detail::swept_kdop<Scalar, kTargetK>(blade);
  std::size_t i = 0;
  for (int visit = 0; visit < kBodyParts && i < kParts; ++visit) {  // Bound: kBodyParts
    if (!overlaps(swept, hulls_[i])) {
      i = kBehind[i];
      continue;
    }
    const PartMask part = mask_of(static_cast<BodyPart>(i));
    if ((wanted & part) != 0 && overlaps(swept, own_hull(i))) reached |= part;
    ++i;
  }
  return reached;
}

/// The blade and a part over the blade's time.
template <class Scalar>
Result<MovingPair<Scalar>> Target<Scalar>::pair_with(std::size_t part,
                                                     const MovingCapsule<Scalar>& blade,
                                                     Scalar from) const {
  MovingCapsule<Scalar> target = this->part(static_cast<BodyPart>(part));
  target.motion = piece_of(target.motion, from, blade.motion.duration);
  return make_moving_pair(blade, target);
}

/// Joins what the search of one part found to what is known of the parts before it.
template <class Scalar>
void Target<Scalar>::take(const PartSearch& search, BodyPart part, Scalar from,
                          TouchSearch<Scalar>& first) {
  const SearchResult<Scalar>& result = search.result;
  ++first.searches;
  first.evaluations += result.evaluations;
  if (result.outcome == Outcome::kFree) return;
  const bool cut = result.outcome == Outcome::kBudget;
  const bool invalid = result.outcome == Outcome::kInvalid;
  if (cut) ++first.budget_outs;
  if (invalid) ++first.searches_invalid;
  if (cut || invalid) {  // t_free of an invalid one is 0: nothing is known
    first.complete = false;
    first.known_until = min_of(first.known_until, from + result.t_free);
    return;
  }
  if (first.found && first.t_free <= from + result.t_free) return;
  first.found = true;
  first.part = part;
  first.t_free = from + result.t_free;
  first.t_hit = from + result.t_hit;
  first.contact = contact_from(result.witness, search.origin_W);
  first.place = result.witness.axes.s;
}

#define BATUTA_INSTANTIATE(S) template class Target<S>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
