/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "switchedOffCoupling.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fv::switchedOffCoupling::switchedOffCoupling
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh)
{
    Info<< "    Switched off (active no): LIGGGHTS is not started" << nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fv::switchedOffCoupling::warnOfChange
(
    const option& source,
    dictionary& known,
    const dictionary& dict
)
{
    if (dict != known)
    {
        known = dict;
        WarningInFunction
            << "The entries of " << source.name() << " in " << dict.name()
            << " have changed. They are read at the start of a run: this one goes on"
            << " as it began" << endl;
    }
}


bool Foam::fv::switchedOffCoupling::read(const dictionary& dict)
{
    warnOfChange(*this, dict_, dict);
    return false;
}


// ************************************************************************* //
