# SPDX-License-Identifier: MIT
# The scenes: each an object that is linked twice, into an image of nothing else (flash, RAM, stack) and into a bench that
# counts the instructions of a run. tools/scenes.py knows what belongs together.
add_library(price_scene_bench OBJECT
  bench/scene.cpp bench/starts.cpp bench/ticks.cpp bench/samples.cpp ${PROJECT_SOURCE_DIR}/tests/target/digest/io_semihosting.cpp)
target_include_directories(price_scene_bench PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/.. ${PROJECT_SOURCE_DIR}/tests/target)
target_link_libraries(price_scene_bench PRIVATE batuta::batuta batuta_core_flags batuta_semihosting)

set(scenes "")
# batuta_price_scene(<name> <file> [definition...])
function(batuta_price_scene name file)
  add_library(price_object_${name} OBJECT ${file})
  target_compile_definitions(price_object_${name} PRIVATE ${ARGN})
  target_include_directories(price_object_${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/scene)
  target_link_libraries(price_object_${name} PRIVATE batuta::batuta batuta_core_flags)
  add_executable(price_scene_${name} scene/main.cpp $<TARGET_OBJECTS:price_object_${name}>)
  target_link_libraries(price_scene_${name} PRIVATE batuta::batuta batuta_core_flags)
  batuta_price_image(price_scene_${name})
  add_executable(price_run_${name} $<TARGET_OBJECTS:price_object_${name}> $<TARGET_OBJECTS:price_scene_bench>)
  target_link_libraries(price_run_${name} PRIVATE batuta::batuta batuta_core_flags batuta_semihosting)
  list(APPEND scenes
    "\"${name}\": {\"image\": \"$<TARGET_FILE:price_scene_${name}>\", \"run\": \"$<TARGET_FILE:price_run_${name}>\"}")
  set(scenes "${scenes}" PARENT_SCOPE)
endfunction()

batuta_price_scene(empty scene/empty.cpp)
foreach(scene StraightSpheres DetectionOnly TwoBlades Rack)
  batuta_price_scene(${scene} scene/world.cpp PRICE_SCENE=batuta::${scene})
endforeach()

# By hand, and feature by feature, where bounds are promised.
if(BATUTA_CPU STREQUAL "cortex-m4f")
  batuta_price_scene(StraightSpheres_by_hand scene/by_hand/straight_spheres.cpp)
  batuta_price_scene(DetectionOnly_by_hand scene/by_hand/detection_only.cpp)
  batuta_price_scene(TwoBlades_by_hand scene/by_hand/two_blades.cpp)
endif()
if(BATUTA_CPU STREQUAL "cortex-m4f" AND BATUTA_THOROUGH)
  foreach(variant NoRestitution RestingNone RestingSettling NoResponse Friction LineContact Gravity Sleep NoEvents NoOwners
          Filters TwoParts WithTranslation WithStepping WithCoarseBox Unturned NoRotation Balls
          SpheresWithEvents)
    batuta_price_scene(${variant} scene/world.cpp PRICE_SCENE=batuta::price::${variant})
  endforeach()
endif()

# What the table of scenes is made of, and nothing else.
get_property(made DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
list(FILTER made INCLUDE REGEX "^price_(scene|run)_")
list(REMOVE_ITEM made price_scene_bench)
add_custom_target(price-scenes DEPENDS ${made})
