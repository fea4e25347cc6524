// SPDX-License-Identifier: MIT
// toc: when two moving capsules first touch.
#include "batuta/detection/search.hpp"
#include "fields.hpp"
#include "query_kind.hpp"

namespace batuta::answer {

namespace {

template <class Scalar>
struct Query {
  MovingCapsule<Scalar> A;
  MovingCapsule<Scalar> B;
};

template <class Scalar, class Source>
MovingCapsule<Scalar> read_body(Source& source, const std::string& body, Scalar duration) {
  MovingCapsule<Scalar> moving;
  moving.motion.duration = duration;
  moving.motion.X_WB = {vector<Scalar>(source, body + 'c'), rotation<Scalar>(source, body + 'q')};
  moving.motion.twist.v_W = vector<Scalar>(source, body + 'v');
  moving.motion.twist.w_W = vector<Scalar>(source, body + 'w');
  moving.capsule_B.axis.a = vector<Scalar>(source, body + "e0");
  moving.capsule_B.axis.b = vector<Scalar>(source, body + "e1");
  moving.capsule_B.radius = number<Scalar>(source, body + 'r');
  return moving;
}

template <class Scalar, class Source>
Query<Scalar> read(Source& source) {
  const Scalar duration = number<Scalar>(source, "T");
  return {read_body(source, "A", duration), read_body(source, "B", duration)};
}

const char* word_for(Outcome outcome) {
  switch (outcome) {
    case Outcome::kFree:
      return "FREE";
    case Outcome::kContact:
      return "CONTACT";
    case Outcome::kTouching:
      return "TOUCHING";
    case Outcome::kBudget:
      return "BUDGET";
    case Outcome::kInvalid:
      break;
  }
  return "INVALID";
}

template <class Scalar>
SearchResult<Scalar> step_through(const MovingPair<Scalar>& pair, const SearchSettings& settings) {
  SteppingOptions<Scalar> options;
  if (settings.tolerance) options.epsilon = static_cast<Scalar>(*settings.tolerance);
  options.max_steps = settings.budget.value_or(kAmpleSteps);
  options.halvings = batuta::detail::kMaxHalvings;
  return search_stepping(pair, options);
}

template <class Scalar, class Search>
SearchResult<Scalar> search_by(const MovingPair<Scalar>& pair, const SearchSettings& settings) {
  typename Search::Options options;
  if (settings.tolerance) options.contact_tolerance = static_cast<Scalar>(*settings.tolerance);
  options.budget = settings.budget.value_or(kMaxBudget);
  return Search::search(pair, options, Vec3<Scalar>::Zero());
}

template <class Scalar>
SearchResult<Scalar> search(const MovingPair<Scalar>& pair, const SearchSettings& settings) {
  switch (settings.method) {
    case Method::kStepping:
      return step_through(pair, settings);
    case Method::kTranslation:
      return search_by<Scalar, Translation<Scalar>>(pair, settings);
    case Method::kAdvancement:
      break;
  }
  return search_by<Scalar, Advancement<Scalar>>(pair, settings);
}

/// Why a search answers kInvalid to a pair that could be made.
const char* reason_for(Method method) {
  switch (method) {
    case Method::kStepping:
      return "the tolerance is relative to the thinner radius, which is 0";
    case Method::kTranslation:
      return "a capsule turns: the method is for what does not";
    case Method::kAdvancement:
      break;
  }
  return "a distance cannot be told";
}

template <class Scalar>
Answer answer(host::QueryRow& row, const SearchSettings& settings) {
  const auto query = read<Scalar>(row);
  const auto pair = make_moving_pair(query.A, query.B);
  if (!pair.ok())
    return {{},
            {},
            "not finite, an orientation 0, a negative radius or time, too far, or too many turns"};
  const SearchResult<Scalar> found = search(pair.value, settings);
  if (found.outcome == Outcome::kInvalid) return {{}, {}, reason_for(settings.method)};
  const auto steps = static_cast<double>(found.evaluations);
  const auto t_free = static_cast<double>(found.t_free);
  const auto t_hit = static_cast<double>(found.t_hit);
  return {word_for(found.outcome), {t_free, t_hit, steps}, {}};
}

std::vector<std::string> needed_columns() {
  return columns_of([](auto& source) { return read<float>(source); });
}

}  // namespace

QueryKind time_of_contact_kind() {
  return {"line,outcome,t_free,t_hit,steps", needed_columns, answer<float>, answer<double>};
}

}  // namespace batuta::answer
