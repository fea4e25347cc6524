// SPDX-License-Identifier: MIT
#include "batuta/fencing/skeleton.hpp"

namespace batuta::fencing {
namespace {

constexpr std::size_t slot(BodyPart part) {
  return static_cast<std::size_t>(part);
}

/// Of a bone of a limb, m.
template <class Scalar>
Scalar length_of(const Bone<Scalar>& bone) {
  return bone.capsule_J.axis.b.x();
}

template <class Scalar>
Vec3<Scalar> turned(const Quat<Scalar>& q, const Vec3<Scalar>& x) {
  return q * x;
}

/// Share of an arm's length at which its shoulder begins to come along: the elbow keeps a bend that
/// does not run through the arm at once.
template <class Scalar>
inline constexpr Scalar kNearlyStraight = Scalar(0.98F);

/// Direction of a vector; `otherwise` where it has none.
template <class Scalar>
Vec3<Scalar> direction_or(const Vec3<Scalar>& v, const Vec3<Scalar>& otherwise) {
  const Scalar length = v.norm();
  return length > Scalar(0) ? Vec3<Scalar>(v / length) : otherwise;
}

template <class Scalar>
Pose<Scalar> trunk_pose(const Vec3<Scalar>& p_W, const Quat<Scalar>& q_WF, Scalar lean) {
  const Vec3<Scalar> turn(Scalar(0), lean, Scalar(0));
  return {p_W, batuta::detail::composed(q_WF, exp_map(turn))};
}

/// The body while it is posed: trunk first, then what it carries.
template <class Scalar>
struct Posing {
  const FencerBuild<Scalar>& build;
  const Pose<Scalar>& X_WF;
  Scalar share;  ///< of a full lunge
  BodyShape<Scalar>& shape;
  Pose<Scalar> pelvis{};  ///< X_WJ
  Pose<Scalar> torso{};   ///< X_WJ

  const Bone<Scalar>& bone(BodyPart part) const { return build.bones[slot(part)]; }

  void stand() {
    const Vec3<Scalar> hips = bone(BodyPart::kPelvis).start_P + share * build.lunge_shift_F;
    pelvis = {to_world(X_WF, hips), X_WF.q_WB};
    torso = trunk_pose(to_world(pelvis, bone(BodyPart::kTorso).start_P), X_WF.q_WB,
                       share * build.lunge_lean);
    put(BodyPart::kPelvis, pelvis);
    put(BodyPart::kTorso, torso);
    // The eyes stay on the opponent.
    put(BodyPart::kHead, {to_world(torso, bone(BodyPart::kHead).start_P), X_WF.q_WB});
  }
  void put(BodyPart part, const Pose<Scalar>& X_WJ) {
    shape[slot(part)] = to_world(X_WJ, bone(part).capsule_J);
  }
  /// Where a limb begins that has its bend up to `reach`, and then takes its root along.
  Vec3<Scalar> root_of(const Vec3<Scalar>& start, const Vec3<Scalar>& goal_W, Scalar give,
                       Scalar reach) const {
    const Vec3<Scalar> way = goal_W - start;
    const Scalar distance = way.norm();
    if (!(distance > reach)) return start;
    return start + (min_of(distance - reach, give) / distance) * way;
  }
  /// The limb whose first bone is `first` and whose second is the next one.
  /// @param carrier  X_WJ of the bone that it begins on
  /// @param give     how far its root comes along before the limb is straight, m
  /// @returns where it ends, W
  Vec3<Scalar> reach(BodyPart first, const Pose<Scalar>& carrier, const Vec3<Scalar>& goal_W,
                     const Vec3<Scalar>& bend_F, Scalar give = Scalar(0)) {
    const auto second = static_cast<BodyPart>(slot(first) + 1);
    const Vec2<Scalar> lengths(length_of(bone(first)), length_of(bone(second)));
    const Vec3<Scalar> start = root_of(to_world(carrier, bone(first).start_P), goal_W, give,
                                       kNearlyStraight<Scalar> * lengths.sum());
    const Reach<Scalar> limb = two_bone_reach(start, goal_W, lengths, turned(X_WF.q_WB, bend_F));
    shape[slot(first)] = {{start, limb.middle}, bone(first).capsule_J.radius};
    shape[slot(second)] = {{limb.middle, limb.end}, bone(second).capsule_J.radius};
    return limb.end;
  }
};

template <class Scalar>
bool is_within_reach(const Vec3<Scalar>& x) {
  return is_finite(x) && x.cwiseAbs().maxCoeff() <= kLargestReach<Scalar>;
}

template <class Scalar>
bool is_good(const Bone<Scalar>& bone) {
  const Segment<Scalar>& axis = bone.capsule_J.axis;
  return is_valid(bone.capsule_J) && bone.capsule_J.radius <= kLargestReach<Scalar> &&
         is_within_reach(bone.start_P) && is_within_reach(axis.a) && is_within_reach(axis.b);
}

/// Whether a bone of a limb lies along x, from the origin.
template <class Scalar>
bool lies_along_x(const Bone<Scalar>& bone) {
  const Segment<Scalar>& axis = bone.capsule_J.axis;
  return axis.a == batuta::detail::zero<Scalar>() && is_positive(axis.b.x()) &&
         axis.b.y() == Scalar(0) && axis.b.z() == Scalar(0);
}

/// Whether a limb can be posed: numbers in range, and two bones of some length, `first` and the
/// next, which begins where that one ends.
template <class Scalar>
bool is_good(const FencerBuild<Scalar>& build, const Limb<Scalar>& limb, BodyPart first) {
  const Bone<Scalar>& upper = build.bones[slot(first)];
  const Bone<Scalar>& lower = build.bones[slot(first) + 1];
  return is_within_reach(limb.goal_F) && is_within_reach(limb.bend_F) &&
         is_positive(limb.bend_F.norm()) && lies_along_x(upper) && lies_along_x(lower) &&
         lower.start_P == upper.capsule_J.axis.b;
}

template <class Scalar>
bool is_good_lunge(const FencerBuild<Scalar>& build) {
  return is_within_reach(Vec3<Scalar>(build.guard_hand_x, build.lunge_hand_x, Scalar(0))) &&
         build.lunge_hand_x > build.guard_hand_x && is_within_reach(build.lunge_shift_F) &&
         is_within_reach(build.stride_F) && build.shoulder_give >= Scalar(0) &&
         build.shoulder_give <= kLargestReach<Scalar> && build.lunge_lean >= Scalar(-1) &&
         build.lunge_lean <= Scalar(1);
}

}  // namespace

template <class Scalar>
Status validate(const FencerBuild<Scalar>& build) {
  bool bones = true;
  for (const Bone<Scalar>& bone : build.bones) bones = bones && is_good(bone);  // Bound: kBodyParts
  const bool limbs = is_good(build, build.weapon_arm, BodyPart::kWeaponUpperArm) &&
                     is_good(build, build.other_arm, BodyPart::kOtherUpperArm) &&
                     is_good(build, build.front_leg, BodyPart::kFrontThigh) &&
                     is_good(build, build.rear_leg, BodyPart::kRearThigh);
  const bool hand = build.bones[slot(BodyPart::kWeaponHand)].start_P ==
                    build.bones[slot(BodyPart::kWeaponForearm)].capsule_J.axis.b;
  return bones && limbs && hand && is_good_lunge(build) ? Status::kOk : Status::kInvalidArgument;
}

const char* name_of(BodyPart part) {
  static constexpr std::array<const char*, kBodyParts> kNames = {
      "pelvis",    "torso",   "head",        "weapon upper arm", "weapon forearm", "weapon hand",
      "upper arm", "forearm", "front thigh", "front shin",       "rear thigh",     "rear shin"};
  if (slot(part) >= kNames.size()) return "unknown";
  return kNames[slot(part)];
}

template <class Scalar>
Reach<Scalar> two_bone_reach(const Vec3<Scalar>& start, const Vec3<Scalar>& goal,
                             const Vec2<Scalar>& lengths, const Vec3<Scalar>& bend) {
  const Vec3<Scalar> way = goal - start;
  const Scalar asked = way.norm();
  const Vec3<Scalar> along = direction_or(way, direction_or<Scalar>(bend, Vec3<Scalar>::UnitX()));
  const Scalar longest = lengths.x() + lengths.y();
  const Scalar shortest =
      lengths.x() < lengths.y() ? lengths.y() - lengths.x() : lengths.x() - lengths.y();
  const Scalar distance = clamp(asked, shortest, longest);

  // Foot of the middle joint on the line to the goal, by the law of cosines; its height by
  // Pythagoras, factored.
  const Scalar a = lengths.x();
  const Scalar foot = distance > Scalar(0)
                          ? (distance + (a - lengths.y()) * (longest / distance)) / Scalar(2)
                          : Scalar(0);
  const Scalar height = std::sqrt(max_of((a - foot) * (a + foot), Scalar(0)));
  const Vec3<Scalar> any = along.unitOrthogonal();
  const Vec3<Scalar> aside = direction_or<Scalar>(bend - bend.dot(along) * along, any);

  Reach<Scalar> limb;
  limb.middle = start + foot * along + height * aside;
  limb.end = start + distance * along;
  limb.in_reach = distance == asked;
  return limb;
}

template <class Scalar>
Scalar lunge_share(const FencerBuild<Scalar>& build, Scalar hand_x_F) {
  const Scalar way = build.lunge_hand_x - build.guard_hand_x;
  return clamp((hand_x_F - build.guard_hand_x) / way, Scalar(0), Scalar(1));
}

template <class Scalar>
void pose_body(const FencerBuild<Scalar>& build, const Stance<Scalar>& stance,
               BodyShape<Scalar>& shape) {
  const auto& [X_WF, X_WH] = stance;
  const Scalar share = lunge_share(build, to_body(X_WF, X_WH.p_W).x());
  Posing<Scalar> posing{build, X_WF, share, shape};
  posing.stand();
  const Vec3<Scalar> wrist = posing.reach(BodyPart::kWeaponUpperArm, posing.torso, X_WH.p_W,
                                          build.weapon_arm.bend_F, build.shoulder_give);
  posing.put(BodyPart::kWeaponHand, {wrist, X_WH.q_WB});
  (void)posing.reach(BodyPart::kOtherUpperArm, posing.torso,
                     to_world(posing.torso, build.other_arm.goal_F), build.other_arm.bend_F);
  const Vec3<Scalar> front_foot = build.front_leg.goal_F + share * build.stride_F;
  (void)posing.reach(BodyPart::kFrontThigh, posing.pelvis, to_world(X_WF, front_foot),
                     build.front_leg.bend_F);
  (void)posing.reach(BodyPart::kRearThigh, posing.pelvis, to_world(X_WF, build.rear_leg.goal_F),
                     build.rear_leg.bend_F);
}

template <class Scalar>
BodyShape<Scalar> pose_body(const FencerBuild<Scalar>& build, const Pose<Scalar>& X_WF,
                            const Pose<Scalar>& X_WH) {
  BodyShape<Scalar> shape;
  pose_body(build, {X_WF, X_WH}, shape);
  return shape;
}

#define BATUTA_INSTANTIATE(S)                                                      \
  template Status validate(const FencerBuild<S>&);                                 \
  template Reach<S> two_bone_reach(const Vec3<S>&, const Vec3<S>&, const Vec2<S>&, \
                                   const Vec3<S>&);                                \
  template S lunge_share(const FencerBuild<S>&, S);                                \
  template void pose_body(const FencerBuild<S>&, const Stance<S>&, BodyShape<S>&); \
  template BodyShape<S> pose_body(const FencerBuild<S>&, const Pose<S>&, const Pose<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
