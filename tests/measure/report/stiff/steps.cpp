// SPDX-License-Identifier: MIT
// A second in steps of a microsecond to a second: a rod that flies and turns, and two balls that
// meet, against the closed form in long double. Nothing is drawn: every shard computes all of it.

#include <memory>

#include "parts.hpp"
#include "resting.hpp"

namespace batuta::report {
namespace {

template <class S>
using Space = Scene<two_blades, Advancement<S>>;

using Wide = Vec3<long double>;
using WideQuat = Eigen::Quaternion<long double>;

struct Error {
  double place = 0;        ///< of the rod, m
  double orientation = 0;  ///< of the rod, rad
  double meeting = 0;      ///< of a ball after it met another one, m
};

template <class SceneT>
void step_through(World<SceneT>& world, long steps) {
  using S = typename SceneT::Scalar;
  const S dt = S(1) / static_cast<S>(steps);
  for (long i = 0; i < steps; ++i) (void)world.step(dt);
}

/// 1.7 m and about 9 rad in a second.
template <class S>
void fly(long steps, Error& error) {
  using SceneT = Space<S>;
  auto world = std::make_unique<World<SceneT>>();
  auto rod = test::rod_at<SceneT>({0.3, -0.2, 0.1}, Vec3<double>::UnitZ());
  rod.body.momentum.linear_W = test::vector<S>(1.5, -0.7, 0.3);
  rod.body.momentum.angular_W = test::vector<S>(0.5, 0.6, 0);
  const auto id = world->add(rod).value;
  const Body<S> start = world->get(id)->body;
  step_through(*world, steps);
  const Body<S>& end = world->get(id)->body;
  const Wide place = start.X_WB.p_W.template cast<long double>() +
                     static_cast<long double>(start.inverse_mass) *
                         start.momentum.linear_W.template cast<long double>();
  const Wide spin = static_cast<long double>(start.inverse_moments.x()) *
                    start.momentum.angular_W.template cast<long double>();
  const WideQuat turned(Eigen::AngleAxis<long double>(spin.norm(), spin.normalized()));
  const WideQuat off = turned.conjugate() * end.X_WB.q_WB.template cast<long double>();
  error.place = static_cast<double>((end.X_WB.p_W.template cast<long double>() - place).norm());
  error.orientation = static_cast<double>(2 * off.vec().norm());
}

/// Equal elastic balls: after they met, each goes on as the other one came.
template <class S>
void meet(long steps, Error& error) {
  using SceneT = Space<S>;
  auto world = std::make_unique<World<SceneT>>();
  constexpr double kRadius = 0.125;
  std::array<typename World<SceneT>::BodyId, 2> ids;
  for (const int k : {0, 1}) {
    const double side = k == 0 ? -1 : 1;
    Actor<SceneT> ball = test::ball_at<SceneT>({0.53 * side, 0, 0}, kRadius);
    ball.restitution = 1;
    ball.body.momentum.linear_W = test::vector<S>(-1.1 * side, 0, 0) / ball.body.inverse_mass;
    ids[static_cast<std::size_t>(k)] = world->add(ball).value;
  }
  step_through(*world, steps);
  // The gap of 2 (0.53 - r) closes at 2.2 m/s, then opens as fast.
  const double expected = -(2 * kRadius - 0.53 + 1.1);
  error.meeting = std::abs(static_cast<double>(world->get(ids[0])->body.X_WB.p_W.x()) - expected);
}

template <class S>
void write_row(Table& table, const char* scalar, long steps) {
  Error error;
  fly<S>(steps, error);
  meet<S>(steps, error);
  table.key("scalar", scalar)
      .key("steps_a_second", static_cast<double>(steps))
      .max("place_m", error.place)
      .max("orientation_rad", error.orientation)
      .max("meeting_m", error.meeting);
  table.end_row();
}

}  // namespace

int report_stiff_steps(const Options& options) {
  Table table(options, "stiff_steps");
  const auto most = static_cast<long>(pick(options, 1000, 100000, 1000000));
  for (long steps = 1; steps <= most; steps *= 10) {
    write_row<float>(table, "float", steps);
    write_row<double>(table, "double", steps);
  }
  return table.write();
}

}  // namespace batuta::report
