# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Read by cpack for each kind of package: which of the two sets of places it takes (packages.cmake).

set(component archive)
if(CPACK_GENERATOR STREQUAL "DEB")
  set(component debian)
endif()
list(GET CPACK_INSTALL_CMAKE_PROJECTS 0 build)
set(CPACK_INSTALL_CMAKE_PROJECTS "${build};grainjet;${component};/")
