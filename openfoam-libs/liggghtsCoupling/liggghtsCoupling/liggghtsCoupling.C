/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liggghtsCoupling.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingCase.H"
#include "couplingEntries.H"
#include "fvMatrices.H"
#include "noFloatTraps.H"
#include "switchedOffCoupling.H"
#include "zeroGradientFvPatchFields.H"

#include <malloc.h>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace fv
{
    defineTypeNameAndDebug(liggghtsCoupling, 0);

    // Switched off by the entry active, it must not need what a coupling needs, nor start LIGGGHTS
    template<>
    autoPtr<option> option::adddictionaryConstructorToTable<liggghtsCoupling>::New
    (
        const word& name,
        const word& modelType,
        const dictionary& dict,
        const fvMesh& mesh
    )
    {
        const dictionary checked
        (
            couplingEntries::checked(name, modelType, dict, mesh)
        );
        if (!checked.lookupOrDefault<Switch>("active", true))
        {
            return autoPtr<option>
            (
                new switchedOffCoupling(name, modelType, checked, mesh)
            );
        }
        return autoPtr<option>(new liggghtsCoupling(name, modelType, checked, mesh));
    }

    addToRunTimeSelectionTable(option, liggghtsCoupling, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// The case is checked before anything is made of it
const dictionary& checkedCase(const dictionary& dict, const fvMesh& mesh)
{
    couplingCase(dict, mesh).check();
    return dict;
}


grainjet::drag::BatchLaw selectDrag(const dictionary& dict)
{
    using grainjet::drag::NamedLaw;

    const word name(dict.lookupOrDefault<word>("drag", "Gidaspow"));
    const auto law = grainjet::drag::findBatchLaw(name, &NamedLaw::dictionary);

    if (!law)
    {
        FatalIOErrorInFunction(dict)
            << "Unknown drag " << name << "\n\nValid drag laws: "
            << grainjet::drag::lawNames(&NamedLaw::dictionary)
            << exit(FatalIOError);
    }
    return law;
}


// The default is a model, not a number, so it is stated in one place
dictionary voidFractionDict(const dictionary& dict)
{
    if (dict.found("voidFraction"))
    {
        return dict.subDict("voidFraction");
    }
    dictionary divided;
    divided.add("model", "divided");
    return divided;
}


// The fields that a fluid step makes and drops are larger than what the C library keeps, so that it
// gives their memory back to the kernel each time and has it zeroed and mapped anew: 10 ms a
// step on 50,000 cells. The next step needs the same memory again: keep it.
void keepMemory()
{
    const int large = 1 << 30;
    mallopt(M_MMAP_THRESHOLD, large);
    mallopt(M_TRIM_THRESHOLD, large);
}


IOobject coupledField(const word& name, const fvMesh& mesh)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::NO_READ,
        IOobject::AUTO_WRITE
    );
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fv::liggghtsCoupling::liggghtsCoupling
(
    const word& name,
    const word& modelType,
    const dictionary& dict,
    const fvMesh& mesh
)
:
    option(name, modelType, dict, mesh),
    script_(checkedCase(coeffs_, mesh).get<fileName>("script")),
    interval_(coeffs_.get<label>("couplingInterval")),
    twoWay_(readSwitch(coeffs_, "coupling", "twoWay", "oneWay")),
    setI_(readSwitch(coeffs_, "formulation", "SetI", "SetII")),
    drag_(selectDrag(coeffs_)),
    fluid_(coeffs_, mesh),
    locator_(mesh),
    boxes_(ownerRoute::meshBoxes(mesh)),
    voidFractionModel_
    (
        voidFractionModel::New(voidFractionDict(coeffs_), locator_)
    ),
    sampler_(fluidSampler::New(coeffs_, locator_)),
    former_(mesh),
    momentum_(grainMomentum::New(coeffs_, fluid_)),
    turbulence_(grainTurbulence::New(coeffs_, mesh)),
    shares_(locator_, boxes_),
    log_(mesh, twoWay_),
    checkedModel_(false),
    timeIndex_(mesh.time().timeIndex()),
    occupied_(mesh.nCells()),
    forceDensity_
    (
        IOobject("grainForceDensity", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimForce/dimVolume, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    bodyForce_(Zero),
    responseTime_(mesh.nCells(), Zero),
    voidFraction_
    (
        coupledField("voidFraction", mesh),
        mesh,
        dimensionedScalar("voidFraction", dimless, scalar(1)),
        zeroGradientFvPatchScalarField::typeName
    ),
    particleVelocity_
    (
        coupledField("particleVelocity", mesh),
        mesh,
        dimensionedVector(dimVelocity, Zero)
    ),
    dragCoefficient_
    (
        coupledField("dragCoefficient", mesh),
        mesh,
        dimensionedScalar(dimDensity/dimTime, Zero)
    ),
    particleMomentumSource_
    (
        coupledField("particleMomentumSource", mesh),
        mesh,
        dimensionedVector(dimForce/dimVolume, Zero)
    )
{
    fieldNames_ = wordList(1, fluid_.UName());
    if (twoWay_ && turbulence_)
    {
        fieldNames_.append(turbulence_->fields());
    }
    applied_.setSize(fieldNames_.size(), false);

    for
    (
        const word& force
      : coeffs_.lookupOrDefault<wordList>("forces", wordList())
    )
    {
        forces_.append(grainForce::New(force, coeffs_, fluid_));
    }

    // Most solvers make their model before their options
    if (fluid_.model())
    {
        checkModel();
    }

    keepMemory();

    // LIGGGHTS needs MPI also where the solver runs without
    UPstream::initNull();

    session_.reset
    (
        new liggghtsSession
        (
            mesh.time().globalPath(),
            coeffs_.lookupOrDefault<fileName>("log", "log.liggghts")
        )
    );
    {
        // LIGGGHTS may divide by zero on its way to an error of its own, or to the checks below
        const noFloatTraps quiet;
        session_->start(script_, former_.grains());
    }
    checkTimeStep();
    checkOverlap();
    checkGrains();
    setPeriod();

    setGravity();

    guests_.reset(new guestGrains(session_(), locator_, boxes_));
    if (former_.continues())
    {
        guests_->recall();
    }
    else
    {
        guests_->forget();
        guests_->locate([](const label, const UList<guestGrain>&){});
    }

    const scalar present = session_->counts().present;
    if (!former_.continues() && present > 0 && guests_->outside() == present)
    {
        FatalIOErrorInFunction(coeffs_)
            << "None of the " << present << " grains of " << script_
            << " lies in a cell of the mesh, whose bounds are " << mesh.bounds()
            << ". Check units (metres) and origin of script and mesh"
            << exit(FatalIOError);
    }

    cloud_.reset(new liggghtsCloud(mesh, session_()));

    restart_.reset
    (
        new couplingRestart(mesh, session_(), momentum_(), log_, former_)
    );

    Info<< "    LIGGGHTS: " << script_ << ", " << present
        << (former_.continues() ? " continued" : " new") << " grains, "
        << interval_ << " DEM steps of " << session_->timeStep()
        << " s per fluid step" << nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fv::liggghtsCoupling::addSup
(
    fvMatrix<vector>& eqn,
    const label fieldi
)
{
    if (eqn.dimensions() != dimVelocity/dimTime*dimVolume)
    {
        FatalIOErrorInFunction(coeffs_)
            << "The momentum equation has the dimensions " << eqn.dimensions()
            << ": " << typeName << " needs an incompressible solver, whose equation"
            << " is divided by density" << exit(FatalIOError);
    }
    if (mesh_.changing())
    {
        FatalIOErrorInFunction(coeffs_)
            << typeName << " needs a mesh that does not move or change"
            << exit(FatalIOError);
    }

    if (!checkedModel_)
    {
        checkModel();
    }

    if (timeIndex_ != mesh_.time().timeIndex())
    {
        checkSources();
        timeIndex_ = mesh_.time().timeIndex();
        advance();
    }

    if (twoWay_)
    {
        momentum_->addSup(eqn);
    }
}


void Foam::fv::liggghtsCoupling::addSup
(
    fvMatrix<scalar>& eqn,
    const label fieldi
)
{
    turbulence_->addSup
    (
        eqn,
        fieldNames_[fieldi],
        dragCoefficient_.primitiveField()/fluid_.rho(),
        responseTime_
    );
}


void Foam::fv::liggghtsCoupling::addSup
(
    const volScalarField& rho,
    fvMatrix<vector>& eqn,
    const label fieldi
)
{
    addSup(eqn, fieldi);
}


Foam::label Foam::fv::liggghtsCoupling::applyToField(const word& fieldName) const
{
    const label fieldi = option::applyToField(fieldName);
    const auto* field = mesh_.cfindObject<volVectorField>(fieldName);

    if
    (
        fieldi < 0 && !applied_[0] && field && field->dimensions() == dimVelocity
    )
    {
        FatalIOErrorInFunction(coeffs_)
            << "U " << fluid_.UName() << ": the solver's momentum equation is for "
            << fieldName << ", so the grains would never move. Set U to " << fieldName
            << exit(FatalIOError);
    }
    return fieldi;
}


bool Foam::fv::liggghtsCoupling::read(const dictionary& dict)
{
    switchedOffCoupling::warnOfChange(*this, dict_, dict);
    return false;
}


// ************************************************************************* //
