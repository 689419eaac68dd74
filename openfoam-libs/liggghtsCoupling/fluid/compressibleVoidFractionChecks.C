/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What the full equations of a gas need of the case, see compressibleVoidFraction.H.

\*---------------------------------------------------------------------------*/

#include "compressibleVoidFraction.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::compressibleVoidFraction::checkCase() const
{
    const fvMesh& mesh = fluid_.mesh();
    wordList fields(transported(mesh));
    fields.append(energyName_);
    fields.append("K");
    for (const word& field : fields)
    {
        checkConvection(fluid_, field);
    }

    couplingEntries::onMaster
    (
        [&]()
        {
            const dictionary schemes(mesh.schemesDict().subOrEmptyDict("ddtSchemes"));
            for (const entry& e : schemes)
            {
                const token first(e.isStream() && e.stream().size() ? e.stream()[0] : token());
                if (first.isWord() && first.wordToken() != "Euler" && first.wordToken() != "none")
                {
                    FatalIOErrorInEntry(schemes, e.keyword())
                        << "ddtSchemes: " << e.keyword() << ' ' << first.wordToken()
                        << ": with equations full in a gas mass, momentum and energy of the gas between the"
                        << " grains are those of the scheme Euler. Set Euler, or equations neglected"
                        << exit(FatalIOError);
                }
            }
            if (mesh.foundObject<volSymmTensorField>("R"))
            {
                FatalIOErrorInFunction(mesh.time().controlDict())
                    << "The turbulence model " << fluid_.model()->type() << " solves for the Reynolds stress R,"
                    << " which equations full in a gas do not support. Take a model of k and epsilon or omega,"
                    << " such as kEpsilon (constant/turbulenceProperties), or set equations neglected"
                    << exit(FatalIOError);
            }
        }
    );
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::compressibleVoidFraction::transported(const fvMesh& mesh)
{
    wordList fields;
    const auto* model = mesh.cfindObject<turbulenceModel>(turbulenceModel::propertiesName);
    if (!model)
    {
        return fields;
    }

    // A frozen model (RAS { turbulence off; }) solves for nothing
    for (const word& kind : {word("RAS"), word("LES")})
    {
        if (!model->subOrEmptyDict(kind).lookupOrDefault<Switch>("turbulence", true))
        {
            return fields;
        }
    }
    for
    (
        const word& name :
        {
            word("k"), word("epsilon"), word("omega"), word("nuTilda"), word("v2"), word("phit"),
            word("gammaInt"), word("ReThetat"), word("flm"), word("fmm")
        }
    )
    {
        if (mesh.foundObject<volScalarField>(name))
        {
            fields.append(name);
        }
    }
    return fields;
}


// ************************************************************************* //
