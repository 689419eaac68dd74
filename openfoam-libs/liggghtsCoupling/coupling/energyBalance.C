/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "energyBalance.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::energyBalance::closeFluidStep
(
    couplingStep& values,
    const energyExchange& energy,
    const heatExchange* heat,
    const compressibleVoidFraction* gas
)
{
    values.energyToFluid = energy.received();
    values.energyOwed = energy.owed();
    if (heat)
    {
        values.energyToFluid += heat->received();
        values.energyOwed += heat->owed();
    }
    if (gas)
    {
        values.energyToFluid += gas->receivedEnergy();
        values.energyOwed += gas->owedEnergy();
        values.gasMass = gas->mass();
    }
}


void Foam::energyBalance::add(const couplingStep& values, const bool first)
{
    toFluid_ = values.energyToFluid;
    owed_ = values.energyOwed;
    mass_ = values.gasMass;
    if (first)
    {
        owedBefore_ = owed_;
    }

    // The gas' part of a step is known once the step is over
    sumToGrains_ += latestToGrains_;
    sumExchanged_ += mag(latestToGrains_);
    sumToFluid_ += toFluid_;
    latestToGrains_ = values.received.work + values.received.heat;
    latestHeat_ = values.received.heat;
    imbalance_ =
        sumExchanged_ > 0
      ? mag(sumToGrains_ + sumToFluid_ + owed_ - owedBefore_)/sumExchanged_
      : 0;
}


Foam::wordList Foam::energyBalance::columns() const
{
    wordList names({"energyToGrains", "energyToFluid", "energyOwed", "energyImbalance"});
    if (full_)
    {
        names.append("gasMass");
    }
    if (heat_)
    {
        names.append("heatToGrains");
    }
    return names;
}


Foam::string Foam::energyBalance::header() const
{
    string text
    (
        heat_
      ? "energy [J]: work of forces with reaction on the grains and heat (energyToGrains), heat alone"
        " (heatToGrains) in this step; to the gas and still owed to it: step before"
      : "energy [J]: work of forces with reaction on the grains (energyToGrains) in this step; to the gas and"
        " still owed to it: step before"
    );
    if (full_)
    {
        text += "; gasMass [kg]: between the grains, with its debts, after the step before";
    }
    return text;
}


void Foam::energyBalance::print(Ostream& os) const
{
    os  << ", energy to grains " << latestToGrains_ << " J, imbalance " << imbalance_;
    if (heat_)
    {
        os  << ", heat to grains " << latestHeat_ << " J";
    }
    if (full_)
    {
        os  << ", gas " << mass_ << " kg";
    }
}


void Foam::energyBalance::write(Ostream& os) const
{
    os  << tab << latestToGrains_ << tab << toFluid_ << tab << owed_ << tab << imbalance_;
    if (full_)
    {
        os  << tab << mass_;
    }
    if (heat_)
    {
        os  << tab << latestHeat_;
    }
}


// ************************************************************************* //
