/* SPDX-License-Identifier: MIT
 * A plugin of QEMU 7.2 that prices every instruction of a Cortex-M4F at its worst: what docs/cycles.md says. At
 * each mark of the program (ticks.hpp) instructions and cycles so far go to the file `out=FILE`, two little-endian words
 * of 64 bits. Debian ships no header for plugins: what is used of the interface is declared here. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef uint64_t PluginId;
struct qemu_plugin_tb;
struct qemu_plugin_insn;
enum { kInlineAddU64 = 0, kNoRegisters = 0 };

void qemu_plugin_register_vcpu_tb_trans_cb(PluginId id, void (*translated)(PluginId, struct qemu_plugin_tb*));
void qemu_plugin_register_atexit_cb(PluginId id, void (*ended)(PluginId, void*), void* data);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb* tb);
struct qemu_plugin_insn* qemu_plugin_tb_get_insn(const struct qemu_plugin_tb* tb, size_t index);
const void* qemu_plugin_insn_data(const struct qemu_plugin_insn* insn);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn* insn);
size_t qemu_plugin_insn_size(const struct qemu_plugin_insn* insn);
void qemu_plugin_register_vcpu_insn_exec_inline(struct qemu_plugin_insn* insn, int op, void* sum, uint64_t add);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn* insn, void (*reached)(unsigned, void*), int flags,
                                            void* data);
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb* tb, void (*reached)(unsigned, void*), int flags,
                                          void* data);

__attribute__((visibility("default"))) int qemu_plugin_version = 1;

static const uint32_t kMark = 0xF3AF80F5U; /* DBG #5 */
enum {
  kOne = 1,
  kRefill = 3,     /* of the pipeline, P of the manual, at most */
  kStall = 1,      /* an address made by the instruction before; a literal that waits for the fetch */
  kConsumed = 1,   /* the instruction after an arithmetic one of the FPU takes its result */
  kDivide = 12,
  kDivideOrRootOfFpu = 14,
  kMultiplyAdd = 2,
  kMultiplyAddOfFpu = 3
};

static uint64_t instructions;
static uint64_t cycles;
static FILE* out;

static unsigned ones(uint32_t bits) { return (unsigned)__builtin_popcount(bits); }

/* What a single transfer takes beside its stall, and one of several registers. */
enum { kTransfer = 2 };

static unsigned of_half(uint32_t w) {
  if ((w & 0xF000U) == 0xD000U || (w & 0xF500U) == 0xB100U) return kOne;             /* B<cond>, CBZ: see on_block */
  if ((w & 0xF800U) == 0xE000U || (w & 0xFF00U) == 0x4700U) return kOne + kRefill;   /* B, BX, BLX */
  if ((w & 0xFC87U) == 0x4487U) return kOne + kRefill;                               /* ADD, MOV to PC */
  if ((w & 0xFE00U) == 0xB400U) return kOne + ones(w & 0x1FFU);                      /* PUSH */
  if ((w & 0xFE00U) == 0xBC00U) return kOne + ones(w & 0x1FFU) + (w & 0x100U ? kRefill : 0); /* POP */
  if ((w & 0xF000U) == 0xC000U) return kOne + ones(w & 0xFFU);                       /* LDM, STM */
  return (w >= 0x5000U && w < 0xA000U) || (w & 0xF800U) == 0x4800U ? kTransfer : kOne;
}

static bool is_fpu(uint32_t w) { return (w & 0xEC000E00U) == 0xEC000A00U; }
static bool is_arithmetic_of_fpu(uint32_t w) { return (w & 0xFF000E10U) == 0xEE000A00U; }

/* Whether that is one of those whose result comes late: no move, sign or comparison. */
static bool comes_late(uint32_t w) {
  if (!is_arithmetic_of_fpu(w)) return false;
  if ((w & 0x00B00000U) != 0x00B00000U) return true;
  const uint32_t kind = (w >> 16) & 15U;
  if ((w & 0x40U) == 0 || kind == 0 || kind == 4U || kind == 5U) return false;       /* VMOV, VABS, VCMP */
  return kind != 1U || (w & 0x80U) != 0;                                             /* VSQRT, not VNEG */
}

static unsigned of_fpu(uint32_t w) {
  if ((w & 0xFFE00000U) == 0xEC400000U) return 2;                                    /* VMOV of two registers */
  if ((w & 0xFF200000U) == 0xED000000U) return kTransfer + (w & 0x100U ? 1 : 0);     /* VLDR, VSTR */
  if ((w & 0xFE000000U) == 0xEC000000U) return kOne + (w & 0xFFU);                   /* VLDM, VSTM, VPUSH, VPOP */
  if (!is_arithmetic_of_fpu(w)) return kOne;                                         /* VMOV, VMRS, VMSR */
  const uint32_t kind = w & 0x00B00040U;
  if (kind == 0x00800000U || (w & 0x00BF00C0U) == 0x00B100C0U) return kDivideOrRootOfFpu; /* VDIV, VSQRT */
  if ((w & 0x00B00000U) == 0 || (w & 0x00B00000U) == 0x00100000U || (w & 0x00B00000U) == 0x00900000U ||
      (w & 0x00B00000U) == 0x00A00000U)
    return kMultiplyAddOfFpu;                                                        /* VMLA, VNMLA, VFNMA, VFMA */
  return kOne;
}

static bool is_conditional_branch(uint32_t w) {
  if (w <= 0xFFFFU) return ((w & 0xF000U) == 0xD000U && (w & 0x0E00U) != 0x0E00U) || (w & 0xF500U) == 0xB100U;
  return (w & 0xF800D000U) == 0xF0008000U && (w & 0x03800000U) != 0x03800000U;
}

static unsigned of_word(uint32_t w) {
  if (is_fpu(w)) return of_fpu(w);
  if ((w & 0xFE400000U) == 0xE8000000U)                                              /* LDM, STM, PUSH, POP */
    return kOne + ones(w & 0xFFFFU) + ((w & 0x00108000U) == 0x00108000U ? kRefill : 0);
  if ((w & 0xFFF0FFE0U) == 0xE8D0F000U) return kTransfer + kOne + kRefill;           /* TBB, TBH */
  if ((w & 0xFE400000U) == 0xE8400000U) return kTransfer + 1;                        /* LDRD, STRD, exclusive */
  if (is_conditional_branch(w)) return kOne;
  if ((w & 0xF8008000U) == 0xF0008000U) return kOne + kRefill;                       /* B, BL, MSR, MRS, barriers */
  if ((w & 0xFE000000U) == 0xF8000000U)                                              /* LDR, STR */
    return kTransfer + ((w & 0x0010F000U) == 0x0010F000U ? kRefill : 0);
  if ((w & 0xFFD0F0F0U) == 0xFB90F0F0U) return kDivide;                              /* SDIV, UDIV */
  if ((w & 0xFFF0F0F0U) == 0xFB00F000U) return kOne;                                 /* MUL */
  if ((w & 0xFF000000U) == 0xFB000000U) return kMultiplyAdd;                         /* MLA, SMULL, ... */
  return kOne;
}

enum { kStackPointer = 13, kProgramCounter = 15, kNoRegister = 16, kUnknownRegister = 17 };

/* The core register that a data operation writes, or none. */
static unsigned written_by(uint32_t w) {
  if (w <= 0xFFFFU) {
    if (w < 0x2000U || (w & 0xFC00U) == 0x4000U || (w & 0xFF00U) == 0xB200U) return w & 7U;
    if (w < 0x4000U || (w & 0xF000U) == 0xA000U) return (w >> 8) & 7U;
    if ((w & 0xFC00U) == 0x4400U) return (w & 7U) | ((w >> 4) & 8U);
    return (w & 0xFF00U) == 0xB000U ? kStackPointer : kNoRegister;
  }
  if (is_fpu(w)) return (w & 0xFF100010U) == 0xEE100010U ? (w >> 12) & 15U : kNoRegister;
  if ((w & 0xFE000000U) == 0xEA000000U || (w & 0xF8008000U) == 0xF0000000U || (w & 0xFE000000U) == 0xFA000000U)
    return (w >> 8) & 15U;
  return kNoRegister;
}

/* Whether a transfer makes its address of this register, of an unknown one, or of the counter of the program. */
static bool is_addressed_by(uint32_t w, unsigned reg) {
  if (w <= 0xFFFFU) {
    const bool is_transfer = (w >= 0x5000U && w < 0xA000U) || (w & 0xF600U) == 0xB400U || (w & 0xF000U) == 0xC000U;
    if ((w & 0xF800U) == 0x4800U) return true;                                       /* a literal */
    if (reg == kUnknownRegister) return is_transfer;
    if ((w & 0xF000U) == 0x5000U) return ((w >> 3) & 7U) == reg || ((w >> 6) & 7U) == reg;
    if ((w & 0xF000U) == 0x9000U || (w & 0xF600U) == 0xB400U) return reg == kStackPointer;
    if ((w & 0xF000U) == 0xC000U) return ((w >> 8) & 7U) == reg;
    return w >= 0x6000U && w < 0x9000U && ((w >> 3) & 7U) == reg;
  }
  const bool is_transfer = (w & 0xFE000000U) == 0xE8000000U || (w & 0xFE000000U) == 0xF8000000U ||
                           (is_fpu(w) && (w & 0xFE000000U) == 0xEC000000U);
  const unsigned base = (w >> 16) & 15U;
  if (reg == kUnknownRegister) return is_transfer;
  return is_transfer && (base == reg || base == kProgramCounter || (w & 15U) == reg);
}

/* Whether an instruction of the FPU names the register that another one writes. */
static bool takes_result(uint32_t next, uint32_t w) {
  if (!is_fpu(next)) return false;
  if ((next & 0xFE000000U) == 0xEC000000U && (next & 0xFF200000U) != 0xED000000U) return true; /* of several */
  const uint32_t d = ((w >> 11) & 0x1EU) | ((w >> 22) & 1U);
  return d == (((next >> 11) & 0x1EU) | ((next >> 22) & 1U)) || d == (((next >> 15) & 0x1EU) | ((next >> 7) & 1U)) ||
         d == (((next << 1) & 0x1EU) | ((next >> 5) & 1U));
}

static uint32_t word_of(const struct qemu_plugin_insn* insn) {
  const uint8_t* code = qemu_plugin_insn_data(insn);
  const uint32_t first = code[0] | (uint32_t)code[1] << 8;
  return qemu_plugin_insn_size(insn) == 2 ? first : first << 16 | code[2] | (uint32_t)code[3] << 8;
}

/* Cycles of an instruction at its worst, between these two; 0: the neighbour is not known. */
__attribute__((visibility("default"))) unsigned batuta_worst_cycles(uint32_t before, uint32_t w, uint32_t next) {
  const unsigned alone = w <= 0xFFFFU ? of_half(w) : of_word(w);
  const unsigned made = before == 0 ? kUnknownRegister : written_by(before);
  const bool stalls = is_addressed_by(w, made);
  const bool consumed = w > 0xFFFFU && comes_late(w) && (next == 0 || takes_result(next, w));
  return alone + (stalls ? kStall : 0) + (consumed ? kConsumed : 0);
}

static void on_mark(unsigned cpu, void* data) {
  (void)cpu, (void)data;
  const uint64_t pair[2] = {instructions, cycles};
  fwrite(pair, sizeof pair, 1, out);
}

/* A block of instructions that ends in a jump, or before one is known. */
typedef struct {
  uint64_t start;
  uint64_t after;        /* where it goes on if its last instruction does not jump */
  bool may_go_on;        /* that is a conditional branch */
} Block;

static const Block* last;

static void on_block(unsigned cpu, void* data) {
  (void)cpu;
  const Block* block = data;
  if (last && last->may_go_on && block->start != last->after) cycles += kRefill;
  last = block;
}

static void on_translation(PluginId id, struct qemu_plugin_tb* tb) {
  (void)id;
  const size_t count = qemu_plugin_tb_n_insns(tb);
  uint32_t before = 0;
  uint32_t word = word_of(qemu_plugin_tb_get_insn(tb, 0));
  for (size_t i = 0; i < count; ++i) {
    struct qemu_plugin_insn* insn = qemu_plugin_tb_get_insn(tb, i);
    const uint32_t next = i + 1 < count ? word_of(qemu_plugin_tb_get_insn(tb, i + 1)) : 0;
    qemu_plugin_register_vcpu_insn_exec_inline(insn, kInlineAddU64, &instructions, 1);
    qemu_plugin_register_vcpu_insn_exec_inline(insn, kInlineAddU64, &cycles, batuta_worst_cycles(before, word, next));
    if (word == kMark) qemu_plugin_register_vcpu_insn_exec_cb(insn, on_mark, kNoRegisters, NULL);
    before = word;
    word = next;
  }
  struct qemu_plugin_insn* end = qemu_plugin_tb_get_insn(tb, count - 1);
  Block* block = malloc(sizeof *block);
  if (!block) abort();
  block->start = qemu_plugin_insn_vaddr(qemu_plugin_tb_get_insn(tb, 0));
  block->after = qemu_plugin_insn_vaddr(end) + qemu_plugin_insn_size(end);
  block->may_go_on = is_conditional_branch(before);
  qemu_plugin_register_vcpu_tb_exec_cb(tb, on_block, kNoRegisters, block);
}

static void on_end(PluginId id, void* data) {
  (void)id, (void)data;
  fclose(out);
}

__attribute__((visibility("default"))) int qemu_plugin_install(PluginId id, const void* info, int count, char** words) {
  (void)info;
  for (int i = 0; i < count; ++i) {
    if (strncmp(words[i], "out=", 4) == 0) out = fopen(words[i] + 4, "wb");
  }
  if (!out) return 1;
  qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
  qemu_plugin_register_atexit_cb(id, on_end, NULL);
  return 0;
}
