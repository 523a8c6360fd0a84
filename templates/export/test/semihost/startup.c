/* Start-up code for a Cortex-M with a single-precision unit: vector table, memory, FPU, main.
 *
 * Needs no C library: what main returns is the exit status of the emulator or of the debugger.
 */
#include <stdint.h>

#include "semihost.h"

int main(void);
void reset(void);
void fault(void);

/* Placed by the linker script. */
extern uint32_t stack_top;
extern uint32_t data_start;
extern uint32_t data_end;
extern uint32_t bss_start;
extern uint32_t bss_end;
extern const uint32_t data_load;

/* Coprocessor access control: both bits of the coprocessors 10 and 11 are the floating-point unit. */
#define CPACR (*(volatile uint32_t *)0xE000ED88U)
#define CPACR_FPU (0xFU << 20)

typedef void (*handler_t)(void);

typedef struct {
    uint32_t *stack;
    handler_t handlers[15];
} vectors_t;

/* The core reads the initial stack pointer, then jumps through the second word. */
__attribute__((section(".vectors"), used)) const vectors_t vectors = {
    &stack_top,
    {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault,
     fault, fault}};

void reset(void)
{
    const uint32_t *from = &data_load;

    CPACR |= CPACR_FPU;
    __asm volatile("dsb\n\tisb" ::: "memory");
    for (uint32_t *to = &data_start; to < &data_end; ++to) {
        *to = *from;
        ++from;
    }
    for (uint32_t *to = &bss_start; to < &bss_end; ++to) {
        *to = 0U;
    }
    semihost_exit(main());
}

/* A fault, an exhausted stack among them, ends the run with a failure. */
void fault(void)
{
    semihost_write("fault\n");
    semihost_exit(1);
}
