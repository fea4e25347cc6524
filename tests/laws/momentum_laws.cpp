// SPDX-License-Identifier: MIT
// Law 2: what bodies do to each other leaves their momenta, and their common centre on its way.
#include "checker.hpp"

namespace batuta::test {

void Checker::check_momentum() {
  if (!closed_) return;
  const Real3 gained = is_.momentum - was_.momentum - was_.mass * told_.dt * told_.g;
  const Real pushes = std::max(was_.pushes, is_.pushes) + fall_;
  const Real largest = std::max(was_.largest, is_.largest) + fall_;
  const Real may_be = 8 * told_.u * (pushes + impulses() * largest);
  hold(gained.norm() <= may_be, "momentum", "linear", gained.norm(), may_be);
}

void Checker::check_center() {
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

void Checker::check_spin() {
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

}  // namespace batuta::test
