/* Times every candidate of one problem in turn and prints nanoseconds per call, and how much of the
   core was ours before and after, whichever was less.

   usage: harness REPETITIONS INPUTS OUTPUTS
   INPUTS holds the number of records, their length, then the records, as doubles. OUTPUTS receives
   what every candidate wrote for the first records, for comparison. */
#include <stdio.h>
#include <stdlib.h>

#include "room.h"

typedef void (*function_t)(const double *, double *);

struct candidate {
    const char *name;
    function_t call;
    long size;
    int epochs;
};

extern const struct candidate candidates[];
extern const int candidate_count;

static double burst(function_t volatile call, long calls, long step, long records, long record,
                    const double *inputs, double *out)
{
    const double start = now();
    long at = 0;

    for (long k = 0; k < calls; ++k) {
        call(&inputs[at * record], out);
        at += step;
        if (at >= records) {
            at = 0;
        }
    }
    return (now() - start) / (double)calls;
}

int main(int argc, char **argv)
{
    if (argc != 4) {
        return 2;
    }
    const int repetitions = atoi(argv[1]);
    double shape[2];
    FILE *file = fopen(argv[2], "rb");

    if ((file == NULL) || (fread(shape, sizeof(double), 2, file) != 2)) {
        return 3;
    }
    const long records = (long)shape[0], record = (long)shape[1];
    double *inputs = aligned_alloc(64, (size_t)((records * record * 8 + 63) / 64 * 64));

    if (fread(inputs, sizeof(double), (size_t)(records * record), file) !=
        (size_t)(records * record)) {
        return 3;
    }
    fclose(file);
    long largest = 0;

    for (int c = 0; c < candidate_count; ++c) {
        largest = (candidates[c].size > largest) ? candidates[c].size : largest;
    }
    double *out = aligned_alloc(64, (size_t)((largest * 8 + 63) / 64 * 64));

    file = fopen(argv[3], "wb");
    for (int c = 0; c < candidate_count; ++c) {
        for (long r = 0; r + candidates[c].epochs <= records; r += candidates[c].epochs) {
            candidates[c].call(&inputs[r * record], out);
            fwrite(out, sizeof(double), (size_t)candidates[c].size, file);
        }
    }
    fclose(file);
    long *calls = malloc((size_t)candidate_count * sizeof(long));

    for (int c = 0; c < candidate_count; ++c) {
        const int step = candidates[c].epochs;
        const double each =
            burst(candidates[c].call, 200, step, records, record, inputs, out) + 0.1;

        calls[c] = (long)(3.5e5 / each) + 1;
    }
    for (int r = 0; r < repetitions; ++r) {
        for (int c = 0; c < candidate_count; ++c) {
            const int step = candidates[c].epochs;
            const double before = room();
            const double each =
                burst(candidates[c].call, calls[c], step, records, record, inputs, out);
            const double after = room();

            printf("%s %.4f %.3f\n", candidates[c].name, each / (double)step,
                   (before < after) ? before : after);
        }
    }
    free(calls);
    free(inputs);
    free(out);
    return 0;
}
