/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The plugin command of LIGGGHTS, compiled into this library: a script with
    `plugin load` runs here as it does under the launcher. The files lie outside of this
    folder, where wmake keeps no objects, and so are taken in as one.

\*---------------------------------------------------------------------------*/

#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Wunused-parameter"

#include "loader/lammps_create_hook.cpp"
#include "loader/plugin_command.cpp"
#include "loader/plugin_loader.cpp"
#include "loader/plugin_file.cpp"
#include "loader/host_build.cpp"
#include "loader/interposition.cpp"
#include "loader/library_file.cpp"
#include "loader/style_maps.cpp"
#include "loader/script_start.cpp"


// ************************************************************************* //
