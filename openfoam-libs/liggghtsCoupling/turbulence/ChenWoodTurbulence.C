/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ChenWoodTurbulence.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingEntries.H"
#include "fvMatrices.H"
#include "knownEntries.H"
#include "turbulenceModel.H"

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
    typedef knownEntries::valueType valueType;
    typedef knownEntries::rule rule;
    knownEntries::checkOnMaster
    (
        coeffs,
        {
            {"B", rule(valueType::NOT_NEGATIVE).like("0.0825")},
            {"Ce", rule(valueType::POSITIVE).like("0.165")},
            {"C3", rule(valueType::NOT_NEGATIVE).like("1.2")}
        }
    );
    B_ = coeffs.lookupOrDefault<scalar>("B", 0.0825);
    Ce_ = coeffs.lookupOrDefault<scalar>("Ce", 0.165);
    C3_ = coeffs.lookupOrDefault<scalar>("C3", 1.2);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::ChenWoodTurbulence::fields() const
{
    return wordList({"k", "epsilon"});
}


void Foam::ChenWoodTurbulence::check
(
    const dictionary& dict,
    const turbulenceModel& model
) const
{
    // These have k and epsilon, but solve for them without sources of options
    const wordHashSet deaf
    ({
        "LamBremhorstKE", "LienCubicKE", "LienLeschziner", "ShihQuadraticKE"
    });

    // A frozen model (RAS { turbulence off; }) solves for nothing
    const bool frozen =
        !model.subOrEmptyDict("RAS").lookupOrDefault<Switch>("turbulence", true);

    word without;
    for (const word& field : fields())
    {
        if (without.empty() && !mesh_.foundObject<volScalarField>(field))
        {
            without = field;
        }
    }

    if (frozen || !without.empty() || deaf.found(model.type()))
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(dict, "turbulenceSources")
                    << "turbulenceSources ChenWood needs a turbulence model with equations for k and"
                    << " epsilon, such as kEpsilon or jetKEpsilon, but this case has " << model.type()
                    << " (simulationType " << model.lookupOrDefault<word>("simulationType", "unknown")
                    << ')'
                    << (frozen ? " with turbulence off" : without.empty() ? " without sources" : "")
                    << (without.empty() ? "" : " without ") << without
                    << " in " << mesh_.time().constant() << '/' << model.name()
                    << ". Change that, or set turbulenceSources to none" << exit(FatalIOError);
            }
        );
    }
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
