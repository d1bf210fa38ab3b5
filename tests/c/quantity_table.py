#!/usr/bin/python3
"""Puts the quantities of the C interface into docs/c_interface.md, from the library; with --check, says whether they stand there.

usage: tests/c/quantity_table.py [--check] build/dev/c/libswayaw_c.so docs/c_interface.md
"""
import ctypes
import pathlib
import re
import sys

KINDS = ("state", "order", "output")


class Quantity(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("unit", ctypes.c_char_p), ("kind", ctypes.c_int), ("description", ctypes.c_char_p)]


def table(library):
    library.swayaw_quantity_at.restype = ctypes.POINTER(Quantity)
    rows, index = ["| name | unit | kind | |", "| --- | --- | --- | --- |"], 0
    while quantity := library.swayaw_quantity_at(index):
        q = quantity.contents
        unit = "–" if q.unit == b"1" else q.unit.decode().replace("N.m", "N m")
        rows.append(f"| `{q.name.decode()}` | {unit} | {KINDS[q.kind]} | {q.description.decode()} |")
        index += 1
    return "\n".join(rows)


def main(arguments):
    check = "--check" in arguments
    library, page = [a for a in arguments if a != "--check"]
    text = pathlib.Path(page).read_text(encoding="utf-8")
    rows = table(ctypes.CDLL(str(pathlib.Path(library).resolve())))
    made, places = re.subn(r"(<!-- table: quantities -->\n).*?(<!-- end -->)", lambda m: f"{m[1]}{rows}\n{m[2]}", text, flags=re.S)
    if places != 1:
        sys.exit(f"{page}: no place for the table of quantities")
    if check and made != text:
        sys.exit(f"{page}: the table of quantities is not that of {library}; {__file__} without --check puts it there")
    if not check:
        pathlib.Path(page).write_text(made, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
