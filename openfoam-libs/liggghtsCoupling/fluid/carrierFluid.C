/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carrierFluid.H"
#include "couplingEntries.H"
#include "fvcGrad.H"
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


// The kind of fluid
Foam::word kindOf(const Foam::dictionary& dict)
{
    return
        dict.isDict("fluid")
      ? dict.subDict("fluid").get<Foam::word>("model")
      : dict.lookupOrDefault<Foam::word>("fluid", "incompressible");
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
    if (!knownEntries::stated(typeName_(), kindOf(dict)))
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

    return autoPtr<carrierFluid>((*dictionaryConstructorTablePtr_)[kindOf(dict)](dict, mesh));
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
