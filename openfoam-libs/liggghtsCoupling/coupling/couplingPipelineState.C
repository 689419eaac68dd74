/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What a continued run needs of the fluid's side, see couplingPipeline.H.

\*---------------------------------------------------------------------------*/

#include "couplingPipeline.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::couplingPipeline::stateFiles() const
{
    wordList names(momentum_.momentum().files());
    if (energy_ && debts_)
    {
        names.append(energy_->files());
    }
    if (heat_)
    {
        names.append(heat_->files());
    }
    if (equations_)
    {
        names.append(equations_->files());
    }
    return names;
}


void Foam::couplingPipeline::writeState()
{
    const tmp<vectorField> tstress
    (
        equations_ ? equations_->write() : tmp<vectorField>(vectorField::null())
    );
    if (heat_)
    {
        scalarField owed(heat_->presentDebts());
        scalarField lost(heat_->debtsOfLost());
        heatDebts_->retire
        (
            *grains_, averages_, fluid_, debtTransport::fields{nullptr, &owed, nullptr, &lost}
        );
        heat_->write(owed, lost);
    }
    grainMomentum& momentum = momentum_.momentum();
    if (!momentum.debts())
    {
        return;
    }

    // As if the step were over: the continued run does not know the grains that were removed in it
    vectorField owed(momentum.presentDebts(tstress()));
    vectorField lost(*momentum.debtsOfLost());
    scalarField energy(energy_ ? energy_->debts() : scalarField());
    scalarField lostEnergy(energy_ ? energy_->debtsOfLost() : scalarField());
    if (debts_)
    {
        debts_->retire
        (
            *grains_, averages_, fluid_,
            debtTransport::fields{&owed, energy_ ? &energy : nullptr, &lost, energy_ ? &lostEnergy : nullptr}
        );
    }
    momentum.write(owed, lost);
    if (energy_)
    {
        energy_->write(energy, lostEnergy);
    }
}


// ************************************************************************* //
