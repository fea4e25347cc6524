// SPDX-License-Identifier: MIT
#include "methods.hpp"

#include <initializer_list>

#include "baselines.hpp"
#include "batuta/detection/search.hpp"

namespace batuta::report {

namespace {

constexpr std::uint32_t kConservativeBudget = 4096;  // as many as stepping has

template <class Scalar>
using Pair = MovingPair<Scalar>;

template <class Scalar>
AdvancementOptions<Scalar> tolerance_options(double contact_tolerance) {
  AdvancementOptions<Scalar> options;
  options.contact_tolerance = static_cast<Scalar>(contact_tolerance);
  return options;
}

template <class Scalar>
AdvancementOptions<Scalar> budget_options(double budget) {
  AdvancementOptions<Scalar> options;
  options.budget = static_cast<std::uint32_t>(budget);
  return options;
}

template <class Scalar>
SteppingOptions<Scalar> epsilon_options(double epsilon) {
  SteppingOptions<Scalar> options;
  options.epsilon = static_cast<Scalar>(epsilon);
  return options;
}

template <class Scalar>
SteppingOptions<Scalar> halvings_options(double halvings) {
  SteppingOptions<Scalar> options;
  options.halvings = static_cast<int>(halvings);
  return options;
}

/// The inflation twice: once for what the search adds, once for the rounding of the judge's input.
template <class Scalar>
double rounding(const Pair<Scalar>& pair) {
  return 2 * static_cast<double>(detail::kInflation<Scalar> * pair.scale);
}

template <class Scalar>
double tolerance_gap(const Pair<Scalar>& pair, double contact_tolerance) {
  return static_cast<double>(
             contact_tolerance_of(pair, tolerance_options<Scalar>(contact_tolerance))) +
         rounding(pair);
}

template <class Scalar>
double default_gap(const Pair<Scalar>& pair, double /*setting*/) {
  return static_cast<double>(contact_tolerance_of(pair, AdvancementOptions<Scalar>{})) +
         rounding(pair);
}

template <class Scalar>
double no_gap(const Pair<Scalar>& pair, double /*setting*/) {
  return rounding(pair);
}

template <class Scalar>
struct Sweep {
  const char* name;
  const char* swept;
  SearchResult<Scalar> (*search)(const Pair<Scalar>&, double);
  double (*contact_gap)(const Pair<Scalar>&, double);
  bool is_slow = false;
};

template <class Scalar>
void append(std::vector<Method<Scalar>>& all, const Sweep<Scalar>& sweep,
            std::initializer_list<double> settings) {
  for (const double setting : settings) {
    all.push_back(
        {sweep.name, sweep.swept, setting, sweep.search, sweep.contact_gap, sweep.is_slow});
  }
}

template <class Scalar>
void append_stepping(std::vector<Method<Scalar>>& all) {
  append<Scalar>(all,
                 {"stepping", "epsilon",
                  [](const Pair<Scalar>& pair, double epsilon) {
                    return search_stepping(pair, epsilon_options<Scalar>(epsilon));
                  },
                  no_gap<Scalar>, true},
                 {4, 1, 0.5, 0.1, 0.02});
  append<Scalar>(all,
                 {"stepping", "halvings",
                  [](const Pair<Scalar>& pair, double halvings) {
                    return search_stepping(pair, halvings_options<Scalar>(halvings));
                  },
                  no_gap<Scalar>, true},
                 {0, 4, 8, 16, 24});
}

template <class Scalar, FalsePosition kForm>
SearchResult<Scalar> false_position(const Pair<Scalar>& pair, double iterations) {
  return search_false_position(pair, SteppingOptions<Scalar>{}, static_cast<int>(iterations),
                               kForm);
}

template <class Scalar>
void append_baselines(std::vector<Method<Scalar>>& all) {
  append<Scalar>(all,
                 {"regula-falsi", "iterations", false_position<Scalar, FalsePosition::kPlain>,
                  no_gap<Scalar>, true},
                 {1, 2, 4, 8});
  append<Scalar>(all,
                 {"illinois", "iterations", false_position<Scalar, FalsePosition::kIllinois>,
                  no_gap<Scalar>, true},
                 {1, 2, 4, 8});
  append<Scalar>(all,
                 {"conservative", "contact_tolerance",
                  [](const Pair<Scalar>& pair, double contact_tolerance) {
                    return search_conservative(pair, static_cast<Scalar>(contact_tolerance),
                                               kConservativeBudget);
                  },
                  tolerance_gap<Scalar>},
                 {1e-2, 1e-3, 1e-4, 1e-5, 1e-6});
}

template <class Scalar>
void append_advancement(std::vector<Method<Scalar>>& all) {
  append<Scalar>(all,
                 {"advancement", "contact_tolerance",
                  [](const Pair<Scalar>& pair, double contact_tolerance) {
                    return search_advancement(pair, tolerance_options<Scalar>(contact_tolerance));
                  },
                  tolerance_gap<Scalar>},
                 {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10});
  append<Scalar>(all,
                 {"advancement", "budget",
                  [](const Pair<Scalar>& pair, double budget) {
                    return search_advancement(pair, budget_options<Scalar>(budget));
                  },
                  default_gap<Scalar>},
                 {2, 4, 6, 8, 12, 16, 32, 64});
}

template <class Scalar>
void append_translation(std::vector<Method<Scalar>>& all) {
  append<Scalar>(all,
                 {"translation", "contact_tolerance",
                  [](const Pair<Scalar>& pair, double contact_tolerance) {
                    return search_translation(pair, tolerance_options<Scalar>(contact_tolerance));
                  },
                  tolerance_gap<Scalar>},
                 {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10});
}

}  // namespace

template <class Scalar>
std::vector<Method<Scalar>> methods(bool turns) {
  std::vector<Method<Scalar>> all;
  append_stepping(all);
  append_baselines(all);
  append_advancement(all);
  if (!turns) append_translation(all);
  return all;
}

template std::vector<Method<float>> methods(bool);
template std::vector<Method<double>> methods(bool);

}  // namespace batuta::report
