# CMake toolchain for a bare Cortex-M, with the emulator in front of every test:
# cmake -B build/m4 -S . -DCMAKE_TOOLCHAIN_FILE=$PWD/test/semihost/toolchain-arm-none-eabi.cmake
# -DSEMIHOST_CPU=cortex-m7 chooses the other processor.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SEMIHOST_CPU)

set(SEMIHOST_CPU cortex-m4 CACHE STRING "cortex-m4 or cortex-m7")
if(SEMIHOST_CPU STREQUAL "cortex-m4")
  set(_flags "-mcpu=cortex-m4 -mfpu=fpv4-sp-d16")
  set(_machine mps2-an386)
elseif(SEMIHOST_CPU STREQUAL "cortex-m7")
  set(_flags "-mcpu=cortex-m7 -mfpu=fpv5-sp-d16")
  set(_machine mps2-an500)
else()
  message(FATAL_ERROR "SEMIHOST_CPU is ${SEMIHOST_CPU}; cortex-m4 and cortex-m7 are known")
endif()

set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_C_FLAGS_INIT "${_flags} -mthumb -mfloat-abi=hard -fno-math-errno -ffp-contract=off -ffunction-sections -fdata-sections")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostartfiles -Wl,--gc-sections -T ${CMAKE_CURRENT_LIST_DIR}/mps2.ld")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-system-arm -M ${_machine} -display none -monitor none -serial none -semihosting-config enable=on,target=native -kernel)

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
