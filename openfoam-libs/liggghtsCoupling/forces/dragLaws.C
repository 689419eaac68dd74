/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The drag laws for many grains at once, compiled into this library. The file lies
    outside of this folder, where wmake keeps no objects.

\*---------------------------------------------------------------------------*/

#include "physics/drag/drag_batch.cpp"


// ************************************************************************* //
