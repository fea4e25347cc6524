// SPDX-License-Identifier: MIT
#include "laws.hpp"

#include <cmath>
#include <memory>
#include <utility>

#include "batuta/mechanics/solid.hpp"
#include "batuta/world/world.hpp"

namespace batuta::worlds {
namespace {

constexpr double kG = 9.81;
constexpr double kQuarter = 1.5707963267948966;  // turn, rad

constexpr SceneOptions falling() {
  SceneOptions scene;
  scene.max_bodies = 4;
  scene.max_pairs = 6;
  scene.friction = scene.line_contact = scene.gravity = true;
  scene.resting = RestingContact::kSettling;
  return scene;
}
template <class S>
using Falling = Scene<falling, Advancement<S>>;

using Vector = Vec3<double>;

/// A solid capsule of 1000 kg/m^3 along z of its body.
template <class S>
Actor<Falling<S>> rod(double length, double radius, const Vector& place, const Quat<double>& q_WB) {
  const Vector end(0, 0, length / 2);
  const Capsule<double> shape = {{-end, end}, radius};
  const auto mass = solid_capsule(shape, 1000.0).value;
  Actor<Falling<S>> actor;
  const Vec3<S> moments = mass.inertia_S.diagonal().template cast<S>();
  actor.body =
      make_body<S>({place.cast<S>(), q_WB.cast<S>()}, static_cast<S>(mass.mass), moments).value;
  actor.capsule_B = {{shape.axis.a.cast<S>(), shape.axis.b.cast<S>()}, static_cast<S>(radius)};
  return actor;
}
Quat<double> about(const Vector& axis) {
  return Quat<double>(Eigen::AngleAxis<double>(kQuarter, axis));
}
template <class S>
void fix(Actor<Falling<S>>& actor) {
  actor.body.inverse_mass = 0;
  actor.body.inverse_moments.setZero();
}

template <class S>
struct Stage {
  std::unique_ptr<World<Falling<S>>> world = std::make_unique<World<Falling<S>>>();
  typename World<Falling<S>>::BodyId id;
  double dt = 0;  ///< as the scalar holds it, s

  explicit Stage(double step) : dt(static_cast<double>(static_cast<S>(step))) {}
  const Body<S>& body() const { return std::as_const(*world).get(id)->body; }
  Vector place() const { return body().X_WB.p_W.template cast<double>(); }
  Vector velocity() const {
    return (body().inverse_mass * body().momentum.linear_W).template cast<double>();
  }
  /// @returns for how long it ran, s
  double run(double seconds) {
    const int count = static_cast<int>(std::lround(seconds / dt));
    for (int i = 0; i < count; ++i) (void)world->step(static_cast<S>(dt));
    return count * dt;
  }
};

/// The parabola after a second, as a share of the way.
template <class S>
double parabola(double dt) {
  Stage<S> stage(dt);
  auto ball = rod<S>(0, 0.05, {0, 0, 0}, Quat<double>::Identity());
  ball.body.momentum = momentum_of(ball.body, Twist<S>{Vec3<S>(3, 0, 5), Vec3<S>::Zero()});
  stage.id = stage.world->add(ball).value;
  const double t = stage.run(1);
  const Vector want(3 * t, 0, 5 * t - kG * t * t / 2);
  return (stage.place() - want).norm() / want.norm();
}

/// A ball dropped on a floor from 1 m. @returns the least and most of E / E0 in ten seconds, off 1
template <class S>
double bounces(double dt) {
  constexpr double kRadius = 0.05;
  Stage<S> stage(dt);
  auto floor = rod<S>(10, kRadius, {0, 0, -kRadius}, about(Vector::UnitY()));
  fix(floor);
  (void)stage.world->add(floor);
  auto ball = rod<S>(0, kRadius, {0, 0, kRadius + 1}, Quat<double>::Identity());
  ball.restitution = 1;
  stage.id = stage.world->add(ball).value;
  double worst = 0;
  const int count = static_cast<int>(std::lround(10 / dt));
  for (int i = 0; i < count; ++i) {
    (void)stage.world->step(static_cast<S>(dt));
    const double energy = kG * (stage.place().z() - kRadius) + stage.velocity().squaredNorm() / 2;
    worst = std::max(worst, std::abs(energy / kG - 1));
  }
  return worst;
}

/// A rod across two rails tilted by `angle` along y. @returns its acceleration, m/s^2, while it
/// would turn by less than half a turn in a step of 1/30 s if it rolled
template <class S>
double acceleration(double dt, double angle, double mu, bool rolls) {
  Stage<S> stage(dt);
  auto settings = stage.world->settings();
  settings.gravity_W = Vector(0, kG * std::sin(angle), -kG * std::cos(angle)).template cast<S>();
  (void)stage.world->configure(settings);
  for (const double x : {-0.35, 0.35}) {
    auto rail = rod<S>(8, 0.01, {x, 2, 0}, about(-Vector::UnitX()));
    rail.friction = static_cast<S>(mu);
    fix(rail);
    (void)stage.world->add(rail);
  }
  auto bar = rod<S>(1, 0.01, {0, -0.8, 0.02 + 5e-5}, about(Vector::UnitY()));
  bar.friction = static_cast<S>(mu);
  if (!rolls) bar.body.inverse_moments.z() = 0;
  stage.id = stage.world->add(bar).value;
  stage.run(0.2);
  const double before = stage.velocity().y();
  const double time = stage.run(0.4);
  return (stage.velocity().y() - before) / time;
}

/// g (sin - mu cos).
template <class S>
double sliding(double dt) {
  const double angle = std::atan(0.6);
  const double want = kG * (std::sin(angle) - 0.5 * std::cos(angle));
  return std::abs(acceleration<S>(dt, angle, 0.5, false) / want - 1);
}

/// A rolling body has 1 + I / (m r^2) times its mass.
template <class S>
double rolling(double dt) {
  const double angle = 0.2;
  const auto bar = rod<double>(1, 0.01, Vector::Zero(), Quat<double>::Identity());
  const double share = bar.body.inverse_mass / bar.body.inverse_moments.z() / (0.01 * 0.01);
  const double want = kG * std::sin(angle) / (1 + share);
  return std::abs(acceleration<S>(dt, angle, 0.5, true) / want - 1);
}

/// A rod of three unlike moments, 10 rad/s for ten seconds, without gravity: its energy.
template <class S>
double tumbling(double dt) {
  Stage<S> stage(dt);
  auto settings = stage.world->settings();
  settings.gravity_W.setZero();
  (void)stage.world->configure(settings);
  auto bar = rod<S>(0.6, 0.03, {0, 0, 0}, Quat<double>::Identity());
  const Vec3<S> moments(S(0.01), S(0.02), S(0.03));
  bar.body = make_body<S>(bar.body.X_WB, S(1), moments).value;
  bar.body.momentum = momentum_of(bar.body, Twist<S>{Vec3<S>::Zero(), Vec3<S>(3, 9, 3)});
  stage.id = stage.world->add(bar).value;
  const auto energy = [&] { return kinetic_energy(stage.body()); };
  const auto before = static_cast<double>(energy());
  double worst = 0;
  const int count = static_cast<int>(std::lround(10 / dt));
  for (int i = 0; i < count; ++i) {
    (void)stage.world->step(static_cast<S>(dt));
    worst = std::max(worst, std::abs(static_cast<double>(energy()) / before - 1));
  }
  return worst;
}

struct Law {
  const char* name;
  double (*in_float)(double);
  double (*in_double)(double);
};
constexpr Law kAll[] = {{"parabola", parabola<float>, parabola<double>},
                        {"energy of bounces", bounces<float>, bounces<double>},
                        {"sliding", sliding<float>, sliding<double>},
                        {"rolling", rolling<float>, rolling<double>},
                        {"energy of a tumbling body", tumbling<float>, tumbling<double>}};
static_assert(std::size(kAll) == kLaws);

}  // namespace

LawError law_error(int law, bool is_float, double step_us) {
  const Law& chosen = kAll[law];
  const double dt = step_us * 1e-6;
  return {chosen.name, is_float ? "float" : "double", step_us,
          is_float ? chosen.in_float(dt) : chosen.in_double(dt)};
}

}  // namespace batuta::worlds
