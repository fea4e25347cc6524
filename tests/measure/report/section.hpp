// SPDX-License-Identifier: MIT
#pragma once
// What every section of the report stands on. A section is a program batuta_report_<section> that
// writes <section>.csv: rows of accumulators that merge exactly (table.hpp), so that shards of a
// sweep can run anywhere and their files be put together by merge.py.

#include "histogram.hpp"
#include "options.hpp"
#include "table.hpp"
#include "timing.hpp"
