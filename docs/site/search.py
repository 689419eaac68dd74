# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""search.py <site>: of the pages that mkdocs has made, those that guide come first in the search.

A page's weight stands in the index of the search, where later releases of mkdocs-material put it, too. Debian's does
not read it, so that its reader of the index is changed in the one place where it takes a page in.
"""

import json
import pathlib
import re
import sys

# What a reader looks for with a word of a message or of a task, before what the reference and the measurements say of it
WEIGHT = 4
GUIDES = re.compile(r"docs/(troubleshooting|choosing|liggghtsCoupling|quickJet|tutorial\w*)\.html")
TAKES_IN = re.compile(r"(?<=this\.add\()(\w+)(?=\))")


def main(site):
    index = site / "search/search_index.json"
    content = json.loads(index.read_text())
    weighed = 0
    for entry in content["docs"]:
        if GUIDES.match(entry["location"]):
            entry["boost"] = WEIGHT
            weighed += 1
    index.write_text(json.dumps(content, separators=(",", ":")))
    readers = list(site.glob("assets/javascripts/workers/search.*.js"))
    texts = [reader.read_text() for reader in readers]
    known = sum(len(re.findall(r"this\.add\(\w+,\{boost:", text)) for text in texts)
    for reader, text in zip(readers, texts):
        text, changed = TAKES_IN.subn(r"\1,{boost:\1.boost||1}", text)
        known += changed
        reader.write_text(text)
    if not weighed or known != 1:
        # the pages are whole without it
        print("search.py: the search of this release of mkdocs-material is not known: no page is put first", file=sys.stderr)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
