# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""pages.py <Grainjet> <folder>: copies the Markdown pages with their pictures and writes mkdocs.yml beside them.

The pages are written for a Git host. For mkdocs, README.md becomes index.md, links to files that are no pages become
plain text, and a list or table has an empty line before it. Formulas between $ or $$ are set by KaTeX, which is copied
from the system, so that the pages need no connection.
"""

import json
import pathlib
import re
import shutil
import sys

# The reader's questions. Every page stands here once; a page that does not is an error
NAVIGATION = [
    ("Start", ["README.md", "docs/installing.md", "docs/building.md", "docs/quickJet.md", "docs/tutorial.md",
               "docs/troubleshooting.md"]),
    ("Tutorials", ["docs/tutorial_*.md"]),
    ("Drop into my case", ["docs/loader.md", "docs/fix_hertz_cg.md", "docs/coarsegraining.md", "docs/stock_commands.md",
                           "docs/liggghtsCoupling.md", "docs/fix_fluid_force.md", "docs/fix_fluid_heat.md", "docs/fix_grain_motion.md",
                           "docs/fix_plate_stats.md", "docs/fix_surface_stats.md", "docs/fix_collision_stats.md",
                           "docs/fix_wall_roughness.md", "docs/jetKEpsilon.md", "docs/particleSamplingPlanes.md"]),
    ("Choose", ["docs/choosing.md", "docs/comparison.md"]),
    ("Models", ["docs/what_grains_feel.md", "docs/errata.md"]),
    ("Cases", ["cases/README.md", "docs/gallery.md", "docs/fluidBed.md", "docs/waterJet.md", "docs/sandblast.md", "docs/elbow.md",
               "docs/coldSpray.md", "docs/jetMill.md"]),
    ("Theory", ["docs/theory-*.md"]),
    ("Validation", ["validation/README.md", "validation/**/*.md"]),
    ("Extend", ["docs/new_model.md", "docs/contributing.md"]),
    ("Releases", ["docs/CHANGELOG.md"]),
]
CONFIGURATION = """\
site_name: Grainjet
site_description: Coarse-grained CFD-DEM for particle-laden jets, in stock LIGGGHTS and stock OpenFOAM
docs_dir: pages
use_directory_urls: false
theme:
  name: material
  font: false
  features: [navigation.tabs, navigation.top, search.highlight]
plugins: [search]
extra_css: [katex/katex.min.css, grainjet.css]
extra_javascript: [katex/katex.min.js, formulas.js]
markdown_extensions:
  - tables
  - sane_lists
  - pymdownx.superfences
  - pymdownx.highlight
  - pymdownx.arithmatex:
      generic: true
  - toc:
      permalink: true
      slugify: !!python/object/apply:pymdownx.slugs.slugify {kwds: {case: lower}}
nav:
"""
STYLE = """\
.md-grid { max-width: 76rem; }
.md-typeset table:not([class]) { font-size: .68rem; }
.md-typeset table:not([class]) th, .md-typeset table:not([class]) td { padding: .4em .7em; min-width: 3rem; }
.md-typeset td code { word-break: normal; overflow-wrap: normal; }
.md-typeset img { max-height: 40rem; }
div.arithmatex { overflow-x: auto; overflow-y: hidden; }
.katex { position: relative; }
.md-typeset :is(h1, h2, h3) { overflow-wrap: anywhere; }
"""
# arithmatex writes a formula as text between \( and \), or \[ and \]
FORMULAS = """\
for (const formula of document.querySelectorAll(".arithmatex"))
  katex.render(formula.textContent.trim().slice(2, -2), formula, {displayMode: formula.tagName === "DIV", throwOnError: false});
"""
KATEX = pathlib.Path("/usr/share/javascript/katex")
FENCE = re.compile(r"(?ms)(^[ \t]*```.*?^[ \t]*```[ \t]*$)")
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")
ITEM = re.compile(r"[-*] |\d+\. ")


def named(pattern, root):
    """A pattern's pages, the folder's README first."""
    return sorted((str(path.relative_to(root)) for path in root.glob(pattern) if "runs" not in path.parts),
                  key=lambda name: (name.rpartition("/")[0], not name.endswith("README.md"), name))


def navigation(root):
    """[(section, pages)], each page once."""
    taken, sections = set(), []
    for section, patterns in NAVIGATION:
        pages = []
        for pattern in patterns:
            found = named(pattern, root)
            if not found:
                sys.exit(f"pages.py: there is no page {pattern}")
            pages += [name for name in found if name not in taken]
            taken.update(found)
        sections.append((section, pages))
    lost = set(named("docs/*.md", root)) - taken
    if lost:
        sys.exit(f"pages.py: give a place in the navigation to {', '.join(sorted(lost))}")
    return sections


def place(name):
    return "index.md" if name == "README.md" else name


def linked(text, page, pages, root, pictures):
    """A text with its links for the site; notes its pictures."""
    def changed(match):
        picture, words, target = match.groups()
        if re.match(r"[a-z]+:|#", target):
            return match[0]
        name, _, fragment = target.partition("#")
        there = (page.parent / name).resolve()
        if there.is_dir() and (there / "README.md").is_file():
            there, name = there / "README.md", f"{name.rstrip('/')}/README.md"
        relative = str(there.relative_to(root))
        if picture:
            pictures.add(relative)
            return match[0]
        if relative not in pages:
            return words
        if relative == "README.md":
            name = name.replace("README.md", "index.md")
        return f"[{words}]({name}{'#' + fragment if fragment else ''})"
    return LINK.sub(changed, text)


def spaced(text):
    """A text with an empty line before each list and table, but in code and formulas."""
    lines, code = [], False
    for line in text.splitlines():
        if line.lstrip().startswith("```") or line == "$$":
            code = not code
        before = lines[-1] if lines else ""
        starts = (ITEM.match(line) and not before.startswith((" ", "- ", "* ")) and not ITEM.match(before)
                  or line.startswith("|") and not before.startswith("|"))
        if not code and before and starts:
            lines.append("")
        lines.append(line)
    return "\n".join(lines) + "\n"


def main(root, folder):
    sections = navigation(root)
    pages = {name for _, names in sections for name in names}
    pictures = set()
    nav = ""
    for section, names in sections:
        nav += f"  - {section}:\n"
        for name in names:
            page = root / name
            text = page.read_text()
            # links stand between pieces of code, and around spans of it
            parts = FENCE.split(text)
            text = "".join(part if i % 2 else linked(part, page, pages, root, pictures) for i, part in enumerate(parts))
            there = folder / "pages" / place(name)
            there.parent.mkdir(parents=True, exist_ok=True)
            there.write_text(spaced(text))
            title = re.search(r"(?m)^# (.*)$", text)[1].replace("`", "")
            nav += f"    - {json.dumps(title)}: {place(name)}\n"
    for name in pictures:
        there = folder / "pages" / name
        there.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(root / name, there)
    (folder / "pages/grainjet.css").write_text(STYLE)
    (folder / "pages/formulas.js").write_text(FORMULAS)
    for name in ("katex.min.js", "katex.min.css", *(f"fonts/{font.name}" for font in (KATEX / "fonts").glob("*.woff2"))):
        there = folder / "pages/katex" / name
        there.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(KATEX / name, there)
    (folder / "mkdocs.yml").write_text(CONFIGURATION + nav)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]))
