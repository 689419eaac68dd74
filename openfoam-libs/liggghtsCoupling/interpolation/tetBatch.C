/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// g++ takes a comparison for something that may trap, and does one point after the other
#if defined(__GNUC__) && !defined(__clang__)
    #pragma GCC optimize("no-trapping-math")
#endif

#include "tetBatch.H"

// * * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * //

namespace
{

// a ^ b of point i
struct crossOf
{
    double x, y, z;

    crossOf(const Foam::tetBatch::vectors& a, const Foam::tetBatch::vectors& b, const int i)
    :
        x(a[1][i]*b[2][i] - a[2][i]*b[1][i]),
        y(a[2][i]*b[0][i] - a[0][i]*b[2][i]),
        z(a[0][i]*b[1][i] - a[1][i]*b[0][i])
    {}

    // Product with a vector
    double operator&(const double (&v)[3]) const
    {
        return x*v[0] + y*v[1] + z*v[2];
    }
};

inline double smaller(const double a, const double b)
{
    return a < b ? a : b;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::tetBatch::weigh()
{
    for (int i = 0; i < size; ++i)
    {
        const crossOf between(b, d, i);
        const crossOf rb(r, b, i);
        const crossOf dr(d, r, i);
        const double ri[3] = {r[0][i], r[1][i], r[2][i]};
        const double qi[3] = {q[0][i], q[1][i], q[2][i]};
        const double side = between & ri;

        // On a triangle the other corner makes no tetrahedron
        const double beyond = (between & qi)*side;
        const double sameAsD =
            (other[0][i] == d[0][i]) & (other[1][i] == d[1][i]) & (other[2][i] == d[2][i]);
        const bool far = (beyond < 0) & (sameAsD == 0);

        const double ci[3] =
        {
            far ? other[0][i] : qi[0],
            far ? other[1][i] : qi[1],
            far ? other[2][i] : qi[2]
        };
        const double inverse = 1/(between & ci);
        const double wb = -(dr & ci)*inverse;
        const double wd = -(rb & ci)*inverse;
        const double wq = side*inverse;
        const double w0 = 1 - wb - wd - wq;

        weights[0][i] = w0;
        weights[1][i] = wb;
        weights[2][i] = wd;
        weights[3][i] = wq;
        isOther[i] = far ? 1 : 0;
        least[i] = smaller(smaller(wb, wd), smaller(wq, w0));
    }
}


// ************************************************************************* //
