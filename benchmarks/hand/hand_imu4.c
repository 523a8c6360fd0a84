/* R (v + a x v / 2 + sculling) / dt from four sub-samples, and its Jacobian, by row. */
#include "hand_rotation.h"

void hand_imu4(const double q[restrict], const double bg[restrict], const double ba[restrict],
               const double dth[restrict], const double dv[restrict], const double dt[restrict],
               double value[restrict], double nz[restrict]);
void hand_imu4(const double q[restrict], const double bg[restrict], const double ba[restrict],
               const double dth[restrict], const double dv[restrict], const double dt[restrict],
               double value[restrict], double nz[restrict])
{
    HAND_ROTATION(q);
    const double c1 = 54.0 / 105.0, c2 = 92.0 / 105.0, c3 = 214.0 / 105.0;
    const double t = dt[0], rate = 1.0 / t, part = 0.25 * t;
    const double gx = bg[0] * part, gy = bg[1] * part, gz = bg[2] * part;
    const double sx = ba[0] * part, sy = ba[1] * part, sz = ba[2] * part;
    /* Corrected last sub-sample, sums, and weighted sums of the first three. */
    const double ax4 = dth[9] - gx, ay4 = dth[10] - gy, az4 = dth[11] - gz;
    const double vx4 = dv[9] - sx, vy4 = dv[10] - sy, vz4 = dv[11] - sz;
    const double ax = 0.5 * (dth[0] + dth[3] + dth[6] + dth[9]) - 2.0 * gx;
    const double ay = 0.5 * (dth[1] + dth[4] + dth[7] + dth[10]) - 2.0 * gy;
    const double az = 0.5 * (dth[2] + dth[5] + dth[8] + dth[11]) - 2.0 * gz;
    const double vx = dv[0] + dv[3] + dv[6] + dv[9] - 4.0 * sx;
    const double vy = dv[1] + dv[4] + dv[7] + dv[10] - 4.0 * sy;
    const double vz = dv[2] + dv[5] + dv[8] + dv[11] - 4.0 * sz;
    const double total = c1 + c2 + c3;
    const double wax = c1 * dth[0] + c2 * dth[3] + c3 * dth[6] - total * gx;
    const double way = c1 * dth[1] + c2 * dth[4] + c3 * dth[7] - total * gy;
    const double waz = c1 * dth[2] + c2 * dth[5] + c3 * dth[8] - total * gz;
    const double wvx = c1 * dv[0] + c2 * dv[3] + c3 * dv[6] - total * sx;
    const double wvy = c1 * dv[1] + c2 * dv[4] + c3 * dv[7] - total * sy;
    const double wvz = c1 * dv[2] + c2 * dv[5] + c3 * dv[8] - total * sz;
    const double ux = vx + (ay * vz - az * vy) + (way * vz4 - waz * vy4) + (wvy * az4 - wvz * ay4);
    const double uy = vy + (az * vx - ax * vz) + (waz * vx4 - wax * vz4) + (wvz * ax4 - wvx * az4);
    const double uz = vz + (ax * vy - ay * vx) + (wax * vy4 - way * vx4) + (wvx * ay4 - wvy * ax4);
    const double fx = rate * ux, fy = rate * uy, fz = rate * uz;
    /* d u / d bg = dt [hx]x and d u / d ba = -dt (I + [k]x), from all three products. */
    const double quarter = 0.25 * total;
    const double hx = 0.5 * vx + quarter * vx4 - 0.25 * wvx;
    const double hy = 0.5 * vy + quarter * vy4 - 0.25 * wvy;
    const double hz = 0.5 * vz + quarter * vz4 - 0.25 * wvz;
    const double kx = ax + 0.25 * wax - quarter * ax4;
    const double ky = ay + 0.25 * way - quarter * ay4;
    const double kz = az + 0.25 * waz - quarter * az4;

#define ROW(i, a, b, c)                        \
    value[i] = (a) * fx + (b) * fy + (c) * fz; \
    nz[9 * (i)] = (c) * fy - (b) * fz;         \
    nz[9 * (i) + 1] = (a) * fz - (c) * fx;     \
    nz[9 * (i) + 2] = (b) * fx - (a) * fy;     \
    nz[9 * (i) + 3] = (b) * hz - (c) * hy;     \
    nz[9 * (i) + 4] = (c) * hx - (a) * hz;     \
    nz[9 * (i) + 5] = (a) * hy - (b) * hx;     \
    nz[9 * (i) + 6] = (c) * ky - (b) * kz - (a); \
    nz[9 * (i) + 7] = (a) * kz - (c) * kx - (b); \
    nz[9 * (i) + 8] = (b) * kx - (a) * ky - (c)

    ROW(0, r00, r01, r02);
    ROW(1, r10, r11, r12);
    ROW(2, r20, r21, r22);
}
