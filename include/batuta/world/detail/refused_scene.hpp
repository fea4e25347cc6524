// SPDX-License-Identifier: MIT
#pragma once
// Stand-ins for what a refused scene would have, so that a program that uses it is told what to
// change, and nothing else. All features are on, shapes and bodies are of the kind that the program
// was written for. Nothing here is ever linked.

#include "batuta/core/fixed_list.hpp"
#include "batuta/core/pool.hpp"
#include "batuta/world/event.hpp"
#include "batuta/world/scene.hpp"

namespace batuta {
template <class SceneT>
struct Actor;
template <class SceneT>
struct WorldSettings;
}  // namespace batuta

namespace batuta::detail {

template <class SearchT, class = void>
inline constexpr bool kIsSearch = false;
template <class SearchT>
inline constexpr bool kIsSearch<
    SearchT, std::void_t<typename SearchT::Scalar, typename SearchT::Options,
                         decltype(SearchT::kNumber), decltype(SearchT::kForStraightFlight),
                         decltype(SearchT::kForSpheres), decltype(SearchT::kHasContactTolerance),
                         decltype(SearchT::kDefaultBudget), decltype(SearchT::kLeastBudget)>> =
    true;

constexpr SceneOptions everything() {
  SceneOptions scene;
  scene.friction = true;
  scene.resting = RestingContact::kSettling;
  scene.gravity = true;
  scene.filters = true;
  return scene;
}

/// What it would have been if it were a scene.
template <class SceneT, class = void>
struct RefusedScene
    : SceneConstants<SceneOptions, everything, Advancement<float>, FreeFlight<float>, SweptBox> {};
template <class SceneT>
struct RefusedScene<SceneT, std::void_t<decltype(SceneT::kStated), typename SceneT::Controller>>
    : RefusedScene<void> {
  static constexpr bool kKeepsSearch =
      kIsSearch<typename SceneT::Search> && kIsScalar<typename SceneT::Scalar>;
  using Search = std::conditional_t<kKeepsSearch, typename SceneT::Search, Advancement<float>>;
  using Scalar = typename Search::Scalar;
  using Controller = typename SceneT::Controller;
  static constexpr bool kRotation = SceneT::kRotation;
  static constexpr int kCapsulesPerBody =
      min_of(max_of(SceneT::kCapsulesPerBody, 1), 255);  // what can be stored
};

/// Is nowhere. What clang++ compiles with an options function that is not constexpr does not link,
/// and the linker names this.
void write_constexpr_before_the_function_that_returns_the_options();

template <class SceneT>
class RefusedWorld {
 public:
  using Scalar = typename RefusedScene<SceneT>::Scalar;
  using Search = typename RefusedScene<SceneT>::Search;
  using ActorType = Actor<SceneT>;
  using BodyId = Handle<ActorType>;
  using EventList = FixedList<ContactEvent<Scalar>, 1>;

  static constexpr int kMaxRounds = 1;
  static constexpr int kPairsPerRound = 1;

  explicit RefusedWorld(std::uint16_t /*number*/ = 0) {
    write_constexpr_before_the_function_that_returns_the_options();
  }

  Status configure(const WorldSettings<SceneT>& settings);
  const WorldSettings<SceneT>& settings() const;
  void restore(const RefusedWorld& saved);
  Result<BodyId> add(const ActorType& actor);
  Status remove(BodyId id);
  ActorType* get(BodyId id);
  ActorType* steer(BodyId id);
  const ActorType* get(BodyId id) const;
  BodyId id_at(std::uint16_t slot) const;
  int size() const;
  Status step(Scalar dt);
  const StepReport<Scalar>& report() const;
  const EventList& events() const;
  bool is_asleep(BodyId id) const;
  template <class Archive>
  void archive(Archive& ar);
};

}  // namespace batuta::detail
