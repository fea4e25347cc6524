# SPDX-License-Identifier: MIT
# Which TinyUSB the board's USB stick is compiled with, in a tree of its own. PROJECT: the library; WORK: a folder; TREE: what
# configures such a tree; AR: the archiver.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/empty)

# What stands for TinyUSB: its files as far as the image names them, which want what they are to be told.
set(tinyusb ${WORK}/tinyusb)
set(files tusb tusb_fifo usbd usbd_control hid_device dcd_dwc2 dwc2_common)
foreach(file src/tusb.c src/common/tusb_fifo.c src/device/usbd.c src/device/usbd_control.c src/class/hid/hid_device.c
        src/portable/synopsys/dwc2/dcd_dwc2.c src/portable/synopsys/dwc2/dwc2_common.c)
  file(WRITE ${tinyusb}/${file} "#include \"own.h\"\n#include \"part.h\"\n#include \"core.h\"\n#include \"tusb_config.h\"\n"
    "#ifndef STM32F405xx\n#error STM32F405xx\n#endif\nextern int nothing;\n")
endforeach()
file(WRITE ${tinyusb}/src/own.h "")
file(WRITE ${tinyusb}/hw/mcu/st/cmsis_device_f4/Include/part.h "")
file(WRITE ${tinyusb}/lib/CMSIS_5/CMSIS/Core/Include/core.h "")

# expect(<text> <what has to be in it> <what must not>)
function(expect text wanted unwanted)
  string(REGEX REPLACE "[ \n]+" " " flat "${text}")
  string(FIND "${flat}" "${wanted}" place)
  if(wanted AND place EQUAL -1)
    message(FATAL_ERROR "not \"${wanted}\", but:\n${text}")
  endif()
  string(FIND "${flat}" "${unwanted}" place)
  if(unwanted AND NOT place EQUAL -1)
    message(FATAL_ERROR "\"${unwanted}\" in:\n${text}")
  endif()
endfunction()

# configure(<option>...): sets `told`, and `compiled` to the commands with which the tree then compiles.
function(configure)
  file(REMOVE ${WORK}/build/compile_commands.json)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${PROJECT} -B ${WORK}/build ${TREE} -DBATUTA_BUILD_TESTS=OFF ${ARGN}
                  OUTPUT_VARIABLE told ERROR_VARIABLE told)
  set(compiled "")
  if(EXISTS ${WORK}/build/compile_commands.json)
    file(READ ${WORK}/build/compile_commands.json compiled)
  endif()
  return(PROPAGATE told compiled)
endfunction()

configure(-DBATUTA_TINYUSB=${WORK}/empty)
expect("${told}" "BATUTA_TINYUSB=${WORK}/empty: there is no src/tusb.c" "Generating done")

configure(-DBATUTA_TINYUSB=${tinyusb})
expect("${told}" "BATUTA_USB_VENDOR and BATUTA_USB_PRODUCT are not set" "CMake Error")
expect("${compiled}" "${tinyusb}/src/tusb.c" "absent_tinyusb")
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build --target batuta-usb-stick-stack
                COMMAND_ERROR_IS_FATAL ANY)
file(GLOB_RECURSE stack ${WORK}/build/libbatuta-usb-stick-stack.a)
execute_process(COMMAND ${AR} t ${stack} OUTPUT_VARIABLE members COMMAND_ERROR_IS_FATAL ANY)
foreach(file IN LISTS files)
  expect("${members}" "${file}.c" "")
endforeach()

configure(-DBATUTA_TINYUSB=${tinyusb} -DBATUTA_USB_VENDOR=0x1209 -DBATUTA_USB_PRODUCT=0x0001)
expect("${told}" "Generating done" "are not set")
expect("${compiled}" "-DBATUTA_USB_VENDOR=0x1209" "")

configure(-DBATUTA_TINYUSB=)
expect("${told}" "Generating done" "CMake Error")
expect("${compiled}" "absent_tinyusb.cpp" "${tinyusb}")
