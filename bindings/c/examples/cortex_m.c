/* Start-up, log and end on a Cortex-M in QEMU: Arm's semihosting, calls 4 and 24. */

#include "board.h"

int main(void);

static int host(int call, const void *argument) {
    register int r0 __asm__("r0") = call;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}

void print(const char *text) { host(4, text); }

/* Call 24 takes the reason itself: 0x20026 is an ordinary end. */
static void stop(int failed) {
    for (;;) {
        host(24, failed ? (const void *)0x20023 : (const void *)0x20026);
    }
}

static void fault(void) { stop(1); }

/* An FPU is off until it is asked for. */
void start(void);
void start(void) {
    extern uint32_t data_begin, data_end, data_load, bss_begin, bss_end;
    const uint32_t *from = &data_load;
    for (uint32_t *to = &data_begin; to < &data_end;) {
        *to++ = *from++;
    }
    for (uint32_t *to = &bss_begin; to < &bss_end;) {
        *to++ = 0;
    }
#if defined(__ARM_FP)
    *(volatile uint32_t *)0xe000ed88 |= 0xf << 20;
    __asm__ volatile("dsb\nisb");
#endif
    stop(main());
}

extern uint32_t stack_end;
__attribute__((section(".vectors"), used)) static const void *const vectors[] = {
    &stack_end, (const void *)start, (const void *)fault, (const void *)fault,
};
