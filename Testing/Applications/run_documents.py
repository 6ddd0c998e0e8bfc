#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""run_documents.py BMT DOCUMENT...: runs the blocks ```sh of each document, word for word and in order, in a folder of its own;
every command must succeed, and every file that a command is to write must be there. Needs a display."""
import os
import re
import subprocess
import sys
import tempfile


def get_commands(document):
    with open(document, encoding="utf-8") as file:
        blocks = re.findall(r"^```sh\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
    return [line.split("  #")[0].strip() for block in blocks for line in block.splitlines() if line.strip()]


def run(bmt, document):
    """How many commands the document has, and how many failed."""
    commands = get_commands(document)
    environment = dict(os.environ, PATH=os.path.dirname(bmt) + os.pathsep + os.environ["PATH"])
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        for command in commands:
            done = subprocess.run(
                ["bash", "-euo", "pipefail", "-c", command], cwd=folder, env=environment, capture_output=True, text=True,
                check=False)
            outputs = re.findall(r" -o (\S+)", command)
            missing = [name for name in outputs if not os.path.exists(os.path.join(folder, name))]
            print("ok    " if done.returncode == 0 and not missing else "FAILED", command)
            if done.returncode != 0 or missing:
                print(done.stderr, "missing:", missing)
                wrong += 1
    print(f"{document}: {len(commands)} commands, {wrong} failed")
    return len(commands), wrong


def main(bmt, *documents):
    counts = [run(bmt, document) for document in documents]
    return 0 if all(commands > 0 and wrong == 0 for commands, wrong in counts) else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
