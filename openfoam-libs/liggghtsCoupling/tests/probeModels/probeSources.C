/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "probeSources.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"
#include "knownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(probeSources, 0);
    addToRunTimeSelectionTable(grainTurbulence, probeSources, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::probeSources::probeSources(const dictionary& dict, const fvMesh& mesh)
:
    mesh_(mesh)
{
    const dictionary& coeffs = dict.subOrEmptyDict("probeSourcesCoeffs");
    knownEntries::checkOnMaster
    (
        coeffs,
        {{"rate", {knownEntries::valueType::NOT_NEGATIVE, knownEntries::REQUIRED}}}
    );
    rate_ = coeffs.get<scalar>("rate");
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::probeSources::fields() const
{
    return wordList({"k"});
}


void Foam::probeSources::addSup
(
    fvMatrix<scalar>& eqn,
    const word& field,
    const scalarField& coefficient,
    const scalarField& responseTime
) const
{
    eqn.diag() -= rate_*mesh_.V();
}


// ************************************************************************* //
