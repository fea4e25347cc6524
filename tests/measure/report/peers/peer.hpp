// SPDX-License-Identifier: MIT
#pragma once
// What every engine of the comparison is asked and what it answers. No Eigen and no header of an
// engine here: each adapter is compiled by itself, with the settings of its own package.

#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace batuta::peers {

using Triple = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< w, x, y, z

/// A capsule on a body with a constant twist. Its centre of mass is the body's origin, so an
/// engine must turn it about that point and not about the middle of the capsule.
struct PeerBody {
  Triple center_W{};            ///< of mass, at t = 0, m
  Quaternion q_WB{1, 0, 0, 0};  ///< at t = 0; nearly unit: renewed by the adapter
  Triple v_W{};                 ///< m/s
  Triple w_W{};                 ///< rad/s
  Triple a_B{};                 ///< ends of the axis, relative to the centre of mass, m
  Triple b_B{};
  double radius = 0;  ///< m
};

/// First contact of A and B in [0, duration]?
struct PeerQuery {
  PeerBody A;
  PeerBody B;
  double duration = 0;  ///< s
};

struct PeerAnswer {
  bool contact = false;
  double t = 0;  ///< s, of the contact
  /// The engine said that it does not know (out of iterations or of budget). Where `contact` is
  /// set, t is the instant at which the engine asks its caller to stop.
  bool gave_up = false;
};

/// One engine with one way of asking it.
class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer(Peer&&) = delete;
  Peer& operator=(const Peer&) = delete;
  Peer& operator=(Peer&&) = delete;
  virtual ~Peer() = default;

  virtual const char* name() const = 0;
  /// Method, tolerance and limits in use; one line without commas.
  virtual const char* setting() const = 0;
  /// Turn of a body, rad, up to which the engine follows the motion it is given.
  virtual double largest_turn() const { return std::numeric_limits<double>::infinity(); }
  /// Whether it only takes queries in which nothing turns.
  virtual bool only_translation() const { return false; }
  /// Time between samples over the duration, 0 for an engine that does not sample.
  virtual double sampling() const { return 0; }

  /// Makes the shapes, which an engine does once for many steps: neither timed nor counted.
  virtual void load(const PeerQuery& query) = 0;
  /// Answers the query of load(), from its poses and velocities on.
  virtual PeerAnswer ask() = 0;
};

using PeerPtr = std::unique_ptr<Peer>;

inline double dot(const Triple& p, const Triple& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
inline Triple cross(const Triple& p, const Triple& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
/// p + s q
inline Triple along(const Triple& p, double s, const Triple& q) {
  return {p[0] + s * q[0], p[1] + s * q[1], p[2] + s * q[2]};
}
inline double length(const Triple& p) {
  return std::sqrt(dot(p, p));
}

inline Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
          p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}
inline Quaternion unit(const Quaternion& q) {
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
}
/// The turn by the rotation vector w t.
inline Quaternion turn(const Triple& w, double t) {
  const double rate = length(w);
  if (rate == 0) return {1, 0, 0, 0};
  const double s = std::sin(rate * t / 2) / rate;
  return {std::cos(rate * t / 2), s * w[0], s * w[1], s * w[2]};
}
inline Quaternion orientation_at(const PeerBody& body, double t) {
  return unit(product(turn(body.w_W, t), unit(body.q_WB)));
}
inline Triple center_at(const PeerBody& body, double t) {
  return along(body.center_W, t, body.v_W);
}
/// Components in W of a vector that is given in the frame of q.
inline Triple turned(const Quaternion& q, const Triple& p) {
  const Triple u = {q[1], q[2], q[3]};
  const Triple once = cross(u, p);
  return along(along(p, 2 * q[0], once), 2, cross(u, once));
}

/// The capsule of engines whose capsules lie along z about their middle.
struct CapsuleFrame {
  Triple middle_B{};            ///< of the axis, relative to the centre of mass, m
  Quaternion q_BC{1, 0, 0, 0};  ///< turns z into the direction of the axis
  double length = 0;            ///< of the axis, m
};
inline CapsuleFrame capsule_frame(const PeerBody& body) {
  const Triple d = along(body.b_B, -1, body.a_B);
  CapsuleFrame frame;
  frame.middle_B = along(body.a_B, 0.5, d);
  frame.length = length(d);
  if (frame.length == 0) return frame;
  // Half-way construction: the turn from z to d is q = (|d| + d_z, z x d) renewed; near -z the half
  // turn about x is taken first.
  const bool down = d[2] < 0;
  const Triple up = down ? Triple{d[0], -d[1], -d[2]} : d;
  const Quaternion q = unit({frame.length + up[2], -up[1], up[0], 0});
  frame.q_BC = down ? product({0, 1, 0, 0}, q) : q;
  return frame;
}

}  // namespace batuta::peers
