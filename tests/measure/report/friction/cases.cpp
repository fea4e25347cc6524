// SPDX-License-Identifier: MIT
// Blows that are known for trouble: balls at the ends of the range of friction, and thin leaning
// rods (Painleve's), where friction pushes the end into the floor. The largest of each figure over
// the velocities of a case. Few blows: every shard computes all of them.

#include <limits>
#include <vector>

#include "law.hpp"
#include "one_body.hpp"
#include "parts.hpp"

namespace batuta::report {
namespace {

struct Case {
  std::string name;
  FrictionLaw<double> law;
  Collider<double> body;
  std::vector<Twist<double>> twists;
};

std::vector<Case> balls() {
  const Collider<double> ball = rod_on_floor(0, 0, 1);
  const std::vector<Twist<double>> sliding = {{{6, 8, -1}, {0, 0, 0}}, {{6, 8, -1}, {9, -5, 2}}};
  return {{"I08 ball; friction 0", {1, 0, 0}, ball, sliding},
          {"I08 ball; friction 0.5", {1, 0.5, 0}, ball, sliding},
          {"I08 ball; friction 1e6", {1, 1e6, 0}, ball, sliding},
          {"I08 ball; friction 1e6; slip turned round", {1, 1e6, 1}, ball, sliding}};
}

/// Slip to either side, and turns that carry the end towards the slip and against it.
std::vector<Twist<double>> slips() {
  std::vector<Twist<double>> twists;
  for (const double v : {-10.0, -3.0, -1.0, 0.0, 1.0, 3.0, 10.0}) {
    for (const double w : {-20.0, -1.0, 0.0, 1.0, 20.0})
      twists.push_back({{v, 0.1, -1}, {0, w, 0.5}});
  }
  return twists;
}

std::vector<Case> rods() {
  constexpr double kDegree = 3.14159265358979324 / 180;
  std::vector<Case> cases;
  for (const int lean : {10, 30, 45, 60, 80}) {
    cases.push_back({"I10 rod leaning " + std::to_string(lean) + " degrees; friction 2",
                     {1, 2, 0},
                     rod_on_floor(lean * kDegree, 0.5, 1e-3),
                     slips()});
  }
  return cases;
}

void write_row(Table& table, const Case& given, int rounds) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  double kept = kNothing;
  double rebound_error = kNothing;
  double slope = kNothing;
  const Law law{given.law, rounds};
  for (const Twist<double>& twist : given.twists) {
    Collider<double> body = given.body;
    body.twist = twist;
    const test::Strike strike = strike_on_floor(body);
    if (normal_velocity(strike, {strike.A.twist, {}}) >= 0) continue;
    const Effect effect = effect_of(strike, law, answer(strike, law));
    kept = std::fmax(kept, 1 + effect.gain);
    rebound_error = std::fmax(rebound_error, effect.rebound_error);
    slope = std::fmax(slope, effect.tangential / effect.normal);
  }
  table.key("case", given.name)
      .key("way", name_of(rounds))
      .max("kept", kept)
      .max("rebound_error", rebound_error)
      .max("tangential_over_normal", slope);
  table.end_row();
}

}  // namespace

int report_cases(const Options& options) {
  Table table(options, "friction_cases");
  for (const auto& cases : {balls(), rods()}) {
    for (const Case& given : cases) {
      for (const int rounds : kRounds) write_row(table, given, rounds);
    }
  }
  return table.write();
}

}  // namespace batuta::report
