#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""make_man.py BMT VERSION FOLDER: writes bmt.1 and a page for each command, bmt-build.1 and so on, from the help texts."""
import os
import sys

import help


def escape(text):
    """Text as roff takes it: no line begins with a control character."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\n".join("\\&" + line if line[:1] in (".", "'") else line for line in text.splitlines())


def write_page(file, version, command, page, others):
    name = "-".join(("bmt",) + command)
    file.write(f'.TH {name.upper()} 1 "" "Multi-Triangulation toolkit {version}" "User Commands"\n')
    file.write(f".SH NAME\n{escape(name)} \\- {escape(page.text.rstrip('.'))}\n")
    file.write(f".SH SYNOPSIS\n.B {escape(page.usage)}\n")
    if page.positionals:
        file.write(".SH ARGUMENTS\n")
        for heading, text in page.positionals:
            file.write(f".TP\n.I {escape(heading)}\n{escape(text)}\n")
    file.write(".SH OPTIONS\n")
    for option in page.options:
        file.write(f".TP\n.B {escape(', '.join(option.names))} {escape(option.takes)}\n{escape(option.text)}\n")
    if page.commands:
        file.write(".SH COMMANDS\n")
        for heading, text in page.commands:
            file.write(f".TP\n.BR bmt\\-{escape(heading)} (1)\n{escape(text)}\n")
    if page.notes:
        file.write(f".SH NOTES\n.nf\n{escape(page.notes)}\n.fi\n")
    also = ",\n".join(f".BR {escape(other)} (1)" for other in others if other != name)
    file.write(".SH SEE ALSO\n" + also.replace(" (1),", " (1),") + "\n")


def main(bmt, version, folder):
    os.makedirs(folder, exist_ok=True)
    pages = help.read_all(bmt)
    names = ["-".join(("bmt",) + command) for command in pages]
    for command, page in pages.items():
        with open(os.path.join(folder, "-".join(("bmt",) + command) + ".1"), "w", encoding="utf-8") as file:
            write_page(file, version, command, page, names)


if __name__ == "__main__":
    main(*sys.argv[1:])
