/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What must be true before the first step of a coupled run.

\*---------------------------------------------------------------------------*/

#include "liggghtsCoupling.H"
#include "OSspecific.H"
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fv::liggghtsCoupling::checkEntries() const
{
    const wordHashSet own
    ({
        "script", "couplingInterval", "coupling", "voidFraction", "drag", "forces",
        "interpolation", "formulation", "momentum", "turbulenceSources",
        "ChenWoodCoeffs", "U", "p", "log"
    });
    const wordHashSet ofEveryOption({"type", "active", "libs"});

    const auto check = [](const dictionary& dict, const wordHashSet& known)
    {
        for (const entry& e : dict)
        {
            if (!known.found(e.keyword()))
            {
                FatalIOErrorInFunction(dict)
                    << "Unknown entry " << e.keyword() << " in " << dict.dictName()
                    << ". Valid: " << known.sortedToc() << exit(FatalIOError);
            }
        }
    };

    // Entries may lie in a sub-dictionary of the option's own name
    if (&coeffs_ != &dict_ && dict_.found(type() + "Coeffs"))
    {
        check(coeffs_, own);
        check(dict_, ofEveryOption | wordHashSet({type() + "Coeffs"}));
    }
    else
    {
        check(coeffs_, own | ofEveryOption);
    }
    check(coeffs_.subOrEmptyDict("voidFraction"), {"model", "minimum"});
    check(coeffs_.subOrEmptyDict("ChenWoodCoeffs"), {"B", "Ce", "C3"});
}


void Foam::fv::liggghtsCoupling::checkCase() const
{
    const Time& time = mesh_.time();

    const fileName path
    (
        script_.isAbsolute() ? script_ : time.globalPath()/script_
    );
    const bool found = returnReduce
    (
        !Pstream::master() || Foam::isFile(path, false),
        andOp<bool>()
    );
    if (!found)
    {
        FatalIOErrorInFunction(coeffs_)
            << "script " << script_ << " not found: there is no file " << path
            << exit(FatalIOError);
    }

    if (interval_ < 1)
    {
        FatalIOErrorInFunction(coeffs_)
            << "couplingInterval " << interval_ << " is not positive: it is the"
            << " number of DEM steps in a fluid step" << exit(FatalIOError);
    }

    if (time.controlDict().lookupOrDefault("adjustTimeStep", false))
    {
        FatalIOErrorInFunction(time.controlDict())
            << "adjustTimeStep yes cannot be used with " << typeName
            << ": the fluid step is couplingInterval DEM steps. Set it to no"
            << exit(FatalIOError);
    }
}


void Foam::fv::liggghtsCoupling::checkTimeStep() const
{
    const scalar fluid = mesh_.time().deltaTValue();
    const scalar dem = session_->timeStep();

    // Both are typed decimal numbers: equal up to their representation
    if (mag(fluid - interval_*dem) > 1e-9*fluid)
    {
        // As the user typed them, whatever the case's writePrecision
        std::ostringstream message;
        message
            << std::setprecision(10)
            << "The fluid step is not couplingInterval DEM steps: deltaT " << fluid
            << " s (system/controlDict), couplingInterval " << interval_
            << ", timestep " << dem << " s (" << script_ << "), product "
            << interval_*dem << " s.\n    Set deltaT to " << interval_*dem
            << " or couplingInterval to " << fluid/dem;

        FatalIOErrorInFunction(coeffs_)
            << message.str().c_str() << exit(FatalIOError);
    }
}


void Foam::fv::liggghtsCoupling::checkOverlap() const
{
    const liggghtsSession::simulationBox box = session_->box();
    const boundBox dem
    (
        point(box.low[0], box.low[1], box.low[2]),
        point(box.high[0], box.high[1], box.high[2])
    );

    if (!dem.overlaps(mesh_.bounds()))
    {
        FatalIOErrorInFunction(coeffs_)
            << "No grain can ever meet the fluid: the box of " << script_ << ' '
            << dem << " and the mesh " << mesh_.bounds()
            << " have no part in common. Both are in metres"
            << exit(FatalIOError);
    }
}


void Foam::fv::liggghtsCoupling::setPeriod()
{
    const liggghtsSession::simulationBox box = session_->box();
    vector period(Zero);
    point low;
    for (direction k = 0; k < 3; ++k)
    {
        low[k] = box.low[k];
        if (box.periodic[k])
        {
            period[k] = box.high[k] - box.low[k];
        }
    }
    locator_.setPeriod(low, period);
}


// ************************************************************************* //
