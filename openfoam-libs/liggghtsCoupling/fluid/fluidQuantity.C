/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidQuantity.H"
#include "couplingEntries.H"
#include "turbulenceField.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(fluidQuantity, 0);
    defineRunTimeSelectionTable(fluidQuantity, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidQuantity::fluidQuantity(const carrierFluid& fluid)
:
    fluid_(fluid)
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Foam::string Foam::fluidQuantity::noTurbulence(const word& name) const
{
    return turbulenceField::missing(fluid_, name);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fluidQuantity> Foam::fluidQuantity::New
(
    const word& name,
    const carrierFluid& fluid,
    const word& model,
    const dictionary& dict
)
{
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(name);

    couplingEntries::onMaster
    (
        [&]()
        {
            if (!cstrIter.found())
            {
                FatalIOErrorInFunction(dict)
                    << "The model " << model << " asks for the fluid quantity " << name
                    << ", which is not known. Valid: "
                    << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
                    << exit(FatalIOError);
            }
        }
    );
    return autoPtr<fluidQuantity>(cstrIter()(fluid));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField> Foam::fluidQuantity::scalarField() const
{
    FatalErrorInFunction
        << "The fluid quantity " << type() << " is no scalar" << exit(FatalError);
    return tmp<volScalarField>();
}


Foam::tmp<Foam::volVectorField> Foam::fluidQuantity::vectorField() const
{
    FatalErrorInFunction
        << "The fluid quantity " << type() << " is no vector" << exit(FatalError);
    return tmp<volVectorField>();
}


// ************************************************************************* //
