// SPDX-License-Identifier: MIT
#include "batuta/geometry/kdop.hpp"

batuta::Kdop<float, 8> octagon;
