/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Registers the models for the phase-weighted turbulence of DPMFoam and
// MPPICFoam (the fluid fraction enters every term of the equations). From v2012
// on they have a class of their own, whose header lies with the solver; where
// an installation has no sources of solvers there is nothing to register

#if OPENFOAM < 2012
    #include "PhaseIncompressibleTurbulenceModel.H"
    #define solverClass PhaseIncompressibleTurbulenceModel
#elif __has_include("DPMIncompressibleTurbulenceModel.H")
    #include "DPMIncompressibleTurbulenceModel.H"
    #define solverClass DPMIncompressibleTurbulenceModel
#endif

#ifdef solverClass

#include "singlePhaseTransportModel.H"
#include "addToRunTimeSelectionTable.H"
#include "makeTurbulenceModel.H"
#include "laminarModel.H"
#include "RASModel.H"
#include "LESModel.H"
#include "jetKEpsilon.H"

namespace Foam
{
    template<class TransportModel>
    using DPMTurbulenceModel = solverClass<TransportModel>;
}

makeTurbulenceModelTypes
(
    volScalarField,
    geometricOneField,
    incompressibleTurbulenceModel,
    DPMTurbulenceModel,
    singlePhaseTransportModel
);

#define makeRASModel(Type)                                                     \
    makeTemplatedTurbulenceModel                                               \
    (singlePhaseTransportModelDPMTurbulenceModel, RAS, Type)

makeRASModel(jetKEpsilon);

#endif

// ************************************************************************* //
