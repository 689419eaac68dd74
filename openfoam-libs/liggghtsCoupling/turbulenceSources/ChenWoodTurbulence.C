/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ChenWoodTurbulence.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(ChenWoodTurbulence, 0);
    addToRunTimeSelectionTable(grainTurbulence, ChenWoodTurbulence, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ChenWoodTurbulence::ChenWoodTurbulence
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    mesh_(mesh)
{
    const dictionary& coeffs = dict.subOrEmptyDict("ChenWoodCoeffs");
    B_ = coeffs.lookupOrDefault<scalar>("B", 0.0825);
    Ce_ = coeffs.lookupOrDefault<scalar>("Ce", 0.165);
    C3_ = coeffs.lookupOrDefault<scalar>("C3", 1.2);

    if (B_ < 0 || Ce_ <= 0 || C3_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "ChenWoodCoeffs: B " << B_ << ", Ce " << Ce_ << ", C3 " << C3_
            << " must not be negative, and Ce not zero" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::ChenWoodTurbulence::fields() const
{
    return wordList({"k", "epsilon"});
}


void Foam::ChenWoodTurbulence::addSup
(
    fvMatrix<scalar>& eqn,
    const word& field,
    const scalarField& coefficient,
    const scalarField& responseTime
) const
{
    const scalarField& k = mesh_.lookupObject<volScalarField>("k");
    const scalarField& epsilon = mesh_.lookupObject<volScalarField>("epsilon");
    const scalarField& V = mesh_.V();
    const scalar factor = (field == "epsilon" ? C3_ : 1);

    scalarField& diag = eqn.diag();
    forAll(diag, celli)
    {
        const scalar eddyTime = Ce_*k[celli]/max(epsilon[celli], VSMALL);
        const scalar decorrelated =
            -std::expm1(-B_*responseTime[celli]/max(eddyTime, VSMALL));

        // A sink: implicit, on the right-hand side
        diag[celli] -= factor*2*coefficient[celli]*decorrelated*V[celli];
    }
}


// ************************************************************************* //
