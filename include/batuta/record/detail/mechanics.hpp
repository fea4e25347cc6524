// SPDX-License-Identifier: MIT
#pragma once
// The members of the state of room mechanics, for record/archive.hpp.

#include "batuta/mechanics/motion.hpp"
#include "batuta/record/detail/geometry.hpp"

namespace batuta {

template <class Scalar>
void archive(Archive& ar, Pose<Scalar>& pose) {
  auto& [p_W, q_WB] = pose;
  ar(p_W, q_WB);
}

template <class Scalar>
void archive(Archive& ar, Twist<Scalar>& twist) {
  auto& [v_W, w_W] = twist;
  ar(v_W, w_W);
}

template <class Scalar>
void archive(Archive& ar, Momentum<Scalar>& momentum) {
  auto& [linear_W, angular_W] = momentum;
  ar(linear_W, angular_W);
}

template <class Scalar>
void archive(Archive& ar, detail::FlightMemory<Scalar>& flight) {
  auto& [angular_W, excess, axis, is_on_chord] = flight;
  ar(angular_W, excess);
  // One number, which is that of the axis between steps of a world: so it was before chords.
  constexpr int kAxes = 3;
  const int both = ar.count(axis + (is_on_chord ? kAxes : 0), 2 * kAxes - 1);
  axis = static_cast<std::uint8_t>(both % kAxes);
  is_on_chord = both >= kAxes;
}

/// Only a body with three unlike moments has a flight to remember: others have the bytes that they
/// had before there was one, and so has the shape, which is that of a body without moments.
template <class Scalar>
void archive(Archive& ar, Body<Scalar>& body) {
  auto& [X_WB, momentum, inverse_mass, inverse_moments, spin_shows, flight] = body;
  ar(X_WB, momentum, inverse_mass, inverse_moments, spin_shows);
  if (ar.shaping() || !detail::tumbles(body)) return;
  ar(flight);
}

template <class Scalar>
void archive(Archive& ar, Motion<Scalar>& motion) {
  auto& [X_WB, twist, duration] = motion;
  ar(X_WB, twist, duration);
}

}  // namespace batuta
