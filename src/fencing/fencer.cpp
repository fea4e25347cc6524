// SPDX-License-Identifier: MIT
#include "batuta/fencing/fencer.hpp"

#include "map_keys.hpp"

// Data only: lengths in m, masses in kg, frame F (x towards the opponent, y to the fencer's left, z
// up). The keys are in map_keys.hpp.

namespace batuta::fencing {
namespace {

constexpr std::size_t kGuardKey = 22;  ///< of the library's map: its centre
constexpr std::size_t kLungeKey = 40;  ///< of the same: the middle of its front
/// Where the hand is in guard and in a full lunge, x in F, m: lunges of all lines go as far to 2
/// cm.
constexpr float kGuardHandX = kLibraryKeys[kGuardKey].hand_F[0];
constexpr float kLungeHandX = kLibraryKeys[kLungeKey].hand_F[0];

/// A body of this size: 1 is 1.80 m tall.
template <class Scalar>
struct Size {
  Scalar scale;

  Vec3<Scalar> at(float x, float y, float z) const {
    return scale * Vec3<Scalar>(Scalar(x), Scalar(y), Scalar(z));
  }
  Bone<Scalar> trunk(const Vec3<Scalar>& start_P, const Segment<Scalar>& axis, float radius) const {
    return {start_P, {axis, scale * Scalar(radius)}};
  }
  [[gnu::noinline]] Bone<Scalar> limb(const Vec3<Scalar>& start_P, float length,
                                      float radius) const {
    return {start_P, {{at(0, 0, 0), at(length, 0, 0)}, scale * Scalar(radius)}};
  }
};

template <class Scalar>
void set_bones(const Size<Scalar>& size, FencerBuild<Scalar>& build) {
  const auto at = [&size](float x, float y, float z) { return size.at(x, y, z); };
  constexpr float kUpperArm = 0.30F;
  constexpr float kForearm = 0.28F;
  constexpr float kLeg = 0.45F;  // thigh and shin alike
  build.bones = {size.trunk(at(0, 0, 0.85F), {at(0, -0.07F, 0), at(0, 0.07F, 0)}, 0.13F),
                 size.trunk(at(0, 0, 0.12F), {at(0, 0, 0.04F), at(0, 0, 0.34F)}, 0.13F),
                 size.trunk(at(0.03F, 0, 0.50F), {at(0, 0, 0.06F), at(0, 0, 0.16F)}, 0.10F),
                 size.limb(at(0.12F, -0.12F, 0.40F), kUpperArm, 0.050F),
                 size.limb(at(kUpperArm, 0, 0), kForearm, 0.042F),
                 size.limb(at(kForearm, 0, 0), 0.07F, 0.045F),
                 size.limb(at(-0.10F, 0.15F, 0.40F), kUpperArm, 0.050F),
                 size.limb(at(kUpperArm, 0, 0), kForearm, 0.042F),
                 size.limb(at(0.05F, -0.10F, -0.05F), kLeg, 0.075F),
                 size.limb(at(kLeg, 0, 0), kLeg, 0.055F),
                 size.limb(at(-0.05F, 0.10F, -0.05F), kLeg, 0.075F),
                 size.limb(at(kLeg, 0, 0), kLeg, 0.055F)};
}

template <class Scalar>
FencerBuild<Scalar> build_of(const Size<Scalar>& size) {
  FencerBuild<Scalar> build;
  set_bones(size, build);
  build.weapon_arm.bend_F = size.at(0, -0.6F, -1);
  build.other_arm = {size.at(-0.32F, 0.28F, 0.22F), size.at(0, 0.3F, -1)};
  build.front_leg = {size.at(0.35F, -0.10F, 0.08F), size.at(1, 0, 0)};
  build.rear_leg = {size.at(-0.36F, 0.12F, 0.08F), size.at(0.4F, 1, 0)};
  build.guard_hand_x = Scalar(kGuardHandX);
  build.lunge_hand_x = Scalar(kLungeHandX);
  build.lunge_shift_F = size.at(0.45F, 0, -0.25F);
  build.stride_F = size.at(0.65F, 0, 0);
  build.lunge_lean = Scalar(0.25F);
  build.shoulder_give = size.scale * Scalar(0.14F);  // the trunk turns with the arm
  return build;
}

/// Sums to 0.77 kg: blade, guard, grip, pommel.
template <class Scalar>
Weapon<Scalar> epee() {
  const Size<Scalar> size{Scalar(1)};
  Weapon<Scalar> weapon;
  weapon.parts = {
      WeaponPart<Scalar>{{{size.at(0.10F, 0, 0), size.at(1.00F, 0, 0)}, Scalar(0.0045F)},
                         Scalar(0.24F)},
      WeaponPart<Scalar>{Capsule<Scalar>::sphere(size.at(0.07F, 0, 0), Scalar(0.062F)),
                         Scalar(0.20F)},
      WeaponPart<Scalar>{{{size.at(-0.08F, 0, 0), size.at(0.06F, 0, 0)}, Scalar(0.014F)},
                         Scalar(0.17F)},
      WeaponPart<Scalar>{Capsule<Scalar>::sphere(size.at(-0.10F, 0, 0), Scalar(0.012F)),
                         Scalar(0.16F)}};
  weapon.hand_H = {{size.at(-0.05F, 0, 0), size.at(0.03F, 0, 0)}, Scalar(0.04F)};
  weapon.restitution = Scalar(0.3F);
  return weapon;
}

template <class Scalar>
Fencer<Scalar> fencer_of(float size) {
  Fencer<Scalar> fencer;
  fencer.map = library_map<Scalar>();
  fencer.weapon = epee<Scalar>();
  fencer.build = build_of(Size<Scalar>{Scalar(size)});
  return fencer;
}

}  // namespace

template <class Scalar>
Fencer<Scalar> first_fencer() {
  return fencer_of<Scalar>(1.0F);
}

template <class Scalar>
Fencer<Scalar> second_fencer() {
  return fencer_of<Scalar>(1.04F);
}

template <class Scalar>
Pose<Scalar> Salle<Scalar>::X_WF(Side side, Scalar way) const {
  const Scalar half = distance / Scalar(2) - way;
  if (side == Side::kLeft) return {{-half, Scalar(0), Scalar(0)}, Quat<Scalar>::Identity()};
  const Quat<Scalar> facing_back(Scalar(0), Scalar(0), Scalar(0),
                                 Scalar(1));  // half a turn about z
  return {{half, Scalar(0), Scalar(0)}, facing_back};
}

#define BATUTA_INSTANTIATE(S)         \
  template Fencer<S> first_fencer();  \
  template Fencer<S> second_fencer(); \
  template struct Salle<S>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
