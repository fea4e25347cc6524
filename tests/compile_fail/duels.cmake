# SPDX-License-Identifier: MIT
# What a duel's scene leaves out cannot be asked for, and the message says which feature it belongs to.
foreach(off kSleep kGrip kTargets kHaptics)
  batuta_must_compile(Control_Duel_${off} duel_features.cpp -DOFF=${off})
endforeach()
batuta_must_compile(Control_Duel_Grip duel_features.cpp "-DCALL=grip(batuta::Side::kLeft)")
batuta_must_compile(Control_Duel_Body duel_features.cpp "-DCALL=body_W(batuta::Side::kLeft)")
batuta_must_not_compile(Duel_GripWithoutGrip duel_features.cpp "without kGrip there is no grip" -DOFF=kGrip
                        "-DCALL=grip(batuta::Side::kLeft)")
batuta_must_not_compile(Duel_BodyWithoutTargets duel_features.cpp "without kTargets there is no body_W" -DOFF=kTargets
                        "-DCALL=body_W(batuta::Side::kLeft)")
batuta_must_compile(Control_Duel_HeldHand duel_features.cpp "-DCALL=held_hand_W(batuta::Side::kLeft)")
batuta_must_not_compile(Duel_HeldHandWithoutHaptics duel_features.cpp "without kHaptics there is no held_hand_W" -DOFF=kHaptics
                        "-DCALL=held_hand_W(batuta::Side::kLeft)")
batuta_must_not_compile(Duel_BladesThatDoNotTurn duel_features.cpp "its scene takes kRotation = true" -DOFF=kRotation)
batuta_must_not_compile(Duel_BladesOfTwoParts duel_features.cpp "its scene takes kCapsulesPerBody = 1" -DCAPSULES=2)
batuta_must_not_compile(Duel_OfAnotherSearch duel_features.cpp "derive its scene from DuelScene"
                        -DSEARCH=batuta::Stepping<float>)
