/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ownedGrains.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type, class Rest>
Foam::List<Type> Foam::ownedGrains::heldFor
(
    const UList<Type>& former,
    const bitSet& out,
    const Rest& rest
)
{
    const label me = Pstream::myProcNo();
    const label nProcs = Pstream::nProcs();

    // LIGGGHTS may have moved grains: the rank that holds one asks its owner
    List<Type> ofAtom(grains_.n, Type(Zero));
    bitSet taken(former.size());
    List<DynamicList<label>> numbers(nProcs), atoms(nProcs);
    for (label atom = 0; atom < grains_.n; ++atom)
    {
        const double* owner = exchange_.owner[atom];
        const label rank = label(owner[LAMMPS_NS::OWNER_RANK]);
        const label number = label(owner[LAMMPS_NS::OWNER_NUMBER]);
        if (out.test(atom) || rank < 0 || !(owner[LAMMPS_NS::OWNER_PRESENT] > 0))
        {
            continue;
        }
        if (rank == me)
        {
            ofAtom[atom] = former[number];
            taken.set(number);
        }
        else
        {
            numbers[rank].append(number);
            atoms[rank].append(atom);
        }
    }

    labelList asked(nProcs);
    forAll(numbers, proci)
    {
        asked[proci] = numbers[proci].size();
    }
    List<DynamicList<Type>> answers(nProcs);
    impulseBytes_ += ownerRoute::exchange<label>
    (
        numbers,
        [&](const label proci, const UList<label>& incoming)
        {
            for (const label number : incoming)
            {
                answers[proci].append(former[number]);
                taken.set(number);
            }
        }
    );
    impulseBytes_ += ownerRoute::exchange<Type>
    (
        answers,
        asked,
        [&](const label proci, const UList<Type>& values)
        {
            forAll(values, k)
            {
                ofAtom[atoms[proci][k]] = values[k];
            }
        }
    );

    forAll(former, number)
    {
        if (!taken.test(number))
        {
            rest(previousCells_[number], former[number]);
        }
    }
    return ofAtom;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type, class Rest>
void Foam::ownedGrains::handOver
(
    const UList<Type>& former,
    DynamicList<Type>& present,
    const Rest& rest
)
{
    bitSet outside(grains_.n);
    for (const label atom : outsideAtoms_)
    {
        outside.set(atom);
    }
    const List<Type> ofAtom(heldFor(former, outside, rest));

    makeRoom(present, size());
    present.setSize(size(), Type(Zero));
    for (label g = 0; g < size(); ++g)
    {
        if (!sources_[g].remote)
        {
            present[g] = ofAtom[sources_[g].index];
        }
    }
    route_.forward<Type>
    (
        [&](const label item) -> Type { return ofAtom[sentAtoms_[item]]; },
        [&](const label g, const Type& value){ present[g] = value; }
    );
}


template<class Rest>
Foam::scalar Foam::ownedGrains::giveHeat(const UList<scalar>& former, const Rest& rest)
{
    scalar sum = 0;
    const scalarList heat(heldFor(former, bitSet(), rest));
    forAll(heat, atom)
    {
        heats_.temperature[atom] += heat[atom]/capacityOf(atom);
        sum += heat[atom];
    }
    route_.forward<scalar>
    (
        [&](const label item) -> scalar { return heats_.temperature[sentAtoms_[item]]; },
        [&](const label g, const scalar T)
        {
            remoteExtras_[nExtras_*sources_[g].index + (session_.requested().spin ? 3 : 0)] = T;
        }
    );
    return sum;
}


// ************************************************************************* //
