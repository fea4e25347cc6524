// SPDX-License-Identifier: MIT
// Host time of one step of 1 ms: two blades apart, two blades in contact, and the whole duel on
// guard.

#include <benchmark/benchmark.h>

#include "batuta/fencing/duel.hpp"
#include "batuta/world/scenes.hpp"

namespace batuta {
using namespace fencing;
namespace {

template <class S>
using BladesScene = Scene<two_blades, Advancement<S>, Hand<S>>;

template <class S>
Actor<BladesScene<S>> blade(S x, S target_x) {
  Actor<BladesScene<S>> actor;
  const Vec3<S> moments(S(0.02), S(0.02), S(1e-4));
  actor.body = make_body<S>({Vec3<S>(x, 0, 0), Quat<S>::Identity()}, S(0.5), moments).value;
  actor.capsule_B = {{Vec3<S>(0, 0, S(-0.45)), Vec3<S>(0, 0, S(0.45))}, S(0.005)};
  actor.controller = {{Vec3<S>(target_x, 0, 0), Quat<S>::Identity()}, S(1e-3)};
  return actor;
}

template <class S>
void run(benchmark::State& state, S gap, S speed) {
  const S dt = S(1e-3);
  const S half = gap / 2;
  World<BladesScene<S>> world;
  const auto A = world.add(blade<S>(-half, -half + speed * dt)).value;
  const auto B = world.add(blade<S>(half, half)).value;
  const Body<S> start_A = world.get(A)->body;
  const Body<S> start_B = world.get(B)->body;
  double evaluations = 0;
  for (auto _ : state) {
    world.get(A)->body = start_A;
    world.get(B)->body = start_B;
    benchmark::DoNotOptimize(world.step(dt));
    evaluations += world.report().evaluations;
  }
  state.counters["evaluations"] =
      benchmark::Counter(evaluations, benchmark::Counter::kAvgIterations);
}

template <class S>
void BM_WorldStep_BladesFarApart(benchmark::State& state) {
  run<S>(state, S(0.5), S(1));
}
template <class S>
void BM_WorldStep_BladesClose(benchmark::State& state) {
  run<S>(state, S(0.02), S(5));
}
template <class S>
void BM_WorldStep_BladesCollide(benchmark::State& state) {
  run<S>(state, S(0.0125), S(5));
}

BENCHMARK_TEMPLATE(BM_WorldStep_BladesFarApart, float);
BENCHMARK_TEMPLATE(BM_WorldStep_BladesFarApart, double);
BENCHMARK_TEMPLATE(BM_WorldStep_BladesClose, float);
BENCHMARK_TEMPLATE(BM_WorldStep_BladesClose, double);
BENCHMARK_TEMPLATE(BM_WorldStep_BladesCollide, float);
BENCHMARK_TEMPLATE(BM_WorldStep_BladesCollide, double);

void BM_DuelStep_OnGuard(benchmark::State& state) {
  Duel<> duel;
  if (duel.configure(duel_settings(), first_fencer<float>(), second_fencer<float>()) !=
      Status::kOk) {
    state.SkipWithError("the duel could not be configured");
    return;
  }
  for (auto _ : state) benchmark::DoNotOptimize(duel.step(nullptr, nullptr));
}
BENCHMARK(BM_DuelStep_OnGuard);

}  // namespace
}  // namespace batuta
