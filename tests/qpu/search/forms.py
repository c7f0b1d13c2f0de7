# SPDX-License-Identifier: MIT
"""Other ways to write a snippet that mean the same: statements and factors in another order.

What changes is rounding at most. Only simple lines are touched: declarations with a value, and assignments.
"""
import re

ASSIGNMENT = re.compile(r"^  (?:(?:float|vec[234]|Surface) )?([A-Za-z_]\w*)((?:\.\w+)?) ([-+*]?=) ([^;]*);(.*)$")
RETURN = re.compile(r"^  (return )([^;]*);(.*)$")
TOKEN = re.compile(r"\s*([A-Za-z_][\w.]*|\d[\w.]*(?:e[-+]\d+)?|[-+*/(),])")


def plain(line):
    """Placeholders are words of their own while a line is looked at."""
    return re.sub(r"\$\{(\w+)\}", r"PLACE_\1", line)


def restored(line):
    return re.sub(r"PLACE_(light|lane|uv)", r"${\1}", line)


def words(expression):
    return {name.split(".")[0] for name in re.findall(r"[A-Za-z_][\w.]*", expression)}


def effects(line):
    """What a line reads and writes, or nothing where it is no simple statement."""
    match = ASSIGNMENT.match(plain(line))
    if not match:
        return None
    target, member, operator, value, _ = match.groups()
    reads = words(value)
    return reads | ({target} if member or operator != "=" else set()), {target}


def swappable(first, second):
    a, b = effects(first), effects(second)
    return bool(a and b and not (a[1] & b[0] or b[1] & a[0] or a[1] & b[1]))


def move_statement(lines, random):
    """Moves a statement past one to three others that do not depend on it."""
    at = random.randrange(len(lines) - 1)
    moved = list(lines)
    for _ in range(random.choice((1, 1, 1, 2, 3))):
        if at + 1 >= len(moved) or not swappable(moved[at], moved[at + 1]):
            break
        moved[at], moved[at + 1] = moved[at + 1], moved[at]
        at += 1
    return moved


class Expression:
    """Sums of products of calls, names and numbers: ("sum", [(sign, product)]), ("product", [factor]),
    ("atom", text, [argument])."""

    def __init__(self, text):
        self.tokens, self.at = TOKEN.findall(text), 0
        if "".join(self.tokens) != re.sub(r"\s", "", text) or "/" in self.tokens:
            raise ValueError("not simple")
        self.products, self.sums = [], []
        self.root = self._sum()
        if self.at != len(self.tokens):
            raise ValueError("not simple")

    def _peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def _next(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def _sum(self):
        terms = [("+", self._product())]
        while self._peek() in ("+", "-"):
            terms.append((self._next(), self._product()))
        self.sums.append(terms)
        return ("sum", terms)

    def _product(self):
        factors = [self._atom()]
        while self._peek() == "*":
            self._next()
            factors.append(self._atom())
        self.products.append(factors)
        return ("product", factors)

    def _atom(self):
        name = "" if self._peek() == "(" else self._next()
        if name in ("-", ")", ",", "*", "+"):
            raise ValueError("not simple")
        if self._peek() != "(":
            return ("atom", name, None)
        self._next()
        arguments = [self._sum()]
        while self._peek() == ",":
            self._next()
            arguments.append(self._sum())
        if self._peek() != ")":
            raise ValueError("not simple")
        self._next()
        return ("atom", name, arguments)

    def __str__(self):
        return show(self.root)


def show(node):
    if node[0] == "sum":
        text = show(node[1][0][1])
        return text + "".join(f" {sign} {show(product)}" for sign, product in node[1][1:])
    if node[0] == "product":
        return " * ".join(show(factor) for factor in node[1])
    _, name, arguments = node
    return name if arguments is None else f"{name}({', '.join(show(argument) for argument in arguments)})"


def reorder(text, random):
    """The expression with one product's factors, or one sum's terms, in another order or grouped."""
    expression = Expression(text)
    longs = [items for items in expression.products + expression.sums if len(items) > 1]
    if not longs:
        raise ValueError("nothing to reorder")
    items = random.choice(longs)
    if isinstance(items[0][1], tuple):  # a sum: its first term has no sign to print
        positive = [term for term in items if term[0] == "+"]
        random.shuffle(positive)
        items[:] = positive[:1] + [term for term in items if term[0] == "-"] + positive[1:]
    else:
        random.shuffle(items)
        if len(items) > 2 and random.random() < 0.5:
            at = random.randrange(len(items) - 1)
            grouped = ("sum", [("+", ("product", items[at:at + 2]))])
            items[at:at + 2] = [("atom", "", [grouped])]
    return str(expression)


def reorder_line(lines, random):
    at = random.randrange(len(lines))
    line = plain(lines[at])
    match = ASSIGNMENT.match(line) or RETURN.match(line)
    if not match:
        return lines
    begin, end = match.span(4 if match.re is ASSIGNMENT else 2)
    try:
        changed = line[:begin] + reorder(line[begin:end], random) + line[end:]
    except ValueError:
        return lines
    return lines[:at] + [restored(changed)] + lines[at + 1:]


def neighbour(files, random):
    """The snippets with one line of one of them changed or moved."""
    name = random.choice(sorted(files))
    change = random.choice((move_statement, reorder_line))
    return {**files, name: change(files[name], random)}
