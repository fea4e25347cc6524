// SPDX-License-Identifier: MIT
#include "batuta/core/pool.hpp"

void use(batuta::Pool<int, 4>& pool);
void use(batuta::Pool<int, 4>& pool) {
#ifdef IGNORE_RESULT
  pool.make(3);
#else
  pool.remove({});
#endif
}
