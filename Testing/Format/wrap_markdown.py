#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fills the paragraphs of Markdown files to 120 columns; tables, code, images, headings and HTML stay as they are.

usage: wrap_markdown.py FILE...

check_language.py asks find_long_lines of this module which lines are too long.
"""
import re
import sys
import textwrap
from pathlib import Path

WIDTH = 120
ITEM = re.compile(r"^( *)([-*+]|\d+\.) +")
# What is no running text: tables, headings, quotes, HTML, images and definitions of links.
FIXED = re.compile(r"^ *(\||#|>|<|!\[|\[[^\]]+\]:)")
# What a line of a paragraph must not begin with, or it would be something else.
SPECIAL = re.compile(r"^ *([-*+] |\d+\. |#|>|\||=+$|-+$)")


def split_blocks(text):
    """(is running text, lines) in order; an item of a list is a block of its own."""
    blocks, paragraph = [], []
    in_fence = in_item = False

    def close():
        if paragraph:
            blocks.append((True, paragraph.copy()))
            paragraph.clear()

    for line in text.split("\n"):
        fence = line.lstrip().startswith("```")
        is_code = not paragraph and not in_item and line.startswith("    ")
        if fence or in_fence or not line.strip() or is_code or FIXED.match(line):
            close()
            in_fence = in_fence != fence
            in_item = in_item and not line.strip()
            blocks.append((False, [line]))
            continue
        if ITEM.match(line):
            close()
            in_item = True
        elif not paragraph:
            in_item = in_item and line.startswith(" ")
        paragraph.append(line)
    close()
    return blocks


def fill(lines):
    """The lines of one paragraph or item, anew."""
    item = ITEM.match(lines[0])
    first = item.group(0) if item else re.match(r" *", lines[0]).group(0)
    words = " ".join([lines[0][len(first):]] + [line.strip() for line in lines[1:]])
    for width in range(WIDTH, WIDTH - 40, -1):
        filled = textwrap.wrap(words, width, initial_indent=first, subsequent_indent=" " * len(first),
            break_long_words=False, break_on_hyphens=False)
        if not any(SPECIAL.match(line) for line in filled[1:]):
            return filled
    return lines


def wrap(text):
    return "\n".join(line for is_text, lines in split_blocks(text) for line in (fill(lines) if is_text else lines))


def find_long_lines(text):
    """Numbers of the lines of running text that are longer than WIDTH and could be broken."""
    found, number = [], 0
    for is_text, lines in split_blocks(text):
        for line in lines:
            number += 1
            if is_text and len(line) > WIDTH and " " in line.strip():
                found.append(number)
    return found


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    for name in sys.argv[1:]:
        file = Path(name)
        old = file.read_text(encoding="utf-8")
        new = wrap(old)
        if new != old:
            file.write_text(new, encoding="utf-8")
            print(name)
