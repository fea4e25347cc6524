// SPDX-License-Identifier: MIT
#include "six_laws.hpp"

namespace batuta::test {
namespace {

/// Sums over what can be moved.
struct Sums {
  Real mass = 0;
  Real3 momentum = Real3::Zero();
  Real3 center = Real3::Zero();
  Real3 spin = Real3::Zero();  ///< about the common centre
  Real energy = 0;             ///< kinetic and of the height
  Real soft = 0;
  Real pushes = 0;   ///< summed |p|
  Real largest = 0;  ///< |p| of one
  Real moments = 0;  ///< summed |x| |p| + |b|
  Real largest_moment = 0;
};

Sums sums_of(const Seen& seen, const Told& told) {
  Sums sums;
  for (const SeenBody& body : seen) {
    if (!(body.mass > 0)) continue;
    sums.mass += body.mass;
    sums.momentum += body.p;
    sums.center += body.mass * body.x;
    // What is led stands (check_energy()), whatever the blows on it have summed up to.
    if (!body.led) sums.energy += body.kinetic() - body.mass * told.g.dot(body.x);
    sums.soft += body.soft();
    sums.pushes += body.p.norm();
    sums.largest = std::max(sums.largest, body.p.norm());
    const Real moment = (body.x.norm() + body.reach) * body.p.norm() + body.b.norm();
    sums.moments += moment;
    sums.largest_moment = std::max(sums.largest_moment, moment);
  }
  if (!(sums.mass > 0)) return sums;
  sums.center /= sums.mass;
  const Real3 V = sums.momentum / sums.mass;
  for (const SeenBody& body : seen) {
    if (body.mass > 0) sums.spin += (body.x - sums.center).cross(body.p - body.mass * V) + body.b;
  }
  return sums;
}

class Checker {
 public:
  Checker(const Seen& before, const Seen& after, const Told& told)
      : before_(before), after_(after), told_(told) {
    was_ = sums_of(before, told);
    is_ = sums_of(after, told);
    for (const SeenBody& body : before) {
      closed_ = closed_ && !body.led && body.mass > 0;
      driven_ = driven_ || body.moves;
      fall_ += body.mass * told.g.norm() * told.dt;
    }
    find_pairs();
  }

  std::vector<Breach> run() {
    check_finite();
    if (!broken_.empty()) return broken_;
    check_momentum();
    check_center();
    check_spin();
    check_energy();
    check_ways();
    check_overlaps();
    check_flights();
    check_rest();
    check_friction();
    return broken_;
  }

 private:
  struct Pair {
    std::size_t a = 0;
    std::size_t b = 0;
    Real was = 0;  ///< gap before, m
    Real is = 0;
    Real margin = 0;
    Real D = 0;  ///< the length that rules rest
  };

  void hold(bool good, const char* law, const std::string& what, Real by, Real may_be) {
    if (!good) broken_.push_back({law, what, by, may_be});
  }

  /// Nobody is faster, by what energy there is: its own, or all of it where bodies meet.
  Real fastest(const SeenBody& body, Real energy) const {
    return std::sqrt(2 * energy * body.inverse_mass) + told_.g.norm() * told_.dt +
           body.reach * std::sqrt(2 * energy * body.inverse_moments.maxCoeff());
  }

  void find_pairs() {
    Real energy = 0;
    for (const SeenBody& body : before_) {
      energy += body.kinetic();
      for (const SeenBody& other : before_) {
        extent_ = std::max(extent_, (body.x - other.x).norm() + other.reach);
      }
    }
    for (std::size_t i = 0; i < before_.size(); ++i) {
      for (std::size_t k = i + 1; k < before_.size(); ++k) {
        const SeenBody& A = before_[i];
        const SeenBody& B = before_[k];
        const Real way = way_of(i) + way_of(k) + fastest(A, A.kinetic()) * told_.dt +
                         fastest(B, B.kinetic()) * told_.dt;
        // Who goes with others is a part of something as large as they all are.
        const Real among = told_.held > 0 ? 2 * extent_ : 0;
        const Real margin = margin_of(A, B, told_, (way + among) / told_.dt);
        const Real fall = told_.g.norm() * told_.dt * told_.dt;
        const Real D = std::max({told_.D, 2 * margin, fall / 4});
        const Real near = A.reach + B.reach + way + fall + 4 * D;
        if ((A.x - B.x).norm() > near && (after_[i].x - after_[k].x).norm() > near) continue;
        Pair pair;
        pair.a = i;
        pair.b = k;
        pair.was = gap_between(A, B);
        pair.is = gap_between(after_[i], after_[k]);
        pair.margin = margin;
        pair.D = D;
        pairs_.push_back(pair);
      }
    }
  }
  Real way_of(std::size_t i) const {
    const SeenBody& body = after_[i];
    return (body.x - before_[i].x).norm() +
           (body.v().norm() + before_[i].w().norm() * body.reach + body.w().norm() * body.reach) *
               told_.dt;
  }
  /// Impulses of a step that round: those counted, and contacts that last, with one more for each
  /// body that goes on with others, and one that gives back what shifts changed of its moment.
  Real impulses() const {
    int near = 0;
    if (told_.held > 0) near += static_cast<int>(before_.size());
    if (told_.settles && opening() > 0) near += static_cast<int>(before_.size());
    for (const Pair& pair : pairs_)
      near += told_.settles && std::min(pair.was, pair.is) < 2 * pair.D ? 2 : 0;
    return static_cast<Real>(told_.impulses + told_.separations + near);
  }

  void check_finite() {
    for (const SeenBody& body : after_) {
      const Real sum = body.x.sum() + body.p.sum() + body.b.sum() + body.q.coeffs().sum();
      hold(std::isfinite(sum), "finite", "body " + std::to_string(body.slot), 0, 0);
    }
  }

  void check_momentum() {
    if (!closed_) return;
    const Real3 gained = is_.momentum - was_.momentum - was_.mass * told_.dt * told_.g;
    const Real pushes = std::max(was_.pushes, is_.pushes) + fall_;
    const Real largest = std::max(was_.largest, is_.largest) + fall_;
    const Real may_be = 8 * told_.u * (pushes + impulses() * largest);
    hold(gained.norm() <= may_be, "momentum", "linear", gained.norm(), may_be);
  }

  /// The common centre goes on along its parabola, whatever bodies do to each other.
  void check_center() {
    if (!closed_) return;
    const Real3 V = was_.momentum / was_.mass;
    const Real3 way = told_.dt * V + told_.dt * told_.dt / 2 * told_.g;
    const Real off = (is_.center - was_.center - way).norm();
    Real rounding = 0;
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const Real far = std::max(before_[i].x.norm(), after_[i].x.norm());
      rounding += before_[i].mass / was_.mass * (far + way_of(i));
    }
    const Real pushes = std::max(was_.pushes, is_.pushes) + fall_;
    const Real may_be =
        8 * told_.u *
        (rounding * (1 + impulses()) + told_.dt * pushes * (1 + impulses()) / was_.mass);
    hold(off <= may_be, "centre", "of a closed set", off, may_be);
  }

  /// What opening may shift somebody by in a step: half of what is missing to D / 2, at each
  /// contact of a chain, and at each that is answered where the two are in each other; where
  /// contacts do not last, each that is separated to D. And each that is in the other, and told, is
  /// moved clear.
  Real opening() const {
    if (!told_.shifts) return 0;
    Real sum = 0;
    Real margin = 0;
    Real D = 0;
    for (const Pair& pair : pairs_) {
      margin = std::max(margin, pair.margin);
      D = std::max(D, pair.D);
      if (told_.settles && pair.was < pair.D / 2) sum += (pair.D / 2 - pair.was) / 2;
      if (!told_.settles && pair.was < -pair.margin / 2) sum += pair.margin - pair.was;
    }
    // From a margin's depth to as far apart, or to D.
    const Real to = told_.settles ? 2 * margin : std::max(told_.D, margin);
    if (told_.settles) sum += static_cast<Real>(told_.impulses) * (D / 2 + margin);
    return sum + static_cast<Real>(told_.overlaps) * 2 * margin +
           static_cast<Real>(told_.separations) * to;
  }

  /// Summed, besides what bodies go along with a common velocity.
  Real own_momenta(const Real3& V) const {
    Real own = 0;
    for (std::size_t i = 0; i < before_.size(); ++i) {
      own += std::max((before_[i].p - before_[i].mass * V).norm(),
                      (after_[i].p - after_[i].mass * V).norm());
    }
    return own;
  }

  void check_spin() {
    if (!closed_ || !told_.turns) return;
    const Real3 V = was_.momentum / was_.mass;
    Real moments = std::max(was_.moments, is_.moments);
    Real largest = std::max(was_.largest_moment, is_.largest_moment);
    const Real own = own_momenta(V);
    for (std::size_t i = 0; i < before_.size(); ++i) {
      moments += before_[i].mass * told_.g.norm() * told_.dt * before_[i].x.norm();
    }
    const Real off = (is_.spin - was_.spin).norm();
    // Where contacts last it is given back, but where that would add energy that nobody has
    // (world.md, "The moment of a shift"; pressed_test.cpp asks for more).
    const Real may_be = 8 * told_.u * (moments + impulses() * largest) + opening() * own;
    hold(off <= may_be, "spin", "about the common centre", off, may_be);
  }

  void check_energy() {
    if (driven_) return;
    // What a lever's rounding does grows with how soft it is (impulse.md, "Conditioning").
    Real slack = 64 * told_.u * (1 + impulses()) * std::max(was_.soft, is_.soft);
    Real depth = 0;
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const SeenBody& body = before_[i];
      const Real load = body.mass * told_.g.norm();
      // Law 3: a second support may lift what lies on a first one.
      if (!told_.settles && impulses() > 0) slack += load * told_.g.norm() * told_.dt * told_.dt;
      slack += 8 * told_.u * load * (body.x.norm() + way_of(i)) * (1 + impulses());
      depth += load;
      // A velocity that moves nothing by a digit of D in a step.
      const Real least = 8 * told_.u * told_.D / told_.dt;
      slack += body.mass * least * least;
      const Real turn = std::max(body.w().norm(), after_[i].w().norm()) * told_.dt;
      const Real turning =
          std::max(body.b.norm() * body.w().norm(), after_[i].b.norm() * after_[i].w().norm());
      const Real bent = told_.impulses > 0 || impulses() > 0
                            ? 0.144L * turn * turn
                            : 1e-5L * std::max<Real>(1, 100 * turn * turn);
      if (body.is_unlike()) slack += bent * turning;
    }
    slack += depth * opening();
    const Real gained = is_.energy - was_.energy;
    hold(gained <= slack, opening() > 0 ? "energy (gaps opened)" : "energy", "gained", gained,
         slack);
  }

  /// Nobody goes further than all the energy there is would take it, and what opens gaps: 64 D
  /// (world.md, "Opening"), and what is separated.
  void check_ways() {
    if (driven_) return;
    Real energy = 0;
    for (const SeenBody& body : before_) {
      if (!(body.mass > 0)) continue;
      const Real g = told_.g.norm();
      energy += body.kinetic() + body.mass * g * told_.dt * (body.v().norm() + g * told_.dt);
    }
    Real D = told_.D;
    for (const Pair& pair : pairs_) D = std::max(D, pair.D);
    const Real shifts = 1 + static_cast<Real>(told_.separations + told_.overlaps);
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const SeenBody& body = before_[i];
      if (!(body.mass > 0)) continue;
      const Real way = (after_[i].x - body.x).norm();
      const Real speed = std::sqrt(2 * energy * body.inverse_mass) + told_.g.norm() * told_.dt;
      const Real may_be = (64 * D + told_.deepest) * shifts +
                          (1 + 64 * told_.u) * speed * told_.dt + 8 * told_.u * body.x.norm();
      hold(way <= may_be, "way", "of one body", way, may_be);
    }
  }

  /// Who is not in another does not get into it. Who is, because the caller put it there, is told
  /// as soon as one of them moves.
  void check_overlaps() {
    for (const Pair& pair : pairs_) {
      const SeenBody& A = before_[pair.a];
      const SeenBody& B = before_[pair.b];
      const bool idle = (A.led || A.asleep) && (B.led || B.asleep);
      if (idle) continue;
      const std::string who = std::to_string(A.slot) + " in " + std::to_string(B.slot);
      if (pair.was >= -pair.margin) {
        hold(pair.is >= -pair.margin, "overlap", who, -pair.is, pair.margin);
      } else if (told_.complete && (moved(pair.a) || moved(pair.b))) {
        const Real told = told_.deepest + pair.margin;
        hold(told >= -pair.was, "untold overlap", who, -pair.was, told);
      }
    }
  }
  bool moved(std::size_t i) const {
    return before_[i].x != after_[i].x || before_[i].q.coeffs() != after_[i].q.coeffs();
  }

  /// Who is near nobody flies freely.
  void check_flights() {
    if (!told_.complete || told_.held > 0) return;
    std::vector<bool> is_near(before_.size(), false);
    for (const Pair& pair : pairs_) is_near[pair.a] = is_near[pair.b] = true;
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const SeenBody& was = before_[i];
      const SeenBody& is = after_[i];
      if (is_near[i] || was.led) continue;
      const std::string who = "body " + std::to_string(was.slot);
      if (was.w().norm() * told_.dt > 3.1L || was.asleep) continue;
      const Real3 way = told_.dt * was.v() + told_.dt * told_.dt / 2 * told_.g;
      const Real off = (is.x - was.x - way).norm();
      const Real may_be = 8 * told_.u *
                          (std::max(was.x.norm(), is.x.norm()) +
                           (was.v().norm() + told_.g.norm() * told_.dt) * told_.dt);
      hold(off <= may_be, "flight", who + " place", off, may_be);
      const Real3 pulled = was.mass * told_.dt * told_.g;
      hold((is.p - was.p - pulled).norm() <= 8 * told_.u * (was.p.norm() + pulled.norm()), "flight",
           who + " momentum", (is.p - was.p - pulled).norm(), 8 * told_.u * was.p.norm());
      hold((is.b - was.b).norm() == 0, "flight", who + " spin", (is.b - was.b).norm(), 0);
    }
  }

  void check_rest() {
    int asleep = 0;
    bool all = !after_.empty();
    for (std::size_t i = 0; i < after_.size(); ++i) {
      asleep += after_[i].asleep ? 1 : 0;
      all = all && before_[i].asleep;
      if (!before_[i].asleep || !after_[i].asleep) continue;
      const Real off = (after_[i].x - before_[i].x).norm() +
                       (after_[i].q.coeffs() - before_[i].q.coeffs()).norm() + after_[i].p.norm() +
                       after_[i].b.norm();
      hold(off == 0, "rest", "sleeper " + std::to_string(after_[i].slot) + " moved", off, 0);
    }
    hold(asleep == told_.asleep, "rest", "who sleeps is counted", asleep, told_.asleep);
    if (all)
      hold(told_.evaluations == 0 && told_.events == 0, "rest", "sleepers cost", told_.evaluations,
           0);
  }

  /// Where nothing struck, contacts were solved as the bodies stood before: what came to a body
  /// that is near but one other lies in the friction cone of that contact.
  void check_friction() {
    if (!told_.settles || !told_.complete || told_.held > 0 || told_.impulses > 0) return;
    std::vector<int> near(before_.size(), 0);
    for (const Pair& pair : pairs_) {
      ++near[pair.a];
      ++near[pair.b];
    }
    for (const Pair& pair : pairs_) {
      const bool is_a = near[pair.a] == 1 && !before_[pair.a].led;
      if (!is_a && (near[pair.b] != 1 || before_[pair.b].led)) continue;
      check_cone(is_a ? pair.a : pair.b, is_a ? pair.b : pair.a, pair.D);
    }
  }
  void check_cone(std::size_t i, std::size_t k, Real D) {
    const SeenBody& A = before_[i];
    const SeenBody& B = before_[k];
    if (A.parts.size() > 1 || B.parts.size() > 1 || A.asleep || after_[i].asleep) return;
    const Real3 n = -way_between(A.parts[0], B.parts[0]).normalized();
    const Real3 J = after_[i].p - A.p - A.mass * told_.dt * told_.g;
    const Real pressed = J.dot(n);
    const Real3 d = A.parts[0].b - A.parts[0].a;
    const Real3 e = B.parts[0].b - B.parts[0].a;
    const bool is_line = d.cross(e).norm() < 0.5L * d.norm() * e.norm();
    // Both points of a line are a sixteenth of a radius apart or more, and within D of the gap.
    const Real radii = A.parts[0].radius + B.parts[0].radius;
    const Real rounding_n = 64 * told_.u * (A.x.norm() + B.x.norm() + A.reach + B.reach) / radii;
    const Real least = std::min(A.parts[0].radius, B.parts[0].radius);
    const Real lean = rounding_n + (is_line ? 16 * D / least : 0);
    const Real rounding =
        64 * told_.u * (A.p.norm() + after_[i].p.norm() + A.mass * told_.dt * told_.g.norm());
    // What its group gives back of a shift's moment is no force of a contact: at least a radius
    // away from what it turns about, or as slow as one that is.
    const Real given = opening() * own_momenta(was_.momentum / was_.mass) / least;
    const Real along = (J - pressed * n).norm();
    const Real may_be = (std::min(A.friction, B.friction) + lean) * pressed + rounding + given;
    hold(along <= may_be, "friction", "body " + std::to_string(A.slot), along, may_be);
  }

  Real extent_ = 0;  ///< of all bodies, m
  const Seen& before_;
  const Seen& after_;
  const Told& told_;
  Sums was_;
  Sums is_;
  Real fall_ = 0;
  bool closed_ = true;
  bool driven_ = false;
  std::vector<Pair> pairs_;
  std::vector<Breach> broken_;
};

}  // namespace

Real gap_between(const SeenBody& A, const SeenBody& B) {
  Real least = std::numeric_limits<Real>::max();
  for (const SeenPart& a : A.parts) {
    for (const SeenPart& b : B.parts) least = std::min(least, gap_of(a, b));
  }
  return least;
}

Real margin_of(const SeenBody& A, const SeenBody& B, const Told& told, Real fastest) {
  const Real L = (A.x - B.x).norm() + 2 * (A.reach + B.reach) + fastest * told.dt;
  const Real contact = std::max(told.tolerance, 96 * told.u) * L + 72 * told.u * L;
  return 2 * contact + 64 * told.u * (A.x.norm() + B.x.norm() + L);
}

std::vector<Breach> broken_laws(const Seen& before, const Seen& after, const Told& told) {
  return Checker(before, after, told).run();
}

}  // namespace batuta::test
