/* R (v + a x v / 2) / dt and its Jacobian toward attitude, gyro and accelerometer bias, by row. */
#include "hand_rotation.h"

void hand_imu1(const double q[restrict], const double bg[restrict], const double ba[restrict],
               const double dth[restrict], const double dv[restrict], const double dt[restrict],
               double value[restrict], double nz[restrict]);
void hand_imu1(const double q[restrict], const double bg[restrict], const double ba[restrict],
               const double dth[restrict], const double dv[restrict], const double dt[restrict],
               double value[restrict], double nz[restrict])
{
    HAND_ROTATION(q);
    const double t = dt[0], rate = 1.0 / t;
    /* Half the corrected angle; the velocity and the force it averages to. */
    const double ax = 0.5 * (dth[0] - bg[0] * t), ay = 0.5 * (dth[1] - bg[1] * t);
    const double az = 0.5 * (dth[2] - bg[2] * t);
    const double vx = dv[0] - ba[0] * t, vy = dv[1] - ba[1] * t, vz = dv[2] - ba[2] * t;
    const double fx = rate * (vx + (ay * vz - az * vy));
    const double fy = rate * (vy + (az * vx - ax * vz));
    const double fz = rate * (vz + (ax * vy - ay * vx));
    /* d u / d bg = [v]x / 2, d u / d ba = -(I + [a]x). */
    const double hx = 0.5 * vx, hy = 0.5 * vy, hz = 0.5 * vz;

#define ROW(i, a, b, c)                        \
    value[i] = (a) * fx + (b) * fy + (c) * fz; \
    nz[9 * (i)] = (c) * fy - (b) * fz;         \
    nz[9 * (i) + 1] = (a) * fz - (c) * fx;     \
    nz[9 * (i) + 2] = (b) * fx - (a) * fy;     \
    nz[9 * (i) + 3] = (b) * hz - (c) * hy;     \
    nz[9 * (i) + 4] = (c) * hx - (a) * hz;     \
    nz[9 * (i) + 5] = (a) * hy - (b) * hx;     \
    nz[9 * (i) + 6] = (c) * ay - (b) * az - (a); \
    nz[9 * (i) + 7] = (a) * az - (c) * ax - (b); \
    nz[9 * (i) + 8] = (b) * ax - (a) * ay - (c)

    ROW(0, r00, r01, r02);
    ROW(1, r10, r11, r12);
    ROW(2, r20, r21, r22);
}
