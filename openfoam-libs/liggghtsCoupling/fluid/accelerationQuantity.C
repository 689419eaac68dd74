/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "accelerationQuantity.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(accelerationQuantity, 0);
    addToRunTimeSelectionTable(fluidQuantity, accelerationQuantity, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::accelerationQuantity::accelerationQuantity(const carrierFluid& fluid)
:
    fluidQuantity(fluid)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volVectorField> Foam::accelerationQuantity::vectorField() const
{
    const fvMesh& mesh = fluid_.mesh();
    const Time& time = mesh.time();
    const volVectorField& U = fluid_.velocity();

    if (!previousU_)
    {
        // The fluid of the start time is what U is before the first step
        IOobject header
        (
            "previousGrainU",
            time.timeName(time.startTime().value()),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        );
        previousU_.reset(new volVectorField(header, U));
    }

    volVectorField& previous = *previousU_;
    tmp<volVectorField> tDUDt((U & fluid_.gradVelocity()));
    volVectorField& DUDt = tDUDt.ref();
    DUDt.primitiveFieldRef() +=
        (U.primitiveField() - previous.primitiveField())/fluid_.previousStep();
    DUDt.correctBoundaryConditions();

    previous.primitiveFieldRef() = U.primitiveField();
    previous.instance() = time.timeName();
    return tDUDt;
}


// ************************************************************************* //
