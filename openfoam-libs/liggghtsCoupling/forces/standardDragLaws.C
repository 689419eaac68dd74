/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The drag laws of liggghts-plugins/physics/drag, which have no coefficients.

\*---------------------------------------------------------------------------*/

#include "dragLaw.H"
#include "addToRunTimeSelectionTable.H"
#include "physics/drag/drag_laws.h"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

//- A law that is a function of void fraction, slip, diameter, density and viscosity
template<grainjet::drag::Law law>
class standardDragLaw
:
    public dragLaw
{
    const label voidFraction_;
    const label rho_;
    const label nu_;

public:

    //- Runtime type information
    TypeName("standardDragLaw");

    standardDragLaw(const dictionary& dict, forceNeeds& needs)
    :
        dragLaw(dict),
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
            coefficient[i] = law
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

#define makeDragLaw(function, Name)                                           \
    typedef standardDragLaw<grainjet::drag::function> Name##DragLaw;          \
    defineTemplateTypeNameAndDebugWithName(Name##DragLaw, #Name, 0);          \
    addToRunTimeSelectionTable(dragLaw, Name##DragLaw, dictionary);           \
    const knownEntries::ofModel Name##Entries(dragLaw::typeName_(), #Name);

makeDragLaw(gidaspow, Gidaspow)
makeDragLaw(wenYu, WenYu)
makeDragLaw(ergun, Ergun)
makeDragLaw(schillerNaumann, SchillerNaumann)
makeDragLaw(stokes, Stokes)
makeDragLaw(diFelice, DiFelice)
makeDragLaw(kochHill, KochHill)
makeDragLaw(beetstra, Beetstra)

} // End namespace Foam


// ************************************************************************* //
