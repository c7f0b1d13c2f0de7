# SPDX-License-Identifier: MIT
# 32-bit Raspberry Pi OS and Debian's armhf: Pi 2, 3, 4. A Pi 1 or Zero has an ARMv6 processor (pi1), which Debian's
# libraries do not run on: that needs a sysroot copied from Raspberry Pi OS. See rpi.cmake for the options.
set(RPI_ARCHITECTURE armhf)
set(RPI_TRIPLET arm-linux-gnueabihf)
set(RPI_PROCESSOR armv7l)
set(RPI_QEMU qemu-arm)
set(RPI_FLAGS_any "-march=armv7-a -mfpu=vfpv3-d16 -mfloat-abi=hard -mthumb")
set(RPI_FLAGS_pi1 "-march=armv6 -mfpu=vfp -mfloat-abi=hard -marm")
set(RPI_FLAGS_pi2 "-mcpu=cortex-a7 -mfpu=neon-vfpv4 -mfloat-abi=hard -mthumb")
set(RPI_FLAGS_pi3 "-mcpu=cortex-a53 -mfpu=neon-fp-armv8 -mfloat-abi=hard -mthumb")
set(RPI_FLAGS_pi4 "-mcpu=cortex-a72 -mfpu=neon-fp-armv8 -mfloat-abi=hard -mthumb")
include(${CMAKE_CURRENT_LIST_DIR}/rpi.cmake)
