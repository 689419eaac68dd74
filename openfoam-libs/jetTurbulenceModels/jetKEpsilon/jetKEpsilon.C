/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "jetKEpsilon.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class BasicTurbulenceModel>
void Foam::RASModels::jetKEpsilon<BasicTurbulenceModel>::setDefault
(
    const dictionary& given,
    dimensionedScalar& coefficient,
    const scalar deflt
)
{
    if (!given.found(coefficient.name()))
    {
        coefficient.value() = deflt;
        this->coeffDict_.set(coefficient.name(), deflt);
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

template<class BasicTurbulenceModel>
Foam::tmp<Foam::fvScalarMatrix>
Foam::RASModels::jetKEpsilon<BasicTurbulenceModel>::epsilonSource() const
{
    if (roundJetCorrection_ == roundJetCorrectionType::none)
    {
        return kEpsilon<BasicTurbulenceModel>::epsilonSource();
    }

    tmp<volTensorField> tgradU = fvc::grad(this->U_);

    // chi epsilon/k = (k/epsilon)^2 times the stretching rate
    const volScalarField::Internal rate
    (
        CPope_*sqr(this->k_()/this->epsilon_())*vortexStretching(tgradU())
    );
    const alphaField& alpha = this->alpha_;
    const rhoField& rho = this->rho_;

    return
        kEpsilon<BasicTurbulenceModel>::epsilonSource()
      - fvm::SuSp(-(alpha()*rho()*rate), this->epsilon_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class BasicTurbulenceModel>
Foam::RASModels::jetKEpsilon<BasicTurbulenceModel>::jetKEpsilon
(
    const alphaField& alpha,
    const rhoField& rho,
    const volVectorField& U,
    const surfaceScalarField& alphaRhoPhi,
    const surfaceScalarField& phi,
    const transportModel& transport,
    const word& propertiesName,
    const word& type
)
:
    kEpsilon<BasicTurbulenceModel>
    (
        alpha,
        rho,
        U,
        alphaRhoPhi,
        phi,
        transport,
        propertiesName,
        type
    ),
    roundJetCorrection_
    (
        roundJetCorrectionNames.getOrDefault
        (
            "roundJetCorrection",
            this->coeffDict_,
            roundJetCorrectionType::none
        )
    ),
    CPope_("C3", dimless, 0.79)
{
    // The base class has put its own defaults where the user gave none
    const dictionary& given =
        this->RASDict_.optionalSubDict(type + "Coeffs");

    setDefault(given, this->C1_, 1.52);
    setDefault(given, this->C2_, 1.90);

    CPope_.readIfPresent(given);
    this->coeffDict_.set(CPope_.name(), CPope_.value());
    this->C3_.value() = 0;

    this->coeffDict_.set
    (
        "roundJetCorrection",
        roundJetCorrectionNames[roundJetCorrection_]
    );

    if (type == typeName)
    {
        this->printCoeffs(type);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class BasicTurbulenceModel>
bool Foam::RASModels::jetKEpsilon<BasicTurbulenceModel>::read()
{
    if (kEpsilon<BasicTurbulenceModel>::read())
    {
        roundJetCorrectionNames.readIfPresent
        (
            "roundJetCorrection",
            this->coeffDict(),
            roundJetCorrection_
        );
        CPope_.readIfPresent(this->coeffDict());
        this->C3_.value() = 0;

        return true;
    }

    return false;
}


// ************************************************************************* //
