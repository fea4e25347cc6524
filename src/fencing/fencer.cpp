// SPDX-License-Identifier: MIT
#include "batuta/fencing/fencer.hpp"

// Data only: lengths in m, masses in kg, frame F (x towards the opponent, y to the fencer's left, z
// up). The tests check what the numbers are chosen for: the guards stand clear of the opponent, the
// blades overlap, a lunge arrives.

namespace batuta::fencing {
namespace {

/// A hand and where its blade points.
struct KeyData {
  float hand_F[3];
  float aim_F[3];  ///< the blade's direction, any length
};
using KeyTable = std::array<KeyData, 9>;

/// Row by row: back guard, guard, lunge; in a row: parry or line to the left, middle, to the right.
constexpr KeyTable kFirstKeys = {{{{0.28F, 0.27F, 1.18F}, {1.0F, -0.20F, 0.22F}},
                                  {{0.24F, -0.16F, 1.24F}, {1.0F, 0.10F, 0.36F}},
                                  {{0.28F, -0.36F, 1.14F}, {1.0F, -0.14F, 0.26F}},
                                  {{0.38F, 0.28F, 1.14F}, {1.0F, -0.26F, 0.14F}},
                                  {{0.42F, -0.14F, 1.12F}, {1.0F, 0.177F, 0.12F}},
                                  {{0.40F, -0.34F, 1.08F}, {1.0F, -0.10F, 0.18F}},
                                  {{1.18F, 0.12F, 1.30F}, {1.0F, -0.07F, 0.00F}},
                                  {{1.20F, -0.10F, 1.16F}, {1.0F, 0.095F, 0.02F}},
                                  {{1.18F, -0.32F, 1.00F}, {1.0F, 0.25F, 0.02F}}}};

constexpr KeyTable kSecondKeys = {{{{0.30F, 0.28F, 1.22F}, {1.0F, -0.20F, 0.20F}},
                                   {{0.26F, -0.16F, 1.28F}, {1.0F, 0.10F, 0.32F}},
                                   {{0.30F, -0.37F, 1.18F}, {1.0F, -0.14F, 0.24F}},
                                   {{0.40F, 0.29F, 1.18F}, {1.0F, -0.26F, 0.11F}},
                                   {{0.44F, -0.14F, 1.16F}, {1.0F, 0.182F, 0.08F}},
                                   {{0.42F, -0.35F, 1.12F}, {1.0F, -0.10F, 0.14F}},
                                   {{1.23F, 0.12F, 1.34F}, {1.0F, -0.07F, -0.03F}},
                                   {{1.25F, -0.10F, 1.20F}, {1.0F, 0.095F, -0.02F}},
                                   {{1.23F, -0.33F, 1.04F}, {1.0F, 0.25F, 0.00F}}}};

template <class Scalar>
Vec3<Scalar> vec(const float (&x)[3]) {
  return {Scalar(x[0]), Scalar(x[1]), Scalar(x[2])};
}

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
FencerBuild<Scalar> build_of(const Size<Scalar>& size, const KeyTable& keys) {
  FencerBuild<Scalar> build;
  set_bones(size, build);
  build.weapon_arm.bend_F = size.at(0, -0.6F, -1);
  build.other_arm = {size.at(-0.32F, 0.28F, 0.22F), size.at(0, 0.3F, -1)};
  build.front_leg = {size.at(0.35F, -0.10F, 0.08F), size.at(1, 0, 0)};
  build.rear_leg = {size.at(-0.36F, 0.12F, 0.08F), size.at(0.4F, 1, 0)};
  build.guard_hand_x = Scalar(keys[4].hand_F[0]);
  build.lunge_hand_x = Scalar(keys[7].hand_F[0]);
  build.lunge_shift_F = size.at(0.45F, 0, -0.25F);
  build.stride_F = size.at(0.65F, 0, 0);
  build.lunge_lean = Scalar(0.25F);
  return build;
}

template <class Scalar>
Pose<Scalar> key_pose(const KeyData& key) {
  const Vec3<Scalar> aim = vec<Scalar>(key.aim_F).normalized();
  // The shortest turn from x to the aim, which never points backwards.
  return {vec<Scalar>(key.hand_F),
          renewed(Quat<Scalar>(Scalar(1) + aim.x(), Scalar(0), -aim.z(), aim.y()))};
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
Fencer<Scalar> fencer_of(const KeyTable& keys, float size) {
  Fencer<Scalar> fencer;
  for (std::size_t i = 0; i < keys.size(); ++i) {  // Bound: nine keys
    fencer.keys_FH[i] = key_pose<Scalar>(keys[i]);
  }
  fencer.weapon = epee<Scalar>();
  fencer.build = build_of(Size<Scalar>{Scalar(size)}, keys);
  return fencer;
}

}  // namespace

template <class Scalar>
Fencer<Scalar> first_fencer() {
  return fencer_of<Scalar>(kFirstKeys, 1.0F);
}

template <class Scalar>
Fencer<Scalar> second_fencer() {
  return fencer_of<Scalar>(kSecondKeys, 1.04F);
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
