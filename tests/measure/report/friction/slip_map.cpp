// SPDX-License-Identifier: MIT
// Where one body sticks and where it slides: tangential over normal impulse, and the energy that is
// kept, against the direction in which it comes. Few blows: every shard computes all of them.

#include "law.hpp"
#include "one_body.hpp"
#include "parts.hpp"

namespace batuta::report {
namespace {

constexpr double kDegree = 3.14159265358979324 / 180;
constexpr int kMostDegrees = 85;  ///< from the normal, to either side
constexpr std::array<double, 4> kFrictions = {0.2, 0.5, 1, 10};
constexpr std::array<int, 2> kWays = {0, 50};
/// An impulse this close to the cone slides.
constexpr double kOnCone = 1 - 1e-9;

struct Shown {
  const char* name;
  Collider<double> body;
};

void write_row(Table& table, const Shown& shown, int degrees, const Law& law) {
  Collider<double> body = shown.body;
  body.twist.v_W = {std::sin(degrees * kDegree), 0, -std::cos(degrees * kDegree)};
  const test::Strike strike = strike_on_floor(body);
  const Effect effect = effect_of(strike, law, answer(strike, law));
  const bool sticks = effect.tangential < kOnCone * law.friction.friction * effect.normal;
  table.key("body", shown.name)
      .key("way", name_of(law.rounds))
      .key("friction", law.friction.friction)
      .key("degrees", degrees)
      .max("tangential_over_normal", effect.tangential / effect.normal)
      .max("kept", 1 + effect.gain)
      .max("sticks", sticks ? 1 : 0);
  table.end_row();
}

}  // namespace

int report_slip_map(const Options& options) {
  const std::array<Shown, 2> all = {
      {{"ball", rod_on_floor(0, 0, 0.5)},
       {"rod leaning 45 degrees", rod_on_floor(45 * kDegree, 0.5, 0.01)}}};
  const int step = static_cast<int>(pick(options, 17, 1, 1));
  Table table(options, "friction_map");
  for (const Shown& shown : all) {
    for (const double friction : kFrictions) {
      for (const int rounds : kWays) {
        for (int degrees = -kMostDegrees; degrees <= kMostDegrees; degrees += step) {
          write_row(table, shown, degrees, {{1, friction, 0}, rounds});
        }
      }
    }
  }
  return table.write();
}

}  // namespace batuta::report
