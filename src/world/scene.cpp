// SPDX-License-Identifier: MIT
#include "batuta/world/scene.hpp"

namespace batuta {

template <class Scalar>
Status validate(const WorldSettings<Scalar>& settings) {
  const auto positive = [](Scalar x) { return is_finite(x) && x > Scalar(0); };
  const bool good = positive(settings.search.epsilon) && settings.search.max_steps >= 1 &&
                    settings.search.halvings >= 0 && settings.search.halvings <= kMaxHalvings &&
                    positive(settings.rest_speed) && positive(settings.separation) &&
                    positive(settings.min_separation_time);
  return good ? Status::kOk : Status::kInvalidArgument;
}

template Status validate(const WorldSettings<float>&);
template Status validate(const WorldSettings<double>&);

}  // namespace batuta
