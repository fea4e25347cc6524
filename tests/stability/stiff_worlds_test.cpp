// SPDX-License-Identifier: MIT
// Worlds and duels of stiff pairs: masses up to 1e9 apart, moments up to 1e6, any restitution and
// friction, grips at the ends of their strength and time. Everybody stays a number and apart from
// the others, and without gravity energy never grows but by rounding.
#include <gtest/gtest.h>

#include <memory>

#include "batuta/fencing/duel.hpp"
#include "draws.hpp"
#include "resting.hpp"

namespace batuta {
using namespace fencing;
namespace {

constexpr SceneOptions stiff_gas_options() {
  SceneOptions scene = test::rest_scene_options();
  scene.max_bodies = 9;
  scene.max_pairs = 36;
  scene.gravity = false;
  scene.friction = true;
  return scene;
}
template <class S>
using StiffGas = Scene<stiff_gas_options, Advancement<S>, test::FreeOrHand<S>>;

constexpr int kRods = 3;

/// How three rods are made, and what they do to each other and to the walls.
struct Stiffness {
  double mass_ratio = 1;  ///< of the second one to the two others
  double anisotropy = 1;  ///< of the moments across and along
  double restitution = 0;
  double friction = 0;
};

/// A closed box of 1 m: six balls so large that they overlap at its edges.
template <class SceneT>
void add_walls(World<SceneT>& world, const Stiffness& how) {
  using S = typename SceneT::Scalar;
  constexpr double kRadius = 4;
  for (int k = 0; k < 6; ++k) {
    Vec3<double> place = Vec3<double>::Zero();
    place(k / 2) = (k % 2 == 0 ? 1 : -1) * (kRadius + 0.5);
    Actor<SceneT> wall = test::ball_at<SceneT>(place, kRadius);
    wall.body.inverse_mass = 0;
    wall.body.inverse_moments.setZero();
    wall.restitution = static_cast<S>(how.restitution);
    wall.friction = static_cast<S>(how.friction);
    ASSERT_TRUE(world.add(wall).ok());
  }
}

/// Rods along z, with the moments that are asked for: needles, balls or anything.
template <class SceneT>
void add_rods(World<SceneT>& world, const Stiffness& how, std::uint64_t number) {
  using S = typename SceneT::Scalar;
  test::Draws draw(9, 0, number);
  for (int k = 0; k < kRods; ++k) {
    auto rod = test::rod_at<SceneT>({0.2 * k - 0.2, 0, 0}, Vec3<double>::UnitZ());
    rod.capsule_B = {{test::vector<S>(0, 0, -0.1), test::vector<S>(0, 0, 0.1)}, S(0.04)};
    const double mass = k == 1 ? how.mass_ratio : 1;
    const double across = 0.005 * mass;
    const Vec3<S> moments = test::vector<S>(across, across, across / how.anisotropy);
    rod.body = make_body<S>(rod.body.X_WB, static_cast<S>(mass), moments).value;
    const Vec3<double> momentum = 3 * mass * draw.direction();
    const Vec3<double> spin = 0.05 * mass * draw.direction();
    rod.body.momentum.linear_W = momentum.cast<S>();
    // Across mostly: along its axis a needle would turn 1e6 times as fast.
    rod.body.momentum.angular_W = test::vector<S>(spin.x(), spin.y(), spin.z() / how.anisotropy);
    rod.restitution = static_cast<S>(how.restitution);
    rod.friction = static_cast<S>(how.friction);
    ASSERT_TRUE(world.add(rod).ok());
  }
}

/// Energy, and what its rounding is measured by: the energy if all spin were about the softest axis
/// [a tilt of u of the axis moves as much].
struct Energy {
  double now = 0;
  double size = 0;
};
template <class SceneT>
Energy energy_of(const World<SceneT>& world) {
  Energy sum;
  for (int k = 0; k < kRods; ++k) {
    const auto& body = test::body_in(world, k).body;
    const Vec3<double> p = body.momentum.linear_W.template cast<double>();
    const Vec3<double> b = body.momentum.angular_W.template cast<double>();
    const Quat<double> q = body.X_WB.q_WB.template cast<double>();
    const Vec3<double> b_B = q.normalized().conjugate() * b;
    const Vec3<double> inverse = body.inverse_moments.template cast<double>();
    const double moving = static_cast<double>(body.inverse_mass) * p.squaredNorm();
    sum.now += (moving + inverse.dot(Vec3<double>(b_B.cwiseProduct(b_B)))) / 2;
    sum.size += (moving + inverse.maxCoeff() * b.squaredNorm()) / 2;
  }
  return sum;
}

constexpr double kStep = 5e-3;  // s
constexpr double kD = 1e-4;     // m, as the scene has it

/// How far ends of rods go in a step, summed, m.
template <class SceneT>
double way_of(const World<SceneT>& world) {
  double sum = 0;
  for (int k = 0; k < kRods; ++k) {
    const auto twist = twist_of(test::body_in(world, k).body);
    sum += kStep *
           (static_cast<double>(twist.v_W.norm()) + 0.14 * static_cast<double>(twist.w_W.norm()));
  }
  return sum;
}

template <class S>
class StiffWorlds : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(StiffWorlds, Scalars);

/// A blow, or a step of a turning body, rounds momenta and velocities some tens of times.
template <class S>
const double kGainOfARounding = 64 * static_cast<double>(kRoundOff<S>);

template <class S>
int run(const Stiffness& how, std::uint64_t number) {
  using SceneT = StiffGas<S>;
  auto world = std::make_unique<World<SceneT>>();
  add_rods(*world, how, number);
  add_walls(*world, how);
  Energy before = energy_of(*world);
  double way = way_of(*world);
  int collisions = 0;
  for (int step = 0; step < 150; ++step) {
    EXPECT_EQ(world->step(static_cast<S>(kStep)), Status::kOk);
    const auto& report = world->report();
    collisions += static_cast<int>(report.collisions);
    const Energy after = energy_of(*world);
    const double size = std::max(before.size, after.size);
    // A velocity that moves nothing by a digit of D in a step is none.
    const double least = 8 * static_cast<double>(kRoundOff<S>) * kD / kStep;
    const double allowed = kGainOfARounding<S> * (1 + report.collisions) * size +
                           how.mass_ratio * least * least + 2 * least * least;
    EXPECT_LE(after.now - before.now, allowed) << "step " << step;
    EXPECT_TRUE(is_finite(after.now));
    // Beside walls of 4 m, lengths add up to less than 10 m, and to the ways of the step.
    EXPECT_LE(static_cast<double>(report.deepest_overlap),
              test::margin<S>(10 + way + way_of(*world)))
        << "step " << step;
    way = way_of(*world);
    before = after;
  }
  return collisions;
}

TYPED_TEST(StiffWorlds, AnyMassRatioInertiaAndLaw_GainNoEnergy) {
  int collisions = 0;
  std::uint64_t number = 0;
  for (const double ratio : {1e-9, 1e-3, 1.0, 1e3, 1e9}) {
    for (const double anisotropy : {1.0, 1e3, 1e6}) {
      for (const double restitution : {0.0, 0.5, 1.0}) {
        for (const double friction : {0.0, 0.5, 1e6}) {
          SCOPED_TRACE(::testing::Message() << "masses " << ratio << " moments " << anisotropy
                                            << " C " << restitution << " mu " << friction);
          collisions += run<TypeParam>({ratio, anisotropy, restitution, friction}, number++);
        }
      }
    }
  }
  EXPECT_GT(collisions, 2000);
}

/// A fencer's weapon so many times as heavy.
template <class S>
Fencer<S> heavier(Fencer<S> fencer, double times, double restitution) {
  fencer.weapon.mass *= static_cast<S>(times);
  fencer.weapon.moments *= static_cast<S>(times);
  fencer.weapon.restitution = static_cast<S>(restitution);
  return fencer;
}

/// How far a blade may be in the other one where it has been turned back, m: the margin of lengths
/// of 3 m (src/world/detail/margin.md).
template <class S>
constexpr S kTurnedBack = S(std::is_same_v<S, float> ? 7e-5 : 1e-5);

/// Blades thrown at each other for a second; they never overlap. @returns blows and rests
template <class S>
std::uint32_t fence(const Fencer<S>& left, const Fencer<S>& right) {
  auto duel = std::make_unique<Duel<DuelScene<two_fencers, Advancement<S>>>>();
  auto settings = duel_settings<DuelScene<two_fencers, Advancement<S>>>();
  settings.target = 0;  // nobody is touched: the bout goes on
  EXPECT_EQ(duel->configure(settings, left, right), Status::kOk);
  for (std::uint32_t k = 0; k < 1000; ++k) {
    InputSample sample;
    sample.time = 1000U * k;
    sample.x = k / 120 % 2 == 0 ? -0.9F : 0.9F;
    sample.y = 0.4F;  // arms half out, through each other
    EXPECT_EQ(duel->step(&sample, &sample), Status::kOk);
    const auto A = duel->blade_W(Side::kLeft);
    const auto B = duel->blade_W(Side::kRight);
    EXPECT_TRUE(is_valid(A) && is_valid(B)) << k;
    EXPECT_GT(capsule_gap(A, B).gap, -kTurnedBack<S>) << k;
  }
  EXPECT_EQ(duel->report().searches_invalid, 0U);
  return duel->report().blows + duel->report().rests;
}

TYPED_TEST(StiffWorlds, DuelOfWeaponsOfAnyMass_BladesStayApart) {
  using S = TypeParam;
  for (const double root : {1.0, 1e-2, 30.0, 3.2e4}) {  // ratios of 1e-4 ... 1e9
    for (const double restitution : {0.0, 0.5, 1.0}) {
      SCOPED_TRACE(::testing::Message() << "masses " << root * root << " C " << restitution);
      const auto contacts = fence(heavier(first_fencer<S>(), root, restitution),
                                  heavier(second_fencer<S>(), 1 / root, restitution));
      EXPECT_GT(contacts, 0U);
    }
  }
}

TYPED_TEST(StiffWorlds, GripsAtTheEndsOfStrengthAndTime_BladesStayApart) {
  using S = TypeParam;
  for (const double strength : {1e-9, 1.0, 1e9}) {
    for (const double time : {1e-6, 0.02, 1e3}) {
      for (const double recover : {1e-6, 0.1, 1e3}) {
        SCOPED_TRACE(::testing::Message() << strength << " N, N m " << time << " s " << recover);
        auto left = first_fencer<S>();
        left.grip.force = left.grip.torque = static_cast<S>(strength);
        left.grip.composure = left.grip.settle_torque = static_cast<S>(1 / strength);
        left.grip.min_regain = static_cast<S>(time);
        left.grip.max_regain = static_cast<S>(max_of(time, 0.4));
        left.grip.recover_time = static_cast<S>(recover);
        EXPECT_GT(fence(left, second_fencer<S>()), 0U);
      }
    }
  }
}

}  // namespace
}  // namespace batuta
