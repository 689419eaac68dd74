# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The blocks of the pages, each checked by the program that it is for. A fault is a text that names page and line.

    liggghts    run for 0 steps by liggghts-plugins, behind the lines that it lacks to be a script. Behind the comment
                <!-- no run --> it is read only
    diff        of a script: once as it is without what is added, once without what is taken away
    foam        read by foamDictionary; see also docs/tests/case_block_foam.py
    sh          read by bash; its programs, its paths below the project and the options of the project's programs exist
    cpp, cmake, make    stands as it is in a source file
    python      compiled; run by the tests of the page
    text        what programs print, formulas, the syntax of commands
"""

import pathlib
import re
import shutil
from typing import NamedTuple

import grainjet
from grainjet import dictionaries, scripts

LANGUAGES = {"liggghts", "diff", "foam", "sh", "cpp", "cmake", "make", "python", "text"}
FENCE = re.compile(r"(?ms)^([ \t]*)```([^\n`]*)\n(.*?)^\1```[ \t]*$")



class Block(NamedTuple):
    page: str
    line: int
    mark: str           # of the comment in the line before
    language: str
    text: str

    @property
    def place(self):
        return f"{self.page}:{self.line}"


def pages():
    """The pages that people write: the one that a program writes is left out."""
    return [grainjet.ROOT / "README.md", grainjet.ROOT / "cases/README.md", *sorted((grainjet.ROOT / "docs").glob("*.md")),
            *sorted(path for path in (grainjet.ROOT / "validation").rglob("*.md") if path.name != "report.md")]


def of_text(text, page):
    found = []
    for match in FENCE.finditer(text):
        before = text[:match.start()].rstrip("\n").rpartition("\n")[2]
        mark = re.fullmatch(r"<!-- (.*) -->", before)
        body = re.sub(f"(?m)^{match[1]}", "", match[3])
        found.append(Block(page, text.count("\n", 0, match.start()) + 1, mark[1] if mark else "", match[2].strip(), body))
    return found


def of_pages():
    return [block for path in pages() for block in of_text(path.read_text(), str(path.relative_to(grainjet.ROOT)))]


# LIGGGHTS ------------------------------------------------------------------------------------------------------------

MATERIAL = {"youngsModulus": "peratomtype", "poissonsRatio": "peratomtype", "coefficientRestitution": "peratomtypepair",
            "coefficientFriction": "peratomtypepair", "coefficientRollingFriction": "peratomtypepair",
            "coefficientRollingViscousDamping": "peratomtypepair", "thermalCapacity": "peratomtype"}
VALUE = {"youngsModulus": 5e6, "poissonsRatio": 0.3, "thermalCapacity": 385}


def variant(text, sign):
    """A diff without the lines of one sign."""
    return "".join(line[1:] + "\n" if line[:1] in "+- " else line + "\n" for line in text.splitlines() if line[:1] != sign)


def script(block):
    """A block of commands with what it lacks to be a script."""
    code = re.sub(r"&\n", " ", re.sub(r"#[^\n]*", "", block))

    def has(pattern):
        return re.search(pattern, code, re.M)

    types = max([len(words.split()) for words in re.findall(r"\bperatomtype ([\d.e+\- ]+)", code)] or [1])
    head = re.findall(r"(?m)^processors .*$", code)
    rest = re.sub(r"(?m)^processors .*$", "", block)
    box = "" if has("^create_box") else f"region grainjet_box block -0.06 0.06 -0.06 0.06 0 0.15 units box\ncreate_box {types} grainjet_box\n"
    grain = "".join(f"create_atoms {kind} single 0.0 0.0 {kind}e-2 units box\n" for kind in range(1, types + 1))
    grain += "set group all diameter 1e-3 density 2500\n"
    material = ""
    for name, kind in MATERIAL.items():
        if not has(rf"property/global {name}\b"):
            value = VALUE.get(name, 0.5)
            values = " ".join([str(value)] * types) if kind == "peratomtype" else " ".join([str(types), *[str(value)] * types ** 2])
            material += f"fix grainjet_{name} all property/global {name} {kind} {values}\n"
    contact = "" if has(r"\bhertz/cg\b|^pair_style") else "plugin load hertzcgplugin.so\nfix grainjet_contact all hertz/cg\n"
    before = ("" if has(r"grain/motion.*gravity|\bfix \S+ all gravity") else "fix grainjet_gravity all gravity 9.81 vector 0 0 -1\n")
    if has(r"fluid/heat coupled") and not has("fluid/force coupled"):
        before += "plugin load fluidforceplugin.so\nfix grainjet_fluid all fluid/force coupled\n"
    if has("dump_modify ID"):
        before += "dump ID all custom 1000 ID.txt id x\n"
    after = "" if has(r"\bnve|grain/motion") else "fix grainjet_motion all nve/sphere\n"
    inside = box + grain + material + contact + before + rest + after
    if has("^create_box"):
        inside = rest + grain + material + contact + before + after
    return ("units si\nsoft_particles yes\natom_style granular\natom_modify map array sort 0 0\nboundary f f f\nnewton off\n"
            "communicate single vel yes\nneighbor 0.001 bin\ntimestep 1e-6\n" + "\n".join(head) + "\n" + inside)


def disc(radius=0.03, corners=16):
    """A surface in the plane z = 0."""
    from math import cos, pi, sin
    rim = [(radius * cos(2 * pi * i / corners), radius * sin(2 * pi * i / corners), 0.0) for i in range(corners)]
    return scripts.stl(*(((0.0, 0.0, 0.0), rim[i - 1], rim[i]) for i in range(corners)))


def faults_of_liggghts(block, folder):
    texts = [variant(block.text, sign) for sign in "+-"] if block.language == "diff" else [block.text]
    for text in texts:
        for name in re.findall(r"\bfile (\S+\.stl)", text):
            (folder / name).write_text(disc())
        (folder / "in.block").write_text(script(text) + ("" if block.mark == "no run" else "run 0\n"))
        ran = grainjet.run(["liggghts-plugins", "-in", "in.block", "-log", "none", "-var", "continued", "0", "-var", "restart", "none"],
                           folder, timeout=60)
        if ran.code or ran.errors:
            yield f"{block.place}: LIGGGHTS says\n{ran.output[-600:]}"


# OpenFOAM ------------------------------------------------------------------------------------------------------------

def _read_by_foam(texts, folder):
    path = folder / "blocks"
    dictionaries.write(path, "\n".join(f"block{i}\n{{\n{text}\n}}" for i, text in enumerate(texts)) + "\nend yes;\n")
    ran = grainjet.run(["foamDictionary", "-keywords", path], folder)
    names = re.findall(r"(?m)^(\w+)$", ran.output)
    good = not ran.code and names == ["FoamFile", *(f"block{i}" for i in range(len(texts))), "end"] and "Warning" not in ran.output
    return "" if good else ran.output[-600:]


def faults_of_foam(blocks, folder):
    """One process reads all; if it fails, one each tells which of them is wrong."""
    if not _read_by_foam([block.text for block in blocks], folder):
        return []
    alone = [(block, _read_by_foam([block.text], folder)) for block in blocks]
    return [f"{block.place}: foamDictionary says\n{said}" for block, said in alone if said] or ["the blocks of OpenFOAM together"]


# shell ---------------------------------------------------------------------------------------------------------------

# what a reader has elsewhere: other systems, the sources of LIGGGHTS, cases of the reader's own, what a package installs
ELSEWHERE = re.compile(r"^(apt|apt-get|tar|jet/|myModels/|\$GRAINJET_DIR\b|/usr/share/grainjet/)")
ROOMS = r"(?:cases|validation|openfoam-libs|liggghts-plugins|docs)/"


def commands(text):
    """(program, its words) of each command of a script, as plain as those of pages are."""
    text = re.sub(r"\\\n", " ", text)
    text = re.sub(r"'[^'\n]*'|\"[^\"\n]*\"", lambda quoted: quoted[0].replace(";", ",").replace("|", "/").replace("#", "_").replace(" ", "_"), text)
    for line in text.splitlines():
        line = re.sub(r"(^|\s)#.*", "", line)
        for part in re.split(r";|&&|\|", line):
            words = [word for word in part.split() if not re.match(r"[<>]", word)]
            while words and (re.match(r"\w+=", words[0]) or words[0] in ("do", "done", "then", "fi")):
                words = words[1:]
            if words and words[0] == "for":
                continue
            if words:
                yield words[0].strip('"'), words[1:]


def options_of(program):
    """The text of a program of the project and of what lies beside it, in which its options are looked for."""
    beside = [path for path in program.parent.glob("*.py")] if program.suffix == ".py" else []
    shared = list((grainjet.ROOT / "openfoam-libs/tools").glob("*.sh")) + list((grainjet.ROOT / "cases/common").glob("*"))
    return "".join(path.read_text() for path in {program, *beside, *shared} if path.is_file())


def faults_of_shell(block, folder):
    plain = re.sub(r"<([\w .-]+)>", "placeholder", block.text)
    (folder / "block.sh").write_text(plain)
    read = grainjet.run(["bash", "-n", "block.sh"], folder)
    if read.code:
        yield f"{block.place}: bash says\n{read.output}"
    for program, words in commands(plain):
        if ELSEWHERE.match(program):
            continue
        path = grainjet.ROOT / re.sub(r'^"?\$GRAINJET_DIR"?/', "", program)
        ours = "/" in program and not program.startswith("/usr")
        if program in ("source", "export", "set", "."):
            continue
        if program == "/usr/bin/python3" and words and words[0].endswith(".py"):
            path, ours = grainjet.ROOT / words[0], True
        if ours and not path.is_file():
            if not program.startswith('"') and "$" not in program and "placeholder" not in program:
                yield f"{block.place}: there is no {program}"
        elif not ours and not shutil.which(program, path=grainjet.ENV["PATH"]) and grainjet.run(["bash", "-c", f"type {program}"], folder).code:
            yield f"{block.place}: there is no program {program}"
        elif ours and words:
            text = options_of(path)
            for option in (re.split(r"[=\]]", word.lstrip("["))[0] for word in words if re.match(r"\[?--?[a-z]", word)):
                if not re.search(rf"{re.escape(option)}(?![\w-])|add_argument\([^)]*[\"']{re.escape(option)}[\"']", text):
                    yield f"{block.place}: {program} has no option {option}"
    for name in re.findall(rf"(?<![\w/.>$}}-])(?:\./)?({ROOMS}[\w/.-]*\w)", plain):
        if not (grainjet.ROOT / name).exists():
            yield f"{block.place}: there is no {name}"


# code ----------------------------------------------------------------------------------------------------------------

SUFFIXES = {"cpp": (".C", ".H", ".cpp", ".h"), "cmake": ("CMakeLists.txt",), "make": ("files", "options")}


def sources(language):
    return [path.read_text() for room in ("openfoam-libs", "liggghts-plugins") for path in (grainjet.ROOT / room).rglob("*")
            if path.name.endswith(SUFFIXES[language]) and path.is_file() and "lnInclude" not in path.parts]


def faults_of_code(blocks, language):
    texts = sources(language)
    return [f"{block.place}: no source has these lines" for block in blocks if not any(block.text in text for text in texts)]


def faults_of_python(block):
    try:
        compile(block.text, block.place, "exec")
    except SyntaxError as fault:
        yield f"{block.place}: {fault}"
