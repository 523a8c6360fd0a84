/* How much of a core is ours: a virtual processor is often one of two threads that share one. */
#ifndef ROOM_H
#define ROOM_H

#include <stdint.h>
#include <time.h>

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * (double)t.tv_sec + (double)t.tv_nsec;
}

/* Nanoseconds of a cycle: a fourth of a product and an OR that wait for the ones before. */
static double cycle(uintptr_t *link)
{
    enum { LINKS = 2000 };
    const double start = now();

    for (int k = 0; k < LINKS; ++k) {
        *link *= *link | 2U;
        __asm__ volatile("" : "+r"(*link));
    }
    return (now() - start) / (4.0 * LINKS);
}

/* A compiler may not join sums across this, or leave them out. */
#define ASIDE                                \
    __asm__ volatile("" : "+r"(a), "+r"(b)); \
    __asm__ volatile("" : "+r"(c), "+r"(d)); \
    __asm__ volatile("" : "+r"(e), "+r"(f)); \
    __asm__ volatile("" : "+r"(g), "+r"(h))

/* Independent additions in a cycle. What the other thread does stretches the additions, the clock
   the cycle as well. Of two cycles the shorter counts: one that was interrupted would say that
   there was room which there was not. */
static double room(void)
{
    enum { ROUNDS = 4000, SUMS = 32 };
    uintptr_t link = (uintptr_t)now() | 3U;
    const double before = cycle(&link);
    uintptr_t a = link, b = link, c = link, d = link, e = link, f = link, g = link, h = link;
    const double start = now();

    for (int k = 0; k < ROUNDS; ++k) {
        a += link, b += link, c += link, d += link, e += link, f += link, g += link, h += link;
        ASIDE;
        a += link, b += link, c += link, d += link, e += link, f += link, g += link, h += link;
        ASIDE;
        a += link, b += link, c += link, d += link, e += link, f += link, g += link, h += link;
        ASIDE;
        a += link, b += link, c += link, d += link, e += link, f += link, g += link, h += link;
        ASIDE;
    }
    const double taken = now() - start;
    const double after = cycle(&link);

    return (double)(SUMS * ROUNDS) * ((before < after) ? before : after) / taken;
}

#endif
