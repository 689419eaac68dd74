/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fieldChange.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fieldChange::begin
(
    const volVectorField& U,
    const labelUList& cells,
    const scalarField& drag
)
{
    const scalarField& V = U.mesh().V();
    contents_.clear();
    for (const label celli : cells)
    {
        contents_.append(content{celli, drag[celli]*V[celli], U[celli]});
    }
}


void Foam::fieldChange::addStep
(
    const volVectorField& U,
    scalar& change,
    scalar& weights
) const
{
    for (const content& c : contents_)
    {
        change += c.weight*mag(U[c.cell] - c.velocity);
        weights += c.weight;
    }
}


// ************************************************************************* //
