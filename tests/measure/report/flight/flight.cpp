// SPDX-License-Identifier: MIT
// Report on the free flight of bodies with three unlike moments: error against step length and
// cost.

#include <chrono>
#include <cmath>
#include <memory>
#include <vector>

#include "batuta/world/world.hpp"
#include "draws.hpp"
#include "euler_reference.hpp"
#include "section.hpp"

namespace batuta::report {
namespace {

constexpr std::uint64_t kSeed = 19830214;
constexpr double kSeconds = 1;
constexpr long kReferenceSteps = 50000;

/// One body alone in a world.
constexpr SceneOptions space() {
  return {};
}
template <class S>
using Space = Scene<space, Advancement<S>>;

struct Shape {
  const char* name;
  Vec3<double> moments;  ///< kg m^2, of a body of 1 kg
  bool about_middle;     ///< turns about its middle axis, but for a hundredth: it tumbles
};

/// Bricks of a breadth, width and height, and a body like a racket.
const std::array<Shape, 3>& shapes() {
  static const std::array<Shape, 3> all = {{{"brick", {0.0108, 0.0083, 0.0042}, false},
                                            {"plank", {0.0834, 0.0850, 0.0020}, false},
                                            {"racket", {0.0012, 0.0164, 0.0175}, true}}};
  return all;
}

struct Flight {
  Vec3<double> moments;
  Quat<double> q_WB;
  Vec3<double> angular_W;  ///< kg m^2/s
  Spin end;                ///< by the reference
};

/// At 10 rad/s or so; a function of (shape, index) alone.
Flight flight_of(const Shape& shape, std::uint64_t stream, std::uint64_t index) {
  test::Draws draws(kSeed, stream, index);
  Flight flight;
  flight.moments = shape.moments;
  flight.q_WB = draws.rotation();
  const double rate = draws.between(8, 12);
  const Vec3<double> aside = draws.direction();
  const Vec3<double> w_B =
      rate * (shape.about_middle ? Vec3<double>(Vec3<double>::UnitY() + 0.01 * aside) : aside);
  flight.angular_W = flight.q_WB * Vec3<double>(flight.moments.cwiseProduct(w_B));
  Spin start;
  start.q_WB = flight.q_WB.cast<Wide>();
  start.w_B = w_B.cast<Wide>();
  flight.end = turned_by_euler(start, flight.moments.cast<Wide>(), kSeconds, kReferenceSteps);
  return flight;
}

/// What a flight came to.
struct End {
  Quat<double> q_WB;
  double ns = 0;
  bool held = false;  ///< in some step, for it turned too far in it
};

double energy_of(const Flight& flight, const Quat<double>& q_WB) {
  const Vec3<double> b_B = q_WB.conjugate() * flight.angular_W;
  return b_B.cwiseProduct(b_B.cwiseQuotient(flight.moments)).sum() / 2;
}

/// As the library's world flies it.
template <class S>
End fly(const Flight& flight, long steps) {
  using SceneT = Space<S>;
  Actor<SceneT> actor;
  actor.capsule_B = {{{S(-0.1), 0, 0}, {S(0.1), S(0.05), S(0.02)}}, S(0.01)};
  actor.body = make_body<S>({Vec3<S>::Zero(), renewed<S>(flight.q_WB.cast<S>())}, S(1),
                            Vec3<S>(flight.moments.cast<S>()))
                   .value;
  actor.body.momentum.angular_W = flight.angular_W.cast<S>();
  auto world = std::make_unique<World<SceneT>>();
  const auto id = world->add(actor).value;
  const S dt = static_cast<S>(kSeconds) / static_cast<S>(steps);
  End end;
  const auto start = std::chrono::steady_clock::now();
  for (long i = 0; i < steps; ++i) {
    (void)world->step(dt);
    end.held = end.held || !world->report().complete();
  }
  const auto spent = std::chrono::steady_clock::now() - start;
  end.q_WB = world->get(id)->body.X_WB.q_WB.template cast<double>().normalized();
  end.ns = std::chrono::duration<double, std::nano>(spent).count();
  return end;
}

/// With the angular velocity of its beginning held over each step, as engines do that leave the
/// gyroscopic term out of the step.
End fly_held(const Flight& flight, long steps) {
  End end;
  end.q_WB = flight.q_WB;
  const double dt = kSeconds / static_cast<double>(steps);
  const auto start = std::chrono::steady_clock::now();
  for (long i = 0; i < steps; ++i) {
    const Vec3<double> w_B =
        Vec3<double>(end.q_WB.conjugate() * flight.angular_W).cwiseQuotient(flight.moments);
    end.q_WB = renewed<double>(end.q_WB * exp_map<double>(dt * w_B));
  }
  const auto spent = std::chrono::steady_clock::now() - start;
  end.ns = std::chrono::duration<double, std::nano>(spent).count();
  return end;
}

struct Method {
  const char* name;
  const char* scalar;
  End (*fly)(const Flight&, long);
};
constexpr std::array<Method, 3> kMethods = {{{"batuta", "float", fly<float>},
                                             {"batuta", "double", fly<double>},
                                             {"velocity held", "double", fly_held}}};

/// How far the flights of one setting were off; merges by adding.
struct Off {
  std::uint64_t held = 0;  ///< not judged
  Histogram turn;          ///< rad
  Histogram energy;        ///< of the turning, off by this share of the first
  double worst_turn = 0;
  double worst_energy = 0;
  Histogram in_plain;
};

void judge(Off& off, const Flight& flight, const End& end) {
  if (end.held) {
    ++off.held;
    return;
  }
  const Quat<Wide> between = flight.end.q_WB.conjugate() * end.q_WB.cast<Wide>();
  const Wide sine = std::min<Wide>(1, between.vec().norm());
  const auto turn = static_cast<double>(2 * std::asin(sine));
  const double energy = std::abs(energy_of(flight, end.q_WB) / energy_of(flight, flight.q_WB) - 1);
  off.turn.add(turn);
  off.energy.add(energy);
  off.worst_turn = std::max(off.worst_turn, turn);
  off.worst_energy = std::max(off.worst_energy, energy);
}

void write_row(Table& table, const Shape& shape, const Method& method, long step_us,
               const Off& off) {
  table.key("shape", shape.name)
      .key("method", method.name)
      .key("scalar", method.scalar)
      .key("step_us", static_cast<double>(step_us))
      .sum("flights", off.turn.count())
      .sum("held", off.held)
      .hist("turn_rad", off.turn)
      .max("worst_turn_rad", off.worst_turn)
      .hist("energy_share", off.energy)
      .max("worst_energy_share", off.worst_energy)
      .hist("time_in_plain", off.in_plain)
      .end_row();
}

void fly_all(Table& table, Mode mode, const Shape& shape, const std::vector<Flight>& flights) {
  for (const long step_us : {100L, 200L, 400L, 1000L, 2000L, 4000L, 10000L, 20000L}) {
    if (mode == Mode::kTiny && step_us < 2000) continue;
    for (const Method& method : kMethods) {
      const double plain = plain_ns();
      Off off;
      for (const Flight& flight : flights) {
        const End end = method.fly(flight, static_cast<long>(1e6 * kSeconds) / step_us);
        judge(off, flight, end);
        if (!end.held) off.in_plain.add(end.ns / plain);
      }
      write_row(table, shape, method, step_us, off);
    }
  }
}

int report_flight(const Options& options) {
  const Range range = share_of(options, pick(options, 3, 12, 200));
  Table table(options, "flight");
  Progress progress("flight: shapes", shapes().size());
  std::uint64_t stream = 0;
  for (const Shape& shape : shapes()) {
    std::vector<Flight> flights;
    for (std::uint64_t i = range.first; i < range.last; ++i) {
      flights.push_back(flight_of(shape, stream, i));
    }
    ++stream;
    fly_all(table, options.mode, shape, flights);
    progress.advance();
  }
  return table.write();
}

}  // namespace
}  // namespace batuta::report

int main(int argc, char** argv) {
  using namespace batuta::report;
  return report_flight(parse(
      argc, argv,
      {"flight", "Free flight of bodies with three unlike moments: error against step and cost.",
       "2 minutes"}));
}
