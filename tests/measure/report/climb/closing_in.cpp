// SPDX-License-Identifier: MIT
#include "closing_in.hpp"

#include <algorithm>
#include <optional>

#include "batuta/detection/advancement.hpp"
#include "ensemble.hpp"
#include "reference.hpp"

namespace batuta::report {

namespace {

constexpr std::uint64_t kSeed = 20080229;
constexpr double kContactTolerance = 1e-10;  // over S
constexpr double kClearStart = 0.05;         // over S
constexpr double kThinnest = 0.01;           // m
constexpr double kThickest = 0.5;            // m
constexpr int kSamples = 200;

struct Near {
  MovingCapsule<double> A;
  MovingCapsule<double> B;
};

/// The query with radii that make its least gap `distance` S. Nothing where it would start too
/// near, where a radius would be out of range, or where the least gap is at an end of the step.
std::optional<Near> brought_near(const Near& query, const test::LeastGap<double>& least,
                                 double gap_at_start, double distance) {
  const auto pair = make_moving_pair(query.A, query.B);
  if (!pair.ok()) return std::nullopt;
  const double S = pair.value.scale;
  const double change = least.gap - distance * S;
  Near near = query;
  near.A.capsule_B.radius += change / 2;
  near.B.capsule_B.radius += change / 2;
  const auto radii = std::minmax(near.A.capsule_B.radius, near.B.capsule_B.radius);
  const double end = query.A.motion.duration;
  const bool on_the_way = least.t > end / 64 && least.t < end - end / 64;
  const bool apart = gap_at_start - change > kClearStart * S;
  if (radii.first < kThinnest || radii.second > kThickest || !on_the_way || !apart) return {};
  return near;
}

void ask(Figures& figures, const Near& near) {
  AdvancementOptions<double> options;
  options.contact_tolerance = kContactTolerance;
  options.budget = kMaxBudget;
  const auto pair = make_moving_pair(near.A, near.B);
  if (!pair.ok()) return;
  figures.add(search_advancement(pair.value, options).evaluations);
}

}  // namespace

std::array<Figures, kDistances.size()> close_in(Range indices, Progress& progress) {
  std::array<Figures, kDistances.size()> figures;
  for (std::uint64_t i = indices.first; i < indices.last; ++i) {  // Bound: the range
    const test::Query drawn = test::make_query(test::Family::kGeneric, kSeed, i);
    const Near query{test::cast<double>(drawn.A), test::cast<double>(drawn.B)};
    const test::Reference<double> reference(query.A, query.B);
    const auto least = reference.least_gap(0, reference.duration(), kSamples);
    for (std::size_t k = 0; k < kDistances.size(); ++k) {  // Bound: the distances
      const auto near = brought_near(query, least, reference.gap(0), kDistances[k]);
      if (near) ask(figures[k], *near);
    }
    progress.advance();
  }
  return figures;
}

}  // namespace batuta::report
