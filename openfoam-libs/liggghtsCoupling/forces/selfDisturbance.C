/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "selfDisturbance.H"
#include "couplingEntries.H"
#include "dragForce.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

word interpolationOf(const dictionary& coupling)
{
    return coupling.lookupOrDefault<word>("interpolation", "cellPoint");
}


// As voidFractionModel selects it
bool isDivided(const dictionary& coupling)
{
    return
        coupling.subOrEmptyDict("voidFraction").lookupOrDefault<word>("model", "divided")
     == "divided";
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::selfDisturbance::wanted(const dictionary& coupling)
{
    if (!coupling.lookupOrDefault<Switch>("selfDisturbance", false))
    {
        return false;
    }
    couplingEntries::onMaster
    (
        [&]()
        {
            if (!couplingEntries::twoWay(coupling))
            {
                FatalIOErrorInFunction(coupling)
                    << "selfDisturbance yes with coupling oneWay: the fluid does not feel the"
                    << " grains, so they see no wake of their own. Remove selfDisturbance, or"
                    << " set coupling twoWay" << exit(FatalIOError);
            }
            const word scheme(interpolationOf(coupling));
            if (scheme != "cell" && scheme != "cellPoint")
            {
                FatalIOErrorInFunction(coupling)
                    << "selfDisturbance yes with interpolation " << scheme
                    << ": what this scheme shows of a grain's own wake is not known. Use"
                    << " interpolation cellPoint or cell, or remove selfDisturbance"
                    << exit(FatalIOError);
            }
        }
    );
    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::selfDisturbance::selfDisturbance(forceNeeds& needs)
:
    mesh_(needs.mesh()),
    response_
    (
        interpolationOf(needs.coupling()) == "cell"
      ? grainjet::wake::CELL : grainjet::wake::CELL_POINT
    ),
    divided_(isDivided(needs.coupling())),
    rho_(needs.quantity("rho")),
    nuEff_(needs.quantity("nuEff")),
    modes_(needs.state("ownWake", scalarList(6, 0.0)))
{
    needs.impulse();
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::selfDisturbance> Foam::selfDisturbance::New(forceNeeds& needs)
{
    return autoPtr<selfDisturbance>
    (
        wanted(needs.coupling()) ? new selfDisturbance(needs) : nullptr
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::selfDisturbance::check
(
    const dictionary& coupling,
    const UPtrList<grainForce>& forces
)
{
    bool drag = false;
    for (const grainForce& force : forces)
    {
        drag |= bool(isA<dragForce>(force));
    }
    couplingEntries::onMaster
    (
        [&]()
        {
            if (!drag && coupling.lookupOrDefault<Switch>("selfDisturbance", false))
            {
                FatalIOErrorInFunction(coupling)
                    << "selfDisturbance yes, but forces has no drag that it could correct."
                    << " Add drag to forces, or remove selfDisturbance" << exit(FatalIOError);
            }
        }
    );
}


void Foam::selfDisturbance::correct(grainBatch& grains) const
{
    typedef grainBatch::lane lane;

    const lane& rho = *grains.fluid(rho_);
    const lane& nuEff = *grains.fluid(nuEff_);
    lane* modes = grains.state(modes_);
    const scalarField& V = mesh_.V();
    const scalar dt = mesh_.time().deltaTValue();

    for (label i = 0; i < grainBatch::size; ++i)
    {
        const scalar volume = V[grains.cell[i]];
        const scalar side = std::cbrt(volume);

        // Speed relative to the fluid as it was undisturbed until now
        scalar sqr = 0;
        for (direction k = 0; k < 3; ++k)
        {
            const scalar slip =
                grains.fluidVelocity[k][i] - modes[k][i] - modes[k + 3][i]
              - grains.velocity[k][i];
            sqr += slip*slip;
        }
        const grainjet::wake::Step step
        (
            response_,
            divided_ ? 2*grains.radius[i]/side : 0,
            nuEff[i]*dt/(side*side),
            std::sqrt(sqr)*dt/side
        );

        for (direction k = 0; k < 3; ++k)
        {
            const scalar given = -grains.impulse[k][i]/(rho[i]*volume);
            for (direction mode = 0; mode < 2; ++mode)
            {
                scalar& u = modes[k + 3*mode][i];
                u = (u + step.gain[mode]*given)*step.kept[mode];
                grains.fluidVelocity[k][i] -= u;
            }
        }
    }
}


// ************************************************************************* //
