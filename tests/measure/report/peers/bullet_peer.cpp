// SPDX-License-Identifier: MIT
// Bullet: btContinuousConvexCollision (conservative advancement, rotation included) and, where
// nothing turns, btSubsimplexConvexCast.
//
// Shape: btMultiSphereShape of two equal spheres at the ends of the axis, because a btCapsuleShape
// is centred on its body's origin and ours turns about its centre of mass. Its margin is set to the
// radius, so that Bullet's GJK sees the bare segment.
// Precision: the package's double build (float64), the more exact of the two that it offers. The
// float build gave the same answers except at extreme scales, in some 10 % less time.
// Fixed in Bullet: contact is a gap of at most 1 mm; 64 rounds, then "no hit" with a report of
// failure to a callback, which we count; a stalled step and parting along the present normal are
// "no hit" without report. Velocities are worked out from two end poses, so turns beyond pi are
// not seen, and poses within the interval are integrated with a turn of at most pi / 4.

#include <BulletCollision/CollisionShapes/btMultiSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>

#include "roster.hpp"

namespace batuta::peers {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTurnLimit = kPi / 4;  // ANGULAR_MOTION_THRESHOLD of btTransformUtil.h

btVector3 vector(const Triple& p) {
  return {p[0], p[1], p[2]};
}

btTransform pose_at(const PeerBody& body, double t) {
  const Quaternion q = orientation_at(body, t);
  return btTransform(btQuaternion(q[1], q[2], q[3], q[0]), vector(center_at(body, t)));
}

/// Hears what the return value does not tell: that the rounds ran out.
struct Result : btConvexCast::CastResult {
  bool failed = false;
  void reportFailure(int /*error*/, int /*rounds*/) override { failed = true; }
};

std::unique_ptr<btMultiSphereShape> make_shape(const PeerBody& body) {
  const btVector3 ends[2] = {vector(body.a_B), vector(body.b_B)};
  const btScalar radii[2] = {body.radius, body.radius};
  auto shape = std::make_unique<btMultiSphereShape>(ends, radii, 2);
  shape->setMargin(body.radius);
  return shape;
}

class BulletBase : public Peer {
 public:
  void load(const PeerQuery& query) override {
    query_ = query;
    shape_A_ = make_shape(query.A);
    shape_B_ = make_shape(query.B);
  }

 protected:
  PeerAnswer cast(btConvexCast& method, double t0, double t1) const {
    Result result;
    const bool hit = method.calcTimeOfImpact(pose_at(query_.A, t0), pose_at(query_.A, t1),
                                             pose_at(query_.B, t0), pose_at(query_.B, t1), result);
    if (!hit) return {false, 0, result.failed};
    return {true, t0 + result.m_fraction * (t1 - t0), false};
  }

  PeerQuery query_;
  std::unique_ptr<btMultiSphereShape> shape_A_;
  std::unique_ptr<btMultiSphereShape> shape_B_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver depth_;
};

/// The interval in one call, or in equal parts in which no body turns beyond the limit.
class BulletContinuous : public BulletBase {
 public:
  explicit BulletContinuous(bool divide) : divide_(divide) {}

  const char* name() const override { return divide_ ? "bullet_divided" : "bullet"; }
  const char* setting() const override {
    return divide_ ? "btContinuousConvexCollision; double; contact at 1 mm; one call per 44 degrees"
                   : "btContinuousConvexCollision; double; contact at 1 mm; one call per query";
  }
  double largest_turn() const override { return divide_ ? Peer::largest_turn() : kTurnLimit; }

  PeerAnswer ask() override {
    const int parts = divide_ ? parts_of(query_) : 1;
    btContinuousConvexCollision method(shape_A_.get(), shape_B_.get(), &simplex_, &depth_);
    PeerAnswer answer;
    for (int i = 0; i < parts && !answer.contact && !answer.gave_up; ++i) {
      answer = cast(method, query_.duration * i / parts, query_.duration * (i + 1) / parts);
    }
    return answer;
  }

 private:
  static int parts_of(const PeerQuery& query) {
    const double turn = query.duration * std::max(length(query.A.w_W), length(query.B.w_W));
    return 1 + static_cast<int>(turn / (kTurnLimit * 44 / 45));
  }

  bool divide_;
};

class BulletSubsimplex : public BulletBase {
 public:
  const char* name() const override { return "bullet_subsimplex"; }
  const char* setting() const override {
    return "btSubsimplexConvexCast; double; its default epsilon and 64 rounds";
  }
  bool only_translation() const override { return true; }

  PeerAnswer ask() override {
    btSubsimplexConvexCast method(shape_A_.get(), shape_B_.get(), &simplex_);
    return cast(method, 0, query_.duration);
  }
};

}  // namespace

std::vector<PeerPtr> bullet_peers() {
  std::vector<PeerPtr> peers;
  peers.push_back(std::make_unique<BulletContinuous>(false));
  peers.push_back(std::make_unique<BulletContinuous>(true));
  peers.push_back(std::make_unique<BulletSubsimplex>());
  return peers;
}

}  // namespace batuta::peers
