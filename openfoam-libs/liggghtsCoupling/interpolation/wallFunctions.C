/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallFunctions.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "nutLowReWallFunctionFvPatchScalarField.H"
#include "releases.H"
#include "turbulenceModel.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// nut on a patch, if it is a wall function that bridges a log layer; else null
const Foam::nutWallFunctionFvPatchScalarField* wallFunction
(
    const Foam::fvPatchScalarField& nut
)
{
    return
        Foam::isA<Foam::nutLowReWallFunctionFvPatchScalarField>(nut) ? nullptr
      : Foam::isA<Foam::nutWallFunctionFvPatchScalarField>(nut)
      ? &Foam::refCast<const Foam::nutWallFunctionFvPatchScalarField>(nut) : nullptr;
}


// By name: those of the atmosphere are in a library that need not be there
bool isRough(const Foam::word& type)
{
    for (const char* part : {"Rough", "Atm", "atm"})
    {
        if (type.find(part) != std::string::npos)
        {
            return true;
        }
    }
    return false;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallFunctions::find()
{
    const tmp<volScalarField> tnut(fluid_.model()->nut());
    const volScalarField& nut = tnut();
    wordList walls;

    for (const fvPatchScalarField& patchNut : nut.boundaryField())
    {
        const fvPatch& patch = patchNut.patch();
        if (!isA<wallFvPatch>(patch))
        {
            continue;
        }
        walls.append(patch.name() + " (" + patchNut.type() + ')');
        const nutWallFunctionFvPatchScalarField* function = wallFunction(patchNut);
        if (!function)
        {
            continue;
        }

        if (isRough(patchNut.type()))
        {
            couplingEntries::onMaster
            (
                [&]()
                {
                    FatalIOErrorInEntry(dict_, "wallLaw")
                        << "wallLaw knows the profile at smooth walls only, but " << nut.name()
                        << " on patch " << patch.name() << " is " << patchNut.type()
                        << ". Take a wall function for smooth walls there, such as nutkWallFunction,"
                        << " or remove wallLaw" << exit(FatalIOError);
                }
            );
        }
        const auto& constants = releases::wallConstants(*function);
        if (patches_.size() && (constants.kappa() != kappa_ || constants.E() != E_))
        {
            couplingEntries::onMaster
            (
                [&]()
                {
                    FatalIOErrorInEntry(dict_, "wallLaw")
                        << "wallLaw needs the same constants on all walls, but " << nut.name()
                        << " has kappa " << constants.kappa() << ", E " << constants.E()
                        << " on patch " << patch.name() << " and kappa " << kappa_ << ", E " << E_
                        << " on patch " << nut.mesh().boundary()[patches_[0]].name()
                        << ". Make them equal, or remove wallLaw" << exit(FatalIOError);
                }
            );
        }
        patches_.append(patch.index());
        kappa_ = constants.kappa();
        E_ = constants.E();
        Cmu_ = constants.Cmu();
        sublayerEdge_ = constants.yPlusLam();
    }

    if (patches_.empty())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(dict_, "wallLaw")
                    << "wallLaw yes, but no wall has a wall function for nut, so that there is no"
                    << " profile to rebuild. Walls, with their nut: " << flatOutput(walls)
                    << ".\n    If walls are resolved, remove wallLaw: interpolation cellPoint is right"
                    << " there. Else give nut a wall function, such as nutkWallFunction or"
                    << " nutUSpaldingWallFunction" << exit(FatalIOError);
            }
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallFunctions::wallFunctions(const dictionary& dict, const carrierFluid& fluid)
:
    fluid_(fluid),
    dict_(dict),
    kappa_(0),
    E_(0),
    Cmu_(0),
    sublayerEdge_(0)
{
    fluid_.checkViscosity();
    couplingEntries::onMaster([&](){ find(); });
    patches_.clear();
    find();

    for (const label patchi : patches_)
    {
        const polyPatch& patch = fluid_.mesh().boundaryMesh()[patchi];
        for (label facei = patch.start(); facei < patch.start() + patch.size(); ++facei)
        {
            faces_.append(facei);
        }
    }
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

bool Foam::wallFunctions::laminar(const carrierFluid& fluid)
{
    return fluid.model() && fluid.model()->get<word>("simulationType") == "laminar";
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::wallFunctions::names() const
{
    wordList result;
    for (const label patchi : patches_)
    {
        result.append(fluid_.mesh().boundary()[patchi].name());
    }
    return result;
}


Foam::List<Foam::wallFunctions::faceState> Foam::wallFunctions::states() const
{
    List<faceState> states(faces_.size());
    label n = 0;
    for (const label patchi : patches_)
    {
        const fvPatchVectorField& U = fluid_.U().boundaryField()[patchi];
        const vectorField gradient(U.snGrad());
        const vectorField normal(U.patch().nf());
        const scalarField nu(fluid_.model()->nu(patchi));
        const scalarField nuEff(fluid_.model()->nuEff(patchi));
        const scalarField& deltaCoeffs = U.patch().deltaCoeffs();

        forAll(U, i)
        {
            const vector tangential(gradient[i] - normal[i]*(normal[i] & gradient[i]));
            faceState& state = states[n++];
            state.velocity = U[i];
            state.frictionOverNu = std::sqrt(nuEff[i]*mag(tangential))/nu[i];
            if (nuEff[i] <= nu[i] && state.frictionOverNu > sublayerEdge_*deltaCoeffs[i])
            {
                state.frictionOverNu = 0;
            }
        }
    }
    return states;
}


// ************************************************************************* //
