// SPDX-License-Identifier: MIT
// Law 2 over a thousand contacts: a gas of rods and balls that a central force keeps together has
// the angular momentum that it had, but for what the force gave (summed here) and what separations
// took. What those take is derived in world.md, "Separation", and summed here from the shifts that
// controllers are told: s x p of each body.
#include <gtest/gtest.h>

#include "draws.hpp"
#include "law_worlds.hpp"

namespace batuta {

namespace test {

/// Flies freely, and sums what the separations of its body have changed.
template <class S>
struct Watcher : FreeFlight<S> {
  Vec3<double> turned = Vec3<double>::Zero();   ///< of the angular momentum about the origin
  Vec3<double> shifted = Vec3<double>::Zero();  ///< m s, kg m
  int shifts = 0;

  void on_contact(const Body<S>& body, const Feedback<S>& feedback) {
    const Vec3<double> s = feedback.shift_W.template cast<double>();
    turned += s.cross(body.momentum.linear_W.template cast<double>());
    shifted += s / static_cast<double>(body.inverse_mass);
    shifts += s.isZero(0) ? 0 : 1;
  }
};

}  // namespace test

template <class S>
struct MovesByMomentumOnly<test::Watcher<S>> : std::true_type {};

namespace {

using test::Sums;
using test::Vector;

constexpr std::uint16_t kBodies = 12;
constexpr double kPull = 40;  ///< of the force over mass and distance, 1/s^2

constexpr test::LawFeatures kGas = {false, false, false, 1, 12};
template <class S, RestingContact kRests>
using GasScene = Scene<test::law_options<kRests, kGas>, Advancement<S>, test::Watcher<S>>;

template <class S>
class Gas : public ::testing::Test {};
using Scalars = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Gas, Scalars);

template <class SceneT>
class ClosedGas {
 public:
  using S = typename SceneT::Scalar;
  static constexpr double kU = static_cast<double>(kRoundOff<S>);

  explicit ClosedGas(double restitution) {
    test::Draws draws(11, 1, 1);
    for (int i = 0; i < kBodies; ++i) {
      const Vector place(0.3 * (i % 3 - 1), 0.3 * (i / 3 % 2), 0.3 * (i / 6));
      const auto q_WB = test::about(draws.direction(), draws.between(0, 3));
      auto body = test::solid_rod<SceneT>(i % 2 == 0 ? 0.2 : 0, 0.04, place, q_WB);
      body.restitution = static_cast<S>(restitution);
      if constexpr (SceneT::kFriction) body.friction = S(0.1);
      test::throw_body(body, draws.direction(), 3 * draws.direction());
      EXPECT_TRUE(world_->add(body).ok());
    }
    start_ = sums().spin;
    spread_ = sums().spread;
  }

  /// Until there were 1,000 contacts. Bound: three minutes
  void run(double dt) {
    for (int i = 0; i * dt < 180 && contacts_ < 1000; ++i) {
      given_ += test::pull_together(*world_, kPull, dt);
      ASSERT_EQ(world_->step(static_cast<S>(dt)), Status::kOk);
      ++steps_;
      const auto& report = world_->report();
      contacts_ += report.collisions + report.separations;
      spread_ = max_of(spread_, sums().spread);
    }
  }
  /// To 1e-5 of the summed |x| |p| + |b| in float; in double to 8 u of it for each contact, and for
  /// each body and step. Where contacts last, their group gives back what shifts change (world.md,
  /// "The moment of a shift"). @returns how many were shifted
  long expect_spin_kept() const {
    Vector turned = Vector::Zero();
    Vector shifted = Vector::Zero();
    long shifts = 0;
    for (std::uint16_t i = 0; i < kBodies; ++i) {
      const auto& watcher = std::as_const(*world_).get(world_->id_at(i))->controller;
      turned += watcher.turned;
      shifted += watcher.shifted;
      shifts += watcher.shifts;
    }
    EXPECT_GE(contacts_, 1000) << "or nothing is seen";
    const auto roundings = static_cast<double>(contacts_ + kBodies * steps_);
    const double share = min_of(1e-5, 8 * kU * roundings);
    if constexpr (SceneT::kResting == RestingContact::kSettling) turned.setZero();
    EXPECT_LE((sums().spin - start_ - given_ - turned).norm(), share * spread_);
    // Separations leave the common centre: a shift is rounded once for each body.
    EXPECT_LE(shifted.norm(), 8 * kU * sums().mass * static_cast<double>(shifts));
    return shifts;
  }

 private:
  Sums sums() const { return test::sums_of(std::as_const(*world_)); }

  std::unique_ptr<World<SceneT>> world_ = std::make_unique<World<SceneT>>();
  Vector start_ = Vector::Zero();
  Vector given_ = Vector::Zero();  ///< angular momentum about the origin, by the force
  double spread_ = 0;
  long contacts_ = 0;
  long steps_ = 0;
};

template <class SceneT>
long collide(double restitution, double dt) {
  SCOPED_TRACE(::testing::Message() << "C = " << restitution << ", " << dt << " s");
  const auto gas = std::make_unique<ClosedGas<SceneT>>(restitution);
  gas->run(dt);
  return gas->expect_spin_kept();
}

TYPED_TEST(Gas, AThousandContacts_LeaveAngularMomentum) {
  for (const double restitution : {1.0, 0.95}) {
    for (const double dt : {1e-3, 4e-3, 1.0 / 60}) {
      collide<GasScene<TypeParam, RestingContact::kNone>>(restitution, dt);
      collide<GasScene<TypeParam, RestingContact::kSettling>>(restitution, dt);
    }
  }
}

TYPED_TEST(Gas, AThousandContacts_LeaveWhatSeparationsDoNotTake) {
  long shifts = 0;
  for (const double restitution : {1.0, 0.9, 0.5}) {
    for (const double dt : {1e-3, 4e-3, 1.0 / 60}) {
      shifts += collide<GasScene<TypeParam, RestingContact::kSeparation>>(restitution, dt);
    }
  }
  EXPECT_GE(shifts, 100) << "or nothing is seen";
}

}  // namespace
}  // namespace batuta
