// SPDX-License-Identifier: MIT
#include "batuta/fencing/skeleton.hpp"

namespace batuta::fencing {
namespace {

constexpr std::size_t slot(BodyPart part) {
  return static_cast<std::size_t>(part);
}

template <class Scalar>
Vec3<Scalar> turned(const Quat<Scalar>& q, const Vec3<Scalar>& x) {
  return q * x;
}

/// Share of an arm's length at which its shoulder begins to come along: the elbow keeps a bend that
/// does not run through the arm at once.
template <class Scalar>
inline constexpr Scalar kNearlyStraight = Scalar(0.98F);

/// The shortest turn that carries the x axis of `q_WF` into the direction `x_W`. Unit x_W; straight
/// backwards: about z.
template <class Scalar>
Quat<Scalar> pointing(const Quat<Scalar>& q_WF, const Vec3<Scalar>& x_W) {
  const Vec3<Scalar> x_F = q_WF.conjugate() * x_W;
  const Quat<Scalar> twice(Scalar(1) + x_F.x(), Scalar(0), -x_F.z(), x_F.y());
  const bool backwards = !(twice.squaredNorm() > kRoundOff<Scalar>);
  const Quat<Scalar> half_turn(Scalar(0), Scalar(0), Scalar(0), Scalar(1));
  return detail::composed(q_WF, backwards ? half_turn : twice);
}

/// Direction of a vector; `otherwise` where it has none.
template <class Scalar>
Vec3<Scalar> direction_or(const Vec3<Scalar>& v, const Vec3<Scalar>& otherwise) {
  const Scalar length = v.norm();
  return length > Scalar(0) ? Vec3<Scalar>(v / length) : otherwise;
}

template <class Scalar>
Pose<Scalar> trunk_pose(const Vec3<Scalar>& p_W, const Quat<Scalar>& q_WF, Scalar lean) {
  const Vec3<Scalar> turn(Scalar(0), lean, Scalar(0));
  return {p_W, detail::composed(q_WF, exp_map(turn))};
}

/// The body while it is posed: bones in order, each on a bone that stands already.
template <class Scalar>
struct Posing {
  const FencerBuild<Scalar>& build;
  Pose<Scalar> X_WF;
  Scalar share;  ///< of a full lunge
  std::array<Pose<Scalar>, static_cast<std::size_t>(kBodyParts)> X_WJ{};

  Vec3<Scalar> start_of(BodyPart part) const {
    const auto parent = static_cast<std::size_t>(kBodyParent[slot(part)]);
    return to_world(X_WJ[parent], build.bones[slot(part)].start_P);
  }
  Scalar length_of(BodyPart part) const {
    return build.bones[slot(part)].capsule_J.axis.direction().norm();
  }

  void stand() {
    const Vec3<Scalar> hips =
        build.bones[slot(BodyPart::kPelvis)].start_P + share * build.lunge_shift_F;
    X_WJ[slot(BodyPart::kPelvis)] = {to_world(X_WF, hips), X_WF.q_WB};
    carry(BodyPart::kTorso, share * build.lunge_lean);
    carry(BodyPart::kHead, Scalar(0));  // the eyes stay on the opponent
  }
  /// Where a limb begins that has its bend up to `reach`, and then takes its root along.
  Vec3<Scalar> root_of(BodyPart first, const Vec3<Scalar>& goal_W, Scalar give,
                       Scalar reach) const {
    Vec3<Scalar> start = start_of(first);
    const Vec3<Scalar> way = goal_W - start;
    const Scalar distance = way.norm();
    if (!(distance > reach)) return start;
    return start + (min_of(distance - reach, give) / distance) * way;
  }
  void carry(BodyPart part, Scalar lean) {
    X_WJ[slot(part)] = trunk_pose(start_of(part), X_WF.q_WB, lean);
  }
  /// The limb whose first bone is `first` and whose second is the next one.
  /// @param give  how far its root comes along before the limb is straight, m
  void reach(BodyPart first, const Vec3<Scalar>& goal_W, const Vec3<Scalar>& bend_F,
             Scalar give = Scalar(0)) {
    const auto second = static_cast<BodyPart>(slot(first) + 1);
    const Vec2<Scalar> lengths(length_of(first), length_of(second));
    const Vec3<Scalar> start =
        root_of(first, goal_W, give, kNearlyStraight<Scalar> * lengths.sum());
    const Reach<Scalar> limb = two_bone_reach(start, goal_W, lengths, turned(X_WF.q_WB, bend_F));
    X_WJ[slot(first)] = {start,
                         pointing(X_WF.q_WB, Vec3<Scalar>((limb.middle - start) / lengths.x()))};
    X_WJ[slot(second)] = {
        limb.middle, pointing(X_WF.q_WB, Vec3<Scalar>((limb.end - limb.middle) / lengths.y()))};
  }
};

/// A bone where it is posed. Limbs begin at their joint: nothing is turned for that end.
template <class Scalar>
Capsule<Scalar> placed(const Pose<Scalar>& X_WJ, const Capsule<Scalar>& capsule_J) {
  const Segment<Scalar>& axis = capsule_J.axis;
  const bool begins_at_joint =
      axis.a.x() == Scalar(0) && axis.a.y() == Scalar(0) && axis.a.z() == Scalar(0);
  return {{begins_at_joint ? X_WJ.p_W : to_world(X_WJ, axis.a), to_world(X_WJ, axis.b)},
          capsule_J.radius};
}

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

/// Whether a limb can be posed: numbers in range, and two bones of some length, `first` and the
/// next.
template <class Scalar>
bool is_good(const FencerBuild<Scalar>& build, const Limb<Scalar>& limb, BodyPart first) {
  const Bone<Scalar>& upper = build.bones[slot(first)];
  const Bone<Scalar>& lower = build.bones[slot(first) + 1];
  return is_within_reach(limb.goal_F) && is_within_reach(limb.bend_F) &&
         is_positive(limb.bend_F.norm()) && is_positive(upper.capsule_J.axis.direction().norm()) &&
         is_positive(lower.capsule_J.axis.direction().norm());
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
  return bones && limbs && is_good_lunge(build) ? Status::kOk : Status::kInvalidArgument;
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
BodyShape<Scalar> pose_body(const FencerBuild<Scalar>& build, const Pose<Scalar>& X_WF,
                            const Pose<Scalar>& X_WH) {
  const Scalar share = lunge_share(build, to_body(X_WF, X_WH.p_W).x());
  Posing<Scalar> posing{build, X_WF, share};
  posing.stand();
  posing.reach(BodyPart::kWeaponUpperArm, X_WH.p_W, build.weapon_arm.bend_F, build.shoulder_give);
  posing.X_WJ[slot(BodyPart::kWeaponHand)] = {posing.start_of(BodyPart::kWeaponHand), X_WH.q_WB};
  const Vec3<Scalar> other_hand =
      to_world(posing.X_WJ[slot(BodyPart::kTorso)], build.other_arm.goal_F);
  posing.reach(BodyPart::kOtherUpperArm, other_hand, build.other_arm.bend_F);
  const Vec3<Scalar> front_foot = build.front_leg.goal_F + share * build.stride_F;
  posing.reach(BodyPart::kFrontThigh, to_world(X_WF, front_foot), build.front_leg.bend_F);
  posing.reach(BodyPart::kRearThigh, to_world(X_WF, build.rear_leg.goal_F), build.rear_leg.bend_F);

  BodyShape<Scalar> shape;
  for (std::size_t i = 0; i < shape.size(); ++i) {  // Bound: kBodyParts
    shape[i] = placed(posing.X_WJ[i], build.bones[i].capsule_J);
  }
  return shape;
}

#define BATUTA_INSTANTIATE(S)                                                      \
  template Status validate(const FencerBuild<S>&);                                 \
  template Reach<S> two_bone_reach(const Vec3<S>&, const Vec3<S>&, const Vec2<S>&, \
                                   const Vec3<S>&);                                \
  template S lunge_share(const FencerBuild<S>&, S);                                \
  template BodyShape<S> pose_body(const FencerBuild<S>&, const Pose<S>&, const Pose<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
