/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "selfDisturbance.H"
#include "boundBox.H"
#include "couplingEntries.H"
#include "dragForce.H"
#include "entryError.H"

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


// Half of the box around each cell
tmp<vectorField> halfSides(const fvMesh& mesh)
{
    tmp<vectorField> tsides(new vectorField(mesh.nCells()));
    const labelListList& cellPoints = mesh.cellPoints();
    forAll(cellPoints, celli)
    {
        const boundBox box(mesh.points(), cellPoints[celli], false);
        tsides.ref()[celli] = 0.5*box.span();
    }
    return tsides;
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
                FatalIOErrorInEntry(coupling, "selfDisturbance")
                    << "selfDisturbance yes with coupling oneWay: the fluid does not feel the"
                    << " grains, so they see no wake of their own. Remove selfDisturbance, or"
                    << " set coupling twoWay" << exit(FatalIOError);
            }
            const word scheme(interpolationOf(coupling));
            if (scheme != "cell" && scheme != "cellPoint")
            {
                FatalIOErrorInEntry(coupling, "selfDisturbance")
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
    fluid_(needs.fluid()),
    mesh_(needs.mesh()),
    linear_(interpolationOf(needs.coupling()) == "cellPoint"),
    response_(linear_ ? grainjet::wake::CELL_POINT : grainjet::wake::CELL),
    divided_(isDivided(needs.coupling())),
    halfSide_(halfSides(needs.mesh())),
    rho_(needs.quantity("rho")),
    nuEff_(needs.quantity("nuEff")),
    modes_(needs.state("ownWake", scalarList(9, 0.0)))
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
                FatalIOErrorInEntry(coupling, "selfDisturbance")
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
    lane* seen = modes + 6;
    const scalarField& V = mesh_.V();
    const vectorField& C = mesh_.cellCentres();
    const scalar dt = fluid_.previousStep();

    for (label i = 0; i < grainBatch::size; ++i)
    {
        const label celli = grains.cell[i];
        const scalar volume = V[celli];
        const scalar side = std::cbrt(volume);

        // Speed relative to the fluid as it was undisturbed until now, and place in the cell
        scalar sqr = 0;
        scalar offset[3], radius[3];
        for (direction k = 0; k < 3; ++k)
        {
            const scalar slip =
                grains.fluidVelocity[k][i] - seen[k][i] - grains.velocity[k][i];
            sqr += slip*slip;
            offset[k] = (grains.position[k][i] - C[celli][k])/halfSide_[celli][k];
            radius[k] = divided_ ? grains.radius[i]/halfSide_[celli][k] : 0;
        }
        const grainjet::wake::Step step
        (
            response_,
            grainjet::wake::Place(offset, radius, linear_),
            nuEff[i]*dt/(side*side),
            std::sqrt(sqr)*dt/side
        );

        for (direction k = 0; k < 3; ++k)
        {
            const scalar given = -grains.impulse[k][i]/(rho[i]*volume);
            seen[k][i] = 0;
            for (direction mode = 0; mode < 2; ++mode)
            {
                scalar& a = modes[k + 3*mode][i];
                a = (a + given)*step.kept[mode];
                seen[k][i] += step.weight[mode]*a;
            }
            grains.fluidVelocity[k][i] -= seen[k][i];
        }
    }
}


// ************************************************************************* //
