/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

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
    part.d = UIndirectList<scalar>(d, indices);
    part.rho = UIndirectList<scalar>(rho, indices);
    part.origProc = UIndirectList<label>(origProc, indices);
    part.origId = UIndirectList<label>(origId, indices);
    return part;
}


void Foam::particleState::append(const particleState& other)
{
    position.append(other.position);
    U.append(other.U);
    nParticle.append(other.nParticle);
    d.append(other.d);
    rho.append(other.rho);
    origProc.append(other.origProc);
    origId.append(other.origId);
}


void Foam::particleState::flyOn(const scalar deltaT, const boundBox& bounds)
{
    forAll(position, i)
    {
        const vector way(deltaT*U[i]);
        scalar fraction = 1;

        for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
        {
            const scalar d = way[cmpt];
            const scalar side =
                d > 0 ? bounds.max()[cmpt] : bounds.min()[cmpt];
            const scalar room = side - position[i][cmpt];

            if (mag(d) > mag(room))
            {
                fraction = min(fraction, max(room/d, scalar(0)));
            }
        }

        position[i] += fraction*way;
    }
}


// * * * * * * * * * * * * * * * IOstream Operators  * * * * * * * * * * * * //

Foam::Istream& Foam::operator>>(Istream& is, particleState& state)
{
    is  >> state.position >> state.U >> state.nParticle >> state.d
        >> state.rho >> state.origProc >> state.origId;

    is.check(FUNCTION_NAME);
    return is;
}


Foam::Ostream& Foam::operator<<(Ostream& os, const particleState& state)
{
    os  << state.position << state.U << state.nParticle << state.d
        << state.rho << state.origProc << state.origId;

    os.check(FUNCTION_NAME);
    return os;
}


// ************************************************************************* //
