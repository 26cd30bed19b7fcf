"""Whether the built site holds together; called by scripts/docs with the folder of the pages.

Every link leads to a file, and to a name in it; every page has an example; the search of the site finds every
command, effect, key and function on its page. Links out of the site cannot be followed where there is no network: their
form is looked at, and they are counted.
"""

import json
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from sphinx.search.en import SearchEnglish
from sphinx.util import jsdump

# Pages of Sphinx itself, and what has changed.
NO_EXAMPLE = {"genindex.html", "search.html", "py-modindex.html", "CHANGELOG.html"}


class Anchors(HTMLParser):
    """Links, names and whether there is an example."""

    def __init__(self, text):
        super().__init__()
        self.links, self.ids, self.example, self.title = [], set(), False, ""
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.ids.update(v for k, v in given.items() if k in ("id", "name") and v)
        for key in ("href", "src"):
            if given.get(key):
                self.links.append(given[key])
        classes = (given.get("class") or "").split()
        # A block of code, a cell of a notebook.
        self.example |= any(c.startswith("highlight-") or c == "nbinput" for c in classes) or "doctest" in classes


def read_index(path):
    text = path.read_text(encoding="utf-8")
    inside = re.fullmatch(r"Search\.setIndex\((.*)\)\s*;?", text, re.S)[1]
    try:
        return json.loads(inside)
    except ValueError:
        return jsdump.loads(inside)


class Search:
    """What search.html of the site does with words: all of them, stems, in texts and titles; and names of objects."""

    def __init__(self, index):
        self.index, self.language = index, SearchEnglish({})
        self.objects = {}
        for entries in index["objects"].values():
            for page, *_, name in entries if isinstance(entries, list) else [(*e, n) for n, e in entries.items()]:
                self.objects.setdefault(re.split(r"[.:]", name)[-1], set()).add(index["docnames"][page])

    def pages(self, words):
        found = None
        for word in re.split(r"[^\w]+", words):
            lower = word.lower()
            if not word or lower in self.language.stopwords or lower.isdigit():
                continue
            stem = self.language.stem(lower)
            here = set()
            for table in ("terms", "titleterms"):
                for term in {stem, lower}:
                    pages = self.index[table].get(term, [])
                    here.update([pages] if isinstance(pages, int) else pages)
            found = here if found is None else found & here
        return {self.index["docnames"][p] for p in found or ()}


def dead_links(folder, pages):
    outside, wrong = set(), []
    for path, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme in ("http", "https"):
                if not parts.netloc or " " in link:
                    wrong.append(f"{path}: {link}: no address")
                outside.add(link)
                continue
            if parts.scheme == "data":
                continue
            if parts.scheme or link.startswith("//"):
                wrong.append(f"{path}: {link}: neither a page nor an address")
                continue
            target = (folder / path).parent / unquote(parts.path) if parts.path else folder / path
            target = target.resolve()
            if not target.is_file():
                wrong.append(f"{path}: {link}: no such file")
            elif parts.fragment and target.suffix == ".html":
                name = target.relative_to(folder).as_posix()
                if unquote(parts.fragment) not in pages[name].ids:
                    wrong.append(f"{path}: {link}: no such place on that page")
    return wrong, outside


def main():
    folder = Path(sys.argv[1]).resolve()
    pages = {
        p.relative_to(folder).as_posix(): Anchors(p.read_text(encoding="utf-8")) for p in sorted(folder.rglob("*.html")) if "_static" not in p.parts
    }
    wrong, outside = dead_links(folder, pages)
    wrong += [f"{path}: a page without an example" for path, page in pages.items() if path not in NO_EXAMPLE and not page.example]
    search = Search(read_index(folder / "searchindex.js"))
    expected = json.loads((folder.parent / "expected.json").read_text(encoding="utf-8"))
    for one in expected:
        name, page = one["name"], one["page"]
        if name.lower() in search.language.stopwords and one["kind"] not in ("C++", "C", "python"):
            continue  # "A", "to": words that the search leaves out; of functions it knows the names
        last = re.split(r"[.:]", name)[-1]
        if page not in search.pages(name) | search.objects.get(last, set()):
            wrong.append(f"search: {one['kind']} {name} is not found on {page}")
    kinds = {kind: len({(e["name"], e["page"]) for e in expected if e["kind"] == kind}) for kind in dict.fromkeys(e["kind"] for e in expected)}
    print(
        f"{len(pages)} pages, {sum(len(p.links) for p in pages.values())} links; the search finds "
        + ", ".join(f"{count} of {kind}" for kind, count in kinds.items())
    )
    print(f"{len(outside)} links out of the site, well formed and not followed:", *sorted(outside))
    if wrong:
        sys.exit("\n".join(wrong[:60]) + f"\n{len(wrong)} in all")


main()
