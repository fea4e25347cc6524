// SPDX-License-Identifier: MIT
// batuta itself, asked like the others. Of a bracket the answer is t_free, the instant at which a
// world stops; a budget that ran out is an answer to stop at t_free as well. Default options.

#include "batuta/detection/search.hpp"
#include "batuta/mechanics/rotation.hpp"
#include "roster.hpp"

namespace batuta::peers {

namespace {

template <class Scalar>
Vec3<Scalar> vector(const Triple& p) {
  return {static_cast<Scalar>(p[0]), static_cast<Scalar>(p[1]), static_cast<Scalar>(p[2])};
}

template <class Scalar>
MovingCapsule<Scalar> moving_capsule(const PeerBody& body, double duration) {
  const Quat<Scalar> q(static_cast<Scalar>(body.q_WB[0]), static_cast<Scalar>(body.q_WB[1]),
                       static_cast<Scalar>(body.q_WB[2]), static_cast<Scalar>(body.q_WB[3]));
  MovingCapsule<Scalar> moving;
  moving.capsule_B.axis = {vector<Scalar>(body.a_B), vector<Scalar>(body.b_B)};
  moving.capsule_B.radius = static_cast<Scalar>(body.radius);
  moving.motion.X_WB = {vector<Scalar>(body.center_W), renewed<Scalar>(q)};
  moving.motion.twist = {vector<Scalar>(body.v_W), vector<Scalar>(body.w_W)};
  moving.motion.duration = static_cast<Scalar>(duration);
  return moving;
}

struct Words {
  const char* name = "";
  const char* setting = "";
  bool only_translation = false;
};

template <class Search>
class BatutaPeer : public Peer {
 public:
  using Scalar = typename Search::Scalar;
  explicit BatutaPeer(const Words& words) : words_(words) {}

  const char* name() const override { return words_.name; }
  const char* setting() const override { return words_.setting; }
  bool only_translation() const override { return words_.only_translation; }

  void load(const PeerQuery& query) override {
    A_ = moving_capsule<Scalar>(query.A, query.duration);
    B_ = moving_capsule<Scalar>(query.B, query.duration);
  }

  PeerAnswer ask() override {
    const Result<MovingPair<Scalar>> pair = make_moving_pair<Scalar>(A_, B_);
    if (!pair.ok()) return {false, 0, true};
    const SearchResult<Scalar> found =
        Search::search(pair.value, typename Search::Options{}, Vec3<Scalar>::Zero());
    const auto t = static_cast<double>(found.t_free);
    switch (found.outcome) {
      case Outcome::kFree:
        return {};
      case Outcome::kContact:
      case Outcome::kTouching:
        return {true, t, false};
      case Outcome::kBudget:
        return {true, t, true};
      default:
        return {false, 0, true};
    }
  }

 private:
  Words words_;
  MovingCapsule<Scalar> A_;
  MovingCapsule<Scalar> B_;
};

template <class Search>
void add(std::vector<PeerPtr>& peers, const Words& words) {
  peers.push_back(std::make_unique<BatutaPeer<Search>>(words));
}

}  // namespace

std::vector<PeerPtr> batuta_peers() {
  std::vector<PeerPtr> peers;
  add<Advancement<double>>(peers, {"advancement_double", "contact_tolerance 1e-6 S; budget 64"});
  add<Advancement<float>>(
      peers, {"advancement_float", "contact_tolerance 6e-6 S (the least of float); budget 64"});
  add<Translation<double>>(peers,
                           {"translation_double", "contact_tolerance 1e-6 S; budget 64", true});
  add<Translation<float>>(
      peers,
      {"translation_float", "contact_tolerance 6e-6 S (the least of float); budget 64", true});
  add<Stepping<double>>(
      peers, {"stepping_double", "epsilon half the thinner radius; 4096 steps; 24 halvings"});
  return peers;
}

}  // namespace batuta::peers
