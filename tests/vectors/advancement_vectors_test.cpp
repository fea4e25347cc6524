// SPDX-License-Identifier: MIT
// The searches that never miss against times of contact known to many digits, for both scalars:
// search_advancement() on all of them, search_translation() where nothing turns. What every answer
// must keep: advancement_judge.hpp. That a wrong answer is noticed: planted_faults_test.cpp.

#include "advancement_judge.hpp"

namespace batuta {
namespace {

TEST(AdvancementVectors, Double_EveryClaimIsTrueAndCheap) {
  test::judge_file<test::AdvancementJudge<double>>(test::kTimes, "advancement, double");
}
TEST(AdvancementVectors, Float_EveryClaimIsTrueAndCheap) {
  test::judge_file<test::AdvancementJudge<float>>(test::kTimes, "advancement, float");
}
TEST(TranslationVectors, Double_EveryClaimIsTrueAndCheap) {
  test::judge_file<test::TranslationJudge<double>>(test::kTimes, "translation, double");
}
TEST(TranslationVectors, Float_EveryClaimIsTrueAndCheap) {
  test::judge_file<test::TranslationJudge<float>>(test::kTimes, "translation, float");
}

}  // namespace
}  // namespace batuta
