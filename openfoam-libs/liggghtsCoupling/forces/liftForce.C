/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liftForce.H"
#include "couplingEntries.H"
#include "entryError.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::liftForce::warnOfLimit() const
{
    IOWarningInFunction(dict_)
        << "forces: " << type() << " exceeds the drag of some grains, and the fluid step is"
        << " not short against the time in which drag slows them down. It has been limited to"
        << " what can be integrated. Shorten the fluid step, with couplingInterval, if these"
        << " grains matter" << endl;
}


void Foam::liftForce::warnOfDrag() const
{
    IOWarningInFunction(dict_)
        << "forces: " << type() << " acts on grains without drag, which would slow them down"
        << " and limit it. Held over a fluid step, such a lift makes the slip grow in each,"
        << " without bound. Put drag before it" << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::liftForce::liftForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce(dict, needs),
    limited_(false),
    warned_(false),
    undamped_(false),
    warnedOfDrag_(false)
{
    // In the short form drag is always the first one
    if (!needs.coupling().isDict("forces"))
    {
        return;
    }
    const wordList names(needs.coupling().subDict("forces").toc());
    couplingEntries::onMaster
    (
        [&]()
        {
            if (names.find("drag") > names.find(dict.dictName()))
            {
                FatalIOErrorInEntry(needs.coupling().subDict("forces"), "drag")
                    << "forces: drag stands behind " << dict.dictName() << ", which is limited"
                    << " by it. Put drag before it" << exit(FatalIOError);
            }
        }
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::liftForce::addLift(grainBatch& grains, const lane* L) const
{
    const scalar interval = fluid_.interval();

    bool any = false;
    bool undamped = false;
    for (label i = 0; i < grainBatch::size; ++i)
    {
        const scalar b = grains.Sp[i] + grains.nonReactingSp[i];
        const scalar largest = 0.25*max(sqr(b), 2*b*grains.mass[i]/interval);

        const vector slip
        (
            grainBatch::get(grains.fluidVelocity, i) - grainBatch::get(grains.velocity, i)
        );
        vector lift(grains.particles[i]*grainBatch::get(L, i));
        const scalar square = magSqr(lift);

        if (b > 0 && square > largest)
        {
            lift *= sqrt(largest/square);
            any = true;
        }
        const vector force(slip ^ lift);
        undamped = undamped || (b <= 0 && magSqr(force) > 0);
        grainBatch::add(grains.Su, i, force);
    }
    undamped_ = undamped_ || undamped;
    limited_ = limited_ || any;
}


void Foam::liftForce::prepare()
{
    // Once per fluid step, for all ranks together
    if ((fluid_.intervalIndex() - 1)%fluid_.subSteps() != 0 || (warned_ && warnedOfDrag_))
    {
        return;
    }
    enum { LIMITED = 1, UNDAMPED = 2 };
    unsigned int seen = (limited_ ? LIMITED : 0) | (undamped_ ? UNDAMPED : 0);
    reduce(seen, bitOrOp<unsigned int>());
    if (!warned_ && (seen & LIMITED))
    {
        warned_ = true;
        warnOfLimit();
    }
    if (!warnedOfDrag_ && (seen & UNDAMPED))
    {
        warnedOfDrag_ = true;
        warnOfDrag();
    }
}


// ************************************************************************* //
