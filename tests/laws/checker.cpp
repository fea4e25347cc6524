// SPDX-License-Identifier: MIT
// What the laws are asked with: sums, pairs, and how often a step rounds.
#include "checker.hpp"

namespace batuta::test {

namespace {

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

}  // namespace

Checker::Checker(const Seen& before, const Seen& after, const Told& told)
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

Real Checker::fastest(const SeenBody& body, Real energy) const {
  return std::sqrt(2 * energy * body.inverse_mass) + told_.g.norm() * told_.dt +
         body.reach * std::sqrt(2 * energy * body.inverse_moments.maxCoeff());
}

void Checker::find_pairs() {
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

Real Checker::way_of(std::size_t i) const {
  const SeenBody& body = after_[i];
  return (body.x - before_[i].x).norm() +
         (body.v().norm() + before_[i].w().norm() * body.reach + body.w().norm() * body.reach) *
             told_.dt;
}

bool Checker::moved(std::size_t i) const {
  return before_[i].x != after_[i].x || before_[i].q.coeffs() != after_[i].q.coeffs();
}

Real Checker::impulses() const {
  int near = 0;
  const int bodies = static_cast<int>(before_.size());
  if (told_.held > 0) near += told_.separates ? std::max(bodies, told_.frozen) : bodies;
  if (told_.settles && opening() > 0) near += bodies;
  for (const Pair& pair : pairs_)
    near += told_.settles && std::min(pair.was, pair.is) < 2 * pair.D ? 2 : 0;
  return static_cast<Real>(told_.impulses + told_.separations + near);
}

Real Checker::opening() const {
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

Real Checker::closing() const {
  Real sum = 0;
  for (const Pair& pair : pairs_) {
    if (told_.settles && std::min(pair.was, pair.is) < pair.D) sum += pair.D;
  }
  return sum;
}

Real Checker::lifted() const {
  if (!told_.settles) return 0;
  std::vector<Real> ways(before_.size(), 0);
  for (const Pair& pair : pairs_) {
    if (pair.was >= pair.D) continue;
    ways[pair.a] = std::max(ways[pair.a], pair.D);
    ways[pair.b] = std::max(ways[pair.b], pair.D);
  }
  Real energy = 0;
  for (std::size_t i = 0; i < before_.size(); ++i) {
    energy += before_[i].mass * told_.g.norm() * ways[i];
  }
  return energy;
}

Real Checker::struck() const {
  Real energy = 0;
  const Real fall = told_.g.norm() * told_.dt;
  if (!told_.settles || told_.impulses == 0) return 0;
  for (const SeenBody& body : before_) energy += body.mass * fall * fall / 2;
  return energy;
}

Real Checker::turn(std::size_t i) const {
  return std::max(before_[i].w().norm(), after_[i].w().norm()) * told_.dt;
}

Real Checker::bent(std::size_t i) const {
  return std::max(before_[i].b.norm() * before_[i].w().norm(),
                  after_[i].b.norm() * after_[i].w().norm());
}

Real Checker::drift(std::size_t i) const {
  return 1e-5L * std::max<Real>(1, 100 * turn(i) * turn(i)) * bent(i);
}

Real Checker::off_flight(std::size_t i) const {
  const Real on_chord = 0.144L * turn(i) * turn(i) * bent(i);
  const Real by_blows =
      impulses() * std::max(before_[i].turning(), after_[i].turning()) / 1024 + drift(i);
  return told_.complete ? std::min(on_chord, by_blows) : on_chord;
}

Real Checker::off_flights() const {
  Real energy = 0;
  for (std::size_t i = 0; i < before_.size(); ++i) {
    // principal_frame() makes two equal moments unlike by 16 u at most.
    if (before_[i].is_unlike(16 * told_.u)) energy += off_flight(i);
  }
  return energy;
}

Real Checker::left_by_sweeps() const {
  Real energy = 0;
  for (const Pair& pair : pairs_) {
    const Real load = (before_[pair.a].mass + before_[pair.b].mass) * told_.g.norm();
    if (told_.settles && pair.was < pair.D) energy += load * pair.D / 64;
  }
  return energy;
}

Real Checker::turning() const {
  Real energy = 0;
  for (const SeenBody& body : before_) energy += body.turning();
  return energy;
}

Real Checker::own_momenta(const Real3& V) const {
  Real own = 0;
  for (std::size_t i = 0; i < before_.size(); ++i) {
    own += std::max((before_[i].p - before_[i].mass * V).norm(),
                    (after_[i].p - after_[i].mass * V).norm());
  }
  return own;
}

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

Terms terms_of(const Seen& before, const Seen& after, const Told& told) {
  const Checker checker(before, after, told);
  return {checker.opening(),     checker.closing(),        checker.lifted(), checker.struck(),
          checker.off_flights(), checker.left_by_sweeps(), checker.turning()};
}

}  // namespace batuta::test
