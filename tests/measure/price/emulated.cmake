# SPDX-License-Identifier: MIT
# What only the trees of the emulated boards are asked: the scenes, sizes of types, instructions, and whether the gates
# find what is planted.
# batuta_price_scene_image(<name> <file> [definition...])
function(batuta_price_scene_image name file)
  add_executable(price_${name} scene/${file})
  target_compile_definitions(price_${name} PRIVATE ${ARGN})
  target_link_libraries(price_${name} PRIVATE batuta::batuta batuta_core_flags)
  batuta_price_image(price_${name})
  list(APPEND images "\"${name}\": \"$<TARGET_FILE:price_${name}>\"")
  set(images "${images}" PARENT_SCOPE)
endfunction()

batuta_price_scene_image(detection_only detection_only.cpp)
batuta_price_scene_image(two_capsules two_capsules.cpp)
batuta_price_scene_image(duel duel.cpp PRICE_SEARCH=Advancement)

add_library(price_sizes OBJECT sizes.cpp)
target_link_libraries(price_sizes PRIVATE batuta::batuta batuta_core_flags)

if(TARGET batuta-fencing)
  target_compile_definitions(price_sizes PRIVATE BATUTA_PRICE_FIRMWARE)
  target_link_libraries(price_sizes PRIVATE batuta_firmware batuta_port_mps2)
endif()

# batuta_price_bench(<target> <file> [definition...]): the file says what is measured of a bout.
set(digest ${PROJECT_SOURCE_DIR}/tests/target/digest)
function(batuta_price_bench target file)
  add_executable(${target}
    bench/main.cpp bench/search.cpp bench/kernels.cpp bench/${file} bench/sticks.cpp bench/ticks.cpp bench/samples.cpp
    ${digest}/input.cpp ${digest}/io_semihosting.cpp)
  target_compile_definitions(${target} PRIVATE ${ARGN})
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/.. ${PROJECT_SOURCE_DIR}/tests/target)
  target_link_libraries(${target} PRIVATE batuta::batuta batuta_core_flags batuta_semihosting)
  batuta_price_image(${target})
endfunction()

batuta_price_bench(price_bench bout.cpp PRICE_SEARCH=Advancement)

# The paper's own search from end to end, an opponent in place of a stick, and what measures a stick, where bounds are
# promised.
set(choices "")
if(BATUTA_CPU STREQUAL "cortex-m4f")
  batuta_price_scene_image(measurement measurement.cpp)
  batuta_price_scene_image(duel_stepping duel.cpp PRICE_SEARCH=Stepping)
  batuta_price_bench(price_bench_duel_stepping bout.cpp PRICE_SEARCH=Stepping)
  list(APPEND choices "\"duel_stepping\": \"$<TARGET_FILE:price_bench_duel_stepping>\"")
  batuta_price_bench(price_bench_opponent rival.cpp)
  target_link_libraries(price_bench_opponent PRIVATE batuta_firmware)
  list(APPEND choices "\"opponent\": \"$<TARGET_FILE:price_bench_opponent>\"")
endif()

foreach(plant heap operator_new throw guard double libm stdio recursion indirect_call vla)
  add_executable(price_plant_${plant} plants/${plant}.cpp plants/system_calls.cpp)
  target_link_libraries(price_plant_${plant} PRIVATE batuta::batuta)
  batuta_price_image(price_plant_${plant})
  list(APPEND plants "\"${plant}\": \"$<TARGET_FILE:price_plant_${plant}>\"")
endforeach()
# What is planted has to be compiled the way that is not allowed.
target_compile_options(price_plant_throw PRIVATE -fexceptions)
target_link_options(price_plant_throw PRIVATE "LINKER:--defsym=__exidx_start=0,--defsym=__exidx_end=0")
target_compile_options(price_plant_guard PRIVATE -fthreadsafe-statics)

include(scenes.cmake)
list(JOIN choices ",\n    " choices)
list(JOIN scenes ",\n    " scenes)

set(measured "\"sizes\": \"$<TARGET_OBJECTS:price_sizes>\", \"bench\": \"$<TARGET_FILE:price_bench>\",
  \"choices\": {
    ${choices}
  },
  \"scenes\": {
    ${scenes}
  },")
