/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Registers the models for the incompressible solvers (simpleFoam, pisoFoam,
// pimpleFoam, icoUncoupledKinematicParcelFoam ...)

#include "turbulentTransportModels.H"
#include "jetKEpsilon.H"

makeRASModel(jetKEpsilon);

// ************************************************************************* //
