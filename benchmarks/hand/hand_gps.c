/* p + R l and its Jacobian: identity toward p, -R [l]x toward the attitude, by row. */
#include "hand_rotation.h"

void hand_gps(const double p[restrict], const double q[restrict], const double l[restrict],
              double value[restrict], double nz[restrict]);
void hand_gps(const double p[restrict], const double q[restrict], const double l[restrict],
              double value[restrict], double nz[restrict])
{
    HAND_ROTATION(q);
    const double lx = l[0], ly = l[1], lz = l[2];

    value[0] = p[0] + r00 * lx + r01 * ly + r02 * lz;
    value[1] = p[1] + r10 * lx + r11 * ly + r12 * lz;
    value[2] = p[2] + r20 * lx + r21 * ly + r22 * lz;
    nz[0] = 1.0;
    nz[1] = r02 * ly - r01 * lz;
    nz[2] = r00 * lz - r02 * lx;
    nz[3] = r01 * lx - r00 * ly;
    nz[4] = 1.0;
    nz[5] = r12 * ly - r11 * lz;
    nz[6] = r10 * lz - r12 * lx;
    nz[7] = r11 * lx - r10 * ly;
    nz[8] = 1.0;
    nz[9] = r22 * ly - r21 * lz;
    nz[10] = r20 * lz - r22 * lx;
    nz[11] = r21 * lx - r20 * ly;
}
