/* Output and exit through Arm semihosting, and as much of printf as tests need.
 *
 * printf here knows %d %i %u %x %c %s %% with a width, a leading 0 and the lengths h, l, z and t.
 * It uses neither heap nor files, so that a test links without an operating system.
 */
#include "semihost.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>

#define SYS_WRITE0 0x04U
#define SYS_EXIT 0x18U
#define STOPPED_APPLICATION_EXIT 0x20026U
#define STOPPED_RUN_TIME_ERROR 0x20023U
#define BUFFER_SIZE 128

int printf(const char *restrict format, ...);
int puts(const char *text);
int putchar(int character);

/* One buffer: a request stops the core, so the fewer the better. */
static char buffer[BUFFER_SIZE];
static int used;

static void request(uint32_t operation, uint32_t parameter)
{
    register uint32_t r0 __asm("r0") = operation;
    register uint32_t r1 __asm("r1") = parameter;

    __asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

static void flush(void)
{
    buffer[used] = '\0';
    used = 0;
    request(SYS_WRITE0, (uint32_t)(uintptr_t)buffer);
}

static void put(char character)
{
    buffer[used] = character;
    ++used;
    if ((used == (BUFFER_SIZE - 1)) || (character == '\n')) {
        flush();
    }
}

static void put_text(const char *text)
{
    while (*text != '\0') {
        put(*text);
        ++text;
    }
}

static void put_number(unsigned long value, unsigned long base, int width, char fill, bool minus)
{
    char digits[3 * sizeof(value)];
    int count = 0;

    do {
        digits[count] = "0123456789abcdef"[value % base];
        ++count;
        value /= base;
    } while (value > 0UL);
    if (minus && (fill == '0')) {
        put('-');
    }
    for (int k = count + (minus ? 1 : 0); k < width; ++k) {
        put(fill);
    }
    if (minus && (fill != '0')) {
        put('-');
    }
    while (count > 0) {
        --count;
        put(digits[count]);
    }
}

static void put_signed(long value, int width, char fill)
{
    const unsigned long size = (value < 0) ? (0UL - (unsigned long)value) : (unsigned long)value;

    put_number(size, 10UL, width, fill, value < 0);
}

void semihost_write(const char *text)
{
    put_text(text);
    flush();
}

void semihost_exit(int status)
{
    flush();
    for (;;) {
        request(SYS_EXIT, (status == 0) ? STOPPED_APPLICATION_EXIT : STOPPED_RUN_TIME_ERROR);
    }
}

int putchar(int character)
{
    put((char)character);
    return character;
}

int puts(const char *text)
{
    put_text(text);
    put('\n');
    return 0;
}

/* int, long, size_t and ptrdiff_t have 32 bits on every Cortex-M: lengths are read and skipped. */
int printf(const char *restrict format, ...)
{
    va_list values;

    va_start(values, format);
    for (const char *at = format; *at != '\0'; ++at) {
        if (*at != '%') {
            put(*at);
            continue;
        }
        ++at;
        const char fill = (*at == '0') ? '0' : ' ';
        int width = 0;

        while ((*at >= '0') && (*at <= '9')) {
            width = (10 * width) + (*at - '0');
            ++at;
        }
        while ((*at == 'h') || (*at == 'l') || (*at == 'z') || (*at == 't')) {
            ++at;
        }
        switch (*at) {
        case 'd':
        case 'i':
            put_signed(va_arg(values, long), width, fill);
            break;
        case 'u':
            put_number(va_arg(values, unsigned long), 10UL, width, fill, false);
            break;
        case 'x':
            put_number(va_arg(values, unsigned long), 16UL, width, fill, false);
            break;
        case 'c':
            put((char)va_arg(values, int));
            break;
        case 's':
            put_text(va_arg(values, const char *));
            break;
        case '%':
            put('%');
            break;
        default: /* a test that asks for more must say so loudly */
            semihost_write("printf: unknown conversion\n");
            semihost_exit(1);
        }
    }
    va_end(values);
    return 0;
}
