/* Output and exit through the debugger or the emulator: Arm semihosting. */
#ifndef SEMIHOST_H
#define SEMIHOST_H

/* Write a string that ends with a null character. */
void semihost_write(const char *text);

/* End the run: 0 is success, anything else a failure. */
__attribute__((noreturn)) void semihost_exit(int status);

#endif /* SEMIHOST_H */
