/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Values of entries, see knownEntries.H.

\*---------------------------------------------------------------------------*/

#include "knownEntries.H"
#include "StringStream.H"
#include "Switch.H"

#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

typedef knownEntries::valueType valueType;

typedef knownEntries::rule rule;

// Bounds of numbers: no product of some of them overflows or vanishes
const scalar smallest = 1e-15;
const scalar largest = 1e6;


std::string text(const scalar x)
{
    // The precision of the case would print all digits
    char buffer[32];
    snprintf(buffer, sizeof(buffer), "%g", x);
    return buffer;
}


// The value as it stands in the file, or its beginning
std::string valueOf(const dictionary& dict, const word& key)
{
    const tokenList& tokens = dict.lookup(key);
    std::string result;
    for (const token& t : tokens)
    {
        if (result.size() > 60)
        {
            return result + " ...";
        }
        OStringStream os;
        os << t;
        const bool within = !(result.empty() || result.back() == '(' || os.str() == ")");
        result += (within ? " " : "") + (t.isScalar() ? text(t.number()) : std::string(os.str()));
    }
    return result;
}


// Does OpenFOAM read the value as one of this type?
template<class Type>
bool reads(const dictionary& dict, const word& key, Type& value)
{
    const bool throwing = FatalIOError.throwExceptions();
    bool good = true;
    try
    {
        value = dict.get<Type>(key);
    }
    catch (const IOerror&)
    {
        good = false;
    }
    FatalIOError.throwExceptions(throwing);
    return good;
}


template<class Type>
bool reads(const dictionary& dict, const word& key)
{
    Type value;
    return reads<Type>(dict, key, value);
}


// A label written as one: from v2112 on OpenFOAM rounds numbers with a point, and those out of bounds end the run
bool readsCount(const dictionary& dict, const word& key)
{
    const tokenList& tokens = dict.lookup(key);
    label n = 0;
    return tokens.size() && tokens[0].isLabel() && reads<label>(dict, key, n) && n > 0;
}


bool between(const dictionary& dict, const word& key, const scalar low, const scalar high)
{
    scalar x;
    return reads<scalar>(dict, key, x) && x >= low && x <= high;
}


bool mayBeDictionary(const rule& known)
{
    return
        known.type == valueType::DICTIONARY || known.type == valueType::ANY
     || known.type == valueType::WORD_OR_DICTIONARY
     || known.type == valueType::WORDS_OR_DICTIONARY;
}


// What a value may be
std::string allowed(const rule& known)
{
    const std::string million(text(largest));
    switch (known.type)
    {
        case valueType::WORD: return "one word";
        case valueType::WORDS: return "a list of words in parentheses";
        case valueType::FILE: return "a file name";
        case valueType::SWITCH: return "yes or no";
        case valueType::DICTIONARY: return "a dictionary";
        case valueType::WORD_OR_DICTIONARY: return "one word or a dictionary";
        case valueType::WORDS_OR_DICTIONARY:
            return "a list of words in parentheses, or a dictionary";
        case valueType::COUNT: return "a whole number from 1 to " + std::to_string(labelMax);
        case valueType::NUMBER: return "a number from -" + million + " to " + million;
        case valueType::POSITIVE:
            return "a positive number, from " + text(smallest) + " to " + million;
        case valueType::NOT_NEGATIVE: return "not negative, a number from 0 to " + million;
        case valueType::FRACTION: return "a number above 0 and below 1";
        case valueType::RANGE:
            return "a number from " + text(known.low) + " to " + text(known.high);
        case valueType::ANY: break;
    }
    return "a value";
}


// What follows in an error: the words, the meaning, how to write it
std::string help(const word& key, const rule& known)
{
    std::string result;
    if (known.words.size())
    {
        result += ". Valid: (";
        for (const word& valid : known.words)
        {
            result += (result.back() == '(' ? "" : " ") + valid;
        }
        result += ')';
    }
    if (known.meaning.size())
    {
        result += (known.words.size() ? ". " : ": ") + known.meaning;
    }
    std::string example(known.example);
    if (example.empty() && known.type == valueType::SWITCH)
    {
        example = "yes";
    }
    if (example.size())
    {
        result +=
            ". Write, for instance, " + key + ' ' + example + (example.back() == '}' ? "" : ";");
    }
    return result;
}


void refuse(const dictionary& dict, const word& key, const rule& known)
{
    const std::string value(dict.isDict(key) ? "{ ... }" : valueOf(dict, key));
    FatalIOErrorInEntry(dict, key)
        << key << ' ' << (value.empty() ? "has no value" : value.c_str())
        << " in " << dict.dictName() << (value.empty() ? ". It" : "") << " must be "
        << knownEntries::mustBe(key, known).c_str() << exit(FatalIOError);
}


// Read as a file name, OpenFOAM ends the run for a blank without naming the entry
void checkFile(const dictionary& dict, const word& key, const rule& known)
{
    const ITstream& is = dict.lookup(key);
    if (is.size() == 1 && is[0].isString())
    {
        const string path(is[0].stringToken());
        if (!string::valid<fileName>(path))
        {
            FatalIOErrorInEntry(dict, key)
                << key << ' ' << path << " holds a character that OpenFOAM does"
                << " not allow in a file name, such as a blank or a quote"
                << exit(FatalIOError);
        }
    }
    if (!reads<fileName>(dict, key))
    {
        refuse(dict, key, known);
    }
}


void checkWord(const dictionary& dict, const word& key, const rule& known)
{
    word value;
    if (!reads<word>(dict, key, value))
    {
        refuse(dict, key, known);
    }
    if (known.words.size() && !known.words.found(value))
    {
        FatalIOErrorInEntry(dict, key)
            << "Unknown " << key << ' ' << value << " in " << dict.dictName()
            << help(key, known).c_str() << exit(FatalIOError);
    }
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::string Foam::knownEntries::mustBe(const word& key, const rule& known)
{
    return allowed(known) + help(key, known);
}


void Foam::knownEntries::checkValue
(
    const dictionary& dict,
    const word& key,
    const rule& known
)
{
    if (!dict.found(key))
    {
        return;
    }
    if (dict.isDict(key))
    {
        if (!mayBeDictionary(known))
        {
            refuse(dict, key, known);
        }
        return;
    }

    bool good = true;
    switch (known.type)
    {
        case valueType::WORD:
        case valueType::WORD_OR_DICTIONARY: checkWord(dict, key, known); break;
        case valueType::WORDS:
        case valueType::WORDS_OR_DICTIONARY: good = reads<wordList>(dict, key); break;
        case valueType::FILE: checkFile(dict, key, known); break;
        case valueType::SWITCH: good = reads<Switch>(dict, key); break;
        case valueType::DICTIONARY: good = false; break;
        case valueType::ANY: break;

        case valueType::COUNT: good = readsCount(dict, key); break;
        case valueType::NUMBER: good = between(dict, key, -largest, largest); break;
        case valueType::POSITIVE: good = between(dict, key, smallest, largest); break;
        case valueType::NOT_NEGATIVE: good = between(dict, key, 0, largest); break;
        case valueType::RANGE: good = between(dict, key, known.low, known.high); break;
        case valueType::FRACTION:
        {
            scalar x;
            good = reads<scalar>(dict, key, x) && x > 0 && x < 1;
            break;
        }
    }
    if (!good)
    {
        refuse(dict, key, known);
    }
}


// ************************************************************************* //
