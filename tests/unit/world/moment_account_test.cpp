// SPDX-License-Identifier: MIT
// What a group that nothing holds gives back at the end of a step for what its shifts have changed
// (src/world/world.md, "Opening"), by hand. Sums in long double.

#include "row_rig.hpp"

namespace batuta {
namespace {

using namespace test;
using Exact = long double;
using ExactVec = Eigen::Matrix<Exact, 3, 1>;

/// Four balls in a row whose group turns about x, `far` from the origin along each axis.
std::unique_ptr<RowRig> turning_row(double far) {
  constexpr double kSpin = 2;  // rad/s
  auto rig = std::make_unique<RowRig>();
  for (int i = 0; i < 4; ++i) rig->add(1 + i, 0);
  for (std::size_t i = 0; i < rig->count; ++i) {
    auto& body = rig->body(i);
    const Twist<double> twist = {{0, -kSpin * rig->z(i), 0}, {kSpin, 0, 0}};
    body.momentum = momentum_of(body, twist);
    body.X_WB.p_W += Vec3<double>::Constant(far);
  }
  rig->begin();
  EXPECT_EQ(rig->groups.contacts.size(), 3);
  for (int i = 0; i < 3; ++i) rig->groups.contacts[i].is_solved = true;
  return rig;
}

struct Sums {
  ExactVec linear = ExactVec::Zero();
  ExactVec angular = ExactVec::Zero();  ///< about `about`
  Exact size = 0;                       ///< of all |p|
};
Sums sums_of(RowRig& rig, const ExactVec& about) {
  Sums sums;
  for (std::size_t i = 0; i < rig.count; ++i) {
    const ExactVec p = rig.body(i).momentum.linear_W.cast<Exact>();
    const ExactVec r = rig.body(i).X_WB.p_W.cast<Exact>() - about;
    sums.linear += p;
    sums.angular += r.cross(p) + rig.body(i).momentum.angular_W.cast<Exact>();
    sums.size += p.norm();
  }
  return sums;
}

// The centre of a group is rounded far from the origin; its momentum is not.
TEST(MomentAccount, GroupGivesBack_TheMoment_AndNoMomentum) {
  constexpr Exact kRounding = 8 * kRoundOff<double>;
  for (const double far : {0.0, 1e3, 1e6, 1e8}) {
    const auto rig = turning_row(far);
    const Vec3<double> moment_W(0.125, 0.03, 0);
    rig->bodies.states[1].moment_W = moment_W;
    rig->bodies.is_shifted = true;
    const ExactVec about = rig->body(2).X_WB.p_W.cast<Exact>();
    const Sums before = sums_of(*rig, about);
    detail::give_back_moments(rig->bodies, rig->groups);
    const Sums after = sums_of(*rig, about);
    EXPECT_LE((after.linear - before.linear).norm(), kRounding * (before.size + after.size)) << far;
    const Exact places = 8 * kRoundOff<double> * (1 + static_cast<Exact>(far));
    EXPECT_LE((after.angular - before.angular + moment_W.cast<Exact>()).norm(), places) << far;
  }
}

}  // namespace
}  // namespace batuta
