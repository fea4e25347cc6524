// SPDX-License-Identifier: MIT
// ODE: it has no continuous collision, so its capsule-capsule test (dCollide) is asked at 17 poses,
// in 16 equal steps whatever the duration: more than a game would spend on one frame. An overlap
// that falls between two poses is not seen, and what is seen is late by up to a step.
// The package is built in double. A contact is a depth >= 0.

#include <ode/ode.h>

#include "roster.hpp"

namespace batuta::peers {

namespace {

constexpr int kSteps = 16;

/// A geometry without a body, moved by hand: one product of quaternions a step.
class Geometry {
 public:
  Geometry(const PeerBody& body, const CapsuleFrame& frame)
      : body_(body),
        frame_(frame),
        id_(frame.length > 0 ? dCreateCapsule(nullptr, body.radius, frame.length)
                             : dCreateSphere(nullptr, body.radius)) {}
  Geometry(const Geometry&) = delete;
  Geometry(Geometry&&) = delete;
  Geometry& operator=(const Geometry&) = delete;
  Geometry& operator=(Geometry&&) = delete;
  ~Geometry() { dGeomDestroy(id_); }

  void start(double step) {
    step_ = step;
    steps_ = 0;
    q_WB_ = unit(body_.q_WB);
    turn_ = turn(body_.w_W, step);
    place();
  }
  void advance() {
    ++steps_;
    q_WB_ = product(turn_, q_WB_);
    place();
  }
  dGeomID id() const { return id_; }

 private:
  void place() const {
    const Triple center = center_at(body_, step_ * steps_);
    const Triple p = along(center, 1, turned(q_WB_, frame_.middle_B));
    const Quaternion q = product(q_WB_, frame_.q_BC);
    const dQuaternion q_WC = {q[0], q[1], q[2], q[3]};
    dGeomSetPosition(id_, p[0], p[1], p[2]);
    dGeomSetQuaternion(id_, q_WC);
  }

  PeerBody body_;
  CapsuleFrame frame_;
  dGeomID id_;
  double step_ = 0;
  int steps_ = 0;
  Quaternion q_WB_{1, 0, 0, 0};
  Quaternion turn_{1, 0, 0, 0};
};

class OdeSampling : public Peer {
 public:
  OdeSampling() { dInitODE2(0); }
  OdeSampling(const OdeSampling&) = delete;
  OdeSampling(OdeSampling&&) = delete;
  OdeSampling& operator=(const OdeSampling&) = delete;
  OdeSampling& operator=(OdeSampling&&) = delete;
  ~OdeSampling() override {
    A_.reset();
    B_.reset();
    dCloseODE();
  }

  const char* name() const override { return "ode"; }
  const char* setting() const override {
    return "no continuous collision: dCollide at 16 equal steps; double";
  }
  double sampling() const override { return 1.0 / kSteps; }

  void load(const PeerQuery& query) override {
    duration_ = query.duration;
    A_ = std::make_unique<Geometry>(query.A, capsule_frame(query.A));
    B_ = std::make_unique<Geometry>(query.B, capsule_frame(query.B));
  }

  PeerAnswer ask() override {
    A_->start(duration_ / kSteps);
    B_->start(duration_ / kSteps);
    for (int i = 0; i <= kSteps; ++i) {  // Bound: kSteps
      dContactGeom contact;
      if (dCollide(A_->id(), B_->id(), 1, &contact, sizeof contact) > 0) {
        return {true, duration_ * i / kSteps, false};
      }
      A_->advance();
      B_->advance();
    }
    return {};
  }

 private:
  double duration_ = 0;
  std::unique_ptr<Geometry> A_;
  std::unique_ptr<Geometry> B_;
};

}  // namespace

std::vector<PeerPtr> ode_peers() {
  std::vector<PeerPtr> peers;
  peers.push_back(std::make_unique<OdeSampling>());
  return peers;
}

}  // namespace batuta::peers
