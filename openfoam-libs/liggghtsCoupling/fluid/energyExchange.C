/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "energyExchange.H"
#include "cellAverages.H"
#include "continuedField.H"
#include "couplingEntries.H"
#include "fvMatrices.H"
#include "releases.H"
#include "voidFractionEquations.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::energyExchange::energyExchange(const carrierFluid& fluid)
:
    fluid_(fluid),
    owed_
    (
        continuedField::header("particleEnergyOwed", fluid.mesh(), IOobject::NO_WRITE),
        fluid.mesh(),
        dimensionedScalar(dimEnergy, Zero)
    ),
    lost_
    (
        continuedField::header("energyOfLostGrains", fluid.mesh(), IOobject::NO_WRITE),
        fluid.mesh(),
        dimensionedScalar(dimEnergy, Zero)
    ),
    wanted_(fluid.mesh().nCells(), Zero),
    particleEnergySource_
    (
        cellAverages::writtenField("particleEnergySource", fluid.mesh()),
        fluid.mesh(),
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


void Foam::energyExchange::keepOldTimes(const fvMesh& mesh)
{
    for (const word& name : {word("K"), releases::ofThermo("psi")})
    {
        const auto* field = mesh.cfindObject<volScalarField>(name);
        if (field)
        {
            field->oldTime();
        }
    }
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
    if
    (
        couplingEntries::twoWay(dict) && !couplingEntries::setI(dict)
     && voidFractionEquations::full(dict)
    )
    {
        FatalIOErrorInEntry(dict, "formulation")
            << "formulation SetII with equations full in a solver with an energy equation: gas and"
            << " grains would not keep their energy. Set formulation SetI" << exit(FatalIOError);
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
    const fvMesh& mesh = fluid_.mesh();
    dt_ = dt;

    wanted_ = owed_.field() + lost_.field();
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
    lost_.field() = Zero;
    momentum.addWorkOfLost(lost_.field());

    // fvMatrix keeps (diagonal)*e = source, integrated over cells
    scalarField& source = eqn.source();
    forAll(source, celli)
    {
        source[celli] -=
            (wanted_[celli] - owed_[celli] - lost_[celli])
           /(dt_*fluid_.equationVoidFraction(celli));
    }
}


Foam::scalar Foam::energyExchange::received() const
{
    return dt_ > 0 ? sum(wanted_) - owed() : 0;
}


Foam::scalar Foam::energyExchange::owed() const
{
    return sum(owed_.field()) + sum(lost_.field());
}


void Foam::energyExchange::write(const scalarField& owed, const scalarField& lost) const
{
    continuedField::write(owed_, owed);
    continuedField::write(lost_, lost);
}


Foam::wordList Foam::energyExchange::files() const
{
    return wordList({owed_.name(), lost_.name()});
}


// ************************************************************************* //
