/* pL + Rz(psi) (p + R l) and its Jacobian toward p, attitude, l, pL and psi, by row. */
#include <math.h>

#include "hand_rotation.h"

void hand_ekfcal(const double p[restrict], const double q[restrict], const double l[restrict],
                 const double pl[restrict], const double psi[restrict], double value[restrict],
                 double nz[restrict]);
void hand_ekfcal(const double p[restrict], const double q[restrict], const double l[restrict],
                 const double pl[restrict], const double psi[restrict], double value[restrict],
                 double nz[restrict])
{
    HAND_ROTATION(q);
    const double s = sin(psi[0]), c = cos(psi[0]);
    const double lx = l[0], ly = l[1], lz = l[2];
    /* Rz R: the arm's columns, and what the attitude's follow from. */
    const double m00 = c * r00 - s * r10, m01 = c * r01 - s * r11, m02 = c * r02 - s * r12;
    const double m10 = s * r00 + c * r10, m11 = s * r01 + c * r11, m12 = s * r02 + c * r12;
    const double gx = c * p[0] - s * p[1] + m00 * lx + m01 * ly + m02 * lz;
    const double gy = s * p[0] + c * p[1] + m10 * lx + m11 * ly + m12 * lz;

    value[0] = pl[0] + gx;
    value[1] = pl[1] + gy;
    value[2] = pl[2] + p[2] + r20 * lx + r21 * ly + r22 * lz;
    nz[0] = c;
    nz[1] = -s;
    nz[2] = m02 * ly - m01 * lz;
    nz[3] = m00 * lz - m02 * lx;
    nz[4] = m01 * lx - m00 * ly;
    nz[5] = m00;
    nz[6] = m01;
    nz[7] = m02;
    nz[8] = 1.0;
    nz[9] = -gy;
    nz[10] = s;
    nz[11] = c;
    nz[12] = m12 * ly - m11 * lz;
    nz[13] = m10 * lz - m12 * lx;
    nz[14] = m11 * lx - m10 * ly;
    nz[15] = m10;
    nz[16] = m11;
    nz[17] = m12;
    nz[18] = 1.0;
    nz[19] = gx;
    nz[20] = 1.0;
    nz[21] = r22 * ly - r21 * lz;
    nz[22] = r20 * lz - r22 * lx;
    nz[23] = r21 * lx - r20 * ly;
    nz[24] = r20;
    nz[25] = r21;
    nz[26] = r22;
    nz[27] = 1.0;
}
