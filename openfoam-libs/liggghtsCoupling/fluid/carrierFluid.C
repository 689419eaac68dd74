/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carrierFluid.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "fluidKinds.H"
#include "fvcGrad.H"
#include "fvMatrices.H"
#include "gradScheme.H"
#include "surfaceFields.H"
#include "Time.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(carrierFluid, 0);
    defineRunTimeSelectionTable(carrierFluid, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// The entries of the fluid's own dictionary; the short form has none
Foam::dictionary coefficients(const Foam::dictionary& dict)
{
    if (dict.isDict("fluid"))
    {
        return dict.subDict("fluid");
    }
    Foam::dictionary none;
    none.name() = dict.name();
    return none;
}


// The kind of fluid that the entry says; empty without one
Foam::word kindOf(const Foam::dictionary& dict)
{
    return
        dict.isDict("fluid")
      ? dict.subDict("fluid").get<Foam::word>("model")
      : dict.lookupOrDefault<Foam::word>("fluid", Foam::word());
}


// Check the entries of a kind of fluid
void checkCoefficients(const Foam::dictionary& dict, const Foam::knownEntries::table& entries)
{
    Foam::knownEntries::table known(entries);
    known.insert("model", Foam::knownEntries::valueType::WORD);

    Foam::string longForm;
    if (!dict.isDict("fluid"))
    {
        longForm = "fluid { model " + kindOf(dict) + ";";
    }
    Foam::knownEntries::check(coefficients(dict), known, longForm);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

template<class FieldType>
void Foam::carrierFluid::checkField(const word& key, const dimensionSet& dimensions) const
{
    const word name(dict_.lookupOrDefault<word>(key, key));
    const FieldType* field = mesh_.cfindObject<FieldType>(name);

    couplingEntries::onMaster
    (
        [&]()
        {
            if (!field)
            {
                FatalIOErrorInEntry(dict_, key)
                    << key << ' ' << name << ": there is no " << FieldType::typeName
                    << " of this name. Those that the solver has are "
                    << flatOutput(mesh_.sortedNames<FieldType>()) << exit(FatalIOError);
            }
            if (field->dimensions() != dimensions)
            {
                FatalIOErrorInEntry(dict_, key)
                    << key << ' ' << name << ": the field has the dimensions "
                    << field->dimensions() << " instead of " << dimensions
                    << ", those of the kind of fluid " << type() << ". See the entry dimensions of "
                    << mesh_.time().timeName(mesh_.time().startTime().value())/name
                    << exit(FatalIOError);
            }
        }
    );
}

template void Foam::carrierFluid::checkField<Foam::volScalarField>
(
    const word&, const dimensionSet&
) const;
template void Foam::carrierFluid::checkField<Foam::volVectorField>
(
    const word&, const dimensionSet&
) const;


void Foam::carrierFluid::checkEquationIs
(
    const fvMatrix<vector>& eqn,
    const dimensionSet& dimensions,
    const char* what
) const
{
    if (eqn.dimensions() != dimensions)
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict_)
                    << "The momentum equation has the dimensions " << eqn.dimensions()
                    << ": the kind of fluid " << type() << " needs one of " << dimensions << ", " << what
                    << exit(FatalIOError);
            }
        );
    }
    if (mesh_.changing())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict_)
                    << "liggghtsCoupling needs a mesh that does not move or change. Set dynamicFvMesh to"
                    << " staticFvMesh in " << mesh_.time().constant() << "/dynamicMeshDict"
                    << exit(FatalIOError);
            }
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::carrierFluid::carrierFluid
(
    const dictionary& dict,
    const fvMesh& mesh,
    const knownEntries::table& entries
)
:
    g_(Zero),
    hasGravity_(false),
    previousStep_(0),
    subSteps_(1),
    intervalIndex_(0),
    mesh_(mesh),
    dict_(dict),
    coeffs_(coefficients(dict)),
    UName_(dict.lookupOrDefault<word>("U", "U")),
    pName_(dict.lookupOrDefault<word>("p", "p")),
    velocity_(nullptr),
    voidFraction_(nullptr),
    feltGradP_(nullptr),
    feltDivTau_(nullptr)
{
    if (dict.found("fluid") && !knownEntries::stated(typeName_(), kindOf(dict)))
    {
        couplingEntries::onMaster([&](){ checkCoefficients(dict, entries); });
    }
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::carrierFluid> Foam::carrierFluid::New
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    couplingEntries::onMaster([&](){ checkEntries(dict); });

    word kind(kindOf(dict));
    if (kind.empty())
    {
        kind = fluidKinds::find(dict, mesh);
    }
    else
    {
        fluidKinds::check(kind, dict, mesh);
    }
    return autoPtr<carrierFluid>((*dictionaryConstructorTablePtr_)[kind](dict, mesh));
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

void Foam::carrierFluid::checkEntries(const dictionary& dict)
{
    const knownEntries::rule kinds
    (
        knownEntries::rule
        (
            dictionaryConstructorTablePtr_->sortedToc(),
            knownEntries::REQUIRED
        ).means("A library with models of your own must stand in libs of system/controlDict")
    );
    if (dict.isDict("fluid"))
    {
        knownEntries::checkModel(dict.subDict("fluid"), kinds);
    }
    else if (dict.found("fluid"))
    {
        knownEntries::checkValue(dict, "fluid", kinds);
    }
    else
    {
        return;
    }

    const knownEntries::table* entries = knownEntries::stated(typeName_(), kindOf(dict));
    if (entries)
    {
        checkCoefficients(dict, *entries);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::turbulenceModel* Foam::carrierFluid::model() const
{
    return mesh_.cfindObject<turbulenceModel>(turbulenceModel::propertiesName);
}


Foam::scalar Foam::carrierFluid::previousStep() const
{
    return previousStep_ > 0 ? previousStep_ : mesh_.time().deltaTValue();
}


const Foam::surfaceScalarField& Foam::carrierFluid::phi() const
{
    return mesh_.lookupObject<surfaceScalarField>("phi");
}


Foam::tmp<Foam::volTensorField> Foam::carrierFluid::gradVelocity(const word& scheme) const
{
    const word name(scheme + '(' + UName_ + ')');
    if (!velocity_)
    {
        return fvc::grad(U(), name);
    }

    // A gradient that the solver keeps in its cache under this name is that of U
    return fv::gradScheme<vector>::New(mesh_, mesh_.gradScheme(name))().calcGrad
    (
        *velocity_,
        scheme + '(' + velocity_->name() + ')'
    );
}


void Foam::carrierFluid::checkViscosity() const
{
    if (!model())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict_)
                    << fluidKinds::solver().c_str() << " has no model of turbulence or of laminar flow ("
                    << turbulenceModel::propertiesName << "), from which grains take the viscosity."
                    << " Take a solver that has one, such as pimpleFoam or interFoam"
                    << exit(FatalIOError);
            }
        );
    }

    const tmp<volScalarField> tnu(nu());
    const scalar low = gMin(tnu().primitiveField());
    const scalar high = gMax(tnu().primitiveField());
    if (!(low >= smallest && high <= largest))
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict_)
                    << "nu, the viscosity of the fluid (" << mesh_.time().constant()
                    << "/transportProperties), is " << low << " to " << high
                    << " m2/s. Drag on grains needs one that is positive and within " << smallest
                    << " to " << largest << exit(FatalIOError);
            }
        );
    }
}


const Foam::volVectorField& Foam::carrierFluid::U() const
{
    return mesh_.lookupObject<volVectorField>(UName_);
}


const Foam::volScalarField& Foam::carrierFluid::p() const
{
    return mesh_.lookupObject<volScalarField>(pName_);
}


Foam::tmp<Foam::volScalarField> Foam::carrierFluid::nu() const
{
    return model()->nu();
}


Foam::tmp<Foam::volScalarField> Foam::carrierFluid::effectiveViscosity() const
{
    const tmp<volScalarField> tnuEff(model()->nuEff());
    const volScalarField* rho = equationRho();
    return
        rho
      ? tmp<volScalarField>::New('(' + rho->name() + "*nuEff)", *rho*tnuEff)
      : tmp<volScalarField>::New("nuEff", tnuEff);
}


Foam::tmp<Foam::volVectorField> Foam::carrierFluid::weight() const
{
    return rho()*dimensionedVector
    (
        "g", dimAcceleration, solverGravity() ? *solverGravity() : g()
    );
}


Foam::tmp<Foam::volVectorField> Foam::carrierFluid::gradP() const
{
    tmp<volVectorField> tgrad(fvc::grad(p()));
    if (pressure() == pressureUnit::PASCAL)
    {
        return tgrad;
    }
    const tmp<volScalarField> trho(rho());
    return trho*tgrad;
}


// ************************************************************************* //
