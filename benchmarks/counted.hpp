/* A number that counts its arithmetic: sums, products, quotients, signs and elementary functions.
   Everything the contestants include is included first, then `double` means this number. */
#pragma once

#include <cmath>
#include <complex>
#include <cstdbool>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#if __has_include(<Eigen/Core>)
#include <Eigen/Core>
#endif

class Counted {
public:
    static inline long operations = 0;

    Counted() = default;
    Counted(double value) : value_(value) {}

    double value() const { return value_; }

    friend Counted operator+(Counted a, Counted b) { return counted(a.value_ + b.value_); }
    friend Counted operator-(Counted a, Counted b) { return counted(a.value_ - b.value_); }
    friend Counted operator*(Counted a, Counted b) { return counted(a.value_ * b.value_); }
    friend Counted operator/(Counted a, Counted b) { return counted(a.value_ / b.value_); }
    friend Counted operator-(Counted a) { return counted(-a.value_); }
    friend Counted operator+(Counted a) { return a; }
    Counted &operator+=(Counted b) { return *this = *this + b; }
    Counted &operator-=(Counted b) { return *this = *this - b; }
    Counted &operator*=(Counted b) { return *this = *this * b; }
    Counted &operator/=(Counted b) { return *this = *this / b; }
    friend bool operator<(Counted a, Counted b) { return a.value_ < b.value_; }
    friend bool operator>(Counted a, Counted b) { return a.value_ > b.value_; }
    friend bool operator<=(Counted a, Counted b) { return a.value_ <= b.value_; }
    friend bool operator>=(Counted a, Counted b) { return a.value_ >= b.value_; }
    friend bool operator==(Counted a, Counted b) { return a.value_ == b.value_; }
    friend bool operator!=(Counted a, Counted b) { return a.value_ != b.value_; }

    static Counted counted(double value)
    {
        ++operations;
        return Counted(value);
    }

private:
    double value_;
};

inline Counted sqrt(Counted a) { return Counted::counted(std::sqrt(a.value())); }
inline Counted sin(Counted a) { return Counted::counted(std::sin(a.value())); }
inline Counted cos(Counted a) { return Counted::counted(std::cos(a.value())); }
/* One operation like the library's, in place of symnav's own arithmetic: what libraries do inside
   is not counted either. */
inline Counted sine_of(Counted a) { return sin(a); }
inline Counted cosine_of(Counted a) { return cos(a); }
inline Counted fabs(Counted a) { return Counted(std::fabs(a.value())); }
inline Counted pow(Counted a, Counted b)
{
    return Counted::counted(std::pow(a.value(), b.value()));
}

namespace std {
using ::cos;
using ::pow;
using ::sin;
using ::sqrt;
} // namespace std

#define double Counted
