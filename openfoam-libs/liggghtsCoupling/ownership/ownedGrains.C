/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ownedGrains.H"
#include "Pair.H"
#include "vectorField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::ownedGrains::pack(const fluidAction& action, scalar* values) const
{
    copy(action.velocity, values);
    values[3] = action.dragCoefficient;
    copy(action.force, values + 4);
    values += 7;
    if (session_.requested().nonReacting)
    {
        values[0] = action.nonReactingCoefficient;
        copy(action.nonReactingForce, values + 1);
        values += 4;
    }
    if (session_.requested().torque)
    {
        copy(action.spin, values);
        values[3] = action.spinCoefficient;
        copy(action.torque, values + 4);
        values += 7;
    }
    if (session_.requested().addedMass)
    {
        values[0] = action.addedMass;
        ++values;
    }
    if (session_.requested().heat)
    {
        values[0] = action.temperature;
        values[1] = action.heatTransferCoefficient;
    }
}


Foam::fluidAction Foam::ownedGrains::unpack(const scalar* values) const
{
    fluidAction action;
    action.velocity = vectorOf(values);
    action.dragCoefficient = values[3];
    action.force = vectorOf(values + 4);
    values += 7;
    if (session_.requested().nonReacting)
    {
        action.nonReactingCoefficient = values[0];
        action.nonReactingForce = vectorOf(values + 1);
        values += 4;
    }
    if (session_.requested().torque)
    {
        action.spin = vectorOf(values);
        action.spinCoefficient = values[3];
        action.torque = vectorOf(values + 4);
        values += 7;
    }
    if (session_.requested().addedMass)
    {
        action.addedMass = values[0];
        ++values;
    }
    if (session_.requested().heat)
    {
        action.temperature = values[0];
        action.heatTransferCoefficient = values[1];
    }
    return action;
}


// States have a few numbers: a loop, since moving memory would be a call
void Foam::ownedGrains::getAtomState(const label atom, scalar* values) const
{
    const auto& states = session_.requested().states;
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        const label n = states[i].initial.size();
        const double* from = exchange_.states[i] + n*atom;
        for (label k = 0; k < n; ++k)
        {
            *values++ = from[k];
        }
    }
}


void Foam::ownedGrains::setAtomState(const label atom, const scalar* values) const
{
    const auto& states = session_.requested().states;
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        const label n = states[i].initial.size();
        double* to = exchange_.states[i] + n*atom;
        for (label k = 0; k < n; ++k)
        {
            to[k] = *values++;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ownedGrains::ownedGrains
(
    const liggghtsSession& session,
    const cellLocator& locator
)
:
    session_(session),
    locator_(locator),
    route_(locator.mesh()),
    grains_(),
    exchange_(),
    heats_(),
    nState_(0),
    nExtras_(0),
    nAction_(0),
    leftBox_(0),
    deleted_(0),
    impulseBytes_(0)
{
    const liggghtsSession::requests& requested = session.requested();
    for (const liggghtsSession::requests::state& state : requested.states)
    {
        nState_ += state.initial.size();
    }
    nExtras_ =
        nState_ + (requested.spin ? 3 : 0) + (requested.needsTemperature() ? 2 : 0)
      + (requested.impulse ? 3 : 0);
    nAction_ =
        2 + 7 + (requested.nonReacting ? 4 : 0) + (requested.torque ? 7 : 0)
      + (requested.addedMass ? 1 : 0) + (requested.heat ? 2 : 0) + nState_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::ownedGrains::clearOwners()
{
    const label n = session_.grains().n;
    const liggghtsSession::fluidArrays exchange = session_.fluidForces();

    for (label atom = 0; atom < n; ++atom)
    {
        exchange.owner[atom][LAMMPS_NS::OWNER_RANK] = -1;
    }
}


void Foam::ownedGrains::restoreOwners
(
    const std::function<void(label, const UList<grainData>&)>& found,
    DynamicList<fluidCoefficients>& acted
)
{
    const liggghtsSession::grainArrays grains = session_.grains();
    const liggghtsSession::fluidArrays exchange = session_.fluidForces();
    const liggghtsSession::heatArrays heats = session_.heats();
    const bool heated = session_.requested().heat;

    // Cells are looked for at the positions at the beginning of the interval. Meanwhile both
    // positions of each grain, its impulse, its work and its heat are kept here
    List<Pair<vector>> positions(grains.n);
    vectorField impulses(grains.n);
    scalarField work(session_.requested().work ? grains.n : 0);
    scalarField heat(heated ? grains.n : 0);
    boolList owned(grains.n);
    forAll(positions, atom)
    {
        double* now = grains.position[atom];
        const double* start = exchange.startPosition[atom];
        const double* owner = exchange.owner[atom];
        positions[atom].first() = vectorOf(now);
        positions[atom].second() = vectorOf(start);
        impulses[atom] = vectorOf(exchange.impulse[atom]);
        if (!work.empty())
        {
            work[atom] = exchange.work[atom];
        }
        if (heated)
        {
            heat[atom] = heats.heat[atom];
        }
        owned[atom] =
            owner[LAMMPS_NS::OWNER_RANK] >= 0 && owner[LAMMPS_NS::OWNER_PRESENT] > 0;
        if (owned[atom])
        {
            std::copy_n(start, 3, now);
        }
    }

    clearOwners();
    locate(found);
    const auto ofAtom = [&](const label atom)
    {
        return fluidCoefficients
        {
            exchange_.dragCoefficient[atom],
            heated && heats_.heat[atom] != 0 ? heats_.heatTransferCoefficient[atom] : 0
        };
    };
    makeRoom(acted, size());
    acted.setSize(size());
    for (label g = 0; g < size(); ++g)
    {
        const source from = sources_[g];
        acted[g] = from.remote ? fluidCoefficients() : ofAtom(from.index);
    }
    route_.forward<fluidCoefficients>
    (
        [&](const label item){ return ofAtom(sentAtoms_[item]); },
        [&](const label g, const fluidCoefficients& found){ acted[g] = found; }
    );
    for (label g = 0; g < size(); ++g)
    {
        if (nState_)
        {
            List<scalar> state(nState_);
            getState(g, state.data());
            setState(g, state.cdata());
        }
        set(g, fluidAction());
    }
    send();

    forAll(positions, atom)
    {
        copy(positions[atom].first(), grains.position[atom]);
        copy(positions[atom].second(), exchange.startPosition[atom]);
        copy(impulses[atom], exchange.impulse[atom]);
        if (!work.empty())
        {
            exchange.work[atom] = work[atom];
        }
        if (heated)
        {
            heats.heat[atom] = heat[atom];
        }
        if (!owned[atom])
        {
            exchange.owner[atom][LAMMPS_NS::OWNER_RANK] = -1;
        }
    }
}


void Foam::ownedGrains::send()
{
    route_.back
    (
        nAction_,
        [&](const label g, scalar* values)
        {
            std::copy_n(&remoteActions_[nAction_*sources_[g].index], nAction_, values);
        },
        [&](const label item, const scalar* values)
        {
            const label atom = sentAtoms_[item];
            setAtom(atom, unpack(values + 2), label(values[0]), label(values[1]), true);
            setAtomState(atom, values + nAction_ - nState_);
        }
    );

    // A grain that has just left the mesh still gets the second half of its last kick: its
    // owner of the interval before will book that
    for (const label atom : outsideAtoms_)
    {
        const double* owner = exchange_.owner[atom];
        const label number = label(owner[LAMMPS_NS::OWNER_NUMBER]);
        const bool leaving =
            owner[LAMMPS_NS::OWNER_RANK] >= 0 && owner[LAMMPS_NS::OWNER_PRESENT] > 0;

        setAtom
        (
            atom,
            fluidAction(),
            leaving ? label(owner[LAMMPS_NS::OWNER_RANK]) : -1,
            leaving ? number : -1,
            false
        );
    }
}


// ************************************************************************* //
