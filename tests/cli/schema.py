# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds records to schemas of phspline, with the validator jsonschema.

    schema.py SCHEMA PART... <TABLE

Each PART is a schema of one command, whose definitions must be those of the
SCHEMA.

A line of the table is, with tabs between its parts,

    good DEFINITION FILE              every record of the file is valid
    bad DEFINITION FILE PATH VALUE    its first record is valid, but not if the
                                      part at the path is set to the JSON VALUE,
                                      or removed where VALUE is -

by #/$defs/DEFINITION.  A path is names and indices with / between them; a name that is not there is added.
Prints for each line ok, or not ok with a reason.
"""

import copy
import json
import sys

from jsonschema import Draft202012Validator
from jsonschema.exceptions import best_match


def records(path):
    """The values of a file, one after another, an array as its elements."""
    text = open(path, encoding="utf-8").read()
    decoder = json.JSONDecoder()
    at = 0
    while True:
        while at < len(text) and text[at] in " \t\r\n\ufeff":
            at += 1
        if at == len(text):
            return
        value, at = decoder.raw_decode(text, at)
        yield from value if isinstance(value, list) else [value]


def tampered(record, path, value):
    record = copy.deepcopy(record)
    *before, last = [int(p) if p.isdigit() else p for p in path.split("/")]
    node = record
    for part in before:
        node = node[part]
    if value == "-":
        del node[last]
    elif isinstance(node, list) and last == len(node):
        node.append(json.loads(value))
    else:
        node[last] = json.loads(value)
    return record


class Judge:
    def __init__(self, path, parts):
        self.definitions = self.read(path)["$defs"]
        self.found = {}  # validator of each definition
        self.first = {}  # record, and its error, of each definition and file
        for part in parts:
            for name, definition in self.read(part)["$defs"].items():
                if name not in ("problem", "result"):
                    assert definition == self.definitions[name], (part, name)

    @staticmethod
    def read(path):
        schema = json.load(open(path, encoding="utf-8"))
        Draft202012Validator.check_schema(schema)
        return schema

    def validator(self, name):
        if name not in self.found:
            self.found[name] = Draft202012Validator(
                {"$defs": self.definitions, "$ref": "#/$defs/" + name})
        return self.found[name]

    def error(self, name, record):
        error = best_match(self.validator(name).iter_errors(record))
        if not error:
            return None
        where = "/".join(map(str, error.absolute_path))
        return f"{where}: {error.message[:300]}"

    def good(self, name, path):
        n = 0
        for n, record in enumerate(records(path), 1):
            error = self.error(name, record)
            if error:
                return f"record {n}: {error}"
        return None if n else "no records"

    def bad(self, name, path, part, value):
        if (name, path) not in self.first:
            record = next(records(path))
            self.first[name, path] = record, self.error(name, record)
        record, error = self.first[name, path]
        if error:
            return f"before: {error}"
        if self.validator(name).is_valid(tampered(record, part, value)):
            return "is valid"
        return None


def main():
    judge = Judge(sys.argv[1], sys.argv[2:])
    for line in sys.stdin:
        kind, *rest = line.rstrip("\n").split("\t")
        why = getattr(judge, kind)(*rest)
        label = " ".join([kind, *rest])
        print(f"not ok {label}: {why}" if why else f"ok {label}")


main()
