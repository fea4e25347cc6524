// SPDX-License-Identifier: MIT
// What every file that uses Eigen pays.
#include <Eigen/Core>
#include <Eigen/Geometry>
