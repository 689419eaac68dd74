/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "roundJetCorrection.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::RASModels::roundJetCorrectionType>
Foam::RASModels::roundJetCorrectionNames
({
    { roundJetCorrectionType::none, "none" },
    { roundJetCorrectionType::Pope, "Pope" },
});


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField::Internal>
Foam::RASModels::vortexStretching(const volTensorField& gradU)
{
    // gradU_ij = dU_j/dx_i, so that its Hodge dual is half the curl up to a
    // sign that is squared away
    const volVectorField::Internal omega(2.0*(*skew(gradU.v())));

    return 0.25*(omega & (symm(gradU.v()) & omega));
}


Foam::label Foam::RASModels::limitStretching
(
    scalarField& C3chi,
    const scalar limit
)
{
    label limited = 0;

    for (scalar& value : C3chi)
    {
        if (mag(value) > limit)
        {
            value = value > 0 ? limit : -limit;
            ++limited;
        }
    }

    return returnReduce(limited, sumOp<label>());
}


// ************************************************************************* //
