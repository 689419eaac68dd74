/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Registers the models for the compressible solvers (rhoPimpleFoam,
// buoyantPimpleFoam, sonicFoam, reactingFoam ...) and for the mixture of
// compressibleInterFoam and compressibleMultiphaseInterFoam

#include "turbulentFluidThermoModels.H"
#include "jetKEpsilon.H"

makeRASModel(jetKEpsilon);

// ************************************************************************* //
