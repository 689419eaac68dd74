/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "outletInflow.H"
#include "surfaceFields.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"

#include <sstream>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::outletInflow::check()
{
    if (warned_)
    {
        return;
    }
    const fvMesh& mesh = fluid_.mesh();
    const scalarField& V = mesh.V();
    const scalar dt = mesh.time().deltaTValue();
    const volVectorField& U = fluid_.U();
    tmp<volScalarField> trho;

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Ub = U.boundaryField()[patchi];
        if (!isA<zeroGradientFvPatchVectorField>(Ub) || isA<wallFvPatch>(Ub.patch()))
        {
            continue;
        }
        if (fluid_.compressible() && !trho.valid())
        {
            trho = fluid_.rho();
        }
        const scalarField& flux = fluid_.phi().boundaryField()[patchi];
        const labelUList& cells = Ub.patch().faceCells();
        scalar courant = 0, speed = 0;
        forAll(flux, facei)
        {
            const label celli = cells[facei];
            const scalar inflow = -flux[facei]/(trho.valid() ? trho()[celli] : 1);
            courant = max(courant, inflow*dt/V[celli]);
            speed = max(speed, inflow/Ub.patch().magSf()[facei]);
        }
        reduce(courant, maxOp<scalar>());
        reduce(speed, maxOp<scalar>());
        if (courant > most_)
        {
            warned_ = true;
            std::ostringstream figures;
            figures.precision(3);
            figures << speed << " m/s and a Courant number of " << courant;
            WarningInFunction
                << "The fluid comes in through the outlet " << Ub.patch().name() << ", at up to "
                << figures.str().c_str() << ". Since " << U.name() << " is zeroGradient there it brings the"
                << " velocity of the cell behind, which can grow without bound and end the run, with or"
                << " without grains. Set " << U.name() << " of " << Ub.patch().name() << " to inletOutlet with"
                << " inletValue uniform (0 0 0), or to pressureInletOutletVelocity, or put the outlet further"
                << " away" << endl;
            return;
        }
    }
}


// ************************************************************************* //
