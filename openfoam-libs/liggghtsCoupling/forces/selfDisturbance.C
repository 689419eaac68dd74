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
#include "implicitMomentum.H"
#include "StringStream.H"
#include "voidFractionEquations.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// Own wakes over slips, both summed over grains and intervals, above which the slip is uncertain
constexpr scalar uncertainWake = 2;

// K dt/(rho V) above which such wakes make the fluid diverge
constexpr scalar stiff = 2;

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
            if (voidFractionEquations::full(coupling))
            {
                FatalIOErrorInEntry(coupling, "selfDisturbance")
                    << "selfDisturbance yes with equations full of voidFraction: the wake is known"
                    << " for equations without void fraction only. Remove selfDisturbance, or set"
                    << " equations neglected" << exit(FatalIOError);
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
    state_(needs.state("ownWake", scalarList(13, 0.0))),
    implicit_
    (
        needs.coupling().lookupOrDefault<word>("momentum", "implicit")
     == implicitMomentum::typeName
    ),
    warned_(false),
    wakes_(0),
    slips_(0),
    stiffness_(0)
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


void Foam::selfDisturbance::prepare()
{
    vector sums(wakes_, slips_, stiffness_);
    reduce(sums, sumOp<vector>());

    const scalar ratio = sums[0]/max(sums[1], VSMALL);
    const scalar kappa = sums[2]/max(sums[1], VSMALL);
    if (ratio <= uncertainWake || (warned_ && kappa <= stiff))
    {
        return;
    }
    OStringStream message;
    message
        << "selfDisturbance, time " << mesh_.time().timeName() << ": the fluid that grains pull"
        << " along themselves is " << ratio << " times as fast as their slip, in the mean over the run. ";
    const char* remedy =
        " Use larger cells, a smaller coarse-graining ratio, or remove selfDisturbance";

    if (kappa > stiff)
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalErrorInFunction
                    << message.str().c_str() << "With drag as stiff as here, K dt/(rho V) = " << kappa
                    << ", the fluid would diverge." << remedy << exit(FatalError);
            }
        );
    }
    warned_ = true;
    WarningInFunction
        << message.str().c_str() << "Above " << uncertainWake << " small errors of the wake are large"
        << " ones of the slip." << remedy << nl << endl;
}


void Foam::selfDisturbance::correct(grainBatch& grains) const
{
    typedef grainBatch::lane lane;

    const lane& rho = *grains.fluid(rho_);
    const lane& nuEff = *grains.fluid(nuEff_);
    lane* modes = grains.state(state_);
    lane* seen = modes + 6;
    lane* owed = modes + 9;
    const lane& slope = modes[12];
    const scalarField& V = mesh_.V();
    const vectorField& C = mesh_.cellCentres();
    const scalar dt = fluid_.previousStep();

    for (label i = 0; i < grainBatch::size; ++i)
    {
        const label celli = grains.cell[i];
        const scalar volume = V[celli];
        const scalar side = std::cbrt(volume);

        // Speed relative to the fluid as it was undisturbed until now, and place in the cell
        scalar undisturbed = 0;
        scalar offset[3], radius[3];
        for (direction k = 0; k < 3; ++k)
        {
            const scalar slip =
                grains.fluidVelocity[k][i] - seen[k][i] - grains.velocity[k][i];
            undisturbed += sqr(slip);
            offset[k] = (grains.position[k][i] - C[celli][k])/halfSide_[celli][k];
            radius[k] = divided_ ? grains.radius[i]/halfSide_[celli][k] : 0;
        }
        const grainjet::wake::Step step
        (
            response_,
            grainjet::wake::Place(offset, radius, linear_),
            nuEff[i]*dt/(side*side),
            std::sqrt(undisturbed)*dt/side
        );

        const scalar mass = rho[i]*volume;
        const scalar kappa = slope[i]*dt/mass;
        scalar wake = 0;
        scalar slip = 0;
        for (direction k = 0; k < 3; ++k)
        {
            scalar a[2] = {modes[k][i], modes[k + 3][i]};
            scalar debt = owed[k][i]/mass;
            seen[k][i] = step.advance(-grains.impulse[k][i]/mass, kappa, a, debt);
            modes[k][i] = a[0];
            modes[k + 3][i] = a[1];
            owed[k][i] = debt*mass;
            grains.fluidVelocity[k][i] -= seen[k][i];

            wake += sqr(seen[k][i]);
            slip += sqr(grains.fluidVelocity[k][i] - grains.velocity[k][i]);
        }
        if (i < grains.n)
        {
            wakes_ += std::sqrt(wake);
            slips_ += std::sqrt(slip);
            stiffness_ += kappa*std::sqrt(slip);
        }
    }
}


void Foam::selfDisturbance::remember(grainBatch& grains) const
{
    const scalar dt = mesh_.time().deltaTValue();
    grainBatch::lane& slope = grains.state(state_)[12];

    for (label i = 0; i < grainBatch::size; ++i)
    {
        slope[i] =
            implicit_
          ? grainMomentum::slope
            (
                grains.Sp[i],
                grains.Sp[i] + grains.nonReactingSp[i],
                grains.mass[i],
                grains.addedMass[i],
                dt
            )
          : 0;
    }
}


// ************************************************************************* //
