// SPDX-License-Identifier: MIT
// Collision impulses against exact answers, for both scalars. Errors are in u times the
// conditioning of src/response/impulse.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "batuta/response/impulse.hpp"
#include "judge_file.hpp"
#include "programs/answer/fields.hpp"

namespace batuta {
namespace {

using Real = long double;
using Real3 = Eigen::Matrix<Real, 3, 1>;

constexpr Real kTwistBound = 8;     // in u times the conditioning
constexpr Real kEnergyBound = 2;    // in u times the conditioning
constexpr Real kMomentumBound = 4;  // in ulp of the largest term

template <class Scalar>
Real3 real(const Vec3<Scalar>& x) {
  return x.template cast<Real>();
}

template <class Scalar>
struct ContactSide {
  Body<Scalar> body;
  Twist<Scalar> twist;

  Collider<Scalar> collider() const {
    return {body.X_WB, twist, body.inverse_mass, body.inverse_moments};
  }
};

template <class Scalar>
struct Query {
  ContactSide<Scalar> A;
  ContactSide<Scalar> B;
  Contact<Scalar> contact;
  Scalar restitution = 0;
};

template <class Scalar>
ContactSide<Scalar> read_party(host::QueryRow& row, const std::string& name) {
  ContactSide<Scalar> party;
  const Pose<Scalar> X_WB{answer::vector<Scalar>(row, name + "c"),
                          answer::rotation<Scalar>(row, name + "q")};
  const auto body = make_body(X_WB, answer::number<Scalar>(row, name + "m"),
                              answer::vector<Scalar>(row, name + "J"));
  EXPECT_TRUE(body.ok()) << "line " << row.line();
  party.body = body.value;
  party.twist = {answer::vector<Scalar>(row, name + "v"), answer::vector<Scalar>(row, name + "w")};
  party.body.momentum = momentum_of(party.body, party.twist);
  return party;
}

template <class Scalar>
Query<Scalar> read_query(host::QueryRow& row) {
  Query<Scalar> query{read_party<Scalar>(row, "A"), read_party<Scalar>(row, "B"), {}, 0};
  query.contact.point_W = answer::vector<Scalar>(row, "p");
  query.contact.normal_BA_W = answer::vector<Scalar>(row, "n").normalized();
  query.restitution = answer::number<Scalar>(row, "e");
  return query;
}

Real3 decimals(host::QueryRow& row, const std::string& prefix) {
  return {row.decimal(prefix + "x"), row.decimal(prefix + "y"), row.decimal(prefix + "z")};
}

/// How much one body magnifies rounding: the symbols of src/response/impulse.md.
struct Yielding {
  Real inverse_mass = 0;
  Real lever = 0;       ///< |r|
  Real speed = 0;       ///< |v| + |w| |r|
  Real turn = 0;        ///< |I^-1 (r x n)|
  Real give = 0;        ///< 1/m + (r x n) . I^-1 (r x n)
  Real give_error = 0;  ///< 1/m + 2 |r| |J^-1| |r x n|, by components
  Real softest = 0;     ///< largest inverse moment
};

template <class Scalar>
Yielding yielding_of(const ContactSide<Scalar>& party, const Contact<Scalar>& contact) {
  const Real3 r = real(contact.point_W) - real(party.body.X_WB.p_W);
  const Real3 s_W = r.cross(real(contact.normal_BA_W));
  const Real3 s = party.body.X_WB.q_WB.template cast<Real>().normalized().conjugate() * s_W;
  const Real3 inverse = real(party.body.inverse_moments);
  Yielding y;
  y.inverse_mass = party.body.inverse_mass;
  y.lever = r.norm();
  y.speed = real(party.twist.v_W).norm() + real(party.twist.w_W).norm() * y.lever;
  y.turn = inverse.cwiseProduct(s).norm();
  y.give = y.inverse_mass + s.dot(inverse.cwiseProduct(s));
  y.give_error = y.inverse_mass + 2 * y.lever * inverse.dot(s.cwiseAbs());
  y.softest = inverse.maxCoeff();
  return y;
}

Real ulp(Real x, Real u) {
  return x > 0 ? std::exp2(std::floor(std::log2(x))) * 2 * u : Real(0);
}

/// Energy that rounding the twist by (v, w) can add, J.
template <class Scalar>
Real energy_of_error(const Body<Scalar>& body, const Twist<Scalar>& twist, Real v, Real w) {
  const Momentum<Scalar> momentum = momentum_of(body, twist);
  return real(momentum.linear_W).norm() * v + real(momentum.angular_W).norm() * w;
}

template <class Scalar>
Real energy_of(const Body<Scalar>& body, const Twist<Scalar>& twist) {
  const Real3 w_B = body.X_WB.q_WB.template cast<Real>().normalized().conjugate() * real(twist.w_W);
  Real energy = body.inverse_mass > 0 ? real(twist.v_W).squaredNorm() / body.inverse_mass : 0;
  for (int i = 0; i < 3; ++i) {
    if (body.inverse_moments[i] > 0) energy += w_B[i] * w_B[i] / body.inverse_moments[i];
  }
  return energy / 2;
}

template <class Scalar>
class Judge {
 public:
  void judge(host::QueryRow& row) {
    const Query<Scalar> query = read_query<Scalar>(row);
    const auto answer =
        collision_impulse(query.A.collider(), query.B.collider(), query.contact, query.restitution);
    ASSERT_TRUE(answer.ok()) << "line " << row.line();
    condition(query, answer.value);
    check_twists(row, query, answer.value);
    check_energy(row, query, answer.value);
    check_momentum(row, query, answer.value);
    ASSERT_TRUE(row.ok()) << row.error();
    ++queries_;
  }

  void report(const char* scalar, const test::Evidence& evidence) const {
    EXPECT_GE(queries_, evidence.rows);
    EXPECT_LE(twist_, kTwistBound) << "line " << twist_line_;
    EXPECT_LE(energy_, kEnergyBound) << "line " << energy_line_;
    EXPECT_LE(momentum_, kMomentumBound) << "line " << momentum_line_;
    std::printf(
        "response, %s: %zu queries; twists %.2Lf (line %ld), energy growth %.2Lf (line %ld) u "
        "cond; "
        "momenta %.2Lf ulp (line %ld)\n",
        scalar, queries_, twist_, twist_line_, energy_, energy_line_, momentum_, momentum_line_);
  }

 private:
  static constexpr Real u = kRoundOff<Scalar>;

  /// Sizes of the rounding errors of j, and of both twists, in u.
  void condition(const Query<Scalar>& query, const Impulse<Scalar>& answer) {
    a_ = yielding_of(query.A, query.contact);
    b_ = yielding_of(query.B, query.contact);
    const Real give = a_.give + b_.give;
    j_ = answer.magnitude;
    j_error_ = j_ > 0 ? (1 + Real(query.restitution)) * (a_.speed + b_.speed) / give +
                            j_ * (1 + (a_.give_error + b_.give_error) / give)
                      : Real(0);
  }

  Real v_error(const Yielding& y, const ContactSide<Scalar>& party) const {
    return real(party.twist.v_W).norm() + y.inverse_mass * (j_ + j_error_);
  }
  Real w_error(const Yielding& y, const ContactSide<Scalar>& party) const {
    return real(party.twist.w_W).norm() + y.turn * j_error_ + y.softest * y.lever * j_;
  }

  void see_twist(Real error, Real conditioning, long line) {
    if (conditioning == 0) {
      EXPECT_EQ(error, 0) << "line " << line;
    } else if (error / (u * conditioning) > twist_) {
      twist_ = error / (u * conditioning);
      twist_line_ = line;
    }
  }

  void check_twists(host::QueryRow& row, const Query<Scalar>& query,
                    const Impulse<Scalar>& answer) {
    const auto error = [&](const Vec3<Scalar>& found, const char* prefix) {
      return (real(found) - decimals(row, prefix)).norm();
    };
    see_twist(error(answer.twist_A.v_W, "vA"), v_error(a_, query.A), row.line());
    see_twist(error(answer.twist_A.w_W, "wA"), w_error(a_, query.A), row.line());
    see_twist(error(answer.twist_B.v_W, "vB"), v_error(b_, query.B), row.line());
    see_twist(error(answer.twist_B.w_W, "wB"), w_error(b_, query.B), row.line());
  }

  /// A moving body of infinite mass does work without end: nothing to check there.
  static bool works_for_ever(const ContactSide<Scalar>& party) {
    const bool pushes = party.body.inverse_mass == Scalar(0) && !party.twist.v_W.isZero(0);
    const bool turns =
        party.body.inverse_moments.minCoeff() == Scalar(0) && !party.twist.w_W.isZero(0);
    return pushes || turns;
  }

  void check_energy(host::QueryRow& row, const Query<Scalar>& query,
                    const Impulse<Scalar>& answer) {
    if (works_for_ever(query.A) || works_for_ever(query.B)) return;
    const Real before =
        energy_of(query.A.body, query.A.twist) + energy_of(query.B.body, query.B.twist);
    const Real after =
        energy_of(query.A.body, answer.twist_A) + energy_of(query.B.body, answer.twist_B);
    const Real size =
        after +
        energy_of_error(query.A.body, answer.twist_A, v_error(a_, query.A), w_error(a_, query.A)) +
        energy_of_error(query.B.body, answer.twist_B, v_error(b_, query.B), w_error(b_, query.B));
    if (!(size > 0)) return;
    const Real growth = (after - before) / (u * size);
    if (growth > energy_) {
      energy_ = growth;
      energy_line_ = row.line();
    }
  }

  void see_sum(const Real3& sum, Real largest, long line) {
    const Real figure = largest > 0 ? sum.cwiseAbs().maxCoeff() / ulp(largest, u) : Real(0);
    if (figure > momentum_) {
      momentum_ = figure;
      momentum_line_ = line;
    }
  }

  /// The state is momenta: p and b about the centres. Sums in extended precision, before and after.
  void check_momentum(host::QueryRow& row, const Query<Scalar>& query,
                      const Impulse<Scalar>& answer) {
    Real3 linear = Real3::Zero();
    Real3 angular = Real3::Zero();
    Real largest_p = 0;
    Real largest_H = 0;
    const auto add = [&](const Body<Scalar>& body, const Momentum<Scalar>& change) {
      const Vec3<Scalar> p = body.momentum.linear_W + change.linear_W;
      const Vec3<Scalar> b = body.momentum.angular_W + change.angular_W;
      const Real3 c = real(body.X_WB.p_W);
      const Real3 orbital = c.cross(real(p)) - c.cross(real(body.momentum.linear_W));
      linear += real(p) - real(body.momentum.linear_W);
      angular += orbital + (real(b) - real(body.momentum.angular_W));
      largest_p = std::max({largest_p, real(p).norm(), real(body.momentum.linear_W).norm()});
      largest_H =
          std::max({largest_H, c.norm() * real(p).norm(), real(b).norm(),
                    real(body.momentum.angular_W).norm(),
                    c.norm() * real(body.momentum.linear_W).norm(), real(change.angular_W).norm()});
    };
    add(query.A.body, answer.on_A);
    add(query.B.body, answer.on_B);
    see_sum(linear, largest_p, row.line());
    see_sum(angular, largest_H, row.line());
  }

  Yielding a_;
  Yielding b_;
  Real j_ = 0;
  Real j_error_ = 0;
  std::size_t queries_ = 0;
  Real twist_ = 0;
  Real energy_ = 0;
  Real momentum_ = 0;
  long twist_line_ = 0;
  long energy_line_ = 0;
  long momentum_line_ = 0;
};

TEST(ResponseVectors, Double_ConservesAndIsAccurate) {
  test::judge_file<Judge<double>>(test::kImpulses, "double");
}
TEST(ResponseVectors, Float_ConservesAndIsAccurate) {
  test::judge_file<Judge<float>>(test::kImpulses, "float");
}

}  // namespace
}  // namespace batuta
