# SPDX-License-Identifier: MIT
set(use -include ${prepared})

# What a duel's scene leaves out cannot be asked for, and the message says which feature it belongs to.
foreach(off kSleep kGrip kTargets kHaptics)
  batuta_must_compile(Control_Duel_${off} duel_features.cpp ${use} -DOFF=${off})
endforeach()
batuta_must_compile(Control_Duel_Grip duel_features.cpp ${use} "-DCALL=grip(batuta::Side::kLeft)")
batuta_must_compile(Control_Duel_Body duel_features.cpp ${use} "-DCALL=body_W(batuta::Side::kLeft)")
batuta_must_not_compile(Duel_GripWithoutGrip duel_features.cpp "without kGrip there is no grip" ${use} -DOFF=kGrip
                        "-DCALL=grip(batuta::Side::kLeft)")
batuta_must_not_compile(Duel_BodyWithoutTargets duel_features.cpp "without kTargets there is no body_W" ${use} -DOFF=kTargets
                        "-DCALL=body_W(batuta::Side::kLeft)")
batuta_must_compile(Control_Duel_HeldHand duel_features.cpp ${use} "-DCALL=held_hand_W(batuta::Side::kLeft)")
batuta_must_not_compile(Duel_HeldHandWithoutHaptics duel_features.cpp "without kHaptics there is no held_hand_W" ${use} -DOFF=kHaptics
                        "-DCALL=held_hand_W(batuta::Side::kLeft)")
batuta_must_not_compile(Duel_BladesThatDoNotTurn duel_features.cpp "its scene takes kRotation = true" ${use} -DOFF=kRotation)
batuta_must_not_compile(Duel_BladesOfTwoParts duel_features.cpp "its scene takes kCapsulesPerBody = 1" ${use} -DCAPSULES=2)
batuta_must_not_compile(Duel_OfAnotherSearch duel_features.cpp "derive its scene from DuelScene" ${use}
                        -DSEARCH=batuta::Stepping<float>)
