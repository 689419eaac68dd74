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
    knownEntries::table known(entries);
    known.insert("model", knownEntries::valueType::WORD);

    string longForm;
    if (!dict.isDict("fluid"))
    {
        longForm = "fluid { model " + dict.lookupOrDefault<word>("fluid", "incompressible") + ";";
    }
    knownEntries::checkOnMaster(coeffs_, known, longForm);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::carrierFluid> Foam::carrierFluid::New
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    word kind;
    const auto read = [&]()
    {
        kind =
            dict.isDict("fluid")
          ? dict.subDict("fluid").get<word>("model")
          : dict.lookupOrDefault<word>("fluid", "incompressible");

        if (!dictionaryConstructorTablePtr_->found(kind))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown fluid " << kind << "\n\nValid fluids: "
                << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
                << exit(FatalIOError);
        }
    };
    couplingEntries::onMaster(read);
    read();

    return autoPtr<carrierFluid>((*dictionaryConstructorTablePtr_)[kind](dict, mesh));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::turbulenceModel* Foam::carrierFluid::model() const
{
    return mesh_.cfindObject<turbulenceModel>(turbulenceModel::propertiesName);
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
