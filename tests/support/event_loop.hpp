// SPDX-License-Identifier: MIT
#pragma once
// Colliding bodies without a broad phase, searches, budgets or kept answers: every gap is looked at
// on a fine grid of times, the first that closes is halved down to rounding, and answered. Slow,
// and plain enough to hold a World against. Grazes shorter than the grid are not seen.

#include <vector>

#include "batuta/mechanics/motion.hpp"

namespace batuta::test {

struct Rigid {
  Body<double> body;
  std::vector<Capsule<double>> parts_B;
  double restitution = 0;  ///< of a pair: the larger one
};

struct Happening {
  double time = 0;  ///< in the step, s
  int first = 0;    ///< body, first < second
  int second = 0;
};

class EventLoop {
 public:
  explicit EventLoop(std::vector<Rigid> bodies) : bodies_(std::move(bodies)) {}

  /// Moves everything by dt; between contacts, a body keeps its course.
  /// @returns what happened, in order. Bound: most_events contacts.
  std::vector<Happening> step(double dt, int grid, int most_events);
  const std::vector<Rigid>& bodies() const { return bodies_; }

 private:
  struct Course {
    Motion<double> motion;
    double start = 0;
  };

  Pose<double> pose(int body, double t) const;
  CapsuleGap<double> nearest(int a, int b, double t) const;
  double first_contact(int a, int b, double from, double end, double pace) const;
  void plan(int body, double now, double end);
  void answer(const Happening& happening, double end);

  std::vector<Rigid> bodies_;
  std::vector<Course> courses_;
};

}  // namespace batuta::test
