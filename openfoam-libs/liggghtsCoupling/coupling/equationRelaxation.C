/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equationRelaxation.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::equationRelaxation::warn()
{
    if (factor_ < 1 && !warned_)
    {
        warned_ = true;
        WarningInFunction
            << "The last " << quantity_ << " equation of the time step is relaxed: factor " << factor_
            << " for " << name_ << " in relaxationFactors.equations of fvSolution. So the"
            << " solver does not satisfy it, and the fluid loses a part of the " << quantity_ << " that"
            << " grains give to it, which the column " << column_ << " cannot show. Set " << name_
            << " 1" << endl;
    }
}


// ************************************************************************* //
