/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carrierFluid.H"
#include "fvcGrad.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(carrierFluid, 0);
    defineRunTimeSelectionTable(carrierFluid, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::carrierFluid::carrierFluid(const dictionary& dict, const fvMesh& mesh)
:
    g_(Zero),
    hasGravity_(false),
    mesh_(mesh),
    dict_(dict),
    UName_(dict.lookupOrDefault<word>("U", "U")),
    pName_(dict.lookupOrDefault<word>("p", "p"))
{}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::carrierFluid> Foam::carrierFluid::New
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const word kind(dict.lookupOrDefault<word>("fluid", "incompressible"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(kind);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup(dict, "fluid", kind, *dictionaryConstructorTablePtr_)
            << exit(FatalIOError);
    }
    return autoPtr<carrierFluid>(cstrIter()(dict, mesh));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::turbulenceModel* Foam::carrierFluid::model() const
{
    return mesh_.cfindObject<turbulenceModel>(turbulenceModel::propertiesName);
}


Foam::tmp<Foam::volVectorField> Foam::carrierFluid::gradP() const
{
    tmp<volVectorField> tgrad(fvc::grad(p()));
    if (pressure() == pressureUnit::PASCAL)
    {
        return tgrad;
    }
    const tmp<volScalarField> trho(rho());
    return trho*tgrad;
}


// ************************************************************************* //
