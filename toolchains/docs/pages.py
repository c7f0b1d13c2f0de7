#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages.py SOURCE_DIR OUT_DIR PARTS_DIR: the project's Markdown pages, as Doxygen reads them, and the pictures that they show.

A page and each of its headings get a name that does not depend on Doxygen's version, and links become links to these
names, to the reference of a header, or, where the site has no page of a file, plain text. Fails, with file and line, on a
link to what is not there. Lines keep their numbers up to the first part: a line `<!-- part: NAME -->` becomes the file
PARTS_DIR/NAME, and `<!-- picture: NAME Caption -->` in a page of the handbook the picture PARTS_DIR/PAGE-NAME.
"""
import html
import pathlib
import re
import shutil
import sys

TOPS = ["generator", "lib", "platform", "examples", "toolchains", "tests"]
HANDBOOK = "toolchains/docs/handbook/"
START = HANDBOOK + "README.md"
PICTURES = {".png", ".jpg", ".svg"}
PART = re.compile(r"<!-- part: (\S+) -->$")
PICTURE = re.compile(r"<!-- picture: (\S+) (.+?) -->")
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")


def name_of(page):
    short = page.removeprefix(HANDBOOK).removesuffix(".md").lower()
    return "mainpage" if page == START else "page_" + re.sub(r"[^a-z0-9]+", "_", short)


def slug_of(heading):
    """As GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def pages_of(root):
    """A file without a title is a part of another page."""
    found = [*root.glob("*.md")] + [page for top in TOPS for page in (root / top).rglob("*.md")]
    titled = [page for page in found if page.read_text(encoding="utf-8").startswith("# ")]
    return sorted(page.relative_to(root).as_posix() for page in titled)


def headings_of(text):
    """Those outside of code."""
    code, headings = False, []
    for line in text.splitlines():
        code ^= line.lstrip().startswith("```")
        if not code and line.startswith("#"):
            headings.append(line.lstrip("#").strip())
    return headings


class Site:
    def __init__(self, root, out, parts):
        self.root, self.out, self.parts, self.faults = root, out, parts, []
        self.pages = pages_of(root)
        self.slugs = {page: {slug_of(h) for h in headings_of(self.read(page))} for page in self.pages}

    def read(self, page):
        return (self.root / page).read_text(encoding="utf-8")

    def write(self):
        shutil.rmtree(self.out, ignore_errors=True)
        self.out.mkdir(parents=True)
        for page in self.pages:
            (self.out / (name_of(page) + ".md")).write_text(self.converted(page), encoding="utf-8")
        return self.faults

    def converted(self, page):
        lines, code = [], False
        for number, line in enumerate(self.read(page).splitlines(), 1):
            fence = line.lstrip().startswith("```")
            code ^= fence
            lines.append(line if code or fence else self.line(page, number, line))
        return "\n".join(lines) + "\n"

    def line(self, page, number, line):
        if line.startswith("    ") and not line.lstrip().startswith(("-", "|")):
            return line
        if part := PART.match(line):
            return self.part(page, number, part[1], lambda path: path.read_text(encoding="utf-8"))
        if pictures := PICTURE.findall(line):
            cards = (self.card(page, number, *picture) for picture in pictures)
            return f'<div class="gallery">{"".join(cards)}</div>'
        if line.startswith("#"):
            title = line.lstrip("#").strip()
            mark = name_of(page) if line.startswith("# ") else f"{name_of(page)}_{slug_of(title)}"
            return f"{line} {{#{mark}}}"
        parts = re.split(r"(`[^`]*`)", line)
        text = "".join(part if part.startswith("`") else re.sub(r"([\\@%])", r"\\\1", part) for part in parts)
        return LINK.sub(lambda link: self.link(page, number, link), text)

    def part(self, page, number, name, use):
        path = self.parts / name
        return use(path) if path.exists() else self.fault(page, number, f"the build makes no {name}")

    def card(self, page, number, name, caption):
        name = f"{pathlib.Path(page).stem}-{name}"
        words = html.escape(caption)
        return self.part(page, number, name, lambda _: f'<div class="card"><img src="{name}" alt="{words}"/><div>{words}</div></div>')

    def link(self, page, number, link):
        picture, words, target = link.groups()
        if re.match(r"[a-z]+:", target):
            return link.group()
        path, _, slug = target.partition("#")
        file = (self.root / page).parent / path if path else self.root / page
        file = pathlib.Path(*file.resolve().parts)
        if not file.is_relative_to(self.root) or not file.exists():
            return self.fault(page, number, f"there is no {target}")
        if file.is_dir() and (file / "README.md").exists():
            file = file / "README.md"
        there = file.relative_to(self.root).as_posix()
        if file.suffix in PICTURES:
            name = there.replace("/", "-")
            shutil.copy(file, self.out / name)
            return f"{picture}[{words}]({name})"
        if there in self.slugs:
            if slug and slug not in self.slugs[there]:
                return self.fault(page, number, f"{there} has no heading #{slug}")
            return f"[{words}](@ref {name_of(there)}{'_' + slug if slug else ''})"
        if "/include/franken/" in there:
            return f"[{words}](@ref {there})"
        return words if "`" in words else f"`{words}`"

    def fault(self, page, number, what):
        self.faults.append(f"{self.root / page}:{number}: {what}")
        return ""


def main(source, out, parts):
    faults = Site(pathlib.Path(source).resolve(), pathlib.Path(out), pathlib.Path(parts)).write()
    print("\n".join(faults), file=sys.stderr, end="\n" if faults else "")
    return 1 if faults else 0


sys.exit(main(*sys.argv[1:]))
