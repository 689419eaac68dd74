/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "crossingEvents.H"
#include "releases.H"
#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const label nValues = sizeof(crossingEvents::event)/sizeof(scalar);

static const char* eventColumns =
    "time\tx/D\tdirection\torigProc\torigId\tx\ty\tz"
    "\taxial\tradial\ttangential\tnParticle\tmass";

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::crossingEvents::crossingEvents()
:
    values_(),
    begun_(false)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::crossingEvents::append(const event& e)
{
    const scalar* values = &e.time;
    for (label i = 0; i < nValues; ++i)
    {
        values_.append(values[i]);
    }
}


void Foam::crossingEvents::write(const fileName& path)
{
    List<scalarList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = values_;
    values_.clear();
    Pstream::gatherList(all);

    if (!Pstream::master())
    {
        return;
    }

    DynamicList<event> events;
    for (const scalarList& values : all)
    {
        for (label i = 0; i < values.size(); i += nValues)
        {
            event e;
            std::copy(&values[i], &values[i] + nValues, &e.time);
            events.append(e);
        }
    }

    std::sort
    (
        events.begin(),
        events.end(),
        [](const event& a, const event& b)
        {
            return
                std::tie(a.time, a.plane, a.origProc, a.origId)
              < std::tie(b.time, b.plane, b.origProc, b.origId);
        }
    );

    releases::textFile os(path, begun_);
    os.precision(12);

    if (!begun_)
    {
        os  << "# SI units; axial, radial, tangential: velocity; direction:"
            << " 1 along, -1 against the axis" << nl
            << "# " << eventColumns << nl;
        begun_ = true;
    }

    for (const event& e : events)
    {
        const scalar* values = &e.time;
        for (label i = 0; i < nValues; ++i)
        {
            os  << values[i] << (i + 1 < nValues ? tab : nl);
        }
    }
}


// ************************************************************************* //
