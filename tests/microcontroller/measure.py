#!/usr/bin/env python3
"""Prints the README's table of microcontrollers: flash, stack and instructions of each function of this library.

It needs the target and `pip install unicorn pyelftools`. Flash is what the linker keeps if a program calls one function
only. With `--opt-level 3` and `--double` it prints what the README says of other settings and of f64.
"""

import argparse
import os
import struct
import subprocess
import sys
from pathlib import Path

from elftools.elf.elffile import ELFFile
from unicorn import UC_ARCH_ARM, UC_HOOK_CODE, UC_MODE_THUMB, Uc
from unicorn.arm_const import (
    UC_ARM_REG_C1_C0_2,
    UC_ARM_REG_D0,
    UC_ARM_REG_FPEXC,
    UC_ARM_REG_LR,
    UC_ARM_REG_R0,
    UC_ARM_REG_S0,
    UC_ARM_REG_SP,
)

HERE = Path(__file__).parent
TARGET = "thumbv7em-none-eabihf"
BUILT = HERE.parents[1] / "target"
# The linker lays programs in the first of these. The stack grows down from the second, the third holds arrays, to the
# fourth functions return.
PROGRAM, STACK, ARRAYS, RETURN = 0, 0x2000_0000, 0x3000_0000, 0x4000_0000
ROOM = 0x10_0000
TIME, FORCE, PLACE = 200.0, 100.0, 3.0


def knots(count):
    """A record up to TIME whose forces rise by a tenth, faster and faster, as pairs of a time and a force."""
    shares = [k / (count - 1) for k in range(count)]
    return [x for share in shares for x in (TIME * share, FORCE * (1 + share**2 / 10))]


# Name, function, arrays that it reads, numbers, and how many numbers it writes.
ROWS = [
    ("radius and approach, held load", "radius_and_approach", [], [FORCE, TIME], 2),
    ("radius, approach and peak pressure, held load", "peak_pressure", [], [FORCE, TIME], 3),
    ("the same and a pressure", "of_constants", [], [FORCE, TIME, PLACE], 4),
    ("the same, coefficients of a field", "of_a_field", [], [20.0, FORCE, TIME, PLACE], 4),
    ("the same, `Polynomial`", "of_a_polynomial", [[0.025, 2.0, 1.09375e-4, 4.0]], [TIME, PLACE], 4),
    ("the same, constants, record of 10 knots", "of_ten_knots", [knots(10)], [TIME, PLACE], 4),
    ("the same, record of 100 knots", "of_a_hundred_knots", [knots(100)], [TIME, PLACE], 4),
    ("the same, user-defined load that rises steadily", "of_a_load", [], [FORCE / TIME, TIME, PLACE], 4),
    ("radii at 8 times, held load", "radii", [[25.0 * k for k in range(1, 9)]], [], 8),
    ("4 × 4 pressures, held load", "pressure_field", [[50.0, 100.0, 150.0, 200.0], [0.0, 2.0, 4.0, 6.0]], [], 16),
]


def linker():
    """LLD, which is a part of the Rust toolchain."""
    sysroot = subprocess.run(["rustc", "--print", "sysroot"], check=True, capture_output=True, text=True).stdout
    return next(Path(sysroot.strip()).glob("lib/rustlib/*/bin/rust-lld"))


def library(opt_level, double):
    """All functions, compiled, as a file."""
    command = ["cargo", "build", "--quiet", "--release", "--locked", "--target", TARGET, "--target-dir", BUILT]
    command += ["--manifest-path", HERE / "Cargo.toml"] + (["--features", "double"] if double else [])
    environment = os.environ | {"CARGO_PROFILE_RELEASE_OPT_LEVEL": opt_level}
    subprocess.run(command, check=True, env=environment)
    return BUILT / TARGET / "release/libmicrocontroller.a"


def linked(lld, library, function):
    """The program of one function, as a file."""
    program = library.with_name(f"{function}.elf")
    subprocess.run(
        [lld, "-flavor", "gnu", "--gc-sections", "-e", function, library, "-o", program], check=True
    )
    return program


def run(elf, double, arrays, numbers, written):
    """Stack in bytes, instructions, and the numbers written."""
    machine = Uc(UC_ARCH_ARM, UC_MODE_THUMB)
    machine.reg_write(UC_ARM_REG_C1_C0_2, machine.reg_read(UC_ARM_REG_C1_C0_2) | 0xF << 20)
    machine.reg_write(UC_ARM_REG_FPEXC, 0x4000_0000)
    for start in (PROGRAM, STACK - ROOM, ARRAYS, RETURN):
        machine.mem_map(start, ROOM)
    for segment in elf.iter_segments("PT_LOAD"):
        machine.mem_write(segment["p_vaddr"], segment.data())
    number_format, size, first = ("d", 8, UC_ARM_REG_D0) if double else ("f", 4, UC_ARM_REG_S0)
    address = ARRAYS
    for place, array in enumerate([*arrays, [float("nan")] * written]):
        result = address
        machine.mem_write(address, struct.pack(f"<{len(array)}{number_format}", *array))
        machine.reg_write(UC_ARM_REG_R0 + place, address)
        address += size * len(array)
    for place, number in enumerate(numbers):
        bits = int.from_bytes(struct.pack(f"<{number_format}", number), "little")
        machine.reg_write(first + place, bits)
    machine.reg_write(UC_ARM_REG_SP, STACK)
    machine.reg_write(UC_ARM_REG_LR, RETURN | 1)
    count, lowest = 0, STACK

    def step(machine, *_):
        nonlocal count, lowest
        count += 1
        lowest = min(lowest, machine.reg_read(UC_ARM_REG_SP))

    machine.hook_add(UC_HOOK_CODE, step)
    machine.emu_start(elf.header["e_entry"] | 1, RETURN)
    results = struct.unpack(f"<{written}{number_format}", machine.mem_read(result, size * written))
    return STACK - lowest, count, results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--opt-level", default="s", choices=["0", "1", "2", "3", "s", "z"])
    parser.add_argument("--double", action="store_true", help="in f64")
    options = parser.parse_args()
    lld, functions = linker(), library(options.opt_level, options.double)
    for name, function, *call in ROWS:
        with linked(lld, functions, function).open("rb") as file:
            elf = ELFFile(file)
            flash = sum(segment["p_filesz"] for segment in elf.iter_segments("PT_LOAD"))
            stack, count, results = run(elf, options.double, *call)
        if any(result != result for result in results):
            sys.exit(f"{function} has no result: {results}")
        print(f"| {name} | {flash / 1024:.0f} | {stack / 1024:.1f} | {count} |")


main()
