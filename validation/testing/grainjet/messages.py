# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Grainjet's programs say to a user when something is wrong, read from their sources.

A message is the text of one statement: its string literals joined, with the mark HOLE where the program puts
something in.
"""

import ast
import re
from typing import Iterator, NamedTuple

import grainjet

HOLE = "\0"
WORDS = 4

TOKEN = re.compile(r"""
    (?P<comment> //[^\n]* | /\*.*?\*/ )
  | (?P<directive> ^[ \t]*\#[ \t]*(?:include|if|ifdef|ifndef|else|endif|undef|pragma)[^\n]* )
  | (?P<string> R"\((?P<raw>.*?)\)" | "(?:\\.|[^"\\\n])*" )
  | (?P<character> '(?:\\.|[^'\\\n])' )
  | (?P<end> [;{}] )
  | (?P<code> \w+ | . | \n )
""", re.S | re.M | re.X)

# Statements of C++ whose text is printed in a log or a file, is a name in a table, says what an argument is (errors
# about it have a text of their own), or is for the compiler of Grainjet's own sources
QUIET = re.compile(r"^(?:Info|Log|os|Pout)\s*<<|^writeHeader|\.means\(|reinterpret_cast<void|\bfprintf ?\(out|print\(lmp"
                   r"|^(?!.*fail).*\b(?:in|arguments)\.\w+ ?\(|TypeName"
                   r"|^static_assert ?\((?:sizeof|is_contiguous|tetBatch)")
# The same of texts: headers and bodies of tables and of files for ParaView, remarks in logs
TABLES = re.compile(r"^\W*(?:#|r/D |time x/D|<\?xml|<VTKFile|<DataSet|<DataArray|</CellData|FIELD |CELL_DATA|energy \[J\])"
                    r"|solver PCG; preconditioner")


class Message(NamedTuple):
    file: str
    line: int
    text: str

    def is_sentence(self) -> bool:
        """Others are names, keywords and parts of tables, or so short that a reader does not look for them."""
        return (len(re.findall(r"[A-Za-z]{2,}", self.text)) >= WORDS
                and re.search(r"[A-Za-z]+,? [a-z]+ [a-z]+", self.text) is not None)


def joined(parts) -> str:
    """Strings and holes in one line, with single blanks."""
    text = re.sub(f"{HOLE}[{HOLE} ]*{HOLE}", HOLE, "".join(parts))
    return re.sub(r"\s+", " ", text).strip(f" {HOLE}")


def unescaped(literal: str) -> str:
    return re.sub(r"\\(.)", lambda match: {"n": " ", "t": " "}.get(match[1], match[1]), literal)


def of_cpp(source: str, file: str) -> Iterator[Message]:
    parts, code, line = [], "", 0
    for token in TOKEN.finditer(source):
        if token["comment"] or token["directive"]:
            continue
        if token["string"]:
            line = line or source.count("\n", 0, token.start()) + 1
            parts.append(unescaped(token["string"][1:-1]) if token["raw"] is None else token["raw"])
        elif token["character"]:
            parts.append(unescaped(token["character"][1:-1]))
        elif token["end"]:
            text = joined(parts)
            # coefficients of the laws of wear and what they mean
            described = code.strip() == "," and "/wear/" in file
            if text and not described and not QUIET.search(code.strip()) and not TABLES.search(text):
                yield Message(file, line, text)
            parts, code, line = [], "", 0
        else:
            code += token[0] if token[0] != "\n" else " "
            # FatalIOErrorInEntry(dict, "key") << ...: the key is no part of the message
            if token[0] == "<" and re.search(r"Fatal\w+\s*\([^<]*<$", code):
                parts.clear()
            if token[0] == "nl":
                parts.append(" ")
            elif not re.fullmatch(r"[\s<+()]", token[0]):
                parts.append(HOLE)


def of_shell(source: str, file: str) -> Iterator[Message]:
    """Arguments of fail and step, and what goes to the standard error."""
    source = re.sub(r"\\\n\s*", " ", source)
    for number, line in enumerate(source.splitlines(), 1):
        if line.lstrip().startswith("#") or not re.search(r"\b(?:fail|step) [\"\"]|>&2", line):
            continue
        quoted = re.findall(r'"((?:\\.|[^"\\])*)"', re.sub(r"\$\((?:[^()]|\([^()]*\))*\)", HOLE, line[max(line.find("fail "), 0):]))
        # `fail` has remedies behind its message, `step` a name and a log before it
        for text in quoted if re.search(r"\bstep \"", line) else quoted[:1]:
            text = joined([re.sub(r"\$(?:\w+|\{[^}]*\}|[*@#?])", HOLE, unescaped(text))])
            if text:
                yield Message(file, number, text)


def of_python(source: str, file: str) -> Iterator[Message]:
    """What is raised, given to sys.exit or printed to the standard error."""
    for node in ast.walk(ast.parse(source)):
        called = node.exc if isinstance(node, ast.Raise) else node
        if not isinstance(called, ast.Call):
            continue
        name = ast.unparse(called.func)
        if not (isinstance(node, ast.Raise) or name in ("sys.exit", "parser.error")
                or any(ast.unparse(keyword.value) == "sys.stderr" for keyword in called.keywords)):
            continue
        parts = []
        for part in ast.walk(ast.Tuple(elts=called.args)):
            if isinstance(part, ast.Constant) and isinstance(part.value, str):
                parts.append(part.value)
            elif isinstance(part, ast.FormattedValue):
                parts.append(HOLE)
        text = joined(parts)
        if text:
            yield Message(file, called.lineno, text)


def of_cmake(source: str, file: str) -> Iterator[Message]:
    for match in re.finditer(r'message\(\s*(?:FATAL_ERROR|WARNING)((?:\s*"(?:\\.|[^"\\])*")+)', source):
        text = joined([re.sub(r"\$\{\w+\}", HOLE, " ".join(re.findall(r'"((?:\\.|[^"\\])*)"', match[1])))])
        if text:
            yield Message(file, source.count("\n", 0, match.start()) + 1, text)


def of_file(path) -> Iterator[Message]:
    name = str(path.relative_to(grainjet.ROOT))
    if path.suffix in (".C", ".H", ".cpp", ".h"):
        return of_cpp(path.read_text(), name)
    if path.suffix == ".py":
        return of_python(path.read_text(), name)
    if path.suffix == ".cmake" or path.name == "CMakeLists.txt":
        return of_cmake(path.read_text(), name)
    if path.suffix not in ("", ".sh"):
        return iter(())
    text = path.read_text()
    if text.startswith("#!/usr/bin/python3"):
        return of_python(text, name)
    return of_shell(text, name) if text.startswith(("#!/bin/bash", "#!/bin/sh", "# ")) else iter(())
