/* A plugin for QEMU: weighs each instruction of a Cortex-M0 or M0+ program by Arm's tables, with
   memory that does not wait. For each call of a function whose name has `ask_all` in it, a line:
   instructions, cycles on M0 with the multiplier of one cycle and that of 32, the same on M0+.
   A line `log` where the program logs. Of another machine's program, which logs by a system call,
   only the instructions mean anything.

   Sources: Cortex-M0 Technical Reference Manual (DDI 0432C), table 3-1; Cortex-M0+ Technical
   Reference Manual (DDI 0484C), table 3-1. */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of qemu-plugin.h, version 1, which Debian's QEMU comes without. */
typedef uint64_t plugin_id;
struct block;
struct instruction;
struct machine;
__attribute__((visibility("default"))) int qemu_plugin_version = 1;
extern void qemu_plugin_register_vcpu_tb_trans_cb(plugin_id, void (*)(plugin_id, struct block *));
extern size_t qemu_plugin_tb_n_insns(const struct block *);
extern struct instruction *qemu_plugin_tb_get_insn(const struct block *, size_t);
extern uint64_t qemu_plugin_insn_vaddr(const struct instruction *);
extern const void *qemu_plugin_insn_data(const struct instruction *);
extern size_t qemu_plugin_insn_size(const struct instruction *);
extern const char *qemu_plugin_insn_symbol(const struct instruction *);
extern void qemu_plugin_register_vcpu_syscall_cb(plugin_id, void (*)(plugin_id, unsigned, int64_t, uint64_t, uint64_t,
                                                                     uint64_t, uint64_t, uint64_t, uint64_t, uint64_t,
                                                                     uint64_t));
extern void qemu_plugin_register_vcpu_insn_exec_cb(struct instruction *, void (*)(unsigned, void *), int, void *);

enum { M0, M0_PLUS, CORES };

/* What is known of an instruction before it runs. */
struct known {
    uint64_t address;
    const char *symbol;
    bool asks, logs, multiplies, branches_perhaps;
    unsigned bytes, cycles[CORES];
};

static unsigned ones(unsigned bits) { return (unsigned)__builtin_popcount(bits); }

static void weigh(struct known *to, uint16_t code, uint16_t second) {
    unsigned all = 1, m0 = 0, plus = 0; /* the latter two where they differ */
    to->bytes = 2;
    if ((code & 0xf800) == 0xe000) { /* B */
        m0 = 3, plus = 2;
    } else if ((code & 0xf000) == 0xd000 && (code & 0x0e00) != 0x0e00) { /* B<cc> */
        to->branches_perhaps = true;
    } else if (code >= 0xe800) { /* of 32 bits */
        to->bytes = 4;
        if ((second & 0xd000) == 0xd000) { /* BL */
            m0 = 4, plus = 3;
        } else { /* MRS, MSR, DMB, DSB, ISB */
            m0 = 4, plus = 3;
        }
    } else if ((code & 0xff00) == 0x4700) { /* BX, BLX */
        m0 = 3, plus = 2;
    } else if ((code & 0xfc87) == 0x4487 && (code & 0x0300) != 0x0100) { /* ADD or MOV to the PC */
        m0 = 3, plus = 2;
    } else if ((code & 0xffc0) == 0x4340) { /* MULS */
        to->multiplies = true;
    } else if ((code & 0xf800) == 0x4800 || (code & 0xf000) == 0x5000 || (code & 0xe000) == 0x6000
               || (code & 0xe000) == 0x8000) { /* LDR, STR, of any size */
        all = 2;
    } else if ((code & 0xfe00) == 0xb400) { /* PUSH */
        all = 1 + ones(code & 0x1ff);
    } else if ((code & 0xff00) == 0xbd00) { /* POP with the PC: N counts the PC too */
        m0 = 3 + ones(code & 0x1ff), plus = 2 + ones(code & 0x1ff);
    } else if ((code & 0xff00) == 0xbc00) { /* POP */
        all = 1 + ones(code & 0xff);
    } else if ((code & 0xf000) == 0xc000) { /* LDM, STM */
        all = 1 + ones(code & 0xff);
    }
    to->cycles[M0] = m0 ? m0 : all;
    to->cycles[M0_PLUS] = plus ? plus : all;
}

static struct {
    uint64_t instructions, cycles[CORES], multiplications;
} counted;
static const struct known *before;
static const char *caller;

static void step(unsigned core, void *data) {
    (void)core;
    const struct known *now = data;
    if (before && before->branches_perhaps && now->address != before->address + before->bytes) {
        counted.cycles[M0] += 2;
        counted.cycles[M0_PLUS] += 1;
    }
    if (!caller && now->asks && before && !before->asks) {
        caller = before->symbol;
        memset(&counted, 0, sizeof counted);
    } else if (caller && now->symbol == caller) {
        caller = NULL;
        uint64_t slow = 31 * counted.multiplications, *cycles = counted.cycles;
        fprintf(stderr, "%lu %lu %lu %lu %lu\n", counted.instructions, cycles[M0], cycles[M0] + slow,
                cycles[M0_PLUS], cycles[M0_PLUS] + slow);
    }
    counted.instructions++;
    counted.cycles[M0] += now->cycles[M0];
    counted.cycles[M0_PLUS] += now->cycles[M0_PLUS];
    counted.multiplications += now->multiplies;
    if (now->logs) {
        fprintf(stderr, "log\n");
    }
    before = now;
}

/* One copy of each name, so that names are compared by where they are. */
static const char *kept(const char *name) {
    static char *names[4096];
    static size_t many;
    for (size_t k = 0; k < many; k++) {
        if (!strcmp(names[k], name)) {
            return names[k];
        }
    }
    if (many == sizeof names / sizeof *names) {
        abort();
    }
    return names[many++] = strdup(name);
}

static void translated(plugin_id id, struct block *block) {
    (void)id;
    for (size_t k = 0; k < qemu_plugin_tb_n_insns(block); k++) {
        struct instruction *instruction = qemu_plugin_tb_get_insn(block, k);
        const char *symbol = qemu_plugin_insn_symbol(instruction);
        uint16_t code[2] = {0, 0};
        memcpy(code, qemu_plugin_insn_data(instruction), 2);
        if (code[0] >= 0xe800) {
            memcpy(code, qemu_plugin_insn_data(instruction), 4);
        }
        struct known *known = calloc(1, sizeof *known);
        known->address = qemu_plugin_insn_vaddr(instruction);
        known->symbol = kept(symbol ? symbol : "?");
        known->asks = strstr(known->symbol, "ask_all") != NULL;
        /* The low half of an instruction of AArch64 may have these bits too. */
        known->logs = code[0] == 0xbeab && qemu_plugin_insn_size(instruction) == 2;
        weigh(known, code[0], code[1]);
        qemu_plugin_register_vcpu_insn_exec_cb(instruction, step, 0, known);
    }
}

static void called(plugin_id id, unsigned core, int64_t number, uint64_t a, uint64_t b, uint64_t c, uint64_t d,
                   uint64_t e, uint64_t f, uint64_t g, uint64_t h) {
    (void)id, (void)core, (void)number, (void)a, (void)b, (void)c, (void)d, (void)e, (void)f, (void)g, (void)h;
    fprintf(stderr, "log\n");
}

__attribute__((visibility("default"))) int qemu_plugin_install(plugin_id id, const struct machine *machine, int argc,
                                                               char **argv) {
    (void)machine, (void)argc, (void)argv;
    qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
    qemu_plugin_register_vcpu_syscall_cb(id, called);
    return 0;
}
