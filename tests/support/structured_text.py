"""Runs a function block of Structured Text, SCL or PLCopen XML: python3 structured_text.py FILE BLOCK < lines of numbers.

A small interpreter that shares nothing with the exporter: assignments, IF, FOR, RETURN, calls, LREAL and INT. A line of input holds the
inputs of the block one after the other; a line of output its first output, or nothing where `valid` is FALSE. A block without
`valid` gives all outputs.
"""
import functools
import math
import re
import sys
import xml.etree.ElementTree as ElementTree


def copied(value):
    return [copied(v) for v in value] if isinstance(value, list) else value


FUNCTIONS = {"SIN": math.sin, "COS": math.cos, "ATAN": math.atan, "SQRT": math.sqrt, "ABS": abs, "MIN": min, "MAX": max, "copied": copied}


def expression(text):
    text = re.sub(r"\[([^\[\],]+), ([^\[\]]+)\]", r"[\1][\2]", text)
    text = text.replace("<>", "!=").replace(" AND ", " and ").replace(" OR ", " or ").replace("NOT ", "not ")
    text = re.sub(r"(?<![:<>!])=", "==", text).replace(":=", "=")
    return text.replace("TRUE", "True").replace("FALSE", "False")


def python(body, names):
    """The statements as a Python function of the values of the variables: one statement ends with THEN, ELSE, DO or a semicolon."""
    out = ["def body(values):"] + [f"  {name} = values.get('{name}')" for name in names] + ["  try:"]
    depth = 2
    for statement in re.findall(r"(?:[^;]*?\b(?:THEN|ELSE|DO)\b)|(?:[^;]*;)", body):
        text = " ".join(statement.split())
        if match := re.fullmatch(r"(IF|ELSIF) (.*) THEN", text):
            depth -= match[1] == "ELSIF"
            out.append("  " * depth + ("if " if match[1] == "IF" else "elif ") + expression(match[2]) + ":")
            depth += 1
        elif text == "ELSE":
            out.append("  " * (depth - 1) + "else:")
        elif match := re.fullmatch(r"FOR (\w+) := (.*) TO (.*) DO", text):
            out.append("  " * depth + f"for {match[1]} in range({expression(match[2])}, {expression(match[3])} + 1):")
            depth += 1
        elif text in ("END_IF;", "END_FOR;"):
            depth -= 1
        elif text == "RETURN;":
            out.append("  " * depth + "return")
        elif match := re.fullmatch(r"([\w\[\], +*]+?) := (.*);", text):
            # an array is copied where it is named; an operator gives a number
            array = re.fullmatch(r"[\w\[\], .+*]+", match[2]) and not re.fullmatch(r"[\d.]+", match[2])
            value = expression(match[2])
            out.append("  " * depth + f"{expression(match[1])} = " + (f"copied({value})" if array else value))
        elif match := re.fullmatch(r"(\w+\(.*\));", text):
            out.append("  " * depth + expression(match[1]))
        else:
            raise SyntaxError(text)
    assert depth == 2
    out += ["  finally:", f"    values.update({', '.join(f'{name}={name}' for name in names)})"]
    scope = {}
    exec("\n".join(out), FUNCTIONS, scope)
    return scope["body"]


class Unit:
    """A function or function block: lists of declarations and statements."""

    def __init__(self, name, lists, body):
        self.name, self.lists, self.text = name, lists, body

    @functools.cached_property
    def body(self):
        """The statements, translated when they are first run: most files have units that a test does not call."""
        names = [variable for declared in self.lists.values() for variable, _ in declared]
        return python(self.text, names + [self.name])

    def instance(self, all_units):
        values = {}
        for name, kind in [v for declared in self.lists.values() for v in declared]:
            if sizes := re.findall(r"0\.\.(\d+)", kind):
                value = 0.0
                for size in reversed(sizes):
                    value = [copied(value) for _ in range(int(size) + 1)]
                values[name] = value
            else:
                values[name] = Block(all_units[kind], all_units) if kind in all_units else 0.0
        return values


class Block:
    def __init__(self, unit, all_units):
        self.unit, self.values, self.all = unit, unit.instance(all_units), all_units

    def __call__(self, **inputs):
        self.values.update((name, copied(value)) for name, value in inputs.items())
        self.unit.body(self.values)

    def __getattr__(self, name):
        return self.values[name]


def function(unit):
    def call(**inputs):
        values = dict(inputs)
        unit.body(values)
        return values[unit.name]

    return call


def of_text(text):
    siemens = "LReal" in text
    text = re.sub(r"\(\*.*?\*\)|//[^\n]*", " ", text, flags=re.S).replace('"', "")
    text = re.sub(r"DATA_BLOCK.*?END_DATA_BLOCK", "", text, flags=re.S)
    for word, name, inside in re.findall(r"\b(FUNCTION|FUNCTION_BLOCK) (\w+)(.*?)\bEND_\1\b(?!_)", text, flags=re.S):
        declared = re.findall(r"(VAR\w*)\n(.*?)END_VAR\n", inside, flags=re.S)
        lists = {kind: re.findall(r"(\w+) : ([^;]+);", lines) for kind, lines in declared}
        body = inside.rsplit("END_VAR\n", 1)[1].removeprefix("BEGIN\n")
        # SCL: every variable has a mark, but those that a call names
        own = re.sub(r"(\(|, )\w+ := ", r"\1", body)
        for variable in [name for names in lists.values() for name, _ in names] * siemens:
            assert not re.search(rf"(?<![#.\w]){variable}\b", own), variable
        body = body.replace("#", "")
        yield word, Unit(name, lists, body.strip())


def of_xml(root):
    space = "{http://www.plcopen.org/xml/tc6_0200}"
    for pou in root.iter(space + "pou"):
        lists = {}
        for words in pou.find(space + "interface"):
            for variable in words.findall(space + "variable"):
                kind = variable.find(space + "type")[0]
                ranges = [f"0..{d.get('upper')}" for d in kind.iter(space + "dimension")]
                lists.setdefault(words.tag.removeprefix(space), []).append(
                    (variable.get("name"), kind.get("name") or ",".join(ranges) or kind.tag)
                )
        body = pou.find(f"{space}body/{space}ST/{{http://www.w3.org/1999/xhtml}}xhtml").text
        order = [("VAR_INPUT", "inputVars"), ("VAR_OUTPUT", "outputVars"), ("VAR", "localVars")]
        kind = "FUNCTION" if pou.get("pouType") == "function" else "FUNCTION_BLOCK"
        yield kind, Unit(pou.get("name"), {to: lists[name] for to, name in order if name in lists}, body.strip())


def main():
    file, block = sys.argv[1:]
    text = open(file, encoding="utf-8").read()
    units = list(of_xml(ElementTree.fromstring(text.encode())) if text.startswith("<?xml") else of_text(text))
    FUNCTIONS.update((unit.name, function(unit)) for kind, unit in units if kind == "FUNCTION")
    blocks = {unit.name: unit for kind, unit in units if kind == "FUNCTION_BLOCK"}
    instance = Block(blocks[block], blocks)
    inputs = [(name, int(re.search(r"0\.\.(\d+)", kind)[1]) + 1) for name, kind in instance.unit.lists["VAR_INPUT"]]
    for line in sys.stdin:
        numbers = [float(v) for v in line.split()]
        given = {}
        for name, count in inputs:
            given[name], numbers = numbers[:count], numbers[count:]
        assert not numbers
        instance(**given)
        outputs = [name for name, _ in instance.unit.lists["VAR_OUTPUT"]]
        if "valid" in outputs:
            print(*map(repr, getattr(instance, outputs[0]))) if instance.valid else print()
        else:
            values = [getattr(instance, name) for name in outputs]
            print(*(repr(v) for value in values for v in (value if isinstance(value, list) else [value])))


main()
