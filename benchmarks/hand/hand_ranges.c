/* |p + C R l - s| + b of every satellite; each Jacobian column lies contiguous, 32 apart. */
#include <math.h>

#include "hand_rotation.h"

void hand_ranges(int n, const double p[restrict], const double q[restrict],
                 const double b[restrict], const double l[restrict], const double m[restrict],
                 const double sat[restrict], double value[restrict], double nz[restrict]);
void hand_ranges(int n, const double p[restrict], const double q[restrict],
                 const double b[restrict], const double l[restrict], const double m[restrict],
                 const double sat[restrict], double value[restrict], double nz[restrict])
{
    HAND_ROTATION(q);
    const double lx = l[0], ly = l[1], lz = l[2], clock = b[0];
    const double ux = r00 * lx + r01 * ly + r02 * lz;
    const double uy = r10 * lx + r11 * ly + r12 * lz;
    const double uz = r20 * lx + r21 * ly + r22 * lz;
    const double ax = p[0] + m[0] * ux + m[1] * uy + m[2] * uz;
    const double ay = p[1] + m[3] * ux + m[4] * uy + m[5] * uz;
    const double az = p[2] + m[6] * ux + m[7] * uy + m[8] * uz;
    /* -R [l]x, then C times it. */
    const double k00 = r02 * ly - r01 * lz, k01 = r00 * lz - r02 * lx, k02 = r01 * lx - r00 * ly;
    const double k10 = r12 * ly - r11 * lz, k11 = r10 * lz - r12 * lx, k12 = r11 * lx - r10 * ly;
    const double k20 = r22 * ly - r21 * lz, k21 = r20 * lz - r22 * lx, k22 = r21 * lx - r20 * ly;
    const double g00 = m[0] * k00 + m[1] * k10 + m[2] * k20;
    const double g01 = m[0] * k01 + m[1] * k11 + m[2] * k21;
    const double g02 = m[0] * k02 + m[1] * k12 + m[2] * k22;
    const double g10 = m[3] * k00 + m[4] * k10 + m[5] * k20;
    const double g11 = m[3] * k01 + m[4] * k11 + m[5] * k21;
    const double g12 = m[3] * k02 + m[4] * k12 + m[5] * k22;
    const double g20 = m[6] * k00 + m[7] * k10 + m[8] * k20;
    const double g21 = m[6] * k01 + m[7] * k11 + m[8] * k21;
    const double g22 = m[6] * k02 + m[7] * k12 + m[8] * k22;

#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
        const double dx = ax - sat[3 * i], dy = ay - sat[3 * i + 1], dz = az - sat[3 * i + 2];
        const double range = sqrt(dx * dx + dy * dy + dz * dz);
        const double inverse = 1.0 / range;
        const double ex = dx * inverse, ey = dy * inverse, ez = dz * inverse;

        value[i] = range + clock;
        nz[i] = ex;
        nz[32 + i] = ey;
        nz[64 + i] = ez;
        nz[96 + i] = ex * g00 + ey * g10 + ez * g20;
        nz[128 + i] = ex * g01 + ey * g11 + ez * g21;
        nz[160 + i] = ex * g02 + ey * g12 + ez * g22;
        nz[192 + i] = 1.0;
    }
}
