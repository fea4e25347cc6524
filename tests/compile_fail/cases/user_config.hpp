// SPDX-License-Identifier: MIT
#pragma once
#define BATUTA_ASSERT_LEVEL 1
