/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sessionWarnings.H"
#include "sessionError.H"
#include "List.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "stringList.H"

#include <cctype>
#include <cstdlib>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

std::map<std::string, Foam::sessionWarnings::warning> Foam::sessionWarnings::warnings_;


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::sessionWarnings::key
(
    const std::string& text,
    const std::string& source
)
{
    const auto isDigit = [](const char c) { return std::isdigit(static_cast<unsigned char>(c)); };
    const auto isWord = [](const char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)); };

    // A digit within a word, as in an ID, is no number
    std::string result(source + ' ');
    for (std::size_t i = 0; i < text.size();)
    {
        if (isDigit(text[i]) && (i == 0 || !isWord(text[i - 1])))
        {
            char* end = nullptr;
            std::strtod(text.c_str() + i, &end);
            i = end - text.c_str();
            result += '#';
        }
        else
        {
            result += text[i++];
        }
    }
    return result;
}


void Foam::sessionWarnings::print(warning& w, const int rank)
{
    w.printed = true;
    Warning
        << "LIGGGHTS" << (rank ? " on rank " + std::to_string(rank) : std::string()).c_str()
        << ": " << w.text.c_str() << w.place.c_str()
        << "\n    source " << w.source.c_str() << ", log of LIGGGHTS "
        << sessionPlace::log.c_str()
        << ". This is said once; how often it came is said at the end of the run" << nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sessionWarnings::add
(
    const std::string& text,
    const std::string& source,
    const std::string& place
)
{
    warning& w = warnings_[key(text, source)];
    if (!w.count++)
    {
        w.source = source;
        w.place = place;
    }
    w.text = text;
    if (Pstream::master() && !w.printed)
    {
        print(w, 0);
    }
}


void Foam::sessionWarnings::gather()
{
    // Of each one: key, text, source
    List<stringList> all(Pstream::nProcs());
    stringList& mine = all[Pstream::myProcNo()];
    for (auto& item : warnings_)
    {
        if (!item.second.printed)
        {
            item.second.printed = true;
            mine.append(item.first);
            mine.append(item.second.text);
            mine.append(item.second.source);
        }
    }
    if (!returnReduce(mine.size(), sumOp<label>()))
    {
        return;
    }

    Pstream::gatherList(all);
    if (Pstream::master())
    {
        forAll(all, rank)
        {
            for (label i = 0; i < all[rank].size(); i += 3)
            {
                warning& w = warnings_[all[rank][i]];
                if (!w.printed)
                {
                    w.text = all[rank][i + 1];
                    w.source = all[rank][i + 2];
                    print(w, rank);
                }
            }
        }
    }
}


bool Foam::sessionWarnings::anyWaiting()
{
    for (const auto& item : warnings_)
    {
        if (!item.second.printed)
        {
            return true;
        }
    }
    return false;
}


std::string Foam::sessionWarnings::waiting()
{
    std::string lines;
    for (const auto& item : warnings_)
    {
        if (!item.second.printed)
        {
            lines += "\n    LIGGGHTS had warned on this rank: " + item.second.text;
        }
    }
    return lines;
}


void Foam::sessionWarnings::summarise()
{
    // Of each one: key, text, source, count
    List<stringList> all(Pstream::nProcs());
    stringList& mine = all[Pstream::myProcNo()];
    for (const auto& item : warnings_)
    {
        mine.append(item.first);
        mine.append(item.second.text);
        mine.append(item.second.source);
        mine.append(std::to_string(item.second.count));
    }
    warnings_.clear();
    if (!returnReduce(mine.size(), sumOp<label>()))
    {
        return;
    }

    Pstream::gatherList(all);
    if (Pstream::master())
    {
        std::map<std::string, warning> sums;
        for (const stringList& list : all)
        {
            for (label i = 0; i < list.size(); i += 4)
            {
                warning& w = sums[list[i]];
                const std::int64_t count = std::stoll(list[i + 3]);
                // A rank that has only printed for another one knows its words, not a count
                if (count || w.text.empty())
                {
                    w.text = list[i + 1];
                    w.source = list[i + 2];
                }
                w.count += count;
            }
        }

        Info<< nl << "Warnings of LIGGGHTS, with the latest words of each:" << nl;
        for (const auto& item : sums)
        {
            const warning& w = item.second;
            Info<< "    " << std::to_string(w.count).c_str()
                << (w.count == 1 ? " time: " : " times: ") << w.text.c_str()
                << " (" << w.source.c_str() << ')' << nl;
        }
        Info<< endl;
    }
}


// ************************************************************************* //
