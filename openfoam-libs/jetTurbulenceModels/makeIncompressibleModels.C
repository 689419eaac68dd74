/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Registers the models for the incompressible solvers (simpleFoam, pisoFoam,
// pimpleFoam ...), and for those of several immiscible ones, which solve for the
// mixture (interFoam, interIsoFoam, multiphaseInterFoam ...)

#include "turbulentTransportModels.H"
#include "jetKEpsilon.H"

makeRASModel(jetKEpsilon);

// ************************************************************************* //
