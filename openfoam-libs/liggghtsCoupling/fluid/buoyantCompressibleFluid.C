/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "buoyantCompressibleFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "fluidKinds.H"
#include "voidFractionEquations.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(buoyantCompressibleFluid, 0);
    addToRunTimeSelectionTable(carrierFluid, buoyantCompressibleFluid, dictionary);
    const knownEntries::ofModel buoyantCompressibleEntries
    (
        carrierFluid::typeName_(), buoyantCompressibleFluid::typeName_()
    );
    const fluidKinds buoyantCompressibleKind
    (
        buoyantCompressibleFluid::typeName_(), "buoyantPimpleFoam",
        &buoyantCompressibleFluid::misfit
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::buoyantCompressibleFluid::buoyantCompressibleFluid
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    compressibleFluid(dict, mesh),
    pressure_(mesh)
{}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::string Foam::buoyantCompressibleFluid::misfit(const fvMesh& mesh)
{
    const string missing(compressibleFluid::missing(mesh));
    return missing.empty() ? hydrostaticPressure::missing(mesh) : missing;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::buoyantCompressibleFluid::check() const
{
    if (voidFractionEquations::full(dict_))
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(dict_.subDict("voidFraction"), "equations")
                    << "equations full is not there for a compressible fluid with gravity, which "
                    << fluidKinds::solver().c_str() << " has. Set equations neglected, or take rhoPimpleFoam"
                    << exit(FatalIOError);
            }
        );
    }
    checkSolver();
}


Foam::tmp<Foam::volVectorField> Foam::buoyantCompressibleFluid::weight() const
{
    return
        pressure_.ofSameTime(mesh_.lookupObject<volScalarField>("rho"))
       *dimensionedVector("g", dimAcceleration, pressure_.g());
}


Foam::tmp<Foam::volVectorField> Foam::buoyantCompressibleFluid::gradP() const
{
    return pressure_.gradient
    (
        pressure_.ofSameTime(mesh_.lookupObject<volScalarField>("rho"))
    );
}


// ************************************************************************* //
