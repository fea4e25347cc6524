# SPDX-License-Identifier: MIT
set(use -include ${prepared_duel})

# What a duel's scene leaves out cannot be asked for, and the message says which feature it belongs to.
foreach(off sleep grip targets haptics)
  batuta_must_compile(Control_Duel_${off} duel_features.cpp ${use} "-DCHANGE=scene.${off} = false")
endforeach()
batuta_must_compile(Control_Duel_BladeAlone duel_features.cpp ${use} "-DCHANGE=scene.capsules_per_body = scene.max_pairs = 1")
batuta_must_compile(Control_Duel_Grip duel_features.cpp ${use} "-DCALL=grip(Side::kLeft)")
batuta_must_compile(Control_Duel_Body duel_features.cpp ${use} "-DCALL=body_W(Side::kLeft)")
batuta_must_compile(Control_Duel_HeldHand duel_features.cpp ${use} "-DCALL=held_hand_W(Side::kLeft)")
batuta_must_compile(Control_Duel_Stepping duel_features.cpp ${use} "-DSCENE=DuelScene<drill, Stepping<double>>")
batuta_must_not_compile(Duel_GripWithoutGrip duel_features.cpp "without grip there is no grip" ${use}
                        "-DCHANGE=scene.grip = false" "-DCALL=grip(Side::kLeft)")
batuta_must_not_compile(Duel_BodyWithoutTargets duel_features.cpp "without targets there is no body_W" ${use}
                        "-DCHANGE=scene.targets = false" "-DCALL=body_W(Side::kLeft)")
batuta_must_not_compile(Duel_HeldHandWithoutHaptics duel_features.cpp "without haptics there is no held_hand_W" ${use}
                        "-DCHANGE=scene.haptics = false" "-DCALL=held_hand_W(Side::kLeft)")

# batuta_no_duel(<name> <regular expression of the message> [macro of the case...])
function(batuta_no_duel name message)
  list(TRANSFORM ARGN PREPEND -D)
  batuta_one_error(Duel_${name} duel_features.cpp ${message} ${ARGN})
  if(clang)
    batuta_one_error_by_clang(Duel_${name} duel_features.cpp ${message} ${ARGN})
  endif()
endfunction()

batuta_no_duel(OfTheSmallEngine "engine = Engine::kGeneral: blades turn" "CHANGE=scene.engine = Engine::kSmall")
batuta_no_duel(OfThreeBlades "max_bodies = 2: a duel has two blades" "CHANGE=scene.max_bodies = 3")
batuta_no_duel(OfThreePairs "max_pairs = capsules_per_body squared" "CHANGE=scene.max_pairs = 3")
batuta_no_duel(BladesThatDoNotTurn "rotation = true: blades turn" "CHANGE=scene.rotation = false")
batuta_no_duel(BladesOfTwoParts "capsules_per_body = 3 .blade, guard, hand. or 1 .the blade alone." "CHANGE=scene.capsules_per_body = 2")
batuta_no_duel(HapticsWithoutEvents "haptics takes max_events > 0" "CHANGE=scene.max_events = 0")
batuta_no_duel(Misspelt "target.*did you mean .*targets" "CHANGE=scene.target = false")
batuta_no_duel(OfAGenericScene "name a DuelScene itself: using Drill = DuelScene<my_options>" "SCENE=Scene<plain>")
batuta_no_duel(OfADerivedScene "name a DuelScene itself: using Drill = DuelScene<my_options>" SCENE=Derived)
batuta_no_duel(OfGenericOptions "its first argument is a constexpr function" "SCENE=DuelScene<plain>")
batuta_no_duel(FrictionThatSeparates "friction takes resting = RestingContact::kSettling" "CHANGE=scene.friction = true")
