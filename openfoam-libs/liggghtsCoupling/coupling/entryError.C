/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "entryError.H"
#include "OSspecific.H"
#include "releases.H"

#include <cctype>
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// The file that a dictionary lies in; its name is that of the file, and of dictionaries within
Foam::fileName fileOf(const Foam::dictionary& dict)
{
    Foam::fileName name(dict.name());
    while (!name.empty() && !Foam::isFile(name, false))
    {
        const auto end = name.rfind(Foam::releases::inDictionary);
        name.resize(end == std::string::npos ? 0 : end);
    }
    return name;
}


bool isPartOfWord(const char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}


// Does the text hold a word, not only as a part of another one?
bool holds(const std::string& text, const std::string& word)
{
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    {
        const auto end = at + word.size();
        if
        (
            (at == 0 || !isPartOfWord(text[at - 1]))
         && (end == text.size() || !isPartOfWord(text[end]))
        )
        {
            return true;
        }
    }
    return false;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::label Foam::lineOfEntry(const dictionary& dict, const word& key)
{
    const entry* e = dict.findEntry(key);
    const label line = e ? e->startLineNumber() : -1;
    if (line < 1)
    {
        return -1;
    }

    // OpenFOAM has the line of the value, but not which file it is of: see that the key stands in it, or
    // not far above if the value begins in a line of its own
    const label above = (e->isDict() ? 2 : 1);
    std::ifstream file(fileOf(dict));
    std::string text;
    for (label number = 1; number <= line && std::getline(file, text); ++number)
    {
        if (number >= line - above && holds(text, e->keyword()))
        {
            return line;
        }
    }
    return -1;
}


Foam::OSstream& Foam::entryError
(
    const char* function,
    const char* source,
    const int sourceLine,
    const dictionary& dict,
    const word& key
)
{
    return FatalIOError
    (
        function, source, sourceLine, dict.name(), lineOfEntry(dict, key), -1
    );
}


// ************************************************************************* //
