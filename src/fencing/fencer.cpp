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

  [[gnu::noinline]] Vec3<Scalar> at(float x, float y, float z) const {
    return scale * Vec3<Scalar>(Scalar(x), Scalar(y), Scalar(z));
  }
  Vec3<Scalar> at(const std::array<float, 3>& x) const { return at(x[0], x[1], x[2]); }
};

/// A bone of a body of size 1: where it starts, its axis from there, and its radius, m.
struct BoneOfOne {
  std::array<float, 3> start_P;
  std::array<float, 3> from_J;
  std::array<float, 3> to_J;
  float radius;
};

constexpr float kUpperArm = 0.30F;
constexpr float kForearm = 0.28F;
constexpr float kLeg = 0.45F;  // thigh and shin alike
constexpr std::array<BoneOfOne, static_cast<std::size_t>(kBodyParts)> kBones = {{
    {{0, 0, 0.85F}, {0, -0.07F, 0}, {0, 0.07F, 0}, 0.13F},
    {{0, 0, 0.12F}, {0, 0, 0.04F}, {0, 0, 0.34F}, 0.13F},
    {{0.03F, 0, 0.50F}, {0, 0, 0.06F}, {0, 0, 0.16F}, 0.10F},
    {{0.12F, -0.12F, 0.40F}, {0, 0, 0}, {kUpperArm, 0, 0}, 0.050F},
    {{kUpperArm, 0, 0}, {0, 0, 0}, {kForearm, 0, 0}, 0.042F},
    {{kForearm, 0, 0}, {0, 0, 0}, {0.07F, 0, 0}, 0.045F},
    {{-0.10F, 0.15F, 0.40F}, {0, 0, 0}, {kUpperArm, 0, 0}, 0.050F},
    {{kUpperArm, 0, 0}, {0, 0, 0}, {kForearm, 0, 0}, 0.042F},
    {{0.05F, -0.10F, -0.05F}, {0, 0, 0}, {kLeg, 0, 0}, 0.075F},
    {{kLeg, 0, 0}, {0, 0, 0}, {kLeg, 0, 0}, 0.055F},
    {{-0.05F, 0.10F, -0.05F}, {0, 0, 0}, {kLeg, 0, 0}, 0.075F},
    {{kLeg, 0, 0}, {0, 0, 0}, {kLeg, 0, 0}, 0.055F},
}};

template <class Scalar>
void set_bones(const Size<Scalar>& size, FencerBuild<Scalar>& build) {
  for (std::size_t i = 0; i < kBones.size(); ++i) {  // Bound: kBodyParts
    const BoneOfOne& bone = kBones[i];
    build.bones[i] = {
        size.at(bone.start_P),
        {{size.at(bone.from_J), size.at(bone.to_J)}, size.scale * Scalar(bone.radius)}};
  }
}

template <class Scalar>
void set_build(const Size<Scalar>& size, FencerBuild<Scalar>& build) {
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
}

/// Of epee(): what weapon_body() makes of it, which a test compares to the last bit. So a firmware
/// does not need the code that adds up masses and finds principal axes.
template <class Scalar>
struct EpeeMass {
  Scalar mass;        ///< kg
  Scalar axial;       ///< moment about x, kg m^2
  Scalar transverse;  ///< about y and z
  Scalar center_H;    ///< x of the centre of mass, m
};
template <class Scalar>
constexpr EpeeMass<Scalar> kEpeeMass = {0.769999921F, 0.000335430988F, 0.0709207654F, 0.166623354F};
template <>
constexpr EpeeMass<double> kEpeeMass<double> = {0.76999999582767487, 0.00033543077683579519,
                                                0.070920776887975212, 0.16662337445602293};

/// A capsule along x.
struct AlongX {
  float from_H;
  float to_H;
  float radius;

  template <class Scalar>
  [[gnu::noinline]] Capsule<Scalar> less(Scalar x) const {
    return {{{Scalar(from_H) - x, Scalar(0), Scalar(0)}, {Scalar(to_H) - x, Scalar(0), Scalar(0)}},
            Scalar(radius)};
  }
};

constexpr AlongX kBlade = {0.10F, 1.00F, 0.0045F};
constexpr AlongX kBell = {0.07F, 0.07F, 0.062F};
constexpr AlongX kGripPart = {-0.08F, 0.06F, 0.014F};
constexpr AlongX kPommel = {-0.10F, -0.10F, 0.012F};
constexpr AlongX kHand = {-0.05F, 0.03F, 0.04F};
constexpr float kBounce = 0.3F;

template <class Scalar>
void set_weapon(WeaponBody<Scalar>& weapon) {
  const EpeeMass<Scalar>& of = kEpeeMass<Scalar>;
  weapon.mass = of.mass;
  weapon.moments = {of.axial, of.transverse, of.transverse};
  weapon.X_HB.p_W.x() = of.center_H;
  weapon.blade_B = kBlade.less(of.center_H);
  weapon.guard_B = kBell.less(of.center_H);
  weapon.hand_B = kHand.less(of.center_H);
  weapon.restitution = Scalar(kBounce);
}

template <class Scalar>
Fencer<Scalar> fencer_of(float size) {
  Fencer<Scalar> fencer;
  fencer.map = library_map<Scalar>();
  set_weapon(fencer.weapon);
  set_build(Size<Scalar>{Scalar(size)}, fencer.build);
  return fencer;
}

}  // namespace

template <class Scalar>
Weapon<Scalar> epee() {
  const auto part = [](const AlongX& shape, float mass) {
    return WeaponPart<Scalar>{shape.less(Scalar(0)), Scalar(mass)};
  };
  Weapon<Scalar> weapon;
  weapon.parts = {part(kBlade, 0.24F), part(kBell, 0.20F), part(kGripPart, 0.17F),
                  part(kPommel, 0.16F)};
  weapon.hand_H = kHand.less(Scalar(0));
  weapon.restitution = Scalar(kBounce);
  return weapon;
}

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
  template Weapon<S> epee();          \
  template Fencer<S> first_fencer();  \
  template Fencer<S> second_fencer(); \
  template struct Salle<S>;
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
