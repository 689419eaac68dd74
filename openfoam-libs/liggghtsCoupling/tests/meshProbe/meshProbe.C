/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    meshProbe

Description
    Prints how the coupling finds cells, divides spheres and interpolates on the mesh of a case, see
    probedMesh. Options: -points, -walkers, -steps, -spheres (their numbers), -period (vector).

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "meshFigures.H"
#include "probedMesh.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addOption("points", "N", "Points to find");
    argList::addOption("walkers", "N", "Points to follow");
    argList::addOption("steps", "N", "Over so many steps");
    argList::addOption("spheres", "N", "Spheres to divide");
    argList::addOption("period", "vector", "Sides of the periodic box");

    const argList args(argc, argv);
    Time runTime(Time::controlDictName, args);
    const fvMesh mesh
    (
        IOobject(fvMesh::defaultRegion, runTime.timeName(), runTime, IOobject::MUST_READ)
    );

    meshFigures::print(mesh);
    probedMesh probe(mesh, args.lookupOrDefault<vector>("period", Zero));
    probe.points
    (
        args.lookupOrDefault<label>("points", 0), runTime.globalPath()/"pointsFound"
    );
    probe.spheres(args.lookupOrDefault<label>("spheres", 0));
    if (!Pstream::parRun())
    {
        probe.walk
        (
            args.lookupOrDefault<label>("walkers", 0), args.lookupOrDefault<label>("steps", 0)
        );
    }
    return 0;
}


// ************************************************************************* //
