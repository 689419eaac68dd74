/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What a case must state for the full equations, see voidFractionEquations.H.

\*---------------------------------------------------------------------------*/

#include "voidFractionEquations.H"
#include "couplingEntries.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

bool hasPressureGradient(const dictionary& dict)
{
    const word name("pressureGradient");
    return
        dict.isDict("forces")
      ? dict.subDict("forces").found(name)
      : dict.lookupOrDefault<wordList>("forces", wordList()).found(name);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::voidFractionEquations::checkConvection
(
    const carrierFluid& fluid,
    const word& field
)
{
    // A bounded scheme takes the divergence of the flux out of the equation. That of the fluid between the grains
    // is the rate at which their shares change, with what belongs to it of the field
    const dictionary schemes(fluid.mesh().schemesDict().subOrEmptyDict("divSchemes"));
    const word convection
    (
        "div(" + fluid.momentumFlux().name() + ',' + field + ')'
    );
    for (const word& key : {convection, word("default")})
    {
        if (!schemes.found(key))
        {
            continue;
        }
        const token first(schemes.lookup(key)[0]);
        if (first.isWord() && first.wordToken() == "bounded")
        {
            couplingEntries::onMaster
            (
                [&]()
                {
                    FatalIOErrorInEntry(schemes, key)
                        << "divSchemes: " << convection << " is bounded, with which equations full"
                        << " would not keep "
                        << (field == fluid.UName() ? "the momentum" : ("the field " + field).c_str())
                        << " of fluid and grains. Take the same scheme without the word bounded"
                        << exit(FatalIOError);
                }
            );
        }
        return;
    }
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

bool Foam::voidFractionEquations::full(const dictionary& dict)
{
    return
        dict.subOrEmptyDict("voidFraction").lookupOrDefault<word>("equations", "neglected")
     == "full";
}


void Foam::voidFractionEquations::checkEntries(const dictionary& dict)
{
    if (!full(dict))
    {
        return;
    }

    const dictionary& voidFraction = dict.subDict("voidFraction");
    if (!couplingEntries::twoWay(dict))
    {
        FatalIOErrorInEntry(voidFraction, "equations")
            << "equations full and coupling oneWay: the void fraction changes the flow, while"
            << " oneWay leaves it as it is without grains. Set coupling twoWay, or equations"
            << " neglected" << exit(FatalIOError);
    }
    if (!hasPressureGradient(dict))
    {
        FatalIOErrorInEntry(voidFraction, "equations")
            << "equations full: the pressure of the fluid acts on fluid and grains alike, but"
            << " pressureGradient is not among the forces. Add it, as in\n"
            << "    forces (pressureGradient viscous);\n"
            << "or set equations neglected" << exit(FatalIOError);
    }
    if (dict.lookupOrDefault<word>("momentum", "implicit") != "implicit")
    {
        FatalIOErrorInEntry(voidFraction, "equations")
            << "equations full needs momentum implicit, since dense beds have no explicit step"
            << " that is stable" << exit(FatalIOError);
    }
}


// ************************************************************************* //
