// SPDX-License-Identifier: MIT
#pragma once
// The types of a scene's options. They take no value of another kind, which the compiler would turn
// into one in silence (gravity = -9.81F would be true, max_bodies = 2.5F two): what a compiler says
// names the type, at the line that states the option.

#include <limits>
#include <type_traits>

namespace batuta::detail {

template <class T>
inline constexpr bool kIsCharacter = std::is_same_v<T, char> || std::is_same_v<T, wchar_t> ||
                                     std::is_same_v<T, char16_t> || std::is_same_v<T, char32_t>;
template <class T>
inline constexpr bool kIsNumber =
    std::is_arithmetic_v<T> && !std::is_same_v<T, bool> && !kIsCharacter<T>;
template <class T>
inline constexpr bool kIsWhole = kIsNumber<T>&& std::is_integral_v<T>;

/// What a count is: max_bodies = 8. What an int cannot hold is kTooLarge, which every rule refuses.
struct WholeNumber {
  static constexpr int kTooLarge = std::numeric_limits<int>::max();

  int value = 0;

  template <class T, std::enable_if_t<kIsWhole<T>, int> = 0>
  // cppcheck-suppress noExplicitConstructor ; deviation: scene-options
  constexpr WholeNumber(T number)
      : value(number == static_cast<T>(static_cast<int>(number)) &&
                      (number < T(0)) == (static_cast<int>(number) < 0)
                  ? static_cast<int>(number)
                  : kTooLarge) {}
  template <class T, std::enable_if_t<!kIsWhole<T>, int> = 0>
  constexpr WholeNumber(T other) = delete;  // a count is a whole number: max_bodies = 8
  constexpr operator int() const { return value; }

  constexpr WholeNumber& operator+=(WholeNumber x) { return *this = value + x.value; }
  constexpr WholeNumber& operator-=(WholeNumber x) { return *this = value - x.value; }
  constexpr WholeNumber& operator*=(WholeNumber x) { return *this = value * x.value; }
  constexpr WholeNumber& operator/=(WholeNumber x) { return *this = value / x.value; }
};

/// What an angle or a length is: turn_per_step = 0.1F.
struct RealNumber {
  float value = 0;

  template <class T, std::enable_if_t<kIsNumber<T>, int> = 0>
  // cppcheck-suppress noExplicitConstructor ; deviation: scene-options
  constexpr RealNumber(T number) : value(static_cast<float>(number)) {}
  template <class T, std::enable_if_t<!kIsNumber<T>, int> = 0>
  constexpr RealNumber(T other) = delete;  // it is a number: contact_tolerance = 1e-3F
  constexpr operator float() const { return value; }
};

/// What a feature is: gravity = true.
struct TrueOrFalse {
  bool value = false;

  // cppcheck-suppress noExplicitConstructor ; deviation: scene-options
  constexpr TrueOrFalse(bool on) : value(on) {}
  template <class T>
  constexpr TrueOrFalse(T other) = delete;  // a feature is true or false: gravity = true
  constexpr operator bool() const { return value; }
};

}  // namespace batuta::detail
