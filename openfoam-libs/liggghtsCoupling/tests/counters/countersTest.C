/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    countersTest

Description
    Writes the table of the coupling for counters that no short run reaches: in each of
    five steps every rank has sent 3e9 bytes more, and made as many searches.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "couplingLog.H"
#include "fvMesh.H"
#include "ownerRoute.H"
#include "Time.H"

#include <type_traits>

using namespace Foam;

// What the table gets comes from counters of the same size
static_assert
(
    std::is_same<decltype(std::declval<const ownerRoute&>().bytes()), std::int64_t>::value,
    "the bytes of the exchange are counted by 64 bits"
);
static_assert
(
    std::is_same<decltype(std::declval<const cellLocator&>().searches()), std::int64_t>::value,
    "searches are counted by 64 bits"
);

int main(int argc, char *argv[])
{
    const argList args(argc, argv);
    Time runTime(Time::controlDictName, args);
    const fvMesh mesh(IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ));

    couplingLog log(mesh, false, false, false, false, false);

    for (int n = 1; n <= 5; ++n)
    {
        ++runTime;
        couplingLog::step values;
        values.counts = {0, 0, 0, 0};
        values.bytes = std::int64_t(3000000000)*n + Pstream::myProcNo();
        values.searches = values.bytes + 1;
        values.reduce();
        log.write(values);
    }
}


// ************************************************************************* //
