/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Gives the reason in compressible solvers, which would otherwise call the
// model unknown

#include "turbulentFluidThermoModel.H"
#include "RASModel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

typedef compressible::RASModel compressibleModel;

const word modelName("jetKEpsilon");

// Takes the place of the constructor
autoPtr<compressibleModel> refuse
(
    const geometricOneField&,
    const volScalarField&,
    const volVectorField& U,
    const surfaceScalarField& alphaRhoPhi,
    const surfaceScalarField&,
    const fluidThermo&,
    const word& propertiesName
)
{
    const IOdictionary properties
    (
        IOobject
        (
            IOobject::groupName(propertiesName, alphaRhoPhi.group()),
            U.time().constant(),
            U.db(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    FatalIOErrorInFunction(properties.subDict("RAS"))
        << "RASModel " << modelName
        << " is for incompressible solvers (pimpleFoam, simpleFoam, DPMFoam ...)"
        << " and this one is compressible. Choose another RASModel, for"
        << " instance kEpsilon with C1 1.52 and C2 1.90 in kEpsilonCoeffs"
        << exit(FatalIOError);

    return nullptr;
}


struct registerRefusal
{
    registerRefusal()
    {
        compressibleModel::constructdictionaryConstructorTables();
        compressibleModel::dictionaryConstructorTablePtr_->insert
        (
            modelName,
            &refuse
        );
    }

    ~registerRefusal()
    {
        if (compressibleModel::dictionaryConstructorTablePtr_)
        {
            compressibleModel::dictionaryConstructorTablePtr_->erase
            (
                modelName
            );
        }
    }
};

const registerRefusal registerRefusal_;

} // End anonymous namespace
} // End namespace Foam


// ************************************************************************* //
