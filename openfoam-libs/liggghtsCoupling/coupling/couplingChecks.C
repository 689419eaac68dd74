/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingChecks.H"
#include "couplingEntries.H"
#include "energyExchange.H"
#include "entryError.H"

#include <sstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingChecks::couplingChecks
(
    const dictionary& dict,
    const fvMesh& mesh,
    const liggghtsSession& session
)
:
    dict_(dict),
    mesh_(mesh),
    session_(session),
    script_(dict.get<fileName>("script"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingChecks::overlap() const
{
    const liggghtsSession::simulationBox box = session_.box();
    const boundBox dem
    (
        point(box.low[0], box.low[1], box.low[2]),
        point(box.high[0], box.high[1], box.high[2])
    );

    if (!dem.overlaps(mesh_.bounds()))
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(dict_, "script")
                    << "No grain can ever meet the fluid: the box of " << script_ << ' '
                    << dem << " and the mesh " << mesh_.bounds()
                    << " have no part in common. Both are in metres"
                    << exit(FatalIOError);
            }
        );
    }
}


void Foam::couplingChecks::grains() const
{
    // Far beyond any grain, and far from where products of such numbers overflow
    const scalar smallRadius = 1e-12, largeRadius = 1e6;
    const scalar smallMass = 1e-30, largeMass = 1e30;
    const scalar largeSpeed = 1e9;

    const liggghtsSession::grainArrays grains = session_.grains();
    label odd = labelMax;
    for (label i = 0; i < grains.n; ++i)
    {
        const scalar r = grains.radius[i];
        const scalar m = grains.mass[i];
        const double* v = grains.velocity[i];
        const scalar speed = mag(v[0]) + mag(v[1]) + mag(v[2]);
        if
        (
            !(r >= smallRadius && r <= largeRadius && m >= smallMass && m <= largeMass)
         || !(speed <= largeSpeed)
        )
        {
            odd = min(odd, label(grains.id[i]));
        }
    }
    reduce(odd, minOp<label>());

    if (odd != labelMax)
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(dict_, "script")
                    << "script " << script_ << ": grain " << odd << " has a radius outside of "
                    << smallRadius << " to " << largeRadius << " m, a mass outside of " << smallMass
                    << " to " << largeMass << " kg, or a speed above " << largeSpeed
                    << " m/s. See its diameter, density and velocity" << exit(FatalIOError);
            }
        );
    }
}


bool Foam::couplingChecks::gravity(vector& g) const
{
    double values[3];
    if (!session_.gravity(values))
    {
        return false;
    }
    g = vector(values[0], values[1], values[2]);

    const scalar large = 1e9;
    if (!(mag(g.x()) + mag(g.y()) + mag(g.z()) < large))
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(dict_, "script")
                    << "script " << script_ << ": fix gravity of " << g
                    << " m/s2 must be below " << large << exit(FatalIOError);
            }
        );
    }
    return true;
}


void Foam::couplingChecks::sameGravity(const vector* solver, const vector* script) const
{
    // Directions are written with some digits only
    const scalar tolerance = 1e-6;
    const vector ofScript(script ? *script : vector::zero);
    if (!solver || mag(ofScript - *solver) <= tolerance*mag(*solver))
    {
        return;
    }

    // Not with the digits of the fields
    std::ostringstream message;
    message.precision(9);
    const auto write = [&](const vector& v)
    {
        message << v.x() << ' ' << v.y() << ' ' << v.z();
    };

    if (script)
    {
        message << "gravity is (";
        write(*script);
        message << ')';
    }
    else
    {
        message << "there is no fix gravity";
    }
    message << ", but that of the solver (" << mesh_.time().constant() << "/g) is (";
    write(*solver);
    message << ") m/s2: weight and buoyancy of grains would not be of one gravity. ";

    const scalar size = mag(*solver);
    if (size > 0)
    {
        message << "Write in the script\n    fix g all gravity " << size << " vector ";
        write(*solver/size);
        message << "\nor change ";
    }
    else
    {
        message << "Take fix gravity out, or change ";
    }
    message << mesh_.time().constant() << "/g";

    couplingEntries::onMaster
    (
        [&]()
        {
            FatalIOErrorInEntry(dict_, "script")
                << "script " << script_ << ": " << message.str().c_str() << exit(FatalIOError);
        }
    );
}


void Foam::couplingChecks::heat(const liggghtsSession::requests& needed) const
{
    if (!session_.hasHeat() || needed.heat)
    {
        return;
    }
    const bool energy = !energyExchange::fieldName(mesh_).empty();
    couplingEntries::onMaster
    (
        [&]()
        {
            if (energy)
            {
                FatalIOErrorInEntry(dict_, "forces")
                    << "script " << script_ << " has fix fluid/heat coupled, but forces has no model heat, so"
                    << " the grains would keep their temperature. Add heat { model RanzMarshall; } to forces, or"
                    << " remove the fix" << exit(FatalIOError);
            }
        }
    );
    WarningInFunction
        << "script " << script_ << " has fix fluid/heat coupled, but the solver has no energy equation: fluid and"
        << " grains exchange momentum only, and the grains keep their temperature. This is said once" << endl;
}


void Foam::couplingChecks::anyInside(const label outside) const
{
    const scalar present = session_.counts().present;
    if (present > 0 && outside == present)
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(dict_, "script")
                    << "None of the " << present << " grains of " << script_
                    << " lies in a cell of the mesh, whose bounds are " << mesh_.bounds()
                    << ". Check units (metres) and origin of script and mesh"
                    << exit(FatalIOError);
            }
        );
    }
}


// ************************************************************************* //
