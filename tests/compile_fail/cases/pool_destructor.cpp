// SPDX-License-Identifier: MIT
#include "batuta/core/pool.hpp"

struct Owner {
  ~Owner();
};
batuta::Pool<Owner, 4> pool;
