/* Prints the room there is where a core is ours alone: of what is found in some seconds, which are
   its argument, all but the largest fiftieth, of which some were measured while the clock changed. */
#include <stdio.h>
#include <stdlib.h>

#include "room.h"

#define MOST 100000

static int compare(const void *one, const void *other)
{
    const double a = *(const double *)one, b = *(const double *)other;

    return (a > b) - (a < b);
}

int main(int argc, char **argv)
{
    static double found[MOST];

    if (argc != 2) {
        return 2;
    }
    const struct timespec pause = {0, 2000000L};
    const double end = now() + (1e9 * atof(argv[1]));
    size_t count = 0;

    do {
        found[count] = room();
        ++count;
        (void)nanosleep(&pause, NULL);
    } while ((count < MOST) && (now() < end));
    qsort(found, count, sizeof(double), compare);
    printf("%.3f\n", found[count - 1 - (count / 50)]);
    return 0;
}
