// SPDX-License-Identifier: MIT
#pragma once
// Reads vectors and quaternions by the prefix of their columns. Source: a host::QueryRow, or a
// MissingColumn, so that what a query reads is also the list of the columns it needs.

#include <string>

#include "batuta/mechanics/rotation.hpp"
#include "programs/query_file.hpp"

namespace batuta::answer {

/// Reads nothing; remembers the first column that the file lacks.
class MissingColumn {
 public:
  explicit MissingColumn(const host::QueryFile& file) : file_(file) {}
  float bits(const std::string& column) {
    if (name_.empty() && !file_.has(column)) name_ = column;
    return 0.0F;
  }
  const std::string& name() const { return name_; }

 private:
  const host::QueryFile& file_;
  std::string name_;
};

template <class Scalar, class Source>
Scalar number(Source& source, const std::string& column) {
  return static_cast<Scalar>(source.bits(column));
}

template <class Scalar, class Source>
Vec3<Scalar> vector(Source& source, const std::string& prefix) {
  const Scalar x = number<Scalar>(source, prefix + 'x');
  const Scalar y = number<Scalar>(source, prefix + 'y');
  const Scalar z = number<Scalar>(source, prefix + 'z');
  return {x, y, z};
}

/// A float32 quaternion is only nearly unit: it is renewed in the precision of the answer.
template <class Scalar, class Source>
Quat<Scalar> rotation(Source& source, const std::string& prefix) {
  const Scalar w = number<Scalar>(source, prefix + 'w');
  const Vec3<Scalar> xyz = vector<Scalar>(source, prefix);
  return renewed(Quat<Scalar>(w, xyz.x(), xyz.y(), xyz.z()));
}

/// The missing column of a query that `read(source)` reads.
template <class Read>
std::string missing_column_of(const host::QueryFile& file, const Read& read) {
  MissingColumn source(file);
  (void)read(source);
  return source.name();
}

}  // namespace batuta::answer
