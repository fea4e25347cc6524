// SPDX-License-Identifier: MIT
// Law 3: nothing adds energy, and nobody goes further than the energy there is takes it.
#include "checker.hpp"

namespace batuta::test {

void Checker::check_energy() {
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
    // Without a blow the flight of a body with three unlike moments is as near as motion.md says.
    if (body.is_unlike()) slack += impulses() > 0 ? off_flight(i) : drift(i);
  }
  slack += depth * opening();
  const Real gained = is_.energy - was_.energy;
  hold(gained <= slack, opening() > 0 ? "energy (gaps opened)" : "energy", "gained", gained, slack);
}

void Checker::check_ways() {
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
    const Real may_be = (64 * D + told_.deepest) * shifts + (1 + 64 * told_.u) * speed * told_.dt +
                        8 * told_.u * body.x.norm();
    hold(way <= may_be, "way", "of one body", way, may_be);
  }
}

}  // namespace batuta::test
