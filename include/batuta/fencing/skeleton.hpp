// SPDX-License-Identifier: MIT
#pragma once
// A fencer's body as capsules on bones, posed by where the weapon hand is: the trunk advances and
// leans, arms and legs reach for hands and feet. Frames: W world; F fencer: origin on the floor
// below the pelvis in guard, x towards the opponent, y to the left, z up; J a bone: trunk bones
// have the axes of F when upright, limbs have x along the limb. Mathematics: src/fencing/target.md.

#include <array>

#include "batuta/mechanics/body.hpp"

namespace batuta::fencing {

/// The bones of a fencer, each a capsule.
enum class BodyPart : std::uint8_t {
  kPelvis,          ///< the root
  kTorso,           ///< leans in a lunge
  kHead,            ///< on the torso
  kWeaponUpperArm,  ///< of the arm that holds the weapon
  kWeaponForearm,   ///< of the same arm
  kWeaponHand,      ///< turned as the key poses say
  kOtherUpperArm,   ///< of the arm behind
  kOtherForearm,    ///< of the same arm
  kFrontThigh,      ///< of the leg that lunges
  kFrontShin,       ///< of the same leg
  kRearThigh,       ///< of the leg that stays
  kRearShin,        ///< of the same leg
};
/// How many there are.
inline constexpr int kBodyParts = 12;

/// Lower case, for people; never null.
const char* name_of(BodyPart part);

/// A bone of a fencer's build.
template <class Scalar>
struct Bone {
  /// Where it begins, in the frame of its parent, m. The second bone of a limb, and the weapon
  /// hand: where the bone before ends.
  Vec3<Scalar> start_P = Vec3<Scalar>::Zero();
  Capsule<Scalar> capsule_J;  ///< a limb's: from the origin along +x
};

/// What a limb of two bones reaches for, and where its middle joint gives way to.
template <class Scalar>
struct Limb {
  Vec3<Scalar> goal_F = Vec3<Scalar>::Zero();  ///< in guard; the weapon arm's is the hand instead
  Vec3<Scalar> bend_F = Vec3<Scalar>::Zero();  ///< direction of elbow or knee
};

/// No length or coordinate of a fencer is beyond this, m: so no sum of them overflows, whatever is
/// reached for.
template <class Scalar>
inline constexpr Scalar kLargestReach = Scalar(1000);

/// A body as data. Lengths in m.
template <class Scalar>
struct FencerBuild {
  std::array<Bone<Scalar>, kBodyParts> bones;  ///< by BodyPart
  Limb<Scalar> weapon_arm;                     ///< its goal is the hand, from the key poses
  Limb<Scalar> other_arm;   ///< goal relative to the torso's frame: the arm is carried along
  Limb<Scalar> front_leg;   ///< carried forward by a lunge
  Limb<Scalar> rear_leg;    ///< its foot stays where it is
  Scalar guard_hand_x = 0;  ///< x of the hand in F at which the trunk stands as in guard
  Scalar lunge_hand_x = 1;  ///< and at which the lunge is full; > guard_hand_x
  Vec3<Scalar> lunge_shift_F = Vec3<Scalar>::Zero();  ///< of the pelvis in a full lunge
  Vec3<Scalar> stride_F = Vec3<Scalar>::Zero();       ///< of the front foot in a full lunge
  Scalar lunge_lean = 0;  ///< of the torso in a full lunge, forward, rad, |lean| <= 1
  /// So far the shoulder of the weapon arm goes along with the hand before the arm is straight, >=
  /// 0
  Scalar shoulder_give = 0;
};

/// @returns kOk | kInvalidArgument: not finite or beyond kLargestReach, a capsule that is not
/// valid, a bone of a limb without length or elsewhere than Bone says, a bend of zero, lunge_hand_x
/// <= guard_hand_x, |lunge_lean| > 1, or a negative shoulder_give. Bound: kBodyParts bones.
template <class Scalar>
Status validate(const FencerBuild<Scalar>& build);

/// A body at one instant, in W.
template <class Scalar>
using BodyShape = std::array<Capsule<Scalar>, static_cast<std::size_t>(kBodyParts)>;

/// A limb of two bones.
template <class Scalar>
struct Reach {
  Vec3<Scalar> middle = Vec3<Scalar>::Zero();  ///< elbow or knee
  /// The goal, or the point in its direction that can be reached
  Vec3<Scalar> end = Vec3<Scalar>::Zero();
  bool in_reach = true;  ///< the goal could be reached
};

/// Two bones of given lengths from `start` to `goal`, the middle joint on the side of `bend`.
/// Closed form, one square root for each side of the triangle. Beyond reach the limb is straight;
/// too close it is folded.
/// @param lengths  of the first and the second bone, > 0
/// @pre finite; bend not zero
/// Bound: no loop. Both lengths are kept to rounding.
template <class Scalar>
Reach<Scalar> two_bone_reach(const Vec3<Scalar>& start, const Vec3<Scalar>& goal,
                             const Vec2<Scalar>& lengths, const Vec3<Scalar>& bend);

/// The share of a full lunge that a hand position means, 0 ... 1.
template <class Scalar>
Scalar lunge_share(const FencerBuild<Scalar>& build, Scalar hand_x_F);

/// What a body's pose follows from.
template <class Scalar>
struct Stance {
  Pose<Scalar> X_WF;  ///< where the feet are
  Pose<Scalar> X_WH;  ///< where the hand is
};

/// The whole body for a hand pose (H: x along the blade).
/// @pre `build` as validate() asks for; both poses finite, no position beyond 2 kLargestReach
/// Bound: one forward pass over kBodyParts bones.
template <class Scalar>
BodyShape<Scalar> pose_body(const FencerBuild<Scalar>& build, const Pose<Scalar>& X_WF,
                            const Pose<Scalar>& X_WH);
/// The same, written where it is kept.
template <class Scalar>
void pose_body(const FencerBuild<Scalar>& build, const Stance<Scalar>& stance,
               BodyShape<Scalar>& shape);

}  // namespace batuta::fencing
