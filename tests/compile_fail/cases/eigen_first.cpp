// SPDX-License-Identifier: MIT
#include <Eigen/Core>

#include "batuta/core/types.hpp"
