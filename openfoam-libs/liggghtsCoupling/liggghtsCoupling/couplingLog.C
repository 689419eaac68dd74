/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingLog.H"
#include "surfaceFields.H"
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
    // The neglected inertia and displacement are of the order of the solid fraction
    const scalar noticeable = 0.05;

    if (!warned_ && maxSolidFraction > noticeable)
    {
        warned_ = true;
        WarningInFunction
            << "Grains fill " << 100*maxSolidFraction << " % of a cell. The"
            << " solver's equations hold no void fraction: there they are wrong by one"
            << " to two times as much. This is said once" << endl;
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
            << ": inserted less left less present is not zero. LIGGGHTS deletes grains"
            << " without a trace where they are lost between ranks"
            << " (thermo_modify lost ignore), or by commands of the script other than"
            << " fix massflow/mesh. Column unaccounted of the table has the number."
            << " This is said once" << endl;
    }
}


Foam::scalar Foam::couplingLog::courant() const
{
    const auto* phi = mesh_.cfindObject<surfaceScalarField>("phi");
    if (!phi)
    {
        return -1;
    }

    scalarField sumPhi(mesh_.nCells(), Zero);
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    forAll(neighbour, facei)
    {
        const scalar flux = mag((*phi)[facei]);
        sumPhi[owner[facei]] += flux;
        sumPhi[neighbour[facei]] += flux;
    }
    forAll(phi->boundaryField(), patchi)
    {
        const scalarField& patchPhi = phi->boundaryField()[patchi];
        const labelUList& cells = mesh_.boundary()[patchi].faceCells();
        forAll(patchPhi, i)
        {
            sumPhi[cells[i]] += mag(patchPhi[i]);
        }
    }

    scalar largest = 0;
    forAll(sumPhi, celli)
    {
        largest = max(largest, sumPhi[celli]/mesh_.V()[celli]);
    }
    return
        0.5*returnReduce(largest, maxOp<scalar>())*mesh_.time().deltaTValue();
}


void Foam::couplingLog::writeTableHeader()
{
    OFstream& os = file();
    writeHeader(os, "Balance of the coupling, one row per fluid step");
    writeHeader
    (
        os,
        "unaccounted = inserted - left - present; outside: in no cell; -1: not provided by the script"
    );
    writeHeader
    (
        os,
        "momentum [N s] in this step to the grains; to the fluid and still owed to it: step before"
    );
    writeHeader
    (
        os,
        "bytes sent and searches through the mesh: since the start"
    );
    writeCommented(os, "Time");
    for
    (
        const char* column :
        {
            "inserted", "present", "left", "unaccounted", "outside", "contacts",
            "maxSolidFraction", "volumeCut", "meanSlip", "Courant",
            "percentRayleigh", "toGrains_x", "toGrains_y", "toGrains_z",
            "toFluid_x", "toFluid_y", "toFluid_z", "owed_x", "owed_y", "owed_z",
            "imbalance", "secondsFluid", "secondsDEM", "secondsCoupling",
            "travelling", "bytes", "searches"
        }
    )
    {
        writeTabbed(os, column);
    }
    os << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingLog::couplingLog(const fvMesh& mesh, const bool twoWay)
:
    functionObjects::writeFile(mesh, "liggghtsCoupling", "balance", dictionary()),
    mesh_(mesh),
    twoWay_(twoWay),
    warned_(false),
    missed_(false),
    left_(0),
    clock_(),
    startSeconds_(-1),
    startTime_(0),
    previousSeconds_(0),
    ownSeconds_(0),
    sumToGrains_(Zero),
    sumToFluid_(Zero),
    owedBefore_(Zero),
    sumExchanged_(0),
    latestToGrains_(Zero)
{
    if (Pstream::master())
    {
        writeTableHeader();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    const scalar fluidSeconds = all - values.demSeconds - couplingSeconds;
    previousSeconds_ = now;

    // For the eye, whatever precision the case writes its fields with
    const int precision = Info().precision(4);

    const scalar maxSolidFraction =
        returnReduce(values.maxSolidFraction, maxOp<scalar>());
    const scalar volumeCut = returnReduce(values.volumeCut, sumOp<scalar>());
    warn(maxSolidFraction);

    // As scalars, which count whole numbers up to 9e15
    const vector numbers = returnReduce
    (
        vector(values.left, values.travelling, values.searches),
        sumOp<vector>()
    );
    left_ += numbers[0];
    const label travelling = numbers[1];
    const scalar unaccounted =
        values.counts.inserted - values.counts.present - left_;
    miss(unaccounted);

    const vector sums = returnReduce
    (
        vector(values.slipSum, values.guests, values.bytes),
        sumOp<vector>()
    );
    const scalar slip = sums[1] > 0 ? sums[0]/sums[1] : 0;

    const vector toGrains = returnReduce(values.toGrains, sumOp<vector>());
    const vector toFluid = returnReduce(values.toFluid, sumOp<vector>());
    const vector owed = returnReduce(values.owed, sumOp<vector>());
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

    const scalar done = time.value() - startTime_;
    const scalar secondsLeft =
        (now - startSeconds_)
       *max(time.endTime().value() - time.value(), scalar(0))/max(done, VSMALL);
    const scalar Co = courant();

    Info<< "liggghtsCoupling: grains " << label(values.counts.present)
        << " (inserted " << label(values.counts.inserted)
        << ", left " << label(left_)
        << ", outside mesh " << values.outside
        << ", on another rank " << travelling << "), contacts ";
    printProvided(values.counts.contacts);
    Info<< ", max solid fraction " << maxSolidFraction
        << ", slip " << slip
        << " m/s, Courant " << Co
        << ", Rayleigh ";
    printProvided(values.counts.rayleigh);
    Info<< " %, momentum to grains " << toGrains
        << " N s, imbalance " << imbalance
        << ", time fluid " << label(100*fluidSeconds/all + 0.5)
        << " % DEM " << label(100*values.demSeconds/all + 0.5)
        << " % coupling " << label(100*couplingSeconds/all + 0.5)
        << " %, left ";
    if (secondsLeft < labelMax)
    {
        Info<< label(secondsLeft + 0.5) << " s";
    }
    else
    {
        // stopAt nextWrite and the like have no time at which the run ends
        Info<< "unknown";
    }
    Info<< nl;

    if (volumeCut > 0)
    {
        Info<< "liggghtsCoupling: void fraction at its minimum; solid volume cut "
            << volumeCut << " m3" << nl;
    }
    Info().precision(precision);

    if (Pstream::master())
    {
        OFstream& os = file();
        os  << time.value() << tab << values.counts.inserted
            << tab << values.counts.present << tab << left_ << tab << unaccounted
            << tab << values.outside << tab << values.counts.contacts
            << tab << maxSolidFraction << tab << volumeCut
            << tab << slip << tab << Co << tab << values.counts.rayleigh;
        for (const vector& v : {toGrains, toFluid, owed})
        {
            os  << tab << v.x() << tab << v.y() << tab << v.z();
        }
        os  << tab << imbalance << tab << fluidSeconds
            << tab << values.demSeconds << tab << couplingSeconds
            << tab << travelling << tab << digits(sums[2]).c_str()
            << tab << digits(numbers[2]).c_str()
            << endl;
    }
    ownSeconds_ = clock_.elapsedTime() - now;
}


// ************************************************************************* //
