// SPDX-License-Identifier: MIT
#pragma once
// How a call says that it could not do what was asked. A status is never conditional on a build
// setting.

#include <cstdint>
#include <type_traits>

#include "batuta/core/assert.hpp"

namespace batuta {

/// How a call ended. A call lists those that it returns.
enum class [[nodiscard]] Status : std::uint8_t{
    kOk,               ///< done
    kInvalidArgument,  ///< outside the stated range, or not finite; nothing was changed
    kPoolFull,         ///< the capacity is used up; nothing was changed
    kStaleHandle,      ///< null, foreign, or of an object that is gone; nothing was changed
    kDegenerate,       ///< the answer is defined but arbitrary in part; the docstring says which
    kUnavailable,      ///< nothing new, or the device is gone
};

namespace detail {

/// What a failure carries: T{}, but zeros for Eigen's vectors, which T{} leaves unset.
template <class T, class = void>
struct Blank {
  /// T{}.
  static constexpr T value() { return T{}; }
};
/// For types that have a Zero(): Eigen's vectors and matrices.
template <class T>
struct Blank<T, std::void_t<decltype(T::Zero())>> {
  /// T::Zero().
  static T value() { return T::Zero(); }
};

}  // namespace detail

/// A value and whether it may be used. The value is always a valid object: default (a vector: zero)
/// if the status is not kOk.
template <class T>
struct [[nodiscard]] Result {
  Status status = Status::kInvalidArgument;  ///< how the call ended
  T value = detail::Blank<T>::value();       ///< may be used if the status is kOk

  /// Whether the value may be used: the status is kOk.
  constexpr bool ok() const { return status == Status::kOk; }
};

/// kOk with a value.
template <class T>
constexpr Result<T> success(const T& value) {
  return {Status::kOk, value};
}

/// A status other than kOk with the value of Blank<T>. @pre status is not kOk
template <class T>
constexpr Result<T> failure(Status status) {
  return {status, detail::Blank<T>::value()};
}

}  // namespace batuta
