/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Registers the models for the mixture of MPPICInterFoam, whose turbulence
// carries density and fluid fraction

#include "PhaseCompressibleTurbulenceModel.H"
#include "immiscibleIncompressibleTwoPhaseMixture.H"
#include "addToRunTimeSelectionTable.H"
#include "makeTurbulenceModel.H"
#include "turbulentTransportModel.H"
#include "LESModel.H"
#include "jetKEpsilon.H"

makeTurbulenceModelTypes
(
    volScalarField,
    volScalarField,
    compressibleTurbulenceModel,
    PhaseCompressibleTurbulenceModel,
    immiscibleIncompressibleTwoPhaseMixture
);

#define makeRASModel(Type)                                                     \
    makeTemplatedTurbulenceModel                                               \
    (                                                                          \
       immiscibleIncompressibleTwoPhaseMixturePhaseCompressibleTurbulenceModel,\
       RAS,                                                                    \
       Type                                                                    \
    )

makeRASModel(jetKEpsilon);

// ************************************************************************* //
