// SPDX-License-Identifier: MIT
#include "six_laws.hpp"

#include "checker.hpp"

namespace batuta::test {

std::vector<Breach> Checker::run() {
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

void Checker::check_finite() {
  for (const SeenBody& body : after_) {
    const Real sum = body.x.sum() + body.p.sum() + body.b.sum() + body.q.coeffs().sum();
    hold(std::isfinite(sum), "finite", "body " + std::to_string(body.slot), 0, 0);
  }
}

void Checker::check_overlaps() {
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

void Checker::check_flights() {
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

void Checker::check_rest() {
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

void Checker::check_friction() {
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
void Checker::check_cone(std::size_t i, std::size_t k, Real D) {
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

std::vector<Breach> broken_laws(const Seen& before, const Seen& after, const Told& told) {
  return Checker(before, after, told).run();
}

}  // namespace batuta::test
