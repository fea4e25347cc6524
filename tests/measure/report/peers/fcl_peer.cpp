// SPDX-License-Identifier: MIT
// FCL: continuousCollide() with conservative advancement, its best solver for this: it takes
// Capsule directly (closed-form distance of two capsules), where the default solver samples ten
// poses and the polynomial one takes meshes that translate.
//
// Motion: InterpMotion moves a chosen point of the body, here the centre of mass, with a constant
// velocity while the body turns at a constant rate: exactly our motion. Its constructors take two
// end poses, which cannot tell turns beyond pi, so the velocities are set to those of the query.
// Fixed in FCL: contact is a certified step of at most 1e-4 of the interval; the tolerance and the
// limit of rounds in the request are not used; the loop has no counter (each round takes at least
// 1e-4, so at most 10,000).
//
// Seen: where nothing turns a step can land on the contact to the last bit, and beyond it by
// rounding. The witnesses then stand the wrong way round, FCL takes the pair to part, and answers
// "no contact". It does so through its public calls and with either distance solver.
//
// A shared library with hidden symbols: its Eigen is the package's, with vectors and alignment, and
// must not be mixed with ours.

#include <fcl/geometry/shape/capsule.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/continuous_collision.h>

#include "roster.hpp"

namespace batuta::peers {

namespace {

fcl::Vector3d vector(const Triple& p) {
  return {p[0], p[1], p[2]};
}
fcl::Quaterniond quaternion(const Quaternion& q) {
  return {q[0], q[1], q[2], q[3]};
}

/// The pose at t = 0 of a capsule along z about its middle.
fcl::Transform3d start_of(const PeerBody& body, const CapsuleFrame& frame) {
  const Quaternion q = unit(body.q_WB);
  fcl::Transform3d start = fcl::Transform3d::Identity();
  start.linear() = quaternion(unit(product(q, frame.q_BC))).toRotationMatrix();
  start.translation() = vector(body.center_W) + quaternion(q) * vector(frame.middle_B);
  return start;
}

/// Constant twist about the centre of mass over t in [0, 1].
class TwistMotion : public fcl::InterpMotion<double> {
 public:
  TwistMotion(const PeerBody& body, const CapsuleFrame& frame, double duration)
      : TwistMotion(start_of(body, frame), body, frame, duration) {}

 private:
  TwistMotion(const fcl::Transform3d& start, const PeerBody& body, const CapsuleFrame& frame,
              double duration)
      : fcl::InterpMotion<double>(start.linear(), start.translation(), start.linear(),
                                  start.translation(), center_in(frame)) {
    const double rate = length(body.w_W);
    linear_vel = duration * vector(body.v_W);
    angular_vel = duration * rate;
    angular_axis = rate > 0 ? fcl::Vector3d(vector(body.w_W) / rate) : fcl::Vector3d::UnitX();
  }

  /// The centre of mass in the frame of the capsule.
  static fcl::Vector3d center_in(const CapsuleFrame& frame) {
    return quaternion(frame.q_BC).conjugate() * -vector(frame.middle_B);
  }
};

class FclAdvancement : public Peer {
 public:
  const char* name() const override { return "fcl"; }
  const char* setting() const override {
    return "conservative advancement; InterpMotion; Capsule; double; contact at a step of 1e-4";
  }

  void load(const PeerQuery& query) override {
    query_ = query;
    frame_A_ = capsule_frame(query.A);
    frame_B_ = capsule_frame(query.B);
    shape_A_ = std::make_unique<fcl::Capsuled>(query.A.radius, frame_A_.length);
    shape_B_ = std::make_unique<fcl::Capsuled>(query.B.radius, frame_B_.length);
    shape_A_->computeLocalAABB();
    shape_B_->computeLocalAABB();
  }

  PeerAnswer ask() override {
    const TwistMotion A(query_.A, frame_A_, query_.duration);
    const TwistMotion B(query_.B, frame_B_, query_.duration);
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type = fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    request.ccd_motion_type = fcl::CCDM_LINEAR;
    request.gjk_solver_type = fcl::GST_LIBCCD;  // makes no difference to two capsules
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide<double>(shape_A_.get(), &A, shape_B_.get(), &B, request, result);
    return {result.is_collide, result.time_of_contact * query_.duration, false};
  }

 private:
  PeerQuery query_;
  CapsuleFrame frame_A_;
  CapsuleFrame frame_B_;
  std::unique_ptr<fcl::Capsuled> shape_A_;
  std::unique_ptr<fcl::Capsuled> shape_B_;
};

}  // namespace

std::vector<PeerPtr> fcl_peers() {
  std::vector<PeerPtr> peers;
  peers.push_back(std::make_unique<FclAdvancement>());
  return peers;
}

}  // namespace batuta::peers
