/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "particleState.H"
#include "UIndirectList.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::particleState Foam::particleState::subset
(
    const UList<label>& indices
) const
{
    particleState part;
    part.position = UIndirectList<point>(position, indices);
    part.U = UIndirectList<vector>(U, indices);
    part.nParticle = UIndirectList<scalar>(nParticle, indices);
    part.mass = UIndirectList<scalar>(mass, indices);
    part.origProc = UIndirectList<label>(origProc, indices);
    part.origId = UIndirectList<label>(origId, indices);
    return part;
}


void Foam::particleState::append(const particleState& other)
{
    position.append(other.position);
    U.append(other.U);
    nParticle.append(other.nParticle);
    mass.append(other.mass);
    origProc.append(other.origProc);
    origId.append(other.origId);
}


void Foam::particleState::swap(particleState& other)
{
    position.swap(other.position);
    U.swap(other.U);
    nParticle.swap(other.nParticle);
    mass.swap(other.mass);
    origProc.swap(other.origProc);
    origId.swap(other.origId);
}


// * * * * * * * * * * * * * * * IOstream Operators  * * * * * * * * * * * * //

Foam::Istream& Foam::operator>>(Istream& is, particleState& state)
{
    is  >> state.position >> state.U >> state.nParticle >> state.mass
        >> state.origProc >> state.origId;

    is.check(FUNCTION_NAME);
    return is;
}


Foam::Ostream& Foam::operator<<(Ostream& os, const particleState& state)
{
    os  << state.position << state.U << state.nParticle << state.mass
        << state.origProc << state.origId;

    os.check(FUNCTION_NAME);
    return os;
}


// ************************************************************************* //
