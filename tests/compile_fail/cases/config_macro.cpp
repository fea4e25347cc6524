// SPDX-License-Identifier: MIT
#include "batuta/core/config.hpp"
