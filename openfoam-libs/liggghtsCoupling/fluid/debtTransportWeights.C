/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The weights of the grains in the debts of cells, see debtTransport.H.

\*---------------------------------------------------------------------------*/

#include "debtTransport.H"
#include "gasThermo.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::debtTransport::weight
(
    const scalar coefficient,
    const scalar inertia,
    const scalar dt
)
{
    return -inertia*std::expm1(-coefficient*dt/inertia);
}


void Foam::debtTransport::sumUp
(
    const UList<scalar>& weights,
    DynamicList<scalar>& sums,
    const ownedGrains& grains,
    cellAverages& averages
)
{
    occupiedCells& occupied = averages.cells();
    sums.clear();
    averages.shares().deposit<scalar>
    (
        weights.size(),
        [&](const label g){ return grains.cell(g); },
        [&](const label g){ return weights[g]; },
        [&](const label celli, const scalar fraction, const scalar w)
        {
            occupied.sum(sums, celli) += fraction*w;
        }
    );
    sums.setSize(occupied.cells().size(), Zero);
}


Foam::tmp<Foam::scalarField> Foam::debtTransport::inertia(const carrierFluid& fluid) const
{
    const fvMesh& mesh = fluid.mesh();
    tmp<scalarField> tresult(fluid.rho()().primitiveField()*mesh.V().field());
    scalarField& result = tresult.ref();
    forAll(result, celli)
    {
        result[celli] *= fluid.inertiaVoidFraction(celli);
    }
    if (debts_.ofHeat())
    {
        result *= gasThermo::of(mesh).Cpv()().primitiveField();
    }
    return tresult;
}


bool Foam::debtTransport::isStiffHere
(
    const labelUList& cells,
    const scalarField& inertia,
    const scalar least
)
{
    bool any = false;
    forAll(sums_, i)
    {
        const label celli = cells[i];
        any = any || sums_[i] > stiff_*inertia[celli];
        if (sums_[i] < least*inertia[celli])
        {
            sums_[i] = 0;
        }
    }
    return any;
}


bool Foam::debtTransport::stiff
(
    const ownedGrains& grains,
    cellAverages& averages,
    const carrierFluid& fluid,
    bool& removed
)
{
    sumUp(weight_, sums_, grains, averages);

    // A filter makes no sum per volume larger. Debts of heat are always moved
    const tmp<scalarField> tinertia(inertia(fluid));
    const bool here = isStiffHere(averages.cells().cells(), tinertia(), 0) || debts_.ofHeat();

    // Of all ranks together: is anything stiff, has any of them grains, were any removed?
    enum { STIFF = 1, GRAINS = 2, REMOVED = 4 };
    unsigned int found =
        (here ? STIFF : 0) | (weight_.empty() ? 0 : GRAINS) | (grains.removed().empty() ? 0 : REMOVED);
    reduce(found, bitOrOp<unsigned int>());
    removed = found & REMOVED;

    const bool any = (found & STIFF) && (found & GRAINS);
    if (!any || !averages.filter())
    {
        return any;
    }
    averages.filter()->spread(averages.cells(), sums_);
    const bool spread = isStiffHere(averages.cells().cells(), tinertia(), negligible_);
    return returnReduce(spread, orOp<bool>()) || debts_.ofHeat();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::debtTransport::remember
(
    const UList<grainForces::record>& records,
    const scalar dt
)
{
    ownedGrains::makeRoom(weight_, records.size());
    for (const grainForces::record& r : records)
    {
        weight_.append
        (
            debts_.ofHeat()
          ? weight(r.heatTransferCoefficient, r.heatCapacity, dt)
          : weight(r.dragCoefficient/r.voidFraction, r.mass, dt)
        );
    }
}


void Foam::debtTransport::restore
(
    const ownedGrains& grains,
    const UList<fluidCoefficients>& acted,
    const scalar dt
)
{
    weight_.clear();
    forAll(acted, g)
    {
        weight_.append
        (
            debts_.ofHeat()
          ? weight(acted[g].heatTransfer, grains.heatCapacity(g), dt)
          : weight(acted[g].drag, grains.grain(g).mass, dt)
        );
    }
}


// ************************************************************************* //
