"""Comparison of two .csg texts, of openscad 2021.01 and of csgscope, node by node and token by token.

The texts are equal where numbers differ by noise (1e-5, absolute or relative: they are printed with six digits), where
one side prints an argument of a node that the other leaves out because it has its default, and where they put the same
nodes into other groups: since 2021.01 children(i), if and let make groups where they did not, and the other way around.
What counts for the result stays: which nodes are one operand of a difference, an intersection or a Minkowski sum.
"""
import re

NODE = re.compile(r"([%#!*]*[A-Za-z_]\w*)\((.*)\)$", re.DOTALL)
MODIFIED = re.compile(r"^([%#!*]+)\t+")  # Of 2021.01, which puts modifiers before the indentation.
TOKEN = re.compile(r'"(?:[^"\\]|\\.)*"|[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?|-?[A-Za-z_$][\w$]*|\S')
NUMBER = re.compile(r"[-+]?\d")
SPECIALS = {"$fn": None, "$fa": None, "$fs": None}  # None: whatever it is.
# What is printed by one of the two versions only, and its default.
DEFAULTS = {
    "linear_extrude": {"center": "false", "convexity": "1", "scale": "[1, 1]", "slices": None, "twist": "0", **SPECIALS},
    "rotate_extrude": {"start": None},
    "import": {"layer": '""', "center": "false"},
}
OPERATIONS = {"difference()", "intersection()", "minkowski(convexity = 0)"}
SAME = {("halign", '"left"', '"default"'), ("valign", '"baseline"', '"default"'), ("script", '"Lati"', '"Latn"')}


def arguments(text):
    """Pairs of name and value, values as texts; commas within brackets and strings part nothing."""
    found, depth, start = [], 0, 0
    for match in TOKEN.finditer(text + ","):
        token = match.group()
        depth += (token in "([") - (token in ")]")
        if token == "," and depth == 0:
            name, _, value = text[start : match.start()].partition("=")
            found.append((name.strip(), value.strip()))
            start = match.end()
    return [pair for pair in found if pair != ("", "")]


def equal_tokens(a, b):
    a, b = TOKEN.findall(a), TOKEN.findall(b)
    return len(a) == len(b) and all(map(equal_token, a, b))


def equal_token(a, b):
    if a == b or (a.lstrip("-") == b.lstrip("-") == "nan"):
        return True
    if not (NUMBER.match(a) and NUMBER.match(b)):
        return False
    x, y = float(a), float(b)
    return abs(x - y) <= 1e-5 * max(1, abs(x), abs(y))


def equal_values(name, a, b):
    if name == "file":  # Relative to the program there, to the output here.
        return a.rsplit("/", 1)[-1] == b.rsplit("/", 1)[-1]
    if (name, a, b) in SAME or equal_tokens(a, b):
        return True
    return name == "scale" and equal_tokens(a, f"[{b}, {b}]")


def equal_heads(theirs, ours):
    if theirs == ours or equal_tokens(theirs, ours):
        return True
    a, b = NODE.match(theirs), NODE.match(ours)
    if not (a and b) or a.group(1) != b.group(1):
        return False
    defaults = DEFAULTS.get(a.group(1).lstrip("%#!*"), {})
    x, y = dict(arguments(a.group(2))), dict(arguments(b.group(2)))
    for name in x.keys() | y.keys():
        if name in x and name in y:
            if not equal_values(name, x[name], y[name]):
                return False
        elif name not in defaults or (defaults[name] is not None and not equal_tokens(x.get(name, y.get(name)), defaults[name])):
            return False
    return True


def nodes(text):
    """Pairs of depth and head, such as (1, "cube(size = …)"), groups dissolved and empty ones left out."""
    root = ["", []]
    stack = [root]
    for line in text.split("\n"):
        line = MODIFIED.sub(r"\1", line.strip())
        if line == "}":
            close(stack)
        elif line.endswith("{"):
            stack.append([line[:-1].rstrip(), []])
        elif line:
            stack.append([line.rstrip(";"), []])
            close(stack)
    found, waiting = [], [(0, root)]
    while waiting:
        depth, (head, children) = waiting.pop()
        found.append((depth, head))
        waiting.extend((depth + 1, child) for child in reversed(children))
    return found


def close(stack):
    """Ends the last node of the stack: it becomes a child of the one before it."""
    node = stack.pop()
    parent = stack[-1]
    if node[0] != "group()":
        parent[1].append(node)
    elif parent[0].lstrip("%#!*") in OPERATIONS and len(node[1]) != 1:  # One that is empty is an operand, too.
        parent[1].append(node)
    else:
        parent[1].extend(node[1])


def place(a, b):
    """Of two heads: the parts about the first token that differs."""
    x, y = list(TOKEN.finditer(a)), list(TOKEN.finditer(b))
    at = next((i for i, (s, t) in enumerate(zip(x, y)) if not equal_token(s.group(), t.group())), 0)
    cut = lambda text, tokens: text if len(text) < 200 else "… " + text[tokens[max(at - 9, 0)].start() :][:150] + " …"
    return cut(a, x), cut(b, y)


def difference(theirs, ours):
    """None where the texts are equal; or (number of the first node that differs, theirs, ours)."""
    if theirs == ours:
        return None
    a, b = nodes(theirs), nodes(ours)
    for number, ((depth, x), (other, y)) in enumerate(zip(a, b)):
        if depth != other or not equal_heads(x, y):
            return number, *place(x, y)
    if len(a) != len(b):
        number = min(len(a), len(b))
        end = (0, "(end)")
        return number, (a[number:] + [end])[0][1][:150], (b[number:] + [end])[0][1][:150]
    return None
