# SPDX-License-Identifier: MIT
"""Runs GLSL ES 1.00 programs of our composer over many pixels at once, with any arithmetic of qpu_math.

It knows what lit opaque programs use: no conditions, no loops, no matrices but as factors of vectors. Values are
lists of components, each an array over the pixels; matrices and arrays are lists of such lists; structs are
dictionaries.
"""
import re

import numpy as np

TYPES = {"float": 1, "vec2": 2, "vec3": 3, "vec4": 4}
MATRICES = {"mat3": 3, "mat4": 4}
TOKEN = re.compile(r"\s*([A-Za-z_]\w*|\d+\.\d*(?:[eE][-+]?\d+)?|\d+|[-+*/]=|[-+*/=(){}\[\];,.<>?:!&|])")


def tokens_of(text):
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r"(?m)^#.*$", "", text)
    text = re.sub(r"precision \w+ float;|\b(highp|mediump|lowp)\b", "", text)
    return TOKEN.findall(text)


class Function:
    def __init__(self, parameters, body):
        self.parameters, self.body = parameters, body


class Program:
    def __init__(self, text):
        self.tokens, self.at = tokens_of(text), 0
        self.functions, self.structs, self.globals = {}, {}, {}
        while self.at < len(self.tokens):
            self._declaration()

    def _next(self, expected=None):
        token = self.tokens[self.at]
        if expected and token != expected:
            raise SyntaxError(f"{expected} expected, found {' '.join(self.tokens[self.at:self.at + 8])}")
        self.at += 1
        return token

    def _peek(self, ahead=0):
        return self.tokens[self.at + ahead]

    def _declaration(self):
        first = self._next()
        if first == "struct":
            name, fields = self._next(), []
            self._next("{")
            while self._peek() != "}":
                self._next()
                fields.append(self._next())
                self._next(";")
            self._next("}")
            self._next(";")
            self.structs[name] = fields
        elif first in ("uniform", "varying", "attribute"):
            kind, name, count = self._next(), self._next(), 1
            if self._peek() == "[":
                self._next()
                count = int(self._next())
                self._next("]")
            self._next(";")
            self.globals[name] = (first, kind, count)
        else:
            self._function(self._next())

    def _function(self, name):
        parameters = []
        self._next("(")
        while self._peek() != ")":
            inout = self._peek() in ("inout", "out")
            if inout:
                self._next()
            self._next()
            parameters.append((self._next(), inout))
            if self._peek() == ",":
                self._next()
        self._next(")")
        self._next("{")
        body = []
        while self._peek() != "}":
            body.append(self._statement())
        self._next("}")
        self.functions[name] = Function(parameters, body)

    def _statement(self):
        if self._peek() == "return":
            self._next()
            value = self._expression()
            self._next(";")
            return ("return", value)
        if self._peek(1) not in ("(", ".", "=", "+=", "-=", "*=", "/=", "["):
            self._next()
            names = []
            while True:
                name = self._next()
                value = None
                if self._peek() == "=":
                    self._next()
                    value = self._expression()
                names.append((name, value))
                if self._next() == ";":
                    return ("declare", names)
        target = self._postfix()
        if self._peek() in ("=", "+=", "-=", "*=", "/="):
            operator = self._next()
            value = self._expression()
            self._next(";")
            return ("assign", target, operator, value)
        self._next(";")
        return ("call", target)

    def _expression(self):
        return self._chain(("+", "-"), lambda: self._chain(("*", "/"), self._unary))

    def _chain(self, operators, part):
        left = part()
        while self._peek() in operators:
            left = (self._next(), left, part())
        return left

    def _unary(self):
        if self._peek() == "-":
            self._next()
            return ("negate", self._unary())
        return self._postfix()

    def _postfix(self):
        token = self._next()
        if token == "(":
            value = self._expression()
            self._next(")")
        elif self._peek() == "(":
            self._next()
            arguments = []
            while self._peek() != ")":
                arguments.append(self._expression())
                if self._peek() == ",":
                    self._next()
            self._next(")")
            value = ("function", token, arguments)
        elif token[0].isdigit():
            value = ("number", float(token))
        else:
            value = ("name", token)
        while self._peek() in (".", "["):
            if self._next() == ".":
                value = ("member", value, self._next())
            else:
                value = ("index", value, int(self._next()))
                self._next("]")
        return value


class Run:
    """One execution: `scope` holds uniforms, attributes or varyings on entry, and varyings or gl_* behind."""

    def __init__(self, program, arithmetic, scope, textures=None):
        self.program, self.math, self.scope, self.textures = program, arithmetic, dict(scope), textures or {}
        self._body(program.functions["main"].body, self.scope)

    def _body(self, body, scope):
        for statement in body:
            kind = statement[0]
            if kind == "return":
                return self._value(statement[1], scope)
            if kind == "declare":
                for name, value in statement[1]:
                    scope[name] = self._value(value, scope) if value else None
            elif kind == "call":
                self._value(statement[1], scope)
            else:
                self._assign(*statement[1:], scope)
        return None

    def _assign(self, target, operator, value, scope):
        new = self._value(value, scope)
        if operator != "=":
            new = self._binary(operator[0], self._value(target, scope), new)
        if target[0] == "name":
            scope[target[1]] = new
            return
        _, (_, name), member = target
        old = scope.get(name)
        if isinstance(old, dict):
            scope[name] = {**old, member: new}
            return
        components = list(old)
        for place, letter in enumerate(member):
            components[self._component(letter)] = new[place if len(new) > 1 else 0]
        scope[name] = components

    @staticmethod
    def _component(letter):
        return "xyzw".index(letter) if letter in "xyzw" else "rgba".index(letter)

    def _value(self, node, scope):
        kind = node[0]
        if kind == "number":
            return [np.asarray(node[1], self.math.number)]
        if kind == "name":
            return scope[node[1]] if node[1] in scope else self.scope[node[1]]
        if kind == "negate":
            return [-c for c in self._value(node[1], scope)]
        if kind == "index":
            return self._value(node[1], scope)[node[2]]
        if kind == "member":
            value = self._value(node[1], scope)
            if isinstance(value, dict):
                return value[node[2]]
            return [value[self._component(letter)] for letter in node[2]]
        if kind == "function":
            return self._call(node[1], node[2], scope)
        return self._binary(kind, self._value(node[1], scope), self._value(node[2], scope))

    def _binary(self, operator, a, b):
        if isinstance(a[0], list):  # matrix times vector
            columns = [[self.math.mul(c, b[i]) for c in column] for i, column in enumerate(a)]
            result = columns[0]
            for column in columns[1:]:
                result = [self.math.add(x, y) for x, y in zip(result, column)]
            return result
        size = max(len(a), len(b))
        pairs = zip(a * size if len(a) == 1 else a, b * size if len(b) == 1 else b)
        if operator == "/":
            return [self.math.mul(x, self.math.rcp(y)) for x, y in pairs]
        function = {"+": self.math.add, "-": self.math.sub, "*": self.math.mul}[operator]
        return [function(x, y) for x, y in pairs]

    def _call(self, name, nodes, scope):
        if name == "texture2D":
            return self.textures[nodes[0][1]]
        arguments = [self._value(node, scope) for node in nodes]
        if name in self.program.structs:
            return dict(zip(self.program.structs[name], arguments))
        if name in TYPES:
            components = [c for argument in arguments for c in argument]
            return components * TYPES[name] if len(components) == 1 else components[: TYPES[name]]
        if name in self.program.functions:
            function = self.program.functions[name]
            inner = {p: a for (p, _), a in zip(function.parameters, arguments)}
            result = self._body(function.body, inner)
            for (parameter, inout), node in zip(function.parameters, nodes):
                if inout:
                    scope[node[1]] = inner[parameter]
            return result
        return getattr(self, "_" + name)(*arguments)

    def _each(self, function, *arguments):
        size = max(len(a) for a in arguments)
        return [function(*parts) for parts in zip(*[a * size if len(a) == 1 else a for a in arguments])]

    def _dot(self, a, b):
        total = self.math.mul(a[0], b[0])
        for x, y in list(zip(a, b))[1:]:
            total = self.math.add(total, self.math.mul(x, y))
        return [total]

    def _cross(self, a, b):
        m, s = self.math.mul, self.math.sub
        return [s(m(a[i], b[j]), m(a[j], b[i])) for i, j in ((1, 2), (2, 0), (0, 1))]

    def _normalize(self, a):
        scale = self.math.rsq(self._dot(a, a)[0])
        return [self.math.mul(c, scale) for c in a]

    def _mix(self, a, b, t):
        one = self.math.number(1)
        return self._each(
            lambda x, y, z: self.math.add(self.math.mul(x, self.math.sub(one, z)), self.math.mul(y, z)), a, b, t)

    def _pow(self, a, b):
        return self._each(lambda x, y: self.math.exp2(self.math.mul(self.math.log2(x), y)), a, b)

    def _clamp(self, a, low, high):
        return self._min(self._max(a, low), high)

    def _max(self, a, b):
        return self._each(np.maximum, a, b)

    def _min(self, a, b):
        return self._each(np.minimum, a, b)

    def _step(self, edge, a):
        return self._each(lambda e, x: np.where(x < e, self.math.number(0), self.math.number(1)), edge, a)

    def _abs(self, a):
        return [np.abs(c) for c in a]

    def _exp2(self, a):
        return [self.math.exp2(c) for c in a]

    def _log2(self, a):
        return [self.math.log2(c) for c in a]

    def _sqrt(self, a):
        return [self.math.sqrt(c) for c in a]

    def _inversesqrt(self, a):
        return [self.math.rsq(c) for c in a]
