/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liggghtsCoupling.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "fluidKinds.H"
#include "fvMatrices.H"
#include "switchedOffCoupling.H"
#include "turbulenceModel.H"

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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fv::liggghtsCoupling::begin()
{
    fluid_ = carrierFluid::New(coeffs_, mesh_);
    fluid_->check();
    fluid_->checkViscosity();
    if (turbulence_)
    {
        turbulence_->check(coeffs_, *fluid_->model());
    }
    pipeline_.reset(new couplingPipeline(coeffs_, *fluid_, cloud_));
}


void Foam::fv::liggghtsCoupling::advance()
{
    if (timeIndex_ != mesh_.time().timeIndex())
    {
        checkSources();
        if (couplingEntries::twoWay(coeffs_))
        {
            momentumRelaxation_.warn();
            energyRelaxation_.warn();
        }
        timeIndex_ = mesh_.time().timeIndex();
        pipeline_->advance();
    }
}


void Foam::fv::liggghtsCoupling::checkSources() const
{
    const bool firstStep = (timeIndex_ == mesh_.time().startTimeIndex());
    for (label i = 1; i < applied_.size(); ++i)
    {
        if (firstStep || applied_[i])
        {
            continue;
        }
        const word& name = fieldNames_[i];
        couplingEntries::onMaster
        (
            [&]()
            {
                if (name == energy_ || name == continuity_)
                {
                    FatalIOErrorInFunction(coeffs_)
                        << "The solver has " << name << ", but has not asked for sources of its equation,"
                        << " so the gas would not get what grains give to it. Take rhoPimpleFoam or"
                        << " sonicFoam, or set coupling oneWay" << exit(FatalIOError);
                }
                else if (turbulence_ && turbulence_->fields().found(name))
                {
                    FatalIOErrorInEntry(coeffs_, "turbulenceSources")
                        << "turbulenceSources " << turbulence_->type() << ": the turbulence model "
                        << fluid_->model()->type() << " has not asked for the sources of "
                        << name << ", so they would have no effect. Set"
                        << " turbulenceSources to none, or change the model"
                        << exit(FatalIOError);
                }
            }
        );
    }
}


void Foam::fv::liggghtsCoupling::addTurbulence
(
    fvMatrix<scalar>& eqn,
    const label fieldi,
    const scalarField& coefficient
) const
{
    if (turbulence_ && turbulence_->fields().found(fieldNames_[fieldi]))
    {
        turbulence_->addSup
        (
            eqn, fieldNames_[fieldi], coefficient, pipeline_->momentum().responseTime()
        );
    }
    pipeline_->addTransportSup(eqn);
}


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
    turbulence_(grainTurbulence::New(coeffs_, mesh)),
    energy_
    (
        couplingEntries::twoWay(coeffs_) ? energyExchange::fieldName(mesh) : word::null
    ),
    continuity_
    (
        !energy_.empty() && voidFractionEquations::full(coeffs_) ? word("rho") : word::null
    ),
    cloud_(mesh),
    timeIndex_(mesh.time().timeIndex()),
    momentumRelaxation_("momentum", "imbalance"),
    energyRelaxation_("energy", "energyImbalance")
{
    fieldNames_ = wordList(1, coeffs_.lookupOrDefault<word>("U", "U"));
    if (turbulence_)
    {
        fieldNames_.append(turbulence_->fields());
    }
    if (!energy_.empty())
    {
        fieldNames_.append(energy_);
    }
    if (!continuity_.empty())
    {
        fieldNames_.append(continuity_);
        for (const word& name : compressibleVoidFraction::transported(mesh))
        {
            if (!fieldNames_.found(name))
            {
                fieldNames_.append(name);
            }
        }
    }
    applied_.setSize(fieldNames_.size(), false);
    fluidKinds::watch(mesh);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fv::liggghtsCoupling::addSup
(
    fvMatrix<vector>& eqn,
    const label fieldi
)
{
    if (!pipeline_)
    {
        begin();
    }
    fluid_->checkEquation(eqn);

    advance();
    momentumRelaxation_.note(eqn);
    pipeline_->addSup(eqn);
}


void Foam::fv::liggghtsCoupling::addSup
(
    fvMatrix<scalar>& eqn,
    const label fieldi
)
{
    // A solver may ask for these sources before those of its momentum equation
    if (!pipeline_)
    {
        begin();
    }
    if (fieldNames_[fieldi] == continuity_)
    {
        // The step of a solver for a gas begins with continuity
        advance();
        pipeline_->addContinuitySup(eqn);
        return;
    }
    const tmp<volScalarField> trho(fluid_->rho());
    addTurbulence
    (
        eqn, fieldi, pipeline_->momentum().dragCoefficient()/trho().primitiveField()
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


void Foam::fv::liggghtsCoupling::addSup
(
    const volScalarField& rho,
    fvMatrix<scalar>& eqn,
    const label fieldi
)
{
    if (fieldNames_[fieldi] == continuity_)
    {
        // The pressure equation, whose coefficient stands in the place of a density
        addSup(eqn, fieldi);
        return;
    }
    if (fieldNames_[fieldi] != energy_)
    {
        if (!pipeline_)
        {
            begin();
        }
        addTurbulence(eqn, fieldi, pipeline_->momentum().dragCoefficient());
        return;
    }
    if (!pipeline_ || timeIndex_ != mesh_.time().timeIndex())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(coeffs_)
                    << "The solver asks for sources of " << energy_ << " before those of its momentum"
                    << " equation. liggghtsCoupling needs a solver that begins a step with momentum, such as"
                    << " rhoPimpleFoam" << exit(FatalIOError);
            }
        );
    }
    energyRelaxation_.note(eqn);
    pipeline_->addEnergySup(eqn);
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
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(coeffs_, "U")
                    << "U " << fieldNames_[0] << ": the solver's momentum equation is for "
                    << fieldName << ", so the grains would never move. Set U to " << fieldName
                    << exit(FatalIOError);
            }
        );
    }
    return fieldi;
}


bool Foam::fv::liggghtsCoupling::read(const dictionary& dict)
{
    switchedOffCoupling::warnOfChange(*this, dict_, dict);
    return false;
}


// ************************************************************************* //
