/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The flux that the solver's pressure equation is about to have, see compressibleVoidFraction.H.

\*---------------------------------------------------------------------------*/

#include "compressibleVoidFraction.H"
#include "couplingEntries.H"
#include "fvcSurfaceIntegrate.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "fvMatrices.H"
#include "linear.H"
#include "releases.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::compressibleVoidFraction::gained(const label celli) const
{
    const scalar change = voidFraction_[celli] - voidFraction_.oldTime()[celli];
    return
        massSource_[celli]
      + (left_[celli] - startRho_[celli]*fluid_.mesh().V()[celli]*change)/dt_;
}


Foam::tmp<Foam::surfaceScalarField> Foam::compressibleVoidFraction::coming
(
    const volScalarField& p
) const
{
    // As these solvers call what their pressure equation is made of
    const fvMesh& mesh = fluid_.mesh();
    const auto* explicitFlux = mesh.cfindObject<surfaceScalarField>("phiHbyA");
    const auto* perPressure = mesh.cfindObject<surfaceScalarField>("phid");
    const auto* ofFaces = mesh.cfindObject<surfaceScalarField>("rhorAUf");
    const auto* ofCells = mesh.cfindObject<volScalarField>("rhorAtU");
    const word psiName(releases::ofThermo("psi"));
    const auto* psi = mesh.cfindObject<volScalarField>(psiName);
    if (!psi || (!ofFaces && !ofCells) || (!explicitFlux && !perPressure))
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalErrorInFunction
                    << "voidFraction { equations full; } (constant/fvOptions): the pressure equation of this"
                    << " solver is not made of the fields that rhoPimpleFoam and sonicFoam have for it: "
                    << psiName << ", phiHbyA or phid, and rhorAUf or rhorAtU. Take one of these solvers, or set"
                    << " equations neglected" << exit(FatalError);
            }
        );
    }
    const tmp<surfaceScalarField> tmobility
    (
        ofFaces ? tmp<surfaceScalarField>(*ofFaces) : linearInterpolate(*ofCells)
    );
    const tmp<surfaceScalarField> tef(faceVoidFraction());
    const word ofLaplacian
    (
        "laplacian(" + (ofFaces ? ofFaces->name() : ofCells->name()) + ',' + p.name() + ')'
    );
    const word ofConvection("div(phid," + p.name() + ')');

    volScalarField q("pressureOfGas", p);
    mesh.setFluxRequired(q.name());
    fvScalarMatrix eqn(-fvm::laplacian((tef()*tmobility())(), q, ofLaplacian));
    if (perPressure)
    {
        eqn += fvm::div((tef()*(*perPressure))(), q, ofConvection);
    }
    const scalarField& e = voidFraction_.primitiveField();
    const scalarField& V = mesh.V();
    const tmp<volScalarField> trho(fluid_.rho());
    const tmp<scalarField> tout
    (
        explicitFlux
      ? outflow((tef()*(*explicitFlux))())
      : tmp<scalarField>(new scalarField(V.size(), Zero))
    );
    scalarField& diag = eqn.diag();
    scalarField& source = eqn.source();
    forAll(diag, celli)
    {
        const scalar storage = e[celli]*(*psi)[celli]*V[celli]/dt_;
        diag[celli] += storage;
        source[celli] +=
            storage*p[celli] + gained(celli) - tout()[celli]
          - e[celli]*(trho()[celli] - startRho_[celli])*V[celli]/dt_;
    }
    eqn.solve(mesh.solver(p.name()));

    fvScalarMatrix solver(-fvm::laplacian(tmobility(), q, ofLaplacian));
    if (perPressure)
    {
        solver += fvm::div(*perPressure, q, ofConvection);
    }
    return
        explicitFlux
      ? *explicitFlux + solver.flux()
      : solver.flux();
}


// ************************************************************************* //
