/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "jetKEpsilon.H"
#include "coefficientChecks.H"

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


template<class BasicTurbulenceModel>
Foam::IOdictionary
Foam::RASModels::jetKEpsilon<BasicTurbulenceModel>::properties
(
    const word& propertiesName,
    const volVectorField& U,
    const surfaceScalarField& alphaRhoPhi
)
{
    return IOdictionary
    (
        IOobject
        (
            IOobject::groupName(propertiesName, alphaRhoPhi.group()),
            U.time().constant(),
            U.db(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
}


template<class BasicTurbulenceModel>
const Foam::word&
Foam::RASModels::jetKEpsilon<BasicTurbulenceModel>::checked
(
    const word& propertiesName,
    const volVectorField& U,
    const surfaceScalarField& alphaRhoPhi
)
{
    const IOdictionary given(properties(propertiesName, U, alphaRhoPhi));

    const string fault(entriesFault(given, typeName));
    if (!fault.empty())
    {
        FatalIOErrorInFunction(given.subOrEmptyDict("RAS"))
            << fault.c_str() << exit(FatalIOError);
    }

    return propertiesName;
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

    const volScalarField::Internal T(this->k_()/this->epsilon_());
    volScalarField::Internal C3chi
    (
        CPope_*pow3(T)*vortexStretching(tgradU())
    );
    const label limited = limitStretching
    (
        C3chi.field(),
        this->C2_.value() - 1
    );

    if (debug)
    {
        Info<< typeName << ": C3 chi from " << gMin(C3chi.field()) << " to "
            << gMax(C3chi.field()) << ", limited in " << limited << " of "
            << returnReduce(C3chi.size(), sumOp<label>()) << " cells" << endl;
    }

    const volScalarField::Internal rate(C3chi/T);
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
        checked(propertiesName, U, alphaRhoPhi),
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
    // An edit must not end a run
    const IOdictionary given
    (
        properties
        (
            turbulenceModel::propertiesName,
            this->U_,
            this->alphaRhoPhi_
        )
    );
    const string fault(entriesFault(given, typeName));
    if (!fault.empty())
    {
        WarningInFunction
            << given.objectPath() << ": " << fault.c_str()
            << ". This run goes on with the coefficients that it has" << endl;

        return this->regIOobject::read();
    }

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
