# SPDX-License-Identifier: MIT
# Scenes that cannot be: each fails with the sentence of scene_check.hpp that says what to change, and with nothing else.
set(scene impossible_scene.cpp)
set(use -include ${prepared_world})

# batuta_impossible_scene(<name> <regular expression of the message> [macro of the case...]): with the build's compiler
function(batuta_impossible_scene name message)
  list(TRANSFORM ARGN PREPEND -D)
  batuta_one_error(Scene_${name} ${scene} ${message} ${use} ${ARGN})
endfunction()

# batuta_no_scene(<name> <file> <regular expression of the message> [flag...]): with every compiler that is there
function(batuta_no_scene name file message)
  batuta_one_error(Scene_${name} ${file} ${message} ${use} ${ARGN})
  if(clang)
    batuta_one_error_by_clang(Scene_${name} ${file} ${message} ${ARGN})
  endif()
endfunction()

# The bases, and what the cases change where it is possible.
foreach(base plain unrested settling sleepy silent crowd hurried)
  batuta_must_compile(Control_Scene_${base} ${scene} ${use} -DBASE=${base})
endforeach()
batuta_must_compile(Control_Scene_straight ${scene} ${use} -DBASE=straight -DSEARCH=Translation<float>)
batuta_must_compile(Control_Scene_spherical ${scene} ${use} -DBASE=straight -DSEARCH=Spheres<double>)
batuta_must_compile(Control_Scene_small ${scene} ${use} -DBASE=small -DSEARCH=Spheres<float> -DWITHOUT_EVENTS)
batuta_must_compile(Control_Scene_FrictionThatSettles ${scene} ${use} -DBASE=settling "-DCHANGE=scene.friction = true")
batuta_must_compile(Control_Scene_FrictionWithoutRest ${scene} ${use} -DBASE=unrested "-DCHANGE=scene.friction = true")
batuta_must_compile(Control_Scene_TwoCapsules ${scene} ${use} "-DCHANGE=scene.capsules_per_body = 2")
batuta_must_compile(Control_Scene_EightSmallBodies ${scene} ${use} -DBASE=small -DSEARCH=Translation<float>
                    "-DCHANGE=scene.max_bodies = 8" -DWITHOUT_EVENTS)
batuta_must_compile(Control_Scene_HalfAsManyPairs ${scene} ${use}
                    "-DCHANGE=(scene.max_bodies = 9, scene.max_pairs = 4)")
batuta_must_compile(Control_Scene_OwnController ${scene} ${use} -DCONTROLLER=Own)
batuta_must_compile(Control_Scene_CoarseBox ${scene} ${use} -DBOUND=CoarseBox)
batuta_must_compile(Control_Scene_IsNamed no_scene.cpp ${use})

# What is misspelt, or stated where nobody reads it.
batuta_no_scene(Misspelt_max_bodies ${scene} "max_bodis.*did you mean .*max_bodies" "-DCHANGE=scene.max_bodis = 3")
batuta_no_scene(Misspelt_filters ${scene} "filter.*did you mean .*filters" "-DCHANGE=scene.filter = true")
batuta_no_scene(Misspelt_beyondRecognition ${scene} "no member named .*capacity" "-DCHANGE=scene.capacity = 3")
foreach(option grip targets haptics)
  batuta_no_scene(Misplaced_${option} ${scene} "no member named .*${option}" "-DCHANGE=scene.${option} = true")
endforeach()
batuta_no_scene(Derived no_scene.cpp "name the scene itself: using MyScene = Scene<my_options>" -DDERIVED)
batuta_no_scene(DerivedInPrivate no_scene.cpp "name the scene itself: using MyScene = Scene<my_options>" -DDERIVED_IN_PRIVATE)
foreach(what WITHOUT_BASE OTHER_BASE NUMBER)
  batuta_no_scene(${what} no_scene.cpp "its scene is a Scene: using MyScene = Scene<my_options>" -D${what})
endforeach()
foreach(what OPTIONS_OF_ANOTHER_TYPE NO_FUNCTION)
  batuta_no_scene(${what} no_scene.cpp "its first argument is a constexpr function that returns SceneOptions" -D${what})
endforeach()
batuta_no_scene(SearchLeftOut no_scene.cpp "its second argument is a search" -DSEARCH_LEFT_OUT)

batuta_no_scene(OfDuelOptions no_scene.cpp "its options lost what DuelOptions add" -DDUEL_OPTIONS)
batuta_no_scene(OfADuel no_scene.cpp "a DuelScene is for a Duel" -DDUEL_SCENE)
foreach(qualifier const volatile)
  batuta_no_scene(Of${qualifier} no_scene.cpp "name its scene without const or volatile" -DQUALIFIER=${qualifier})
endforeach()

# Values of another kind, which the compiler would turn into a count or a switch: refused at the line that states them.
batuta_no_scene(OfKindCharacter_max_bodies ${scene} "deleted" "-DCHANGE=scene.max_bodies = '8'")
foreach(value 2.5F \"8\" true)
  string(MAKE_C_IDENTIFIER "${value}" kind)
  batuta_no_scene(OfKind${kind}_max_bodies ${scene} "deleted" "-DCHANGE=scene.max_bodies = ${value}")
endforeach()
foreach(value -9.81F 1 nullptr)
  string(MAKE_C_IDENTIFIER "${value}" kind)
  batuta_no_scene(OfKind${kind}_gravity ${scene} "deleted" "-DCHANGE=scene.gravity = ${value}")
endforeach()
foreach(option turn_per_step contact_tolerance)
  batuta_no_scene(OfKindBool_${option} ${scene} "deleted" "-DCHANGE=scene.${option} = true")
endforeach()
batuta_must_compile(Control_Scene_Changed ${scene} ${use}
                    "-DCHANGE=(scene.max_pairs *= 6, scene.max_pairs += 2, scene.max_pairs -= 1, scene.max_contacts /= 2)")
batuta_must_compile(Control_Scene_OfOtherWholeNumbers ${scene} ${use}
                    "-DCHANGE=(scene.max_pairs = 3U, scene.max_contacts = 8ULL, scene.max_events = static_cast<unsigned char>(9))")
batuta_no_scene(OfAnotherEngine ${scene} "engine: choose Engine::kGeneral or Engine::kSmall"
                "-DCHANGE=scene.engine = static_cast<Engine>(7)")
batuta_no_scene(OfAnotherRest ${scene} "resting: choose RestingContact::kNone, kSeparation or kSettling"
                "-DCHANGE=scene.resting = static_cast<RestingContact>(7)")

# What nobody would read.
batuta_impossible_scene(SleeplessTime "sleep_time takes sleep = true" "CHANGE=scene.sleep_time = 9")
foreach(base plain unrested)
  batuta_impossible_scene(SeparationsOf_${base} "max_separations takes resting = RestingContact::kSettling" BASE=${base}
                          "CHANGE=scene.max_separations = 9")
endforeach()
batuta_no_scene(StraightWithController ${scene} "without rotation, bodies fly by their momenta and ask no controller" -DBASE=straight
                -DSEARCH=Translation<float> -DCONTROLLER=Own)
batuta_no_scene(SmallWithPairs ${scene} "Engine::kSmall has room for all pairs" -DBASE=small "-DCHANGE=scene.max_pairs = 28"
                -DSEARCH=Translation<float>)
batuta_no_scene(SmallWithAxis ${scene} "Engine::kSmall keeps no boxes in order" -DBASE=small "-DCHANGE=scene.sweep_axis = 1"
                -DSEARCH=Translation<float>)

# Controllers and scalars.
batuta_no_scene(ControllerWithoutPlan ${scene} "its controller lacks PlannedMotion<Scalar> plan" -DCONTROLLER=WithoutPlan)
batuta_no_scene(ControllerWithoutContact ${scene} "its controller lacks void on_contact" -DCONTROLLER=WithoutContact)
batuta_no_scene(ControllerWithoutStepEnd ${scene} "its controller lacks void on_step_end" -DCONTROLLER=WithoutStepEnd)
batuta_no_scene(ControllerOfAnotherScalar ${scene} "its controller and its search take different scalars" -DCONTROLLER=FreeFlight<double>)
batuta_no_scene(OwnControllerOfAnotherScalar ${scene} "its controller and its search take different scalars" -DCONTROLLER=Own
                -DSEARCH=Advancement<double>)
batuta_no_scene(OfIntegers ${scene} "its search is one of float or double" -DSEARCH=Advancement<int>)
batuta_no_scene(BoundThatIsNone ${scene} "its fourth argument is SweptBox or CoarseBox" -DBOUND=int)

# Capacities.
foreach(count 1 65535)
  batuta_impossible_scene(Of${count}Bodies "max_bodies: choose 2 ... 65534" "CHANGE=scene.max_bodies = ${count}")
endforeach()
foreach(count 0 256)
  batuta_impossible_scene(Of${count}Capsules "capsules_per_body: choose 1 ... 255" "CHANGE=scene.capsules_per_body = ${count}")
endforeach()
batuta_impossible_scene(Of65536Capsules "no more than 65535 capsules in all" BASE=crowd "CHANGE=scene.capsules_per_body = 64")
foreach(count 0 -1 65536 2147483647 4294967298)
  foreach(capacity max_pairs max_contacts)
    batuta_impossible_scene(Of${count}_${capacity} "${capacity}: choose 1 ... 65535" "CHANGE=scene.${capacity} = ${count}")
  endforeach()
  batuta_impossible_scene(Of${count}_max_separations "max_separations: choose 1 ... 65535" BASE=settling
                          "CHANGE=scene.max_separations = ${count}")
endforeach()
foreach(count -1 65536 4294967295)
  batuta_impossible_scene(Of${count}_max_events "max_events: choose 0 ... 65535" "CHANGE=scene.max_events = ${count}")
endforeach()
foreach(count -1 4097 4294967295)
  batuta_impossible_scene(OfBudget${count} "budget: choose 1 ... 4096" "CHANGE=scene.budget = ${count}")
endforeach()
batuta_impossible_scene(OfBudgetBeyondSteps "budget: choose 1 ... 4096" SEARCH=Stepping<float> "CHANGE=scene.budget = 1000000001")
batuta_impossible_scene(OfFewerStepsThanHalvings "budget: choose 1 ... 4096" SEARCH=Stepping<float> "CHANGE=scene.budget = 1")
batuta_impossible_scene(SpheresWithBudget "takes one evaluation: leave out budget" BASE=straight SEARCH=Spheres<float>
                        "CHANGE=scene.budget = 1")
foreach(search Advancement Stepping)
  batuta_must_compile(Control_Scene_LeastBudgetOf${search} ${scene} ${use} -DSEARCH=${search}<float>
                      "-DCHANGE=scene.budget = ${search}<float>::kLeastBudget")
endforeach()
batuta_must_compile(Control_Scene_OfManySteps ${scene} ${use} -DSEARCH=Stepping<float> "-DCHANGE=scene.budget = 1000000000")
batuta_must_compile(Control_Scene_OfTheMost ${scene} ${use} -DBASE=settling
  "-DCHANGE=(scene.max_pairs = scene.max_contacts = scene.max_events = scene.max_separations = 65535, scene.budget = 4096)")
foreach(seconds 0 61)
  batuta_impossible_scene(SleepsAfter${seconds}Seconds "sleep_time: choose a time above 0, at most 60 s" BASE=sleepy
                          "CHANGE=scene.sleep_time = ${seconds}")
endforeach()
batuta_impossible_scene(RollingWithoutFriction "rolling_resistance takes friction = true" BASE=settling
                        "CHANGE=scene.rolling_resistance = true, scene.friction = false")
foreach(axis -1 3)
  batuta_impossible_scene(SweptAlongAxis${axis} "sweep_axis: choose 0, 1 or 2" "CHANGE=scene.sweep_axis = ${axis}")
endforeach()
batuta_no_scene(OfFewPairs ${scene} "max_pairs: at least max_bodies / 2" "-DCHANGE=(scene.max_bodies = 8, scene.max_pairs = 3)")

# Features that exclude each other.
foreach(search Advancement Stepping)
  batuta_impossible_scene(StraightWith${search} "without rotation, the search is Translation<Scalar> or Spheres<Scalar>"
                          BASE=straight SEARCH=${search}<float>)
endforeach()
batuta_impossible_scene(SpheresThatTurn "Spheres<Scalar> takes rotation = false" BASE=unrested SEARCH=Spheres<float>)
batuta_impossible_scene(SpheresOfTwoParts "Spheres<Scalar> takes capsules_per_body = 1" BASE=straight SEARCH=Spheres<float>
                        "CHANGE=scene.capsules_per_body = 2")
foreach(resting kSeparation kSettling)
  batuta_impossible_scene(StraightWith_${resting} "without rotation, set resting = RestingContact::kNone" BASE=straight
                          SEARCH=Translation<float> "CHANGE=scene.resting = RestingContact::${resting}")
  batuta_impossible_scene(SilentWith_${resting} "without response, set resting = RestingContact::kNone" BASE=silent
                          "CHANGE=scene.resting = RestingContact::${resting}")
endforeach()
foreach(feature friction line_contact)
  batuta_impossible_scene(StraightWith_${feature} "${feature} takes rotation = true" BASE=straight SEARCH=Translation<float>
                          "CHANGE=scene.${feature} = true")
endforeach()
foreach(feature restitution friction line_contact)
  batuta_impossible_scene(SilentWith_${feature} "without response, set ${feature} = false" BASE=silent
                          "CHANGE=scene.${feature} = true")
endforeach()
batuta_impossible_scene(SilentWithoutEvents "without response, set max_events > 0" BASE=silent "CHANGE=scene.max_events = 0")
batuta_impossible_scene(FrictionThatSeparates "friction takes resting = RestingContact::kSettling" "CHANGE=scene.friction = true")
foreach(base plain unrested)
  batuta_impossible_scene(SleepOf_${base} "sleep takes resting = RestingContact::kSettling" BASE=${base}
                          "CHANGE=scene.sleep = true")
endforeach()
batuta_impossible_scene(SleepWithoutEvents "sleep takes max_events > 0" BASE=sleepy "CHANGE=scene.max_events = 0")

# What the small engine cannot do.
batuta_no_scene(SmallThatTurns ${scene} "Engine::kSmall takes rotation = false" -DBASE=small "-DCHANGE=scene.rotation = true"
                -DSEARCH=Translation<float>)
batuta_no_scene(SmallWithEvents ${scene} "Engine::kSmall takes max_events = 0" -DBASE=small "-DCHANGE=scene.max_events = 1"
                -DSEARCH=Translation<float>)
batuta_no_scene(SmallWithoutResponse ${scene} "Engine::kSmall takes response = true" -DBASE=small
                "-DCHANGE=scene.response = false" -DSEARCH=Translation<float>)
batuta_no_scene(SmallOfTwoParts ${scene} "Engine::kSmall takes capsules_per_body = 1" -DBASE=small
                "-DCHANGE=scene.capsules_per_body = 2" -DSEARCH=Translation<float>)
batuta_no_scene(SmallOfNineBodies ${scene} "Engine::kSmall takes max_bodies of at most 8" -DBASE=small
                "-DCHANGE=scene.max_bodies = 9" -DSEARCH=Translation<float>)

# Turn, contact tolerance and budget.
batuta_impossible_scene(ToleranceAboveOne "contact_tolerance: 0 ... 1" "CHANGE=scene.contact_tolerance = 1.5F")
batuta_impossible_scene(TurnBelowNothing "turn_per_step: choose 0 ... 3.14" "CHANGE=scene.turn_per_step = -1")
batuta_impossible_scene(TurnBeyondHalfATurn "turn_per_step: choose 0 ... 3.14" "CHANGE=scene.turn_per_step = 3.15F")
batuta_impossible_scene(TurnWithoutEnd "turn_per_step: choose 0 ... 3.14" "CHANGE=scene.turn_per_step = std::numeric_limits<float>::infinity()")
batuta_impossible_scene(TurnOfWhatFliesStraight "turn_per_step takes rotation = true" BASE=straight SEARCH=Translation<float>
                        "CHANGE=scene.turn_per_step = 1")
batuta_impossible_scene(ToleranceWithStepping "have a meaning for Advancement and Translation only" "CHANGE=scene.contact_tolerance = 1e-3F"
                        SEARCH=Stepping<float>)
batuta_impossible_scene(TurnOfSevenEvaluations "turn_per_step takes a budget of at least 8"
                        "CHANGE=(scene.turn_per_step = 1, scene.budget = 7)")
batuta_impossible_scene(BudgetTooSmallForTurnAndTolerance "budget does not suffice for this turn_per_step" BASE=hurried
                        "CHANGE=scene.budget = 15")
