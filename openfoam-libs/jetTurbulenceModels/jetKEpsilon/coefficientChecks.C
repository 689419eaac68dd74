/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coefficientChecks.H"
#include "roundJetCorrection.H"
#include "OStringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// All that is positive; then those of every model; then the rest
const wordHashSet numbers({"Cmu", "C1", "C2", "C3", "sigmak", "sigmaEps"});
const wordHashSet minima({"kMin", "epsilonMin", "omegaMin"});
const wordHashSet switches({"RASModel", "turbulence", "printCoeffs"});
const word correction("roundJetCorrection");


string unknownEntry
(
    const dictionary& dict,
    const word& keyword,
    const wordHashSet& valid
)
{
    OStringStream message;
    message
        << "Unknown entry " << keyword << " in " << dict.dictName()
        << ". Valid: " << flatOutput(valid.sortedToc());
    return message.str();
}


// What is wrong with the number of an entry: not one, or not within limits
string numberFault
(
    const entry& e,
    const scalar low,
    const scalar high,
    const string& range
)
{
    const ITstream& tokens = e.stream();
    const bool good =
    (
        tokens.size() && tokens.last().isNumber()
     && tokens.last().number() >= low && tokens.last().number() <= high
    );

    if (good)
    {
        return string();
    }

    OStringStream message;
    message << e.keyword();
    for (const token& t : tokens)
    {
        message << ' ' << t;
    }
    message << " must be a number " << range.c_str();
    return message.str();
}


string valueFault(const entry& e)
{
    const word& keyword = e.keyword();

    if (minima.found(keyword))
    {
        return numberFault(e, VSMALL, 1000, "above 0, at most 1000");
    }
    if (numbers.found(keyword))
    {
        return numberFault
        (
            e,
            keyword == "C3" ? 0 : keyword == "C2" ? 1 + SMALL : 0.001,
            1000,
            keyword == "C3" ? "from 0 to 1000"
          : keyword == "C2" ? "above 1 (turbulence has to decay), at most 1000"
          : "from 0.001 to 1000"
        );
    }
    if (keyword == correction)
    {
        const ITstream& tokens = e.stream();
        const bool known =
        (
            tokens.size() == 1 && tokens[0].isWord()
         && RASModels::roundJetCorrectionNames.found(tokens[0].wordToken())
        );
        if (!known)
        {
            OStringStream message;
            message << "Unknown " << correction;
            for (const token& t : tokens)
            {
                message << ' ' << t;
            }
            message
                << ". Valid: "
                << flatOutput(RASModels::roundJetCorrectionNames.sortedToc());
            return message.str();
        }
    }
    return string();
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::string Foam::RASModels::entriesFault
(
    const dictionary& properties,
    const word& model
)
{
    const word block(model + "Coeffs");
    const dictionary& ras = properties.subOrEmptyDict("RAS");

    // Without a dictionary of their own the coefficients may lie in RAS
    const bool apart = ras.found(block);
    if (apart && !ras.isDict(block))
    {
        return block + " in RAS must be a dictionary, " + block + " { }";
    }

    const wordHashSet ofBlock(numbers | wordHashSet({correction}));
    const wordHashSet ofRAS(switches | minima | wordHashSet({block}));

    for (const entry& e : ras)
    {
        const word& keyword = e.keyword();
        const bool coefficient = ofBlock.found(keyword) && !e.isDict();

        if (!coefficient && !ofRAS.found(keyword))
        {
            return
                unknownEntry(ras, keyword, ofRAS) + "; coefficients of "
              + model + " go to " + block;
        }
        if (coefficient && apart)
        {
            return
                keyword + " in RAS is not read where there is a dictionary "
              + block + ": move it there";
        }

        const string fault(e.isDict() ? string() : valueFault(e));
        if (!fault.empty())
        {
            return fault;
        }
    }

    for (const entry& e : ras.subOrEmptyDict(block))
    {
        const word& keyword = e.keyword();
        const string fault
        (
            ofBlock.found(keyword) && !e.isDict()
          ? valueFault(e)
          : unknownEntry(ras.subDict(block), keyword, ofBlock)
        );
        if (!fault.empty())
        {
            return fault;
        }
    }

    for (const entry& e : properties)
    {
        if (e.isDict() && e.keyword().find("Coef") != std::string::npos)
        {
            return
                "Dictionary " + e.keyword() + " is not read beside RAS: the"
                " coefficients go to RAS { " + block + " { } }";
        }
    }

    return string();
}


// ************************************************************************* //
