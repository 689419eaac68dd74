/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatExchange.H"
#include "cellAverages.H"
#include "continuedField.H"
#include "fvMatrices.H"
#include "gasThermo.H"
#include "lostDebts.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::heatExchange::missing(const cellSource& source) const
{
    return source.slope*(he_[source.cell] - source.he0)*dt_;
}


Foam::heatExchange::cellSource& Foam::heatExchange::sourceOf(const label celli)
{
    if (number_[celli] < 0)
    {
        number_[celli] = sources_.size();
        sources_.append(cellSource{celli, 0, 0, he_[celli]});
    }
    return sources_[number_[celli]];
}


void Foam::heatExchange::payLost()
{
    if (max(mag(lost_.field())) == 0)
    {
        return;
    }
    const tmp<volScalarField> trho(fluid_.rho());
    const tmp<volScalarField> tcapacity(gasThermo::of(fluid_.mesh()).Cpv());
    const volScalarField& T = fluid_.mesh().lookupObject<volScalarField>("T");
    forAll(lost_, celli)
    {
        scalar& owed = lost_[celli];
        if (owed != 0)
        {
            const scalar rho = trho()[celli];
            const scalar own = rho*fluid_.mesh().V()[celli]*tcapacity()[celli]*T[celli];
            const scalar now = lostDebts::share(fluid_, celli, rho, dt_)*min(1.0, own/mag(owed))*owed;
            owed -= now;
            sourceOf(celli).wanted += now;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::heatExchange::heatExchange
(
    const carrierFluid& fluid,
    const word& energy
)
:
    fluid_(fluid),
    he_(fluid.mesh().lookupObject<volScalarField>(energy)),
    sources_(),
    number_(fluid.mesh().nCells(), -1),
    owed_
    (
        continuedField::header("particleHeatOwed", fluid.mesh(), IOobject::NO_WRITE),
        fluid.mesh(),
        dimensionedScalar(dimEnergy, Zero)
    ),
    lost_
    (
        continuedField::header("heatOfLostGrains", fluid.mesh(), IOobject::NO_WRITE),
        fluid.mesh(),
        dimensionedScalar(dimEnergy, Zero)
    ),
    particleHeatSource_
    (
        cellAverages::writtenField("particleHeatSource", fluid.mesh()),
        fluid.mesh(),
        dimensionedScalar(dimPower/dimVolume, Zero)
    ),
    received_(0),
    dt_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::heatExchange::close()
{
    received_ = 0;

    // Before the first step nothing has been received, and what is owed stays
    for (const cellSource& source : sources_)
    {
        scalar& owed = owed_[source.cell];
        owed = missing(source);
        received_ += source.wanted - owed;
    }
}


void Foam::heatExchange::set
(
    const labelUList& cells,
    const scalarField& heat,
    const scalarField& slope,
    const scalarField& felt,
    const scalar dt
)
{
    const scalarField& V = fluid_.mesh().V();
    const tmp<volScalarField> tc(gasThermo::of(fluid_.mesh()).Cpv());
    const volScalarField& T = fluid_.mesh().lookupObject<volScalarField>("T");
    dt_ = dt;

    sources_.clear();
    particleHeatSource_.primitiveFieldRef() = Zero;
    forAll(cells, i)
    {
        const label celli = cells[i];
        cellSource& source = sourceOf(celli);
        source.wanted = owed_[celli] - heat[i];
        if (slope[i] > 0)
        {
            const scalar c = tc()[celli];
            source.slope = slope[i]/(dt*c);
            source.he0 += c*(felt[i] - T[celli]);
        }
        particleHeatSource_[celli] = -heat[i]/(dt*V[celli]);
    }

    // Cells with a debt that no grain has taken back, such as one of no weight
    forAll(owed_, celli)
    {
        if (number_[celli] < 0 && owed_[celli] != 0)
        {
            sourceOf(celli).wanted = owed_[celli];
        }
    }
    payLost();
    for (const cellSource& source : sources_)
    {
        number_[source.cell] = -1;
    }
}


void Foam::heatExchange::addSup(fvMatrix<scalar>& eqn) const
{
    // fvMatrix keeps (diagonal)*he = source, integrated over cells
    scalarField& diag = eqn.diag();
    scalarField& rhs = eqn.source();
    for (const cellSource& source : sources_)
    {
        const scalar e = fluid_.equationVoidFraction(source.cell);
        diag[source.cell] -= source.slope/e;
        rhs[source.cell] -= (source.wanted/dt_ + source.slope*source.he0)/e;
    }
}


Foam::tmp<Foam::scalarField> Foam::heatExchange::presentDebts() const
{
    tmp<scalarField> towed(new scalarField(owed_.field()));
    for (const cellSource& source : sources_)
    {
        towed.ref()[source.cell] = missing(source);
    }
    return towed;
}


Foam::scalar Foam::heatExchange::owed() const
{
    return sum(owed_.field()) + sum(lost_.field());
}


void Foam::heatExchange::write(const scalarField& owed, const scalarField& lost) const
{
    continuedField::write(owed_, owed);
    continuedField::write(lost_, lost);
}


Foam::wordList Foam::heatExchange::files() const
{
    return wordList({owed_.name(), lost_.name()});
}


// ************************************************************************* //
