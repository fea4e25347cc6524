// SPDX-License-Identifier: MIT
#include "batuta/fencing/target.hpp"

#include "batuta/detection/swept_volume.hpp"
#include "batuta/response/impulse.hpp"

namespace batuta::fencing {
namespace {

/// How far an end of a bone may leave the straight way of its step, as a share of the chord between
/// its axes at start and end: pi^2 / 32, and 1/2 where the axes differ in length, rounded up
/// (target.md).
template <class Scalar>
inline constexpr Scalar kBulge = Scalar(0.81);

/// How fast a blade comes out that is deeper in a body than kGive, m/s: at most.
template <class Scalar>
inline constexpr Scalar kComesOut = Scalar(1);

/// A blade that sinks in more slowly is stopped in a later step, when there is more of it, m/s
/// (target.md, "Steel").
template <class Scalar>
inline constexpr Scalar kCreep = Scalar(0.05F);

/// Blows that stop a blade in one plan: each answers the deepest place of the one before.
constexpr int kMostStops = 12;

/// The rounding of shapes and of the twist between them, as a share of the coordinates (target.md).
template <class Scalar>
inline constexpr Scalar kShapeOutward = 64 * kRoundOff<Scalar>;

/// Between the axes of a bone at start and end, no shorter than the straight one, m.
template <class Scalar>
Scalar chord_between(const Segment<Scalar>& start, const Segment<Scalar>& end) {
  return (end.direction() - start.direction()).cwiseAbs().sum();
}

/// What the hull of both ends of a bone's step has to grow by to hold it in between, m.
template <class Scalar>
Scalar margin_between(const Segment<Scalar>& start, const Segment<Scalar>& end) {
  const Vec3<Scalar> d0 = start.direction();
  const Vec3<Scalar> d1 = end.direction();
  const bool turns_far = !(d0.dot(d1) >= Scalar(0));
  const Scalar chord = chord_between(start, end);
  const Scalar size = start.a.cwiseAbs().sum() + start.b.cwiseAbs().sum() + end.a.cwiseAbs().sum() +
                      end.b.cwiseAbs().sum();
  return (turns_far ? Scalar(1) : kBulge<Scalar>)*chord + kShapeOutward<Scalar> * size;
}

/// The constant twist of the shortest turn that carries the axis of a capsule into another of the
/// same length. The body's frame sits in the middle of the capsule with the axes of W; a turn about
/// the capsule's own axis would not show.
template <class Scalar>
MovingCapsule<Scalar> between(const Segment<Scalar>& start_W, const Capsule<Scalar>& end_W,
                              Scalar dt) {
  const Vec3<Scalar> p0 = start_W.at(Scalar(0.5));
  MovingCapsule<Scalar> moving;
  moving.capsule_B = {{start_W.a - p0, start_W.b - p0}, end_W.radius};
  moving.motion.X_WB = {p0, Quat<Scalar>::Identity()};
  moving.motion.duration = dt;
  if (!(dt > Scalar(0))) return moving;

  const Vec3<Scalar> d0 = start_W.direction();
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

/// Of the ends of all axes.
template <class Scalar>
Aabb<Scalar> ends_of(const BodyShape<Scalar>& shape_W) {
  Vec3<Scalar> low = shape_W[0].axis.a;
  Vec3<Scalar> high = low;
  for (const Capsule<Scalar>& part : shape_W) {  // Bound: kBodyParts
    low = low.cwiseMin(part.axis.a.cwiseMin(part.axis.b));
    high = high.cwiseMax(part.axis.a.cwiseMax(part.axis.b));
  }
  return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
}

/// The part of a motion from `from` on, `duration` long.
template <class Scalar>
Motion<Scalar> piece_of(const Motion<Scalar>& motion, Scalar from, Scalar duration) {
  return {pose_at(motion, min_of(from, motion.duration)), motion.twist, duration};
}

/// A plan that blows have changed is slowed down where it has more energy than the plan before and
/// what bodies that move may give it: |T| <= |T_0| + sqrt(m / 2) (2 u + o) in the norm of energy, u
/// the fastest of the parts that it struck, o kComesOut where it began too deep (target.md,
/// "Energy"). @param push  2 u + o, m/s
template <class Scalar>
void keep_energy(Body<Scalar> blade, const Twist<Scalar>& before, Scalar push,
                 Twist<Scalar>& twist) {
  if (!(blade.inverse_mass > Scalar(0))) return;
  using std::sqrt;
  const auto norm = [&blade](const Twist<Scalar>& of) {
    blade.momentum = momentum_of(blade, of);
    return sqrt(kinetic_energy(blade));
  };
  const Scalar most = norm(before) + push / sqrt(2 * blade.inverse_mass);
  const Scalar now = norm(twist);
  if (!(now > most)) return;
  twist.v_W *= most / now;
  twist.w_W *= most / now;
}

/// A blow without a bounce at the end of a motion: the body leads the blade away from where it
/// would be too deep, at the speed that it must have. @returns false: the motion is left as it is
template <class Scalar>
bool strike(const Body<Scalar>& blade, const Contact<Scalar>& contact, Scalar depth,
            Motion<Scalar>& motion) {
  const Pose<Scalar> end_WB = pose_at(motion, motion.duration);
  const Collider<Scalar> struck{end_WB, motion.twist, blade.inverse_mass, blade.inverse_moments};
  Collider<Scalar> body{end_WB, motion.twist};
  body.twist.v_W += (depth / motion.duration) * contact.normal_BA_W;
  const auto hit = collision_impulse(struck, body, contact, Scalar(0));
  if (hit.ok()) motion.twist = hit.value.twist_A;
  return hit.ok();
}

}  // namespace

template <class Scalar>
void Target<Scalar>::place(const BodyShape<Scalar>& shape_W) {
  shape_W_ = shape_W;
  stay();
}

template <class Scalar>
void Target<Scalar>::place(const FencerBuild<Scalar>& build, const Stance<Scalar>& stance) {
  pose_body(build, stance, shape_W_);
  stay();
}

template <class Scalar>
void Target<Scalar>::move_to(const BodyShape<Scalar>& shape_W, Scalar dt) {
  start_from_here();
  shape_W_ = shape_W;
  arrive(dt);
}

template <class Scalar>
void Target<Scalar>::move_to(const FencerBuild<Scalar>& build, const Stance<Scalar>& stance,
                             Scalar dt) {
  start_from_here();
  pose_body(build, stance, shape_W_);
  arrive(dt);
}

/// The last step's end is the start of this one.
template <class Scalar>
void Target<Scalar>::start_from_here() {
  for (std::size_t i = 0; i < kParts; ++i) start_W_[i] = shape_W_[i].axis;  // Bound: kBodyParts
}

template <class Scalar>
void Target<Scalar>::arrive(Scalar dt) {
  BATUTA_ASSERT(is_finite(dt) && dt > Scalar(0));
  const Aabb<Scalar> before = ends_;
  ends_ = ends_of(shape_W_);
  set_way(merge(before, ends_), dt);
}

template <class Scalar>
void Target<Scalar>::stay() {
  start_from_here();
  ends_ = ends_of(shape_W_);
  set_way(ends_, Scalar(0));
}

/// @param ends  of all axes, at the start and at the end
template <class Scalar>
void Target<Scalar>::set_way(const Aabb<Scalar>& ends, Scalar dt) {
  dt_ = dt;
  hulls_[0] = hull_of_all(ends);
  is_fitted_ = false;
}

/// From a box of all ends of axes, at the start and at the end: no margin of a part is larger than
/// the one here (target.md, "The whole body").
template <class Scalar>
typename Target<Scalar>::Hull Target<Scalar>::hull_of_all(const Aabb<Scalar>& ends) const {
  Scalar radius = 0;
  Scalar chord = 0;
  for (std::size_t i = 0; i < kParts; ++i) {  // Bound: kBodyParts
    radius = max_of(radius, shape_W_[i].radius);
    chord = max_of(chord, chord_between(start_W_[i], shape_W_[i].axis));
  }
  const auto& [low, high] = ends;
  Scalar size = 0;
  for (std::size_t k = 0; k < low.size(); ++k) {  // Bound: 3
    size += max_of(std::abs(low[k]), std::abs(high[k]));
  }
  constexpr Scalar kEnds = 4;  // of a part, at the start and at the end
  const Scalar margin =
      (chord + kShapeOutward<Scalar> * chord) + kShapeOutward<Scalar> * (kEnds * size);
  const Segment<Scalar> all = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
  return batuta::detail::kdop_of<Scalar, kTargetK>(all, all, radius + margin);
}

/// The boxes of the parts, for this step.
template <class Scalar>
void Target<Scalar>::fit() {
  if (is_fitted_) return;
  for (std::size_t i = 1; i < kParts; ++i) hulls_[i] = own_hull(i);  // Bound: kBodyParts
  is_fitted_ = true;
}

/// Holds the part alone during the whole step.
template <class Scalar>
typename Target<Scalar>::Hull Target<Scalar>::own_hull(std::size_t part) const {
  const Segment<Scalar>& start = start_W_[part];
  const Capsule<Scalar>& end = shape_W_[part];
  return batuta::detail::kdop_of<Scalar, kTargetK>(start, end.axis,
                                                   end.radius + margin_between(start, end.axis));
}

template <class Scalar>
MovingCapsule<Scalar> Target<Scalar>::part(BodyPart part) const {
  const auto i = static_cast<std::size_t>(part);
  BATUTA_ASSERT(i < kParts);
  return between(start_W_[i], shape_W_[i], dt_);
}

/// The wanted parts whose hulls a box meets.
template <class Scalar>
PartMask Target<Scalar>::parts_in(const Hull& box, PartMask wanted) {
  PartMask reached = 0;
  if (!overlaps(box, hull())) return reached;
  fit();
  for (std::size_t i = 0; i < kParts; ++i) {  // Bound: kBodyParts
    const PartMask part = mask_of(static_cast<BodyPart>(i));
    if ((wanted & part) == 0) continue;
    if (overlaps(box, i == 0 ? own_hull(i) : hulls_[i])) reached |= part;
  }
  return reached;
}

/// Those that a blade's swept volume meets.
template <class Scalar>
PartMask Target<Scalar>::parts_reached(const MovingCapsule<Scalar>& blade, PartMask wanted) {
  return parts_in(batuta::detail::coarse_swept_kdop<Scalar, kTargetK>(blade), wanted);
}

/// The blade and a part over the blade's time.
template <class Scalar>
Result<MovingPair<Scalar>> Target<Scalar>::pair_with(std::size_t part,
                                                     const BladePiece& piece) const {
  MovingCapsule<Scalar> target = this->part(static_cast<BodyPart>(part));
  target.motion = piece_of(target.motion, piece.from, piece.blade.motion.duration);
  return make_moving_pair(piece.blade, target);
}

/// Where a part's axis is at a time of the step: between its ends on the straight way, at them
/// exactly.
template <class Scalar>
Segment<Scalar> Target<Scalar>::axis_at(std::size_t part, Scalar t) const {
  const Segment<Scalar>& end = shape_W_[part].axis;
  if (!(t < dt_)) return end;
  const Segment<Scalar>& start = start_W_[part];
  const Scalar share = t / dt_;
  return {start.a + share * (end.a - start.a), start.b + share * (end.b - start.b)};
}

/// How much deeper than allowed a blade ends in a part: deeper than kGive, and than what it comes
/// out of it in the time. Where it would be beyond the part's axis at the end, it is looked at from
/// the side from which it came.
template <class Scalar>
typename Target<Scalar>::Dent Target<Scalar>::dent_in(std::size_t part, const BladeWay& way) const {
  const Scalar radii = way.end.radius + shape_W_[part].radius;
  const auto last = closest_points(way.end.axis, axis_at(part, way.from + way.duration));
  Scalar gap = last.distance - radii;
  Dent dent;
  if (!(gap < -kGive<Scalar>)) return dent;
  const auto first = closest_points(way.start.axis, axis_at(part, way.from));
  const Scalar first_gap = first.distance - radii;
  dent.contact = contact_from(capsule_gap(last, way.end.radius, shape_W_[part].radius),
                              batuta::detail::zero<Scalar>());
  dent.part = static_cast<BodyPart>(part);
  const Scalar turned = first.normal_AB.dot(last.normal_AB);
  if (turned < Scalar(0)) {
    gap = (gap + radii) * turned - radii;
    dent.contact.normal_BA_W = -first.normal_AB;
  }
  if (first_gap < -kGive<Scalar>) dent.comes_out = kComesOut<Scalar>;
  dent.depth = min_of(-kGive<Scalar>, first_gap + kComesOut<Scalar> * way.duration) - gap;
  return dent;
}

/// Of all parts in which the blade ends; depth 0: none.
template <class Scalar>
typename Target<Scalar>::Dent Target<Scalar>::deepest_dent(const MovingCapsule<Scalar>& blade,
                                                           Scalar from, PartMask parts) {
  Dent deepest;
  const Motion<Scalar>& motion = blade.motion;
  const Capsule<Scalar> end = to_world(pose_at(motion, motion.duration), blade.capsule_B);
  const PartMask reached = parts_in(batuta::detail::kdop_of<Scalar, kTargetK>(end), parts);
  if (reached == 0) return deepest;
  const BladeWay way = {to_world(motion.X_WB, blade.capsule_B), end, from, motion.duration};
  for (std::size_t i = 0; i < kParts; ++i) {  // Bound: kBodyParts
    if ((reached >> i & 1U) == 0) continue;
    const Dent dent = dent_in(i, way);
    if (dent.depth > deepest.depth) deepest = dent;
  }
  return deepest;
}

/// Of a point of a part, in the step.
template <class Scalar>
Vec3<Scalar> Target<Scalar>::velocity_of(BodyPart part, const Vec3<Scalar>& p_W) const {
  const Motion<Scalar> motion = this->part(part).motion;
  return velocity_at(motion.X_WB, motion.twist, p_W);
}

/// Where blows do not bring it out of all parts, or would turn it faster than a motion may, the
/// blade is between some of them, and goes along.
template <class Scalar>
bool Target<Scalar>::stop(const Body<Scalar>& blade, const Capsule<Scalar>& blade_B, Scalar from,
                          PartMask parts, Motion<Scalar>& motion) {
  if (!(motion.duration > Scalar(0)) || !is_valid(motion)) return false;
  const Twist<Scalar> before = motion.twist;
  BodyPart first = BodyPart::kRearShin;  // of those that it struck: the trunk before its limbs
  Scalar push = 0;
  int blow = 0;
  for (; blow <= kMostStops; ++blow) {  // Bound: kMostStops + 1
    const Dent dent = deepest_dent({blade_B, motion}, from, parts);
    if (!(dent.depth > kCreep<Scalar> * max_of(dt_, motion.duration))) break;
    if (dent.part < first) first = dent.part;
    const Vec3<Scalar>& p_W = dent.contact.point_W;
    push = max_of(push, 2 * velocity_of(dent.part, p_W).norm() + dent.comes_out);
    if (blow < kMostStops && !strike(blade, dent.contact, dent.depth, motion)) break;
    if (blow == kMostStops || !is_valid(motion)) {
      motion.twist = {velocity_of(first, p_W), Vec3<Scalar>::Zero()};
      blow = kMostStops;
      break;
    }
  }
  if (blow > 0) keep_energy(blade, before, push, motion.twist);
  return blow > 0;
}

/// Out of one part after the other, the trunk last: what is between it and a limb is in the limb.
template <class Scalar>
Vec3<Scalar> Target<Scalar>::way_out(const Capsule<Scalar>& blade_B, const Pose<Scalar>& X0_WB,
                                     const Pose<Scalar>& X1_WB, PartMask parts) {
  Vec3<Scalar> way_W = batuta::detail::zero<Scalar>();
  BladeWay way = {to_world(X0_WB, blade_B), to_world(X1_WB, blade_B), Scalar(0), dt_};
  const PartMask reached = parts_in(
      batuta::detail::kdop_of<Scalar, kTargetK>(way.start.axis, way.end.axis, blade_B.radius),
      parts);
  if (reached == 0) return way_W;
  for (std::size_t i = kParts; i-- > 0;) {  // Bound: kBodyParts
    if ((reached >> i & 1U) == 0) continue;
    const Dent dent = dent_in(i, way);
    if (!(dent.depth > kCreep<Scalar> * dt_)) continue;
    const Vec3<Scalar> out_W = dent.depth * dent.contact.normal_BA_W;
    way.end.axis.a += out_W;
    way.end.axis.b += out_W;
    way_W += out_W;
  }
  return way_W;
}

/// Joins what the search of one part found to what is known of the parts before it.
template <class Scalar>
void Target<Scalar>::take(const PartSearch& search, TouchSearch<Scalar>& first) {
  const auto& [result, origin_W, part, from] = search;
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
  first.contact = contact_from(result.witness, origin_W);
  first.place = result.witness.axes.s;
}

#define BATUTA_INSTANTIATE(S) template class Target<S>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
