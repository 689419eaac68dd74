/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingLog.H"
#include "volFields.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// -1 is what no style of the script provides
void printProvided(const Foam::scalar value)
{
    if (value >= 0)
    {
        Foam::Info<< value;
    }
    else
    {
        Foam::Info<< "unknown";
    }
}


// OpenFOAM prints whole numbers as labels, which may have 32 bits
std::string digits(const Foam::scalar count)
{
    return std::to_string(std::llround(count));
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::couplingLog::warn(const scalar maxSolidFraction)
{
    // Neglected inertia and displacement are of the order of the solid fraction; spheres of one size
    // cannot fill more than pi/sqrt(18)
    const scalar noticeable = full_ ? 0.74 : 0.05;

    if (warned_ || !(maxSolidFraction > noticeable))
    {
        return;
    }
    warned_ = true;
    if (full_)
    {
        WarningInFunction
            << "Grains fill " << 100*maxSolidFraction << " % of a cell, more than spheres that do not"
            << " overlap can (74 %). Either they overlap, or the cell is not larger than they are."
            << " See the columns maxSolidFraction and volumeCut of the table. This is said once" << endl;
    }
    else
    {
        WarningInFunction
            << "Grains fill " << 100*maxSolidFraction << " % of a cell. The"
            << " solver's equations hold no void fraction: there they are wrong by one"
            << " to two times as much. The entry voidFraction { equations full; } puts it in. This is said once"
            << endl;
    }
}


void Foam::couplingLog::miss(const scalar unaccounted)
{
    if (!missed_ && mag(unaccounted) > 0.5)
    {
        missed_ = true;
        WarningInFunction
            << label(mag(unaccounted) + 0.5) << " grains "
            << (unaccounted > 0 ? "are gone" : "are too many")
            << ": inserted less removed less present is not zero. LIGGGHTS deletes grains"
            << " without a trace where they are lost between ranks"
            << " (thermo_modify lost ignore), or by commands of the script other than"
            << " fix massflow/mesh. Column unaccounted of the table has the number."
            << " This is said once" << endl;
    }
}


void Foam::couplingLog::warnOfDemStep(const scalar rayleigh)
{
    // In % of the Rayleigh time, as the paper keeps it; -1 if the script does not provide it
    const scalar longest = 20;

    if (!warnedOfDemStep_ && rayleigh > longest)
    {
        warnedOfDemStep_ = true;
        WarningInFunction
            << "The DEM step is " << rayleigh << " % of the Rayleigh time of a grain, more than " << longest
            << " %: contacts may have too few steps, so that they lose less energy than they should or make some."
            << " Shorten timestep in the script, with a couplingInterval that is larger by the same factor, or lower"
            << " Young's modulus."
            << " This is said once" << endl;
    }
}


void Foam::couplingLog::writeTableHeader()
{
    OFstream& os = file();
    writeHeader(os, "Balance of the coupling, one row per fluid step");
    writeHeader
    (
        os,
        "unaccounted = inserted - leftBox - deleted - present; -1: not provided by the script"
    );
    writeHeader
    (
        os,
        "momentum [N s] in this step to the grains, with (toGrains) and without (nonReacting) reaction"
        " on the fluid; to the fluid and still owed to it: step before"
    );
    writeHeader
    (
        os,
        "bytes sent and searches through the mesh: since the start"
    );
    if (subSteps_)
    {
        writeHeader
        (
            os,
            "fluidChange [m/s]: by how much the fluid at the grains has changed in the step before, in the mean;"
            " to be compared with meanSlip"
        );
    }
    if (joule_)
    {
        writeHeader(os, joule_->header());
    }
    else if (full_)
    {
        writeHeader(os, "fluidVolume [m3]: between the grains, at the beginning of the step");
    }
    writeCommented(os, "Time");
    for
    (
        const char* column :
        {
            "inserted", "present", "leftBox", "deleted", "unaccounted", "outsideMesh",
            "contacts", "maxSolidFraction", "volumeCut", "meanSlip",
            "percentRayleigh", "toGrains_x", "toGrains_y", "toGrains_z",
            "nonReacting_x", "nonReacting_y", "nonReacting_z",
            "toFluid_x", "toFluid_y", "toFluid_z", "owed_x", "owed_y", "owed_z",
            "imbalance", "secondsFluid", "secondsDEM", "secondsCoupling",
            "remote", "bytes", "searches"
        }
    )
    {
        writeTabbed(os, column);
    }
    if (subSteps_)
    {
        writeTabbed(os, "fluidChange");
    }
    if (joule_)
    {
        for (const word& column : joule_->columns())
        {
            writeTabbed(os, column);
        }
    }
    else if (full_)
    {
        writeTabbed(os, "fluidVolume");
    }
    os << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingLog::couplingLog
(
    const fvMesh& mesh,
    const bool twoWay,
    const bool subSteps,
    const bool full,
    const bool energy,
    const bool heat
)
:
    functionObjects::writeFile(mesh, "liggghtsCoupling", "balance", dictionary()),
    mesh_(mesh),
    twoWay_(twoWay),
    subSteps_(subSteps),
    full_(full),
    warned_(false),
    missed_(false),
    warnedOfDemStep_(false),
    leftBox_(0),
    deleted_(0),
    clock_(),
    startSeconds_(-1),
    startTime_(0),
    previousSeconds_(0),
    ownSeconds_(0),
    fluidSeconds_(0),
    sumToGrains_(Zero),
    sumToFluid_(Zero),
    owedBefore_(Zero),
    sumExchanged_(0),
    latestToGrains_(Zero),
    joule_(energy ? new energyBalance(full, heat) : nullptr)
{
    if (Pstream::master())
    {
        writeTableHeader();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingLog::closeFluidStep
(
    step& values,
    grainMomentum& momentum,
    const voidFractionEquations* equations,
    const energyExchange* energy,
    const heatExchange* heat,
    const compressibleVoidFraction* gas
)
{
    if (twoWay_)
    {
        values.toFluid = momentum.close(equations ? equations->stress() : vectorField::null());
        values.owed = momentum.owed();
        if (equations)
        {
            values.toFluid += equations->received();
            values.owed += equations->owed();
        }
    }
    if (energy)
    {
        energyBalance::closeFluidStep(values, *energy, heat, gas);
    }
}


void Foam::couplingLog::write(const step& values)
{
    const Time& time = mesh_.time();
    const scalar now = clock_.elapsedTime();

    const bool first = (startSeconds_ < 0);
    if (first)
    {
        startSeconds_ = now - values.demSeconds - values.couplingSeconds;
        startTime_ = time.value() - time.deltaTValue();
        previousSeconds_ = startSeconds_;
    }

    // Shares of the wall clock since the previous line
    const scalar all = max(now - previousSeconds_, VSMALL);
    const scalar couplingSeconds = values.couplingSeconds + ownSeconds_;
    fluidSeconds_ = first ? 0 : all - values.demSeconds - couplingSeconds;
    previousSeconds_ = now;

    // For the eye, whatever precision the case writes its fields with
    const int precision = Info().precision(4);

    const scalar maxSolidFraction = values.cells.maxSolidFraction;
    warn(maxSolidFraction);

    leftBox_ += values.grains.leftBox;
    deleted_ += values.grains.deleted;
    const scalar unaccounted =
        values.counts.inserted - leftBox_ - deleted_ - values.counts.present;
    miss(unaccounted);
    warnOfDemStep(values.counts.rayleigh);

    const scalar slip = values.meanSlip();
    const vector& toGrains = values.received.reacting;
    const vector& toFluid = values.toFluid;
    const vector& owed = values.owed;
    if (first)
    {
        owedBefore_ = owed;
    }

    // The fluid's part of a step is known once the step is over
    sumToGrains_ += latestToGrains_;
    sumExchanged_ += mag(latestToGrains_);
    sumToFluid_ += toFluid;
    latestToGrains_ = toGrains;

    const scalar imbalance =
        twoWay_ && sumExchanged_ > 0
      ? mag(sumToGrains_ + sumToFluid_ + owed - owedBefore_)/sumExchanged_
      : 0;

    if (joule_)
    {
        joule_->add(values, first);
    }

    const scalar done = time.value() - startTime_;
    const scalar secondsLeft =
        (now - startSeconds_)
       *max(time.endTime().value() - time.value(), scalar(0))/max(done, VSMALL);

    Info<< "liggghtsCoupling: grains " << label(values.counts.present)
        << " (inserted " << label(values.counts.inserted)
        << ", left the box " << label(leftBox_)
        << ", deleted " << label(deleted_)
        << ", outside the mesh " << values.grains.outsideMesh
        << ", remote " << values.grains.remote << "), contacts ";
    printProvided(values.counts.contacts);
    Info<< ", max solid fraction " << maxSolidFraction
        << ", slip " << slip
        << " m/s, ";
    if (subSteps_)
    {
        Info<< "change of the fluid " << values.fluidChange() << " m/s, ";
    }
    Info<< "Rayleigh ";
    printProvided(values.counts.rayleigh);
    Info<< " %, momentum to grains " << toGrains
        << " N s, imbalance " << imbalance;
    if (joule_)
    {
        joule_->print(Info);
    }
    else if (full_)
    {
        Info<< ", fluid volume " << values.fluidVolume << " m3";
    }
    Info<< ", time fluid " << label(100*fluidSeconds_/all + 0.5)
        << " % DEM " << label(100*values.demSeconds/all + 0.5)
        << " % coupling " << label(100*couplingSeconds/all + 0.5)
        << " %, still ";
    if (secondsLeft < scalar(labelMax))
    {
        Info<< label(secondsLeft + 0.5) << " s";
    }
    else
    {
        // stopAt nextWrite and the like have no time at which the run ends
        Info<< "unknown";
    }
    Info<< nl;

    if (values.cells.volumeCut > 0)
    {
        Info<< "liggghtsCoupling: void fraction at its minimum; solid volume cut "
            << values.cells.volumeCut << " m3" << nl;
    }
    Info().precision(precision);

    if (Pstream::master())
    {
        OFstream& os = file();
        os  << time.value() << tab << values.counts.inserted
            << tab << values.counts.present << tab << leftBox_ << tab << deleted_
            << tab << unaccounted << tab << values.grains.outsideMesh << tab << values.counts.contacts
            << tab << maxSolidFraction << tab << values.cells.volumeCut
            << tab << slip << tab << values.counts.rayleigh;
        for (const vector& v : {toGrains, values.received.nonReacting, toFluid, owed})
        {
            os  << tab << v.x() << tab << v.y() << tab << v.z();
        }
        os  << tab << imbalance << tab << fluidSeconds_
            << tab << values.demSeconds << tab << couplingSeconds
            << tab << values.grains.remote << tab << digits(values.bytes).c_str()
            << tab << digits(values.searches).c_str();
        if (subSteps_)
        {
            os  << tab << values.fluidChange();
        }
        if (joule_)
        {
            joule_->write(os);
        }
        else if (full_)
        {
            os  << tab << values.fluidVolume;
        }
        os  << endl;
    }
    ownSeconds_ = clock_.elapsedTime() - now;
}


// ************************************************************************* //
