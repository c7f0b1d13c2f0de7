#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""header_filter.py HEADER: what Doxygen reads of a public header.

Adds what a reader of the header sees without being told, and Doxygen does not:
- A comment stands for all declarations below it, up to an empty line or the next comment.
- A comment above `namespace` is the file's.
- Comparison by all members, moving, and what is deleted are the same for every type.
- A member that has the name of its type is what that type says.
What is private is left out. A comment is plain text with `code` in it: it has no command of Doxygen's and
no HTML. Lines keep their numbers.
"""
import re
import sys

SCOPE = re.compile(r"^(?:template<.*> *)?(?:namespace|class|struct|union|enum|extern)\b[^;(]*\{")
SAME_FOR_ALL = [
    (re.compile(r"\boperator==\(.*= default"), "Whether all members are equal."),
    (re.compile(r"^(\w+)\((?:const \1|\1)&&? ?\w*\).*= delete"), "Cannot be copied."),
    (re.compile(r"\boperator=\(.*= delete"), "Cannot be copied."),
    (re.compile(r"^(\w+)\(\1&& ?\w*\)"), "Takes over what the other one holds."),
    (re.compile(r"\boperator=\(\w+&& ?\w*\)"), "Takes over what the other one holds, and lets go of its own."),
    (re.compile(r"^(virtual )?~"), "Lets go of what it holds."),
]
ONE = r"\w+(?: = [^,(]+|\{[^}]*\})?"
LIST = re.compile(rf"^((?:const |static |inline |constexpr |mutable )*[\w:]+(?:<.*>)?) ({ONE}(?:, {ONE})+);( *///<.*)?$")
TYPED = re.compile(r"^(?:\w+::)*([A-Z]\w*) ([a-z]\w*)(?: =.*|\{.*)?;")


def escaped(comment):
    """Text for Doxygen: of what is not between backticks, nothing is a command or a tag."""
    if comment.startswith("    "):
        return comment
    parts = comment.split("`")
    parts[::2] = [re.sub(r"([\\@<>#%&])", r"\\\1", part) for part in parts[::2]]
    return "`".join(parts)


def documentation_of(line):
    """The text of a line of documentation, or None."""
    match = re.match(r"\s*///(?!<|/) ?(.*)", line)
    return match and match.group(1)


def trailing(line):
    code, mark, comment = line.partition("///<")
    code = re.sub(r"(?<=\d)'(?=\d)", "", code)  # Doxygen takes 1'000 for the beginning of a character.
    return f"{code}///< {escaped(comment.strip())}" if mark else code


def each_of(declaration):
    """`int a, b;` as one declaration for each name: Doxygen gives a comment to one of them."""
    match = LIST.match(declaration)
    return [f"{match.group(1)} {name};" for name in re.findall(ONE, match.group(2))] if match else [declaration]


def standing_text(declaration):
    for pattern, text in SAME_FOR_ALL:
        if pattern.search(declaration):
            return text
    typed = TYPED.match(declaration)
    if typed and typed.group(1).lower() == typed.group(2).lower():
        return f"See {typed.group(1)}."
    return ""


class Filter:
    def __init__(self, lines):
        self.lines, self.out = lines, []
        self.above = ""         # The comment that stands for the declarations below it.
        self.commented = False  # It is just above.

    def run(self):
        number = 0
        while number < len(self.lines):
            line = self.lines[number]
            text = line.strip()
            if text == "private:":
                number = self.private(number)
                continue
            if documentation_of(line) is not None:
                self.comment(line)
            elif not text or text.startswith(("//", "#", "}", "public:", "private:", "protected:", "template<")):
                self.apart(line, text)
            elif SCOPE.match(text) and text.count("{") > text.count("}"):
                self.scope(line, text)
            else:
                number = self.declaration(number)
                continue
            number += 1
        return self.out

    def private(self, number):
        """Leaves out what is private, up to the end of the class or to what is not."""
        indent = self.lines[number].index("private:")
        while not re.match(r" {%d}(\}|public:|protected:)" % indent, self.lines[number]):
            self.out.append("")
            number += 1
        return number

    def comment(self, line):
        text = documentation_of(line)
        self.above = f"{self.above} {text}" if self.commented else text
        self.commented = True
        self.out.append(line[: line.index("///")] + "/// " + escaped(text))

    def apart(self, line, text):
        if not text.startswith("template<"):
            self.above, self.commented = "", False
        self.out.append(line)

    def scope(self, line, text):
        if text.startswith("namespace") and self.commented:
            self.give_to_file()
        self.above, self.commented = "", False
        self.out.append(trailing(line))

    def declaration(self, number):
        """Writes a declaration, with the comment that stands for it; returns the number of the line after it."""
        end = self.end_of(number)
        lines = [trailing(line) for line in self.lines[number:end]]
        indent, text = re.match(r"(\s*)(.*)", lines[0]).groups()
        words = ""
        if len(lines) == 1 and LIST.match(text) and "///<" in text:
            text, _, words = (part.strip() for part in text.partition("///<"))
        if not words and not self.commented and not any("///<" in line for line in lines):
            words = escaped(standing_text(text) or self.above)
        if words:
            lines[0] = indent + " ".join(f"/** {words} */ {one}" for one in each_of(text))
        elif self.commented:  # Which Doxygen gives to the first of several names.
            first, *others = each_of(text)
            lines[0] = indent + first + "".join(f" /** {escaped(self.above)} */ {one}" for one in others)
        self.commented = False
        self.out += lines
        return end

    def end_of(self, number):
        """The line behind a declaration, with its body and the comments that trail it."""
        open_braces = 0
        while number < len(self.lines):
            code = self.lines[number].split("//")[0].rstrip()
            open_braces += sum(code.count(c) for c in "{(") - sum(code.count(c) for c in "})")
            number += 1
            if open_braces <= 0 and code.endswith((";", "}", ",")):
                break
        while number < len(self.lines) and self.lines[number].strip().startswith("///<"):
            number += 1
        return number

    def give_to_file(self):
        """The empty line above the comment becomes the command that gives it to the file."""
        first = len(self.out)
        while documentation_of(self.out[first - 1]) is not None:
            first -= 1
        self.out[first - 1] = "/// @file"


def main(path):
    lines = open(path, encoding="utf-8").read().splitlines()
    module = re.search(r"([a-z]+)/include/franken/", path).group(1)
    file = ["/** @file", f"@ingroup {module} */"]  # In place of the licence and of #pragma once.
    print("\n".join(file + Filter(lines[2:]).run()))


main(sys.argv[1])
