/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The drag laws of liggghts-plugins/physics/drag/shaped_drag.h, with an entry sphericity.

\*---------------------------------------------------------------------------*/

#include "dragLaw.H"
#include "addToRunTimeSelectionTable.H"
#include "physics/drag/shaped_drag.h"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

//- A law of particles of a given sphericity
template<class Law>
class shapedDragLaw
:
    public dragLaw
{
    const Law law_;
    const label voidFraction_;
    const label rho_;
    const label nu_;

public:

    //- Runtime type information
    TypeName("shapedDragLaw");

    //- Within what the law was fitted to
    static knownEntries::table entries()
    {
        return knownEntries::table
        ({
            {
                "sphericity",
                knownEntries::rule(Law::LEAST, 1, knownEntries::REQUIRED)
               .means("surface of the sphere of equal volume over that of the particle")
               .like("0.8")
            }
        });
    }

    shapedDragLaw(const dictionary& dict, forceNeeds& needs)
    :
        dragLaw(dict),
        law_(dict.get<scalar>("sphericity")),
        voidFraction_(needs.quantity("voidFraction")),
        rho_(needs.quantity("rho")),
        nu_(needs.quantity("nu"))
    {}

    virtual void coefficient
    (
        const grainBatch& grains,
        const lane& slipSpeed,
        lane& coefficient
    ) const override
    {
        const lane& voidFraction = *grains.fluid(voidFraction_);
        const lane& rho = *grains.fluid(rho_);
        const lane& nu = *grains.fluid(nu_);
        for (label i = 0; i < grainBatch::size; ++i)
        {
            coefficient[i] = law_
            (
                grainjet::drag::State
                {
                    voidFraction[i], slipSpeed[i], grains.particleDiameter[i],
                    rho[i], nu[i]
                }
            );
        }
    }
};

} // End anonymous namespace

#define makeShapedDragLaw(Name)                                               \
    typedef shapedDragLaw<grainjet::drag::Name> Name##DragLaw;                \
    defineTemplateTypeNameAndDebugWithName(Name##DragLaw, #Name, 0);          \
    addToRunTimeSelectionTable(dragLaw, Name##DragLaw, dictionary);           \
    const knownEntries::ofModel Name##Entries                                 \
    (                                                                         \
        dragLaw::typeName_(), #Name, Name##DragLaw::entries()                 \
    );

makeShapedDragLaw(HaiderLevenspiel)
makeShapedDragLaw(Ganser)

} // End namespace Foam


// ************************************************************************* //
