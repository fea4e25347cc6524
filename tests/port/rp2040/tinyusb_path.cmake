# SPDX-License-Identifier: MIT
# Which TinyUSB the SDK is told to take. PROJECT: port/platforms/rp2040/sdk; SDK: what stands for the Pico SDK; WORK: a folder.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/tinyusb/src/tusb.c "")
file(MAKE_DIRECTORY ${WORK}/empty)

# expect(<what is said> <folder for BATUTA_TINYUSB>)
function(expect said folder)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${PROJECT} -B ${WORK}/build -DPICO_SDK_PATH=${SDK} -DBATUTA_TINYUSB=${folder}
                  OUTPUT_VARIABLE told ERROR_VARIABLE told)
  string(REGEX REPLACE "[ \n]+" " " told "${told}")
  string(FIND "${told}" "${said}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "with BATUTA_TINYUSB=${folder} not \"${said}\", but:\n${told}")
  endif()
endfunction()

expect("TinyUSB of the SDK is <>" "")
expect("TinyUSB of the SDK is <${WORK}/tinyusb>" ${WORK}/tinyusb)
expect("there is no src/tusb.c" ${WORK}/empty)
expect("TinyUSB of the SDK is <>" "")
