# SPDX-License-Identifier: MIT
# 64-bit Raspberry Pi OS and Debian: Pi 3, 4, 5 and Zero 2. See rpi.cmake for the options.
set(RPI_ARCHITECTURE arm64)
set(RPI_TRIPLET aarch64-linux-gnu)
set(RPI_PROCESSOR aarch64)
set(RPI_QEMU qemu-aarch64)
set(RPI_FLAGS_any -march=armv8-a)
set(RPI_FLAGS_pi3 -mcpu=cortex-a53)
set(RPI_FLAGS_pi4 -mcpu=cortex-a72)
set(RPI_FLAGS_pi5 -mcpu=cortex-a76)
include(${CMAKE_CURRENT_LIST_DIR}/rpi.cmake)
