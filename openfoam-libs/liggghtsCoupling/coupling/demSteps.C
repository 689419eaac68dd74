/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demSteps.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "Time.H"
#include "voidFractionEquations.H"

#include <cmath>
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Steps are equal up to the representation of decimal numbers. The solver's step is a difference of times when
// it has to meet a time of writing
const Foam::scalar margin = 1e-9;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demSteps::choose(liggghtsSession& session)
{
    const scalar fluid = mesh_.time().deltaTValue();
    const scalar longest = session.scriptTimeStep();
    const scalar interval = fluid/subSteps_;
    const scalar ratio = interval/longest;

    if (!(ratio < 1e9))
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(dict_, "script")
                    << "timestep " << longest << " s of " << dict_.get<fileName>("script")
                    << " is too short for a fluid step of " << fluid << " s: more than 1e9 DEM"
                    << " steps. Enlarge timestep, or set maxDeltaT in system/controlDict"
                    << exit(FatalIOError);
            }
        );
    }

    const label before = n_;
    n_ = max(label(1), label(std::ceil(ratio*(1 - margin))));
    session.setTimeStep(mag(interval - n_*longest) <= margin*interval ? longest : interval/n_);

    if (n_ != before)
    {
        Info<< "liggghtsCoupling: " << n_ << " DEM steps of " << session.timeStep()
            << " s in " << (subSteps_ > 1 ? "each of " + std::to_string(subSteps_) + " sub-steps of " : "")
            << "a fluid step of " << fluid << " s" << endl;
    }
}


void Foam::demSteps::checkFixed(const liggghtsSession& session) const
{
    const label interval = dict_.get<label>("couplingInterval");
    const scalar steps = scalar(subSteps_)*interval;
    const scalar fluid = mesh_.time().deltaTValue();
    const scalar dem = session.timeStep();

    if (mag(fluid - steps*dem) <= margin*fluid)
    {
        return;
    }
    if (adjusted(mesh_.time()))
    {
        const dictionary& controls = mesh_.time().controlDict();
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(controls, "adjustTimeStep")
                    << "adjustTimeStep yes cannot be set in a run that began with a fixed step and"
                    << " couplingInterval " << interval << ". Stop it, remove couplingInterval and"
                    << " continue" << exit(FatalIOError);
            }
        );
    }

    // As the user typed them, whatever the case's writePrecision
    std::ostringstream message;
    message
        << std::setprecision(10)
        << "The fluid step is not " << (subSteps_ > 1 ? "subSteps times " : "")
        << "couplingInterval DEM steps: deltaT " << fluid << " s (system/controlDict), ";
    if (subSteps_ > 1)
    {
        message << "subSteps " << subSteps_ << ", ";
    }
    message
        << "couplingInterval " << interval
        << ", timestep " << dem << " s (" << dict_.get<fileName>("script") << "), product "
        << steps*dem << " s.\n    Set deltaT to " << steps*dem;

    // With whole numbers, which may take another fluid step; subSteps only where it is used
    const scalar number = max(scalar(1), std::round(fluid/dem/subSteps_));
    const scalar nearest = number*subSteps_*dem;
    const scalar parts = std::round(fluid/dem/interval);
    if (subSteps_ > 1 && parts >= 1 && mag(fluid - parts*interval*dem) <= margin*fluid)
    {
        message << ", or subSteps to " << parts;
    }
    if (number < scalar(labelMax))
    {
        message << ", or couplingInterval to " << number;
        if (mag(fluid - nearest) > margin*fluid)
        {
            message << " and deltaT to " << nearest;
        }
    }

    couplingEntries::onMaster
    (
        [&]()
        {
            FatalIOErrorInEntry(dict_, "couplingInterval")
                << message.str().c_str() << exit(FatalIOError);
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::demSteps::demSteps
(
    const dictionary& dict,
    const fvMesh& mesh,
    const scalar previous
)
:
    dict_(dict),
    mesh_(mesh),
    adjusted_(adjusted(mesh.time())),
    subSteps_(subSteps(dict)),
    n_(0),
    previous_(previous)
{}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

bool Foam::demSteps::adjusted(const Time& time)
{
    return time.controlDict().lookupOrDefault("adjustTimeStep", false);
}


Foam::label Foam::demSteps::subSteps(const dictionary& dict)
{
    return dict.lookupOrDefault<label>("subSteps", 1);
}


void Foam::demSteps::checkEntries(const dictionary& dict, const Time& time)
{
    const label n = subSteps(dict);
    if (n > 1 && voidFractionEquations::full(dict))
    {
        FatalIOErrorInEntry(dict, "subSteps")
            << "subSteps " << n << " with equations full of voidFraction: where grains fill so much of the"
            << " cells that they count there, the fluid between them changes as they move, and cannot"
            << " stay as it is for several intervals. Remove subSteps and shorten deltaT, or set equations"
            << " neglected" << exit(FatalIOError);
    }
    if (n > 1 && dict.lookupOrDefault<Switch>("selfDisturbance", false))
    {
        FatalIOErrorInEntry(dict, "subSteps")
            << "subSteps " << n << " with selfDisturbance yes: the wake of a grain is known for a fluid that"
            << " answers to each interval. Remove subSteps, or selfDisturbance" << exit(FatalIOError);
    }
    if (adjusted(time) && dict.found("couplingInterval"))
    {
        FatalIOErrorInEntry(dict, "couplingInterval")
            << "couplingInterval is for a fixed step, but system/controlDict has adjustTimeStep yes:"
            << " then the number of DEM steps follows from deltaT and the script's timestep, which is"
            << " the longest one. Remove couplingInterval, or set adjustTimeStep to no"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demSteps::check(const liggghtsSession& session) const
{
    if (!adjusted_)
    {
        checkFixed(session);
    }
}


Foam::label Foam::demSteps::next(liggghtsSession& session, scalar& previous)
{
    if (adjusted_)
    {
        choose(session);
    }
    else
    {
        checkFixed(session);
        n_ = dict_.get<label>("couplingInterval");
    }
    const scalar fluid = mesh_.time().deltaTValue();
    previous = previous_ > 0 ? previous_ : fluid;
    previous_ = fluid;
    return n_;
}


void Foam::demSteps::report(const liggghtsSession& session, Ostream& os) const
{
    if (adjusted_)
    {
        os  << "DEM steps of at most " << session.scriptTimeStep() << " s";
    }
    else
    {
        os  << dict_.get<label>("couplingInterval") << " DEM steps of " << session.timeStep()
            << " s per ";
        if (subSteps_ > 1)
        {
            os  << "sub-step, " << subSteps_ << " sub-steps per ";
        }
        os  << "fluid step";
    }
}


// ************************************************************************* //
