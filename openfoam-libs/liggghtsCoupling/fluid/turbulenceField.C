/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "turbulenceField.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::turbulenceField::missing(const carrierFluid& fluid, const word& name)
{
    const turbulenceModel* model = fluid.model();
    if (!model)
    {
        return "the solver has no turbulence model. Take a solver that has one, such as pimpleFoam";
    }
    if (fluid.mesh().foundObject<volScalarField>(name))
    {
        return string();
    }
    const string file
    (
        " (" + fluid.mesh().time().constant() + '/' + turbulenceModel::propertiesName
      + "). Select there a model with " + name + ", such as kEpsilon"
    );
    return
        model->get<word>("simulationType") == "laminar"
      ? "the flow is laminar" + file
      : "the turbulence model " + model->type() + " has no field " + name + file;
}


void Foam::turbulenceField::require
(
    const carrierFluid& fluid,
    const word& name,
    const dictionary& dict,
    const word& key,
    const string& what,
    const string& otherwise
)
{
    const string reason(missing(fluid, name));
    couplingEntries::onMaster
    (
        [&]()
        {
            if (!reason.empty())
            {
                FatalIOErrorInEntry(dict, key)
                    << what.c_str() << " needs " << name << " of the fluid's turbulence, but "
                    << reason.c_str() << ", or set " << otherwise.c_str() << exit(FatalIOError);
            }
        }
    );
}


// ************************************************************************* //
