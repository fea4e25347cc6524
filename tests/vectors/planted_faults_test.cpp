// SPDX-License-Identifier: MIT
// The committed part of the exact answers shows a wrong search: the judge of
// advancement_vectors_test.cpp, on all rows of the part, finds nothing against the library, and
// finds the one row whose answer is falsified. The fault is planted in one row of every family that
// has a row for it, as small as it can be:
// - a miss: the contact is answered with kFree;
// - a late contact: t_free is the first number after the true time;
// - a false contact: kContact or kTouching at the instant of the least gap, where that gap is wider
//   than what may be called contact.

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "advancement_judge.hpp"

namespace batuta {
namespace {

using test::ContactTruth;

enum class Fault { kMiss, kLate, kFalseContact };

struct Plant {
  Fault fault = Fault::kMiss;
  long line = 0;       ///< of the file, from 1; 0: nowhere
  double t = 0;        ///< of the true contact, s
  double nearest = 0;  ///< when the gap is least, s
};

/// The first number that is surely later.
template <class Scalar>
Scalar after(double t) {
  auto later = static_cast<Scalar>(t);
  while (static_cast<double>(later) <= t) {  // Bound: 2
    later = std::nextafter(later, std::numeric_limits<Scalar>::infinity());
  }
  return later;
}

/// A search that answers one query wrongly; the others are the library's.
template <class Search>
struct Planted {
  using Scalar = typename Search::Scalar;
  static inline Plant plant;
  static inline long line = 0;  ///< of the query that is asked

  static SearchResult<Scalar> search(const MovingPair<Scalar>& pair,
                                     const AdvancementOptions<Scalar>& options,
                                     const Vec3<Scalar>& seed_AB) {
    const SearchResult<Scalar> found = Search::search(pair, options, seed_AB);
    return line == plant.line ? falsified(found, pair.duration) : found;
  }

 private:
  static SearchResult<Scalar> falsified(SearchResult<Scalar> found, Scalar duration) {
    if (plant.fault == Fault::kMiss) {
      found.outcome = Outcome::kFree;
      found.t_free = found.t_hit = duration;
    } else if (plant.fault == Fault::kLate) {
      found.t_free = after<Scalar>(plant.t);
      found.t_hit = std::max(found.t_hit, found.t_free);
    } else {
      found.t_free = found.t_hit = std::min(static_cast<Scalar>(plant.nearest), duration);
      found.outcome = found.t_free > 0 ? Outcome::kContact : Outcome::kTouching;
    }
    return found;
  }
};

/// The judge of the library, but that it tells the planted search which row is asked.
template <template <class, class> class Judge, class Search>
class PlantedJudge : public Judge<typename Search::Scalar, Planted<Search>> {
 public:
  void judge(host::QueryRow& row) {
    Planted<Search>::line = row.line();
    Judge<typename Search::Scalar, Planted<Search>>::judge(row);
  }
};

/// Whether the fault can be planted in a row, so that the answer is wrong.
template <class Scalar>
bool has_room_for(Fault fault, host::QueryRow& row, const ContactTruth& truth) {
  const auto pair = test::read_pair<Scalar>(row);
  if (!pair.ok()) return false;
  if (fault == Fault::kMiss) return truth.kind != test::kNever;
  if (fault == Fault::kLate) {
    return truth.kind == test::kOnTheWay && after<Scalar>(truth.t) <= pair.value.duration;
  }
  const AdvancementOptions<Scalar> options;
  const auto widest =
      static_cast<double>(contact_tolerance_of(pair.value, options)) +
      static_cast<double>(detail::kInflation<Scalar> * test::query_length_of(pair.value));
  return truth.kind == test::kNever && truth.least_gap - truth.gap_error > widest;
}

using Plants = std::map<std::string, Plant>;  ///< by family

/// One row of every family that has room.
template <class Search>
Plants plants_of(Fault fault) {
  std::ifstream in(test::committed_part(test::kTimes).path);
  host::QueryFile file(in);
  EXPECT_TRUE(file.ok()) << file.error();
  Plants plants;
  host::QueryRow row;
  while (file.next(row)) {  // Bound: the length of the file
    const ContactTruth truth = test::read_truth(row);
    if (Search::kForStraightFlight && !test::is_straight(row)) continue;
    if (!has_room_for<typename Search::Scalar>(fault, row, truth)) continue;
    plants[std::string(row.text("family"))] = {fault, row.line(), truth.t, row.decimal("tgmin")};
  }
  return plants;
}

/// What the judge of the library finds in the whole committed part while a fault is planted.
template <template <class, class> class Judge, class Search>
std::vector<std::string> findings(const Plant& plant) {
  testing::TestPartResultArray found;
  {
    Planted<Search>::plant = plant;
    PlantedJudge<Judge, Search> judge;
    const testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &found);
    test::judge_rows(test::committed_part(test::kTimes).path, judge);
  }
  std::vector<std::string> texts;
  for (int i = 0; i < found.size(); ++i) {  // Bound: found
    texts.emplace_back(found.GetTestPartResult(i).message());
  }
  return texts;
}

/// The scoped trace of the judge names the row.
bool names_line(const std::string& text, long line) {
  return text.find(": line " + std::to_string(line) + "\n") != std::string::npos;
}

template <template <class, class> class Judge, class Search>
void expect_found(Fault fault, std::size_t least_families) {
  const Plants plants = plants_of<Search>(fault);
  EXPECT_GE(plants.size(), least_families);
  for (const auto& [family, plant] : plants) {
    const std::vector<std::string> texts = findings<Judge, Search>(plant);
    EXPECT_FALSE(texts.empty()) << family << ", line " << plant.line << ": not noticed";
    for (const std::string& text : texts) {
      EXPECT_TRUE(names_line(text + "\n", plant.line)) << "line " << plant.line << ": " << text;
    }
  }
}

template <class Scalar>
class PlantedFaults : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(PlantedFaults, Scalars);

TYPED_TEST(PlantedFaults, Advancement_MissIsFound) {
  expect_found<test::AdvancementJudge, Advancement<TypeParam>>(Fault::kMiss, 23);
}
TYPED_TEST(PlantedFaults, Advancement_LateContactIsFound) {
  expect_found<test::AdvancementJudge, Advancement<TypeParam>>(Fault::kLate, 20);
}
TYPED_TEST(PlantedFaults, Advancement_FalseContactIsFound) {
  expect_found<test::AdvancementJudge, Advancement<TypeParam>>(Fault::kFalseContact, 20);
}
TYPED_TEST(PlantedFaults, Translation_MissIsFound) {
  expect_found<test::TranslationJudge, Translation<TypeParam>>(Fault::kMiss, 5);
}
TYPED_TEST(PlantedFaults, Translation_LateContactIsFound) {
  expect_found<test::TranslationJudge, Translation<TypeParam>>(Fault::kLate, 4);
}
TYPED_TEST(PlantedFaults, Translation_FalseContactIsFound) {
  expect_found<test::TranslationJudge, Translation<TypeParam>>(Fault::kFalseContact, 4);
}

/// Line 0 is no row: nothing is planted, and the judge finds nothing.
TYPED_TEST(PlantedFaults, Nothing_IsFoundInTheLibrary) {
  EXPECT_TRUE((findings<test::AdvancementJudge, Advancement<TypeParam>>({}).empty()));
  EXPECT_TRUE((findings<test::TranslationJudge, Translation<TypeParam>>({}).empty()));
}

}  // namespace
}  // namespace batuta
