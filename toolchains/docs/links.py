#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""links.py SITE_DIR: fails where a page of the site links to a file or an anchor that the site does not have."""
import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.anchors, self.links = set(), set()
        self.feed(path.read_text(encoding="utf-8", errors="replace"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src") and value:
                self.links.add(value)


def dead_links(site):
    pages = {path: Page(path) for path in site.rglob("*.html")}
    count = 0
    for path, page in sorted(pages.items()):
        for link in sorted(page.links):
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            count += 1
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file():
                yield f"{path.relative_to(site)}: {link}: no such file"
            elif parts.fragment and target in pages and parts.fragment not in pages[target].anchors:
                yield f"{path.relative_to(site)}: {link}: no such place"
    print(f"{len(pages)} pages, {count} links")
    if count < 1000:
        yield "the links were not found"


dead = list(dead_links(pathlib.Path(sys.argv[1]).resolve()))
print("\n".join(dead), file=sys.stderr, end="\n" if dead else "")
sys.exit(1 if dead else 0)
