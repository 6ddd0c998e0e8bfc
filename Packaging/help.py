# SPDX-License-Identifier: BSD-3-Clause
"""What bmt --help and bmt COMMAND --help say, as data."""
import re
import subprocess
from typing import NamedTuple


class Option(NamedTuple):
    """An option: its names, what it takes ("" for a flag) and what it does."""

    names: list
    takes: str
    text: str


class Page(NamedTuple):
    """A help text: of the program or of one of its commands."""

    text: str
    usage: str
    options: list
    positionals: list
    commands: list  # (name, text)
    notes: str


ENTRY = re.compile(r"^  (\S.*?)(?:  +(\S.*))?$")


def read_entries(lines):
    """(heading, text) of lines such as "  -o,--output TEXT REQUIRED   The file", of which the text may be on the next."""
    entries = []
    for line in lines:
        if re.match(r"^  \S", line):
            heading, text = ENTRY.match(line).groups()
            entries.append([heading, text or ""])
        elif entries and line.startswith("      "):
            entries[-1][1] = (entries[-1][1] + " " + line.strip()).strip()
    return [tuple(entry) for entry in entries]


def read_page(bmt, *command):
    output = subprocess.run([bmt, *command, "--help"], capture_output=True, text=True, check=True).stdout
    sections = {"": []}
    section = ""
    for line in output.splitlines():
        if re.match(r"^[A-Z][a-z]+:$", line):
            section = line[:-1]
            sections[section] = []
        elif section and not line.startswith("  ") and line:
            section = "notes"
            sections.setdefault(section, []).append(line)
        else:
            sections[section].append(line)
    text, usage = sections[""][0], next(line for line in sections[""] if line.startswith("Usage:"))
    options = []
    for heading, what in read_entries(sections.get("Options", [])):
        names, _, takes = heading.partition(" ")
        options.append(Option(names.split(","), takes, what))
    return Page(
        text, usage[len("Usage: "):], options, read_entries(sections.get("Positionals", [])),
        read_entries(sections.get("Subcommands", [])), "\n".join(sections.get("notes", [])))


def read_all(bmt):
    """{(): page of the program, ("build",): page of bmt build, ...}"""
    pages = {(): read_page(bmt)}
    for name, _ in pages[()].commands:
        pages[(name,)] = read_page(bmt, name)
    return pages


def get_choices(takes):
    """The words that an option takes: of "TEXT:{v,regular}=v" v and regular."""
    match = re.search(r"\{([^}]*)\}", takes)
    return [word.split("->")[0] for word in match[1].split(",")] if match else []
