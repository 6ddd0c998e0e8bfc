# SPDX-License-Identifier: BSD-3-Clause
"""test_document.py DOCUMENT: runs the blocks of Python in a document, with the plugin and the model of the tests."""
import os
import re
import sys

from mtparaview import MODEL, check, figure, finish, plain, simple

with open(sys.argv[1], encoding="utf-8") as file:
    blocks = re.findall(r"^```python\n(.*?)^```", file.read(), re.MULTILINE | re.DOTALL)
check("The document has Python", len(blocks) > 0, len(blocks))
names = {}
for block in blocks:
    exec(block.replace("<folder>/MultiTriangulation.so", os.environ["MT_PLUGIN"]).replace("scan.bmt", MODEL), names)  # pylint: disable=exec-used
representation = plain(simple.GetDisplayProperties(names["reader"]))
check("and draws the model", figure(representation, "NumberOfTriangles") > 0, figure(representation, "NumberOfTriangles"))
finish()
