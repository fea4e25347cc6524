# SPDX-License-Identifier: MIT
# What only the trees of the emulated boards are asked: the scenes, sizes of types, instructions, and whether the gates
# find what is planted.
foreach(scene detection_only two_capsules duel)
  add_executable(price_${scene} scene/${scene}.cpp)
  target_link_libraries(price_${scene} PRIVATE batuta::batuta batuta_core_flags)
  batuta_price_image(price_${scene})
  list(APPEND images "\"${scene}\": \"$<TARGET_FILE:price_${scene}>\"")
endforeach()

add_library(price_sizes OBJECT sizes.cpp)
target_link_libraries(price_sizes PRIVATE batuta::batuta batuta_core_flags)

if(TARGET batuta-fencing)
  target_compile_definitions(price_sizes PRIVATE BATUTA_PRICE_FIRMWARE)
  target_link_libraries(price_sizes PRIVATE batuta_firmware batuta_port_mps2)
endif()

set(digest ${PROJECT_SOURCE_DIR}/tests/target/digest)
add_executable(price_bench
  bench/main.cpp bench/search.cpp bench/kernels.cpp bench/bout.cpp bench/ticks.cpp bench/samples.cpp
  ${digest}/input.cpp ${digest}/io_semihosting.cpp)
target_include_directories(price_bench PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/.. ${PROJECT_SOURCE_DIR}/tests/target)
target_link_libraries(price_bench PRIVATE batuta::batuta batuta_core_flags batuta_semihosting)
batuta_price_image(price_bench)

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
list(JOIN scenes ",\n    " scenes)

set(measured "\"sizes\": \"$<TARGET_OBJECTS:price_sizes>\", \"bench\": \"$<TARGET_FILE:price_bench>\",
  \"scenes\": {
    ${scenes}
  },")
