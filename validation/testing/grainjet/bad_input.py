# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad inputs made from a table of entries, for any program.

A test writes down what it knows of each entry (its kind and a good value) and gets the ways to
spoil it: missing, misspelt, empty, twice, of a wrong type, negative, zero, not a number, huge. A new
entry is covered by one new line of the table.

    ENTRIES = {
        "couplingInterval": Entry("count", "10", required=True),
        "minimum": Entry("fraction", "0.3"),
        "drag": Entry("choice", "Gidaspow"),
    }
    for bad in spoil(ENTRIES):
        text = "".join(f"{key} {value};" for key, value in bad.replace(ENTRIES))
        ...run, and look at bad.must_fail...

`must_fail` is False where the text may be accepted (an optional entry left out, a huge length): the
run may then end well or with a clear error, but never by a signal or a hang.
"""

from typing import List, NamedTuple, Optional, Tuple


class Entry(NamedTuple):
    """One entry of an input: what it may hold, and a value with which the input works."""
    kind: str                       # a name of KINDS
    good: str                       # a good value, as text
    required: bool = False          # is leaving it out an error?


class Bad(NamedTuple):
    """One way to spoil an entry: these lines take the place of the good one."""
    entry: str                      # the name of the entry
    what: str                       # what is wrong, for the test's messages
    lines: Tuple[Tuple[str, str], ...]   # (key, value); none: the entry is missing
    must_fail: bool = True

    def replace(self, entries) -> List[Tuple[str, str]]:
        """All lines (key, value) of the input: the good ones, but for the spoilt entry."""
        result = []
        for key, entry in entries.items():
            result += self.lines if key == self.entry else [(key, entry.good)]
        return result


_NO_NUMBER = [("a word", "abc"), ("not a number", "nan"), ("infinite", "inf"), ("two values", "1 2")]
_HUGE = ("huge", "1e300")

# what is wrong, text, and whether it must be refused (if not said: yes)
KINDS = {
    # a whole number from 1 on
    "count": [*_NO_NUMBER, ("zero", "0"), ("negative", "-1"), ("broken", "2.5"), _HUGE,
              ("beyond 32 bits", "99999999999"), ("a thousand million", "1000000000")],
    # a whole number from 0 on
    "countOrNone": [*_NO_NUMBER, ("negative", "-1"), ("broken", "2.5"), _HUGE,
                    ("beyond 32 bits", "99999999999"), ("a thousand million", "1000000000", False)],
    # a number larger than zero
    "positive": [*_NO_NUMBER, ("zero", "0"), ("negative", "-1"), _HUGE, ("minus huge", "-1e300")],
    # a number that is not negative
    "nonNegative": [*_NO_NUMBER, ("negative", "-1"), _HUGE, ("minus huge", "-1e300")],
    # any number
    "number": [*_NO_NUMBER, _HUGE, ("minus huge", "-1e300")],
    # a number between 0 and 1, neither of both
    "fraction": [*_NO_NUMBER, ("zero", "0"), ("negative", "-1"), ("one", "1"), ("above one", "1.5"), _HUGE],
    # one of some words
    "choice": [("another word", "noSuchWord"), ("a number", "1"), ("two values", "one two"),
               ("an empty string", '""'), ("a path", '"a/b"')],
    # yes or no
    "switch": [("another word", "perhaps"), ("a number", "7.5")],
    # the name of something that the program has, such as a field
    "name": [("another name", "noSuchName"), ("a number", "1"), ("two values", "one two")],
    # a file that must exist
    "file": [("not there", '"no/such.file"'), ("with a blank", '"no such file"'), ("a folder", '"."'), ("an empty string", '""')],
    # a file that is written
    "output": [("in a missing folder", '"no/such/folder/file"'), ("a folder", '"."'), ("an empty string", '""')],
}


def misspelt(key: str) -> str:
    """A key with its last two letters swapped, or with one more letter where they are the same."""
    swapped = key[:-2] + key[-1] + key[-2] if len(key) > 2 else key
    return swapped if swapped != key else key + "x"


def values(kind: str) -> List[Tuple[str, str, bool]]:
    """The bad values of a kind: (what is wrong, text, must it be refused)."""
    return [(item[0], item[1], item[2] if len(item) > 2 else True) for item in KINDS[kind]]


def spoil(entries, kinds: Optional[dict] = None) -> List[Bad]:
    """All ways to spoil a table {name: Entry}; `kinds` adds kinds of the test's own,
    {kind: [(what, text[, must_fail])]}."""
    result = []
    for key, entry in entries.items():
        ways = (kinds or {}).get(entry.kind) or KINDS[entry.kind]
        result.append(Bad(key, "missing", (), entry.required))
        result.append(Bad(key, "misspelt", ((misspelt(key), entry.good),)))
        result.append(Bad(key, "no value", ((key, ""),)))
        result.append(Bad(key, "twice", ((key, entry.good), (key, entry.good))))
        for way in ways:
            result.append(Bad(key, way[0], ((key, way[1]),), way[2] if len(way) > 2 else True))
    return result
