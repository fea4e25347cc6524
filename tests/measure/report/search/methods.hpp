// SPDX-License-Identifier: MIT
#pragma once
// What is compared: every search with one of its settings swept over its range, the others as they
// are by default.

#include <vector>

#include "batuta/detection/moving_pair.hpp"

namespace batuta::report {

template <class Scalar>
struct Method {
  const char* name;   ///< of the search
  const char* swept;  ///< of the setting that differs between the rows of this method
  double setting;     ///< its value
  SearchResult<Scalar> (*search)(const MovingPair<Scalar>& pair, double setting);
  /// Gap, m, that the method may take for a contact, rounding included.
  double (*contact_gap)(const MovingPair<Scalar>& pair, double setting);
  bool is_slow;  ///< takes thousands of evaluations: asked and timed less often
};

/// Every method with every setting; with the closed form of pure translation only where nothing
/// turns.
template <class Scalar>
std::vector<Method<Scalar>> methods(bool turns);

}  // namespace batuta::report
