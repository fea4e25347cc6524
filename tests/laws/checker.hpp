// SPDX-License-Identifier: MIT
#pragma once
// A step that is checked, and what is found: what the laws are asked with (checker.cpp), and each
// law (momentum_laws.cpp, energy_laws.cpp, six_laws.cpp).

#include <string>
#include <vector>

#include "six_laws.hpp"

namespace batuta::test {

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

class Checker {
 public:
  Checker(const Seen& before, const Seen& after, const Told& told);

  std::vector<Breach> run();

  /// What opening may shift somebody by in a step: half of what is missing to D / 2, at each
  /// contact of a chain, and at each that is answered where the two are in each other; where
  /// contacts do not last, each that is separated to D. And each that is in the other, and told, is
  /// moved clear.
  Real opening() const;
  /// What contacts that last may close in a step: each some of its D.
  Real closing() const;
  /// The others of Terms.
  Real lifted() const;
  Real struck() const;
  Real off_flights() const;
  Real left_by_sweeps() const;
  Real turning() const;

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
  Real fastest(const SeenBody& body, Real energy) const;
  void find_pairs();
  Real way_of(std::size_t i) const;
  bool moved(std::size_t i) const;
  Real turn(std::size_t i) const;   ///< in the step, rad
  Real bent(std::size_t i) const;   ///< |b| |w|, J
  Real drift(std::size_t i) const;  ///< of the energy of a flight that nobody ends, J
  /// What a body may keep of what it is off the energy of its flight by within a step, J. In a
  /// complete step a 1024th for each impulse (world.md, law 3), besides drift(); else all of it, at
  /// most 2 |b x w| max|w'| T^2 / 8 with |w'| <= 2 |w|^2 / sqrt(3) (motion.md).
  Real off_flight(std::size_t i) const;
  /// Impulses of a step that round: those counted, and contacts that last, with one more for each
  /// body that goes on with others, and one that gives back what shifts changed of its moment. As
  /// n - 1 welds bound a step, but not under kSeparation, where a group parts before it is answered
  /// (world.md, "Together"): there as many round as are counted.
  Real impulses() const;
  /// Summed, besides what bodies go along with a common velocity.
  Real own_momenta(const Real3& V) const;

  void check_finite();
  void check_momentum();
  /// The common centre goes on along its parabola, whatever bodies do to each other.
  void check_center();
  void check_spin();
  void check_energy();
  /// Nobody goes further than all the energy there is would take it, and what opens gaps: 64 D
  /// (world.md, "Opening"), and what is separated.
  void check_ways();
  /// Who is not in another does not get into it. Who is, because the caller put it there, is told
  /// as soon as one of them moves.
  void check_overlaps();
  /// Who is near nobody flies freely.
  void check_flights();
  void check_rest();
  /// Where nothing struck, contacts were solved as the bodies stood before: what came to a body
  /// that is near but one other lies in the friction cone of that contact.
  void check_friction();
  void check_cone(std::size_t i, std::size_t k, Real D);

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

}  // namespace batuta::test
