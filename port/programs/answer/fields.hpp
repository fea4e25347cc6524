// SPDX-License-Identifier: MIT
#pragma once
// Reads vectors and quaternions by the prefix of their columns. Source: a host::QueryRow, or
// ColumnNames, so that what a query reads is also the list of the columns it needs.

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "batuta/geometry/direction.hpp"
#include "batuta/mechanics/rotation.hpp"
#include "programs/query_file.hpp"

namespace batuta::answer {

/// Reads nothing; remembers each column once.
class ColumnNames {
 public:
  float number(const std::string& column) {
    if (std::find(names_.begin(), names_.end(), column) == names_.end()) names_.push_back(column);
    return 0.0F;
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

template <class Scalar, class Source>
Scalar number(Source& source, const std::string& column) {
  return static_cast<Scalar>(source.number(column));
}

template <class Scalar, class Source>
Vec3<Scalar> vector(Source& source, const std::string& prefix) {
  const Scalar x = number<Scalar>(source, prefix + 'x');
  const Scalar y = number<Scalar>(source, prefix + 'y');
  const Scalar z = number<Scalar>(source, prefix + 'z');
  return {x, y, z};
}

/// A float32 quaternion is only nearly unit: it is renewed in the precision of the answer. One that
/// points nowhere, zero or not finite, is no number: what asks with it refuses it.
template <class Scalar, class Source>
Quat<Scalar> rotation(Source& source, const std::string& prefix) {
  const Scalar w = number<Scalar>(source, prefix + 'w');
  const Vec3<Scalar> xyz = vector<Scalar>(source, prefix);
  const Quat<Scalar> q(w, xyz.x(), xyz.y(), xyz.z());
  if (is_finite(q) && q.coeffs() != Eigen::Matrix<Scalar, 4, 1>::Zero()) return renewed(q);
  const Scalar nan = std::numeric_limits<Scalar>::quiet_NaN();
  return {nan, nan, nan, nan};
}

/// A direction of any length, as a unit vector; no number where it points nowhere.
template <class Scalar, class Source>
Vec3<Scalar> direction(Source& source, const std::string& prefix) {
  const Vec3<Scalar> v = vector<Scalar>(source, prefix);
  if (is_finite(v) && v != Vec3<Scalar>::Zero()) return unit(v);
  return Vec3<Scalar>::Constant(std::numeric_limits<Scalar>::quiet_NaN());
}

/// The columns of a query that `read(source)` reads.
template <class Read>
std::vector<std::string> columns_of(const Read& read) {
  ColumnNames source;
  (void)read(source);
  return source.names();
}

}  // namespace batuta::answer
