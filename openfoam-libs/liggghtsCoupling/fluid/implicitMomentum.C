/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "implicitMomentum.H"
#include "addToRunTimeSelectionTable.H"
#include "continuedField.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(implicitMomentum, 0);
    addToRunTimeSelectionTable(grainMomentum, implicitMomentum, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const Foam::grainMomentum::feltStress unfelt{0, Foam::Zero};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::implicitMomentum::missing
(
    const cellSource& source,
    const vectorField& stress
) const
{
    vector owed
    (
        source.later
      + source.slope*(fluid_.U()[source.cell] - source.U0)*dt_
    );
    if (source.felt.volume > 0)
    {
        owed += source.felt.volume*dt_*(stress[source.cell] - source.felt.density);
    }
    return owed;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::implicitMomentum::implicitMomentum(const carrierFluid& fluid)
:
    grainMomentum(fluid),
    sources_(),
    number_(fluid.mesh().nCells(), -1),
    owed_
    (
        continuedField::header("particleMomentumOwed", fluid.mesh(), IOobject::NO_WRITE),
        fluid.mesh(),
        dimensionedVector(dimForce*dimTime, Zero)
    ),
    lost_(fluid),
    dt_(0)
{
    // The debt of a former run is paid like that of a step of this one
    forAll(owed_, celli)
    {
        if (owed_[celli] != vector::zero)
        {
            sources_.append(cellSource{celli, Zero, Zero, 0, Zero, 1, unfelt});
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::implicitMomentum::close(const vectorField& stress)
{
    vector received(Zero);

    // Before the first step nothing has been received, and what is owed stays
    if (dt_ > 0)
    {
        for (const cellSource& source : sources_)
        {
            vector& owed = owed_[source.cell];
            owed = missing(source, stress);
            received += source.wanted + source.later - owed;
            received -= source.felt.volume*dt_*source.felt.density;
        }
    }
    return received;
}


Foam::vector Foam::implicitMomentum::owed() const
{
    vector sum(lost_.owed());
    for (const cellSource& source : sources_)
    {
        sum += owed_[source.cell];
    }
    return sum;
}


void Foam::implicitMomentum::set
(
    const labelUList& cells,
    const vectorField& impulse,
    const scalarField& slope,
    const scalarField& response,
    const stressList& stress,
    const scalar dt
)
{
    const volVectorField& U = fluid_.U();
    const scalarField& V = fluid_.mesh().V();
    const tmp<volScalarField> trho(fluid_.rho());
    const scalarField& rho = trho().primitiveField();
    dt_ = dt;

    DynamicList<label> before(sources_.size());
    for (const cellSource& source : sources_)
    {
        before.append(source.cell);
    }
    sources_.clear();

    forAll(cells, i)
    {
        const label celli = cells[i];
        const scalar e = fluid_.equationVoidFraction(celli);
        const scalar kappa =
            slope[i]*dt/(rho[celli]*fluid_.inertiaVoidFraction(celli)*V[celli]);
        const vector now(e*(1 - (1 - response[i])*kappa/(1 + kappa))*owed_[celli]);
        const feltStress felt(stress.empty() ? unfelt : stress[i]);

        number_[celli] = i;
        sources_.append
        (
            cellSource
            {
                celli, now - impulse[i] + felt.volume*dt*felt.density, owed_[celli] - now, slope[i],
                U[celli], e, felt
            }
        );
    }

    // Cells with a debt that hold no grain any more
    for (const label celli : before)
    {
        if (number_[celli] < 0 && owed_[celli] != vector::zero)
        {
            number_[celli] = sources_.size();
            sources_.append
            (
                cellSource{celli, owed_[celli], Zero, 0, U[celli], 1, unfelt}
            );
        }
    }

    const Map<vector> paid(lost_.pay(dt));
    forAllConstIters(paid, iter)
    {
        const label celli = iter.key();
        if (number_[celli] < 0)
        {
            number_[celli] = sources_.size();
            sources_.append(cellSource{celli, Zero, Zero, 0, U[celli], 1, unfelt});
        }
        sources_[number_[celli]].wanted += iter.val();
    }
    for (const cellSource& source : sources_)
    {
        number_[source.cell] = -1;
    }
}


void Foam::implicitMomentum::addWorkOwed(scalarField& work) const
{
    const volVectorField& U = fluid_.U();
    for (const cellSource& source : sources_)
    {
        const vector& u = U[source.cell];
        work[source.cell] += (source.later + source.slope*(u - source.U0)*dt_) & u;
    }
}


void Foam::implicitMomentum::addSup(fvMatrix<vector>& eqn) const
{
    // fvMatrix keeps (diagonal)*U = source, integrated over cells
    scalarField& diag = eqn.diag();
    vectorField& rhs = eqn.source();
    for (const cellSource& source : sources_)
    {
        const scalar rho = fluid_.equationDensity(source.cell)*source.e;
        diag[source.cell] -= source.slope/rho;
        rhs[source.cell] -= (source.wanted/dt_ + source.slope*source.U0)/rho;
    }
}


Foam::tmp<Foam::vectorField> Foam::implicitMomentum::presentDebts(const vectorField& stress) const
{
    tmp<vectorField> towed(new vectorField(owed_.field()));
    if (dt_ > 0)
    {
        for (const cellSource& source : sources_)
        {
            towed.ref()[source.cell] = missing(source, stress);
        }
    }
    return towed;
}


void Foam::implicitMomentum::write(const vectorField& owed, const vectorField& lost) const
{
    continuedField::write(owed_, owed);
    lost_.write(lost);
}


// ************************************************************************* //
