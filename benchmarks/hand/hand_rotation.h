/* Rotation matrix of a unit quaternion, shared by the hand-written models. */
#ifndef HAND_ROTATION_H
#define HAND_ROTATION_H

#define HAND_ROTATION(q)                                                                        \
    const double w = (q)[0], x = (q)[1], y = (q)[2], z = (q)[3];                                \
    const double x2 = x + x, y2 = y + y, z2 = z + z;                                            \
    const double xx = x * x2, yy = y * y2, zz = z * z2, xy = x * y2, xz = x * z2, yz = y * z2;  \
    const double wx = w * x2, wy = w * y2, wz = w * z2;                                         \
    const double r00 = 1.0 - (yy + zz), r01 = xy - wz, r02 = xz + wy;                           \
    const double r10 = xy + wz, r11 = 1.0 - (xx + zz), r12 = yz - wx;                           \
    const double r20 = xz - wy, r21 = yz + wx, r22 = 1.0 - (xx + yy)

#endif
