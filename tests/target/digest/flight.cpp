// SPDX-License-Identifier: MIT
#include "batuta/mechanics/motion.hpp"

#include "fields.hpp"
#include "sections.hpp"

namespace batuta::digest {
namespace {

constexpr float kStep = 1e-3F;  // s
constexpr std::uint32_t kStepsInBlock = 100;
constexpr std::uint32_t kBlocks = 1000;  // of a body

/// A body by what makes its flight hard.
struct Flyer {
  float mass;                    ///< kg
  std::array<float, 3> moments;  ///< kg m^2
  std::array<float, 3> spin;     ///< angular momentum at the start, kg m^2/s
  bool spin_shows;
};

/// Blades and worse: moments up to a million apart, almost equal ones, fast spins.
constexpr std::array<Flyer, 10> kFlyers = {{
    {0.5F, {0.03F, 0.03F, 3e-6F}, {0.01F, 0.2F, 1e-4F}, false},
    {0.5F, {0.03F, 0.03F, 3e-6F}, {0.01F, 0.2F, 1e-4F}, true},
    {0.5F, {1.0F, 1.0F, 1e-6F}, {3.0F, -2.0F, 1e-4F}, true},
    {2.0F, {1e-3F, 1.0F, 1.0F}, {0.01F, 4.0F, 4.0F}, true},
    {2.0F, {1.0F, 2.0F, 3.0F}, {0.01F, 20.0F, 0.01F}, true},
    {2.0F, {1.0F, 1000.0F, 1000.5F}, {5.0F, 900.0F, 900.0F}, true},
    {2.0F, {1.0F, 1.0001F, 1.0002F}, {7.0F, 8.0F, -9.0F}, true},
    {1e-3F, {1e-9F, 2e-7F, 2.01e-7F}, {1e-8F, 1e-6F, 2e-6F}, true},
    {1e3F, {1e3F, 1e6F, 1.001e6F}, {1e4F, 3e6F, -2e6F}, true},
    {1.0F, {0.4F, 0.4F, 0.4F}, {40.0F, -30.0F, 20.0F}, true},
}};

static_assert(std::uint32_t{kFlyers.size()} * kBlocks * kStepsInBlock == 1000000);

Vec3<float> vector_of(const std::array<float, 3>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

Result<Body<float>> take_off(const Flyer& flyer) {
  auto body = make_body<float>({}, flyer.mass, vector_of(flyer.moments));
  body.value.momentum.linear_W = flyer.mass * Vec3<float>(0.3F, -0.1F, 0.2F);
  body.value.momentum.angular_W = vector_of(flyer.spin);
  body.value.spin_shows = flyer.spin_shows;
  return body;
}

/// Bound: kStepsInBlock steps.
void fly_block(Body<float>& body, Answer& answer) {
  for (std::uint32_t step = 0; step < kStepsInBlock; ++step) {
    const Motion<float> motion = free_flight(body, kStep);
    move_along(body, motion, kStep);
    add(answer, motion.twist);
    add(answer, body.X_WB);
  }
  answer.add("energy", kinetic_energy(body));
}

}  // namespace

void fly(Recorder& recorder) {
  for (std::uint32_t flyer = 0; flyer < kFlyers.size(); ++flyer) {  // Bound: kFlyers
    auto body = take_off(kFlyers[flyer]);
    const Section section = detail::tumbles(body.value) ? Section::kTumbling : Section::kFlight;
    if (!recorder.takes(section)) continue;
    const std::uint32_t last = recorder.shortened(kBlocks);
    for (std::uint32_t block = 0; block < last; ++block) {  // Bound: kBlocks
      Answer answer = recorder.begin(section, index_in(flyer, block));
      answer.add("status", body.status);
      fly_block(body.value, answer);
      recorder.end(section, index_in(flyer, block), answer);
    }
  }
}

}  // namespace batuta::digest
