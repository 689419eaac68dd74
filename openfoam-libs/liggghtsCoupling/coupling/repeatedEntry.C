/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "repeatedEntry.H"
#include "HashSet.H"
#include "IFstream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// Pass over the rest of an entry that is no dictionary
void skipValue(ISstream& is, token t)
{
    label depth = 0;
    while (is.good() && t.good())
    {
        if (t == token::BEGIN_LIST || t == token::BEGIN_BLOCK || t == token::BEGIN_SQR)
        {
            ++depth;
        }
        else if (t == token::END_LIST || t == token::END_BLOCK || t == token::END_SQR)
        {
            --depth;
        }
        else if (t == token::END_STATEMENT && depth == 0)
        {
            return;
        }
        is.read(t);
    }
}


// Search up to the end of the dictionary that begins here; `inside` means within the one that is asked
// for
word firstRepeated(ISstream& is, const word& name, const bool inside, label& line)
{
    HashSet<string> keys;
    token t;

    while (is.read(t).good() && t.good() && t != token::END_BLOCK)
    {
        if (!t.isStringType() && !t.isWord())
        {
            continue;
        }
        const string key(t.isWord() ? string(t.wordToken()) : t.stringToken());
        if (key[0] == '#')
        {
            // A directive and its argument. Conditions make two entries of which one counts
            if (key.substr(0, 3) == "#if")
            {
                return word();
            }
            is.read(t);
            continue;
        }
        if (!keys.insert(key) && (inside || key == name))
        {
            line = t.lineNumber();
            return word(key, false);
        }

        is.read(t);
        if (t == token::BEGIN_BLOCK)
        {
            const word found(firstRepeated(is, name, inside || key == name, line));
            if (!found.empty())
            {
                return found;
            }
        }
        else
        {
            skipValue(is, t);
        }
    }
    return word();
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::word Foam::firstRepeatedEntry
(
    const fileName& file,
    const word& name,
    label& line
)
{
    IFstream is(file);
    return firstRepeated(is, name, false, line);
}


// ************************************************************************* //
