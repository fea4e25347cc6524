// SPDX-License-Identifier: MIT
#include "batuta/core/pool.hpp"

batuta::Pool<char, SLOTS> pool;
