# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# CMake toolchain: Debian's cross compiler for aarch64 (package g++-aarch64-linux-gnu). For compiling
# only: libraries to link with are not at hand, and headers of LIGGGHTS and MPI are this machine's.
#   cmake -S . -B build-aarch64 -DCMAKE_TOOLCHAIN_FILE=validation/compilers/aarch64.cmake

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Where this machine's libraries are: LIGGGHTS' is read for its version, others are named only
set(CMAKE_LIBRARY_PATH /usr/lib/${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-gnu)
