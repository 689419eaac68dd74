/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "probeForce.H"
#include "addToRunTimeSelectionTable.H"

#include <limits>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(probeForce, 0);
    addToRunTimeSelectionTable(grainForce, probeForce, dictionary);

    // Once more under a name that no state can have
    grainForce::adddictionaryConstructorToTable<probeForce> addOddlyNamedProbe_("probe::odd");
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::probeForce::probeForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce
    (
        dict,
        needs,
        {
            {"quantities", knownEntries::valueType::WORDS},
            {"states", knownEntries::valueType::ANY},
            {"infinite", knownEntries::valueType::SWITCH},
            {"numbers", knownEntries::valueType::ANY},
            {"shift", knownEntries::valueType::ANY},
            {"unasked", knownEntries::valueType::WORD},
            {"negative", knownEntries::valueType::WORD},
            {"shown", knownEntries::valueType::WORD},
            {"vector", knownEntries::valueType::SWITCH}
        }
    ),
    shift_(dict.lookupOrDefault<vector>("shift", Zero)),
    unasked_(dict.lookupOrDefault<word>("unasked", word())),
    negative_(dict.lookupOrDefault<word>("negative", word())),
    shown_(dict.found("shown") ? needs.quantity(dict.get<word>("shown")) : -1),
    nShown_(dict.lookupOrDefault<Switch>("vector", false) ? 3 : 1)
{
    if (!negative_.empty())
    {
        needs.nonReacting();
        needs.torque();
    }

    for (const word& name : dict.lookupOrDefault<wordList>("quantities", wordList()))
    {
        needs.quantity(name);
    }

    const scalarList initial
    (
        dict.lookupOrDefault<label>("numbers", 1),
        dict.lookupOrDefault<Switch>("infinite", false)
      ? std::numeric_limits<scalar>::infinity() : 0.0
    );
    for (const word& name : dict.lookupOrDefault<wordList>("states", wordList()))
    {
        needs.state(name, initial);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::probeForce::add(grainBatch& grains) const
{
    for (label i = 0; i < grainBatch::size; ++i)
    {
        grainBatch::add(grains.fluidVelocity, i, shift_);
        for (label k = 0; shown_ >= 0 && k < nShown_; ++k)
        {
            grains.Su[k][i] += 1e-15*grains.fluid(shown_)[k][i];
        }
        if (unasked_ == "torque")
        {
            grains.torque[2][i] += 1e-12;
        }
        if (unasked_ == "spin")
        {
            grains.Su[2][i] += grains.spin[2][i];
        }
        if (unasked_ == "nonReacting")
        {
            grains.nonReactingSu[2][i] += 1e-12;
        }
        if (negative_ == "Sp")
        {
            grains.Sp[i] -= 1;
        }
        if (negative_ == "nonReactingSp")
        {
            grains.nonReactingSp[i] -= 1e-9;
        }
        if (negative_ == "spinCoefficient")
        {
            grains.spinCoefficient[i] -= 1e-15;
        }
    }
}


// ************************************************************************* //
