/* Calls a function with every record: outputs bit by bit, then ticks of the timer over calls.

   The program that includes this defines RECORDS, SIZE, records, and the function CALL. */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define CONTROL (*(volatile uint32_t *)0xE000E010U)
#define RELOAD (*(volatile uint32_t *)0xE000E014U)
#define VALUE (*(volatile uint32_t *)0xE000E018U)
#define MOST 0x00FFFFFFU
#define ROUNDS 25

void CALL(const float *in, float *out);

static float out[SIZE];

static void nothing(const float *in, float *to)
{
    (void)in;
    (void)to;
}

static unsigned long ticks(void (*volatile call)(const float *, float *))
{
    const uint32_t earlier = VALUE;

    for (int round = 0; round < ROUNDS; ++round) {
        for (int k = 0; k < RECORDS; ++k) {
            call(records[k], out);
        }
    }
    return (earlier - VALUE) & MOST;
}

int main(void)
{
    for (int k = 0; k < RECORDS; ++k) {
        memset(out, 0, sizeof(out));
        CALL(records[k], out);
        printf("out");
        for (int i = 0; i < SIZE; ++i) {
            uint32_t bits;

            memcpy(&bits, &out[i], sizeof(bits));
            printf(" %lx", (unsigned long)bits);
        }
        printf("\n");
    }
    RELOAD = MOST;
    VALUE = 0U;
    CONTROL = 5U;
    const unsigned long idle = ticks(nothing);

    printf("ticks %lu in %d\n", ticks(CALL) - idle, ROUNDS * RECORDS);
    return 0;
}
