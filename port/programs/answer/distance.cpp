// SPDX-License-Identifier: MIT
// distance: how far two segments are apart, and where.
#include "batuta/geometry/capsule.hpp"
#include "fields.hpp"
#include "query_kind.hpp"

namespace batuta::answer {

namespace {

template <class Scalar>
struct Query {
  Segment<Scalar> A;
  Segment<Scalar> B;
};

template <class Scalar, class Source>
Segment<Scalar> read_segment(Source& source, const std::string& name) {
  return {vector<Scalar>(source, name + '0'), vector<Scalar>(source, name + '1')};
}

template <class Scalar, class Source>
Query<Scalar> read(Source& source) {
  return {read_segment<Scalar>(source, "A"), read_segment<Scalar>(source, "B")};
}

/// Finite, and no coordinate beyond kLargestCoordinate.
template <class Scalar>
bool is_usable(const Segment<Scalar>& segment) {
  return is_valid(Capsule<Scalar>{segment, Scalar(0)});
}

template <class Scalar>
Answer answer(host::QueryRow& row, const SearchSettings& /*settings*/) {
  const auto query = read<Scalar>(row);
  if (!is_usable(query.A) || !is_usable(query.B)) return {{}, {}, "not finite, or too far"};
  const ClosestPoints<Scalar> closest = closest_points(query.A, query.B);
  const Vec3<double> n = closest.normal_AB.template cast<double>();
  const auto d = static_cast<double>(closest.distance);
  const auto s = static_cast<double>(closest.s);
  const auto u = static_cast<double>(closest.u);
  return {{}, {d, s, u, n.x(), n.y(), n.z()}, {}};
}

std::vector<std::string> needed_columns() {
  return columns_of([](auto& source) { return read<float>(source); });
}

}  // namespace

QueryKind distance_kind() {
  return {"line,d,s,u,nx,ny,nz", needed_columns, answer<float>, answer<double>};
}

}  // namespace batuta::answer
