// SPDX-License-Identifier: MIT
#include "batuta/fencing/map.hpp"

#include <cstring>

#include "batuta/geometry/direction.hpp"
#include "map_keys.hpp"

namespace batuta::fencing {
namespace {

constexpr int kMapKeyNumbers = 7;
constexpr int kFeetNumber = 6;  ///< the last of them

template <class Scalar>
constexpr LibraryKeys<Scalar> in_scalar(const LibraryKeys<float>& keys) {
  LibraryKeys<Scalar> same{};
  for (std::size_t i = 0; i < keys.size(); ++i) {  // Bound: the keys of the library's map
    for (std::size_t k = 0; k < keys[i].hand_F.size(); ++k) {  // Bound: 3
      same[i].hand_F[k] = Scalar(keys[i].hand_F[k]);
      same[i].turn_F[k] = Scalar(keys[i].turn_F[k]);
    }
    same[i].feet = Scalar(keys[i].feet);
  }
  return same;
}

template <class Scalar>
constexpr LibraryKeys<Scalar> kKeysOfLibrary = in_scalar<Scalar>(kLibraryKeys);
template <class Scalar>
constexpr FencerMap<Scalar> kMapOfLibrary = {kKeysOfLibrary<Scalar>.data(), kLibraryColumns,
                                             kLibraryRows};

/// The numbers of the map as the kernels read them; turns are against the axes of F.
template <class Scalar>
batuta::detail::KeyGridView<Scalar> grid_of(const FencerMap<Scalar>& map) {
  static_assert(sizeof(MapKey<Scalar>) == kMapKeyNumbers * sizeof(Scalar));
  return {map.keys->hand_F.data(), kMapKeyNumbers, map.columns, map.rows, Quat<Scalar>::Identity()};
}

/// What is within kNoOrder is taken away from it, and the rest stretched to reach 1 at 1 again.
template <class Scalar>
Scalar order_of(Scalar asked) {
  const Scalar rest = asked - clamp(asked, -kNoOrder<Scalar>, kNoOrder<Scalar>);
  return clamp(rest / (Scalar(1) - kNoOrder<Scalar>), Scalar(-1), Scalar(1));
}

template <class Scalar>
bool is_good(const MapKey<Scalar>& key) {
  const Vec3<Scalar> hand_F(key.hand_F[0], key.hand_F[1], key.hand_F[2]);
  const Vec3<Scalar> turn_F(key.turn_F[0], key.turn_F[1], key.turn_F[2]);
  // Before the largest is looked for: a NaN may lose a comparison.
  return is_finite(hand_F) && is_finite(turn_F) &&
         batuta::detail::largest_component(hand_F) <= kLargestReach<Scalar> &&
         turn_F.norm() <= batuta::detail::kMaxKeyTurn<Scalar> &&
         std::abs(key.feet) <= kLargestFeetKey<Scalar>;
}

constexpr bool is_map_size(int keys) {
  return keys >= kFewestMapKeys && keys <= kMostMapKeys;
}

/// Takes in one word after the other. A step is one to one in `sum` and in the word, and brings the
/// upper half of what it has, where a factor alone would leave a sign, down to the lower.
constexpr std::uint32_t stirred(std::uint32_t sum, std::uint32_t word) {
  constexpr std::uint32_t kFactor = 0x9E3779B1U;  // odd, with bits all over
  const std::uint32_t x = sum ^ word;
  return ((x << 15U) | (x >> 17U)) * kFactor;
}

/// Bit by bit, whatever the order of bytes in memory.
template <class Scalar>
std::uint32_t stirred_number(std::uint32_t sum, Scalar number) {
  std::conditional_t<sizeof(Scalar) == 4, std::uint32_t, std::uint64_t> bits = 0;
  static_assert(sizeof bits == sizeof number);
  std::memcpy(&bits, &number, sizeof bits);
  const std::uint32_t low = stirred(sum, static_cast<std::uint32_t>(bits));
  if constexpr (sizeof(Scalar) == 4) return low;
  return stirred(low, static_cast<std::uint32_t>(std::uint64_t{bits} >> 32U));
}

}  // namespace

template <class Scalar>
Status validate(const FencerMap<Scalar>& map) {
  if (map.keys == nullptr || !is_map_size(map.columns) || !is_map_size(map.rows)) {
    return Status::kInvalidArgument;
  }
  for (int i = 0; i < map.columns * map.rows; ++i) {  // Bound: kMostMapKeys^2
    if (!is_good(map.keys[i])) return Status::kInvalidArgument;
  }
  return Status::kOk;
}

template <class Scalar>
MapPlace<Scalar> place_on(const FencerMap<Scalar>& map, const Vec2<Scalar>& stick) {
  const auto surface = batuta::detail::surface_on(grid_of(map), stick, kFeetNumber);
  return {surface, order_of(surface.number)};
}

template <class Scalar>
KeyedPose<Scalar> hand_at(const FencerMap<Scalar>& map, const Vec2<Scalar>& stick) {
  return batuta::detail::pose_on(grid_of(map), stick);
}

template <class Scalar>
KeyedPose<Scalar> hand_at(const FencerMap<Scalar>& map, const Vec2<Scalar>& stick,
                          const Pose<Scalar>& X_WF) {
  return hand_at(place_on(map, stick), X_WF);
}

template <class Scalar>
KeyedPose<Scalar> hand_at(const MapPlace<Scalar>& place, const Pose<Scalar>& X_WF) {
  // Turns come out against W already.
  KeyedPose<Scalar> hand = batuta::detail::pose_of(place.surface, X_WF.q_WB);
  hand.X_WH.p_W = to_world(X_WF, hand.X_WH.p_W);
  const Mat3<Scalar> R_WF = batuta::detail::to_matrix(X_WF.q_WB);
  for (int k = 0; k < hand.jacobian.cols(); ++k) {  // Bound: 2
    const Vec3<Scalar> v_F = hand.jacobian.col(k).template head<3>();
    hand.jacobian.col(k).template head<3>() = R_WF * v_F;
  }
  return hand;
}

template <class Scalar>
Scalar feet_at(const FencerMap<Scalar>& map, const Vec2<Scalar>& stick) {
  return place_on(map, stick).feet;
}

template <class Scalar>
std::uint32_t map_id(const FencerMap<Scalar>& map) {
  // The rows show in how many numbers there are.
  std::uint32_t id = stirred(0, static_cast<std::uint32_t>(map.columns));
  const Scalar* numbers = map.keys->hand_F.data();
  const int count = kMapKeyNumbers * map.columns * map.rows;
  for (int i = 0; i < count; ++i) id = stirred_number(id, numbers[i]);  // Bound: 7 kMostMapKeys^2
  return id;
}

template <class Scalar>
const FencerMap<Scalar>& library_map() {
  return kMapOfLibrary<Scalar>;
}

#define BATUTA_INSTANTIATE(S)                                                         \
  template Status validate(const FencerMap<S>&);                                      \
  template MapPlace<S> place_on(const FencerMap<S>&, const Vec2<S>&);                 \
  template KeyedPose<S> hand_at(const MapPlace<S>&, const Pose<S>&);                  \
  template KeyedPose<S> hand_at(const FencerMap<S>&, const Vec2<S>&);                 \
  template KeyedPose<S> hand_at(const FencerMap<S>&, const Vec2<S>&, const Pose<S>&); \
  template S feet_at(const FencerMap<S>&, const Vec2<S>&);                            \
  template std::uint32_t map_id(const FencerMap<S>&);                                 \
  template const FencerMap<S>& library_map<S>();
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::fencing
