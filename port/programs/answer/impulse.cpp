// SPDX-License-Identifier: MIT
// impulse: what a collision without friction does to two bodies.
#include "batuta/response/impulse.hpp"

#include "fields.hpp"
#include "query_kind.hpp"

namespace batuta::answer {

namespace {

/// A body as it is asked about; only the twist says how it moves, because infinite mass has no
/// momentum.
template <class Scalar>
struct Party {
  Pose<Scalar> X_WB;
  Twist<Scalar> twist;
  Scalar mass = 0;
  Vec3<Scalar> moments = Vec3<Scalar>::Zero();
};

template <class Scalar>
struct Query {
  Party<Scalar> A;
  Party<Scalar> B;
  Contact<Scalar> contact;
  Scalar restitution = 0;
};

template <class Scalar, class Source>
Party<Scalar> read_party(Source& source, const std::string& body) {
  Party<Scalar> party;
  party.X_WB = {vector<Scalar>(source, body + 'c'), rotation<Scalar>(source, body + 'q')};
  party.twist.v_W = vector<Scalar>(source, body + 'v');
  party.twist.w_W = vector<Scalar>(source, body + 'w');
  party.mass = number<Scalar>(source, body + 'm');
  party.moments = vector<Scalar>(source, body + 'J');
  return party;
}

template <class Scalar, class Source>
Query<Scalar> read(Source& source) {
  const Party<Scalar> A = read_party<Scalar>(source, "A");
  const Party<Scalar> B = read_party<Scalar>(source, "B");
  const Vec3<Scalar> point = vector<Scalar>(source, "p");
  const Vec3<Scalar> normal = direction<Scalar>(source, "n");
  return {A, B, {point, normal, Scalar(0)}, number<Scalar>(source, "e")};
}

template <class Scalar>
Collider<Scalar> collider(const Body<Scalar>& body, const Twist<Scalar>& twist) {
  return {body.X_WB, twist, body.inverse_mass, body.inverse_moments};
}

/// Of what can be moved; infinite mass counts as zero.
template <class Scalar>
Scalar energy(Body<Scalar> body, const Twist<Scalar>& twist) {
  body.momentum = momentum_of(body, twist);
  return kinetic_energy(body);
}

template <class Scalar>
void append(std::vector<double>& numbers, const Twist<Scalar>& twist) {
  for (const Vec3<Scalar>& part : {twist.v_W, twist.w_W}) {  // Bound: 2
    for (int i = 0; i < 3; ++i) numbers.push_back(static_cast<double>(part[i]));
  }
}

template <class Scalar>
Answer answer(host::QueryRow& row, const SearchSettings& /*settings*/) {
  const auto query = read<Scalar>(row);
  const auto A = make_body(query.A.X_WB, query.A.mass, query.A.moments);
  const auto B = make_body(query.B.X_WB, query.B.mass, query.B.moments);
  if (!A.ok() || !B.ok())
    return {{}, {}, "a mass or moment is not positive, a pose not finite, or an orientation 0"};
  const auto impulse =
      collision_impulse(collider(A.value, query.A.twist), collider(B.value, query.B.twist),
                        query.contact, query.restitution);
  if (!impulse.ok())
    return {{}, {}, "not finite, a normal of length 0, or a restitution outside [0, 1]"};
  Answer answer;
  answer.numbers.push_back(static_cast<double>(impulse.value.magnitude));
  append(answer.numbers, impulse.value.twist_A);
  append(answer.numbers, impulse.value.twist_B);
  const Scalar after =
      energy(A.value, impulse.value.twist_A) + energy(B.value, impulse.value.twist_B);
  answer.numbers.push_back(static_cast<double>(after));
  return answer;
}

std::vector<std::string> needed_columns() {
  return columns_of([](auto& source) { return read<float>(source); });
}

}  // namespace

QueryKind impulse_kind() {
  return {"line,j,vAx,vAy,vAz,wAx,wAy,wAz,vBx,vBy,vBz,wBx,wBy,wBz,ke", needed_columns,
          answer<float>, answer<double>};
}

}  // namespace batuta::answer
