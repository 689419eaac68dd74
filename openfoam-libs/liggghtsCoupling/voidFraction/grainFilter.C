/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFilter.H"
#include "coupledPolyPatch.H"
#include "couplingEntries.H"
#include "gaussLaplacianScheme.H"
#include "releases.H"
#include "surfaceFields.H"
#include "Switch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// Of sizes of the mesh, relative
constexpr scalar roundOff = 1e-6;


// Side of the smallest cell [m]; on meshes with empty sides within the plane or line that is solved
scalar smallestCell(const fvMesh& mesh)
{
    scalar depth = 1;
    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (mesh.solutionD()[k] < 0)
        {
            depth *= mesh.bounds().span()[k];
        }
    }
    return Foam::pow(gMin(mesh.V().field())/depth, 1.0/mesh.nSolutionD());
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::grainFilter::check(const dictionary& dict) const
{
    const scalar smallest = smallestCell(mesh_);
    const scalar largest = cmptMax(mesh_.bounds().span());
    bool rotates = false;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const coupledPolyPatch* coupled = isA<coupledPolyPatch>(patch);
        rotates = rotates || (coupled && !coupled->parallel());
    }
    reduce(rotates, orOp<bool>());

    couplingEntries::onMaster
    (
        [&]()
        {
            if (length_ < (1 - roundOff)*smallest)
            {
                FatalIOErrorInEntry(dict, "length")
                    << "length " << length_ << " m of the filter is smaller than the smallest cell, "
                    << smallest << " m, so it would change nothing. Give a length of some cells and"
                    << " grain diameters, or 0 for no filter" << exit(FatalIOError);
            }
            if (length_ > (1 + roundOff)*largest)
            {
                FatalIOErrorInEntry(dict, "length")
                    << "length " << length_ << " m of the filter is larger than the mesh, " << largest
                    << " m. Give a length in metres, of some grain diameters"
                    << exit(FatalIOError);
            }
            if (rotates)
            {
                FatalIOErrorInEntry(dict, "length")
                    << "The filter cannot pass periodic sides that rotate, as this mesh has. Set length"
                    << " 0" << exit(FatalIOError);
            }
        }
    );
}


void Foam::grainFilter::makeMatrix()
{
    const surfaceScalarField gammaMagSf
    (
        dimensionedScalar("gamma", dimArea, sqr(length_)/(4*nSteps))*mesh_.magSf()
    );
    matrix_.reset
    (
        fv::gaussLaplacianScheme<scalar, scalar>::fvmLaplacianUncorrected
        (
            gammaMagSf,
            mesh_.nonOrthDeltaCoeffs(),
            content_
        ).ptr()
    );
    fvScalarMatrix& m = *matrix_;
    m.negate();

    scalarField& diag = m.diag();
    diag += mesh_.V().field();
    forAll(m.internalCoeffs(), patchi)
    {
        const labelUList& faceCells = mesh_.boundary()[patchi].faceCells();
        forAll(faceCells, i)
        {
            diag[faceCells[i]] += m.internalCoeffs()[patchi][i];
        }
    }
}


const Foam::dictionary& Foam::grainFilter::solver() const
{
    static const dictionary own
    (
        IStringStream
        (
            "solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0; maxIter 1000;"
        )()
    );
    const dictionary* solvers = mesh_.solutionDict().findDict("solvers");
    const dictionary* users =
        solvers ? solvers->findDict(content_.name(), keyType::LITERAL) : nullptr;
    return users ? *users : own;
}


void Foam::grainFilter::flow(scalarField& amount, const scalar scale)
{
    const fvScalarMatrix& m = *matrix_;
    const scalarField& x = content_.primitiveField();
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    const scalarField& upper = m.upper();

    forAll(upper, facei)
    {
        const scalar flux =
            -scale*upper[facei]*(x[neighbour[facei]] - x[owner[facei]]);
        amount[owner[facei]] += flux;
        amount[neighbour[facei]] -= flux;
    }

    content_.correctBoundaryConditions();
    forAll(content_.boundaryField(), patchi)
    {
        const fvPatchScalarField& side = content_.boundaryField()[patchi];
        if (side.coupled())
        {
            const tmp<scalarField> tbeyond(side.patchNeighbourField());
            const scalarField& coeffs = m.internalCoeffs()[patchi];
            const labelUList& faceCells = side.patch().faceCells();
            forAll(faceCells, i)
            {
                const label celli = faceCells[i];
                amount[celli] += scale*coeffs[i]*(tbeyond()[i] - x[celli]);
            }
        }
    }
}


void Foam::grainFilter::spreadOne(scalarField& amount, const scalar scale)
{
    const fvScalarMatrix& m = *matrix_;
    scalarField& x = content_.primitiveFieldRef();
    const scalarField& V = mesh_.V();

    for (label step = 0; step < nSteps; ++step)
    {
        const scalarField source(amount/scale);
        x = source/V;
        lduMatrix::solver::New
        (
            content_.name(),
            m,
            m.boundaryCoeffs(),
            m.internalCoeffs(),
            content_.boundaryField().scalarInterfaces(),
            solver()
        )->solve(x, source);
        flow(amount, scale);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::grainFilter::grainFilter(const dictionary& dict, const fvMesh& mesh)
:
    mesh_(mesh),
    length_(dict.get<scalar>("length")),
    content_
    (
        IOobject
        (
            "grainFilter",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    )
{
    check(dict);
    makeMatrix();
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::grainFilter> Foam::grainFilter::New
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    return autoPtr<grainFilter>
    (
        length(dict) > 0 ? new grainFilter(dict.subDict("filter"), mesh) : nullptr
    );
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::grainFilter::length(const dictionary& dict)
{
    return dict.subOrEmptyDict("filter").lookupOrDefault<scalar>("length", 0);
}


void Foam::grainFilter::checkEntries(const dictionary& dict)
{
    if (!dict.isDict("filter"))
    {
        return;
    }
    knownEntries::check
    (
        dict.subDict("filter"),
        {
            {
                "length",
                knownEntries::rule
                (
                    knownEntries::valueType::NOT_NEGATIVE, knownEntries::REQUIRED
                )
               .means("m, over which the grains' volume and forces are spread; 0 for no filter")
               .like("0")
            }
        }
    );
}


void Foam::grainFilter::checkCoupling(const dictionary& dict)
{
    if
    (
        length(dict.subOrEmptyDict("voidFraction")) > 0
     && dict.lookupOrDefault<Switch>("selfDisturbance", false)
    )
    {
        FatalIOErrorInEntry(dict, "selfDisturbance")
            << "selfDisturbance yes and a filter in voidFraction: it corrects for the force of a grain"
            << " in its own cells, while the filter spreads that force over its length. Remove"
            << " selfDisturbance, or set length 0" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::grainFilter::spread(UList<scalarField>& amounts)
{
    // Linear solvers compare with a number that is no small one of small amounts
    scalarList scales(amounts.size() + 1);
    forAll(amounts, i)
    {
        scales[i] = sumMag(amounts[i]);
    }
    scales.last() = sum(mesh_.V().field());
    Pstream::listCombineGather(scales, plusEqOp<scalar>());
    releases::fromMaster(scales);

    bool any = false;
    forAll(amounts, i)
    {
        if (scales[i] > 0)
        {
            spreadOne(amounts[i], scales[i]/scales.last());
            any = true;
        }
    }
    return any;
}


// ************************************************************************* //
