/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "energyExchange.H"
#include "cellAverages.H"
#include "couplingEntries.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::energyExchange::energyExchange(const fvMesh& mesh)
:
    owed_
    (
        IOobject
        (
            "particleEnergyOwed",
            mesh.time().timeName(mesh.time().startTime().value()),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimEnergy, Zero)
    ),
    wanted_(mesh.nCells(), Zero),
    particleEnergySource_
    (
        cellAverages::writtenField("particleEnergySource", mesh),
        mesh,
        dimensionedScalar(dimPower/dimVolume, Zero)
    ),
    dt_(0)
{}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::word Foam::energyExchange::fieldName(const fvMesh& mesh)
{
    if (mesh.foundObject<regIOobject>("thermophysicalProperties"))
    {
        // As the thermodynamics of OpenFOAM call it
        for (const word& name : {word("e"), word("h"), word("ea"), word("ha")})
        {
            const auto* field = mesh.cfindObject<volScalarField>(name);
            if (field && field->dimensions() == dimEnergy/dimMass)
            {
                return name;
            }
        }
    }
    return word::null;
}


void Foam::energyExchange::checkEntries(const dictionary& dict)
{
    if
    (
        couplingEntries::twoWay(dict) && !couplingEntries::setI(dict)
     && grainFilter::length(dict.subOrEmptyDict("voidFraction")) > 0
    )
    {
        FatalIOErrorInEntry(dict, "formulation")
            << "formulation SetII with a filter in a solver with an energy equation: the work of the"
            << " pressure on grains needs their velocity in each cell, and the filter gives their"
            << " volume to cells without grains. Set formulation SetI" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::energyExchange::set
(
    const labelUList& cells,
    const scalarField& work,
    const scalar dt
)
{
    const fvMesh& mesh = particleEnergySource_.mesh();
    dt_ = dt;
    owed_.instance() = mesh.time().timeName();

    wanted_ = owed_.field();
    particleEnergySource_.primitiveFieldRef() = Zero;
    forAll(cells, i)
    {
        const label celli = cells[i];
        wanted_[celli] -= work[i];
        particleEnergySource_[celli] = -work[i]/(dt*mesh.V()[celli]);
    }
}


void Foam::energyExchange::addSup
(
    fvMatrix<scalar>& eqn,
    const grainMomentum& momentum
)
{
    owed_.field() = Zero;
    momentum.addWorkOwed(owed_.field());

    // fvMatrix keeps (diagonal)*e = source, integrated over cells
    eqn.source() -= (wanted_ - owed_.field())/dt_;
}


Foam::scalar Foam::energyExchange::received() const
{
    return dt_ > 0 ? sum(wanted_) - sum(owed_.field()) : 0;
}


Foam::scalar Foam::energyExchange::owed() const
{
    return sum(owed_.field());
}


// ************************************************************************* //
