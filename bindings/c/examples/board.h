/* Where the program runs: on a host, or on a bare Cortex-M that logs by semihosting. */

#include <stdint.h>

#define TEXT_OF(name) #name
#define TEXT(name) TEXT_OF(name)

#ifdef __cplusplus
extern "C"
#endif
void print(const char *text);

static inline void print_number(const char *before, uint32_t number, uint32_t base) {
    char digits[11];
    char *first = digits + 10;
    *first = 0;
    do {
        *--first = "0123456789abcdef"[number % base];
        number /= base;
    } while (number != 0);
    print(before);
    print(first);
}
