/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ownedGrains.H"
#include "clockTime.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// An impulse on its way to the owner of the grain
struct impulseParcel
{
    label number;
    label present;
    label removed;
    vector impulse;

    static constexpr scalar work = 0;
    static constexpr scalar heat = 0;

    void setEnergy(const scalar, const scalar)
    {}
};


// The same with the work
struct workParcel
{
    label number;
    label present;
    label removed;
    vector impulse;
    scalar work;

    static constexpr scalar heat = 0;

    void setEnergy(const scalar done, const scalar)
    {
        work = done;
    }
};


// The same with the heat
struct heatParcel
{
    label number;
    label present;
    label removed;
    vector impulse;
    scalar work;
    scalar heat;

    void setEnergy(const scalar done, const scalar given)
    {
        work = done;
        heat = given;
    }
};

template<> struct is_contiguous<impulseParcel> : std::true_type {};
template<> struct is_contiguous<workParcel> : std::true_type {};
template<> struct is_contiguous<heatParcel> : std::true_type {};

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Left>
Foam::ownedGrains::received Foam::ownedGrains::receiveImpulse
(
    DynamicList<vector>& impulse,
    DynamicList<scalar>& work,
    DynamicList<scalar>& heat,
    const Left& left
)
{
    const liggghtsSession::requests& requested = session_.requested();
    return
        requested.work && requested.heat
      ? receiveParcels<heatParcel>(impulse, work, heat, left)
      : requested.work
      ? receiveParcels<workParcel>(impulse, work, heat, left)
      : receiveParcels<impulseParcel>(impulse, work, heat, left);
}


template<class Parcel, class Left>
Foam::ownedGrains::received Foam::ownedGrains::receiveParcels
(
    DynamicList<vector>& impulse,
    DynamicList<scalar>& work,
    DynamicList<scalar>& heat,
    const Left& left
)
{
    const label n = session_.grains().n;
    LAMMPS_NS::FluidForceExchange& removals = session_.fluidForce();
    const liggghtsSession::fluidArrays exchange = session_.fluidForces();
    const bool nonReacting = session_.requested().nonReacting;
    const liggghtsSession::heatArrays heats = session_.heats();
    const bool works = session_.requested().work;
    const bool heated = works && session_.requested().heat;
    const label me = Pstream::myProcNo();

    makeRoom(impulse, cells_.size());
    impulse.setSize(cells_.size(), Zero);
    work.clear();
    heat.clear();
    if (works)
    {
        makeRoom(work, cells_.size());
        work.setSize(cells_.size(), Zero);
    }
    if (heated)
    {
        makeRoom(heat, cells_.size());
        heat.setSize(cells_.size(), Zero);
    }
    received all;

    removed_.clear();
    const auto arrive = [&](const Parcel& p)
    {
        if (p.present)
        {
            if (p.removed)
            {
                removed_.append(p.number);
            }
            impulse[p.number] += p.impulse;
            if (works)
            {
                work[p.number] += p.work;
            }
            if (heated)
            {
                heat[p.number] += p.heat;
            }
        }
        else
        {
            left(previousCells_[p.number], p.impulse, p.work, p.heat);
        }
    };

    List<DynamicList<Parcel>> parcels(Pstream::nProcs());

    const auto book = [&]
    (
        const double* owner,
        const double* given,
        const scalar done,
        const scalar received,
        const bool removed
    )
    {
        const label rank = label(owner[LAMMPS_NS::OWNER_RANK]);
        Parcel parcel;
        parcel.number = label(owner[LAMMPS_NS::OWNER_NUMBER]);
        parcel.present = label(owner[LAMMPS_NS::OWNER_PRESENT]);
        parcel.removed = removed;
        parcel.impulse = vector(given[0], given[1], given[2]);
        parcel.setEnergy(done, received);
        all.reacting += parcel.impulse;
        all.work += done;
        all.heat += received;
        if (rank == me)
        {
            arrive(parcel);
        }
        else if (rank >= 0)
        {
            parcels[rank].append(parcel);
        }
    };
    const auto bookNonReacting = [&](const double* given)
    {
        all.nonReacting += vector(given[0], given[1], given[2]);
    };

    for (label atom = 0; atom < n; ++atom)
    {
        book
        (
            exchange.owner[atom], exchange.impulse[atom], works ? exchange.work[atom] : 0,
            heated ? heats.heat[atom] : 0, false
        );
        if (nonReacting)
        {
            bookNonReacting(exchange.nonReactingImpulse[atom]);
        }
    }
    leftBox_ = deleted_ = 0;
    for (label i = 0; i < removals.nRemoved; ++i)
    {
        const LAMMPS_NS::FluidForceExchange::Removed& grain = removals.removed[i];
        book(grain.owner, grain.impulse, grain.work, heated ? grain.heat : 0, true);
        bookNonReacting(grain.nonReactingImpulse);
        ++(grain.fate == LAMMPS_NS::FluidForceExchange::LEFT_BOX ? leftBox_ : deleted_);
    }
    removals.clearRemoved(&removals);

    const clockTime clock;
    impulseBytes_ += ownerRoute::exchange<Parcel>
    (
        parcels,
        [&](const label, const UList<Parcel>& incoming)
        {
            for (const Parcel& p : incoming)
            {
                arrive(p);
            }
        }
    );
    all.secondsWaited = clock.elapsedTime();
    return all;
}


// ************************************************************************* //
