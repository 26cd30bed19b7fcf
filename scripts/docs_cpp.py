"""Pages of the C++ and the C API, from what Doxygen reads in the headers; called by scripts/docs_pages.py.

Doxygen gives the declarations. Comments are handed through it as they are written, since it would take
`<`, `#` and `*` of a formula for markup, and are set here: a paragraph stays one, lines that are indented stay
lines, and what begins with a word and a colon (Source, Domain, Accuracy) is a paragraph of its own.
"""

import re
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

from sphinx.domains.c import DefinitionParser as CParser
from sphinx.domains.cpp import DefinitionParser as CppParser

DOXYFILE = """
QUIET = YES
WARN_IF_UNDOCUMENTED = NO
WARN_AS_ERROR = YES
FILE_PATTERNS = *.h
RECURSIVE = YES
INPUT = .
OUTPUT_DIRECTORY = ../doxygen
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL = YES
SORT_MEMBER_DOCS = NO
INCLUDE_GRAPH = NO
INCLUDED_BY_GRAPH = NO
CLASS_GRAPH = NO
MARKDOWN_SUPPORT = NO
AUTOLINK_SUPPORT = NO
FULL_PATH_NAMES = YES
STRIP_FROM_PATH = .
ENABLE_PREPROCESSING = YES
MACRO_EXPANSION = YES
EXPAND_ONLY_PREDEF = YES
PREDEFINED = "RACEWAY_API="
"""


class Config:
    cpp_id_attributes = cpp_paren_attributes = c_id_attributes = c_paren_attributes = []
    c_extra_keywords = []
    c_allow_pre_v3 = c_warn_on_allowed_pre_v3 = False


def for_doxygen(code):
    """The header with its comments as Doxygen hands them through."""
    lines, begun = [], False
    for line in code.split("\n"):
        block = re.match(r"\s*///(?!<) ?(.*)$", line)
        if block:
            if not begun:
                lines.append("/// @verbatim")
            begun = True
            lines.append("/// " + block[1])
            continue
        if begun:
            lines.append("/// @endverbatim")
            begun = False
        behind = re.match(r"(.*?)///< ?(.*)$", line)
        lines.append(f"{behind[1]}///< @verbatim {behind[2]} @endverbatim" if behind else line)
    return "\n".join(lines)


def run_doxygen(root, headers, work):
    """The XML of these headers, which are named from the root of the project."""
    copies = work / "headers"
    for header in headers:
        copy = copies / header
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(for_doxygen((root / header).read_text(encoding="utf-8")), encoding="utf-8")
    subprocess.run(["doxygen", "-"], cwd=copies, input=DOXYFILE, text=True, check=True)
    return work / "doxygen" / "xml"


def escaped(text):
    """Plain words for reStructuredText; `code` in backticks stays code."""
    parts = re.split(r"`+([^`]+)`+", text)
    return "".join(f"\\ ``{part}``\\ " if i % 2 else re.sub(r"([*|_\\`<>@])", r"\\\1", part) for i, part in enumerate(parts))


def comment(element):
    """What stands above or behind a declaration, as lines of reStructuredText."""
    raw = []
    for which in ("briefdescription", "detaileddescription"):
        for block in element.findall(f"{which}//verbatim"):
            raw += (block.text or "").strip("\n").split("\n")
    result, paragraph, literal, labelled = [], [], [], False

    def flush():
        nonlocal paragraph, literal
        if paragraph:
            result.extend([escaped(" ".join(paragraph)), ""])
        if literal:
            least = min(len(line) - len(line.lstrip()) for line in literal if line.strip())
            result.extend(["::", "", *("   " + line[least:] for line in literal), ""])
        paragraph, literal = [], []

    for line in raw:
        # Doxygen leaves the slashes, or of what stands behind a member one blank in front.
        text = re.sub(r"^\s*///( |$)|^ ", "", line).rstrip()
        label = re.match(r"[A-Z][A-Za-z]+: ", text)
        if not text.strip():
            flush()
            labelled = False
        elif label:
            flush()
            labelled = True
            paragraph.append(" ".join(text.split()))
        elif text.startswith("  ") and not labelled:
            if paragraph:
                flush()
            literal.append(text)
        else:
            if literal:
                flush()
            paragraph.append(" ".join(text.split()))
    flush()
    return result


def words(element):
    return "" if element is None else " ".join("".join(element.itertext()).split())


def signature(member):
    """The declaration without what only the compiler asks for."""
    kind, name = member.get("kind"), words(member.find("name"))
    kept = words(member.find("type"))
    kept = re.sub(r"\[\[\w+\]\]|\b(inline|constexpr|explicit|friend|extern)\b", "", kept).strip()
    arguments = words(member.find("argsstring"))
    template = member.find("templateparamlist")
    front = ""
    if template is not None:
        front = (
            "template<"
            + ", ".join(
                words(p.find("type")) + (" " + words(p.find("declname")) if p.find("declname") is not None else "") for p in template.findall("param")
            )
            + "> "
        )
    if kind == "typedef":
        using = words(member.find("definition"))
        return "type", f"{front}{name} = {kept}" if using.startswith("using") or "=" in using else f"{kept} {name}{arguments}"
    if kind == "enum":
        return ("enum-class" if member.get("strong") == "yes" else "enum"), name
    if kind == "function":
        arguments = re.sub(r"\s*=\s*(0|default|delete)$", "", arguments)
        return "function", f"{front}{'static ' if member.get('static') == 'yes' else ''}{kept} {name}{arguments}".strip()
    value = words(member.find("initializer"))
    value = f" {value}" if value.startswith("=") and len(value) < 40 else ""
    return "member", f"{front}{kept} {name}{arguments}{value}"


class Page:
    """Declarations of one language as directives of Sphinx, those it cannot parse as code."""

    def __init__(self, language, compounds):
        self.language, self.compounds = language, compounds
        self.lines, self.seen, self.unparsed, self.names = [], set(), [], []

    def parsed(self, kind, text):
        known = {"struct": "class", "class": "class", "enum-class": "enum"}.get(kind, kind)
        parser = (CppParser if self.language == "cpp" else CParser)(text, location=None, config=Config())
        try:
            if self.language == "cpp":
                parser.parse_declaration(known, kind)
            else:
                parser.parse_declaration(known, kind)
            parser.assert_end()
            return True
        except Exception:  # whatever the parser of Sphinx does not know
            return False

    def declare(self, kind, text, scope, indent, element, name):
        """Opens one; returns the indent of what belongs to it, or None where it stood before."""
        key = (scope, kind, text)
        if key in self.seen:
            return None
        self.seen.add(key)
        pad = " " * indent
        if self.parsed(kind, text):
            self.lines += [f"{pad}.. {self.language}:{kind}:: {text}", ""]
        else:
            self.unparsed.append(f"{scope}::{text}")
            self.lines += [f"{pad}.. code-block:: {self.language}", "", f"{pad}   {text}", "", f"{pad}.. container::", "", f"{pad}   *{name}*", ""]
        self.names.append((scope, name))
        inside = indent + 3
        self.lines += [" " * inside + line if line else "" for line in comment(element)]
        return inside

    def member(self, element, scope, indent):
        name = words(element.find("name"))
        if not name or name.startswith("@") or element.get("prot", "public") != "public":
            if element.get("kind") == "enum" and element.get("prot", "public") == "public":
                for value in element.findall("enumvalue"):
                    self.value(value, "enumerator" if self.language == "cpp" else "macro", scope, indent)
            return
        kind, text = signature(element)
        if element.get("kind") in ("define", "friend") or "friend" in words(element.find("type")):
            return
        inside = self.declare(kind, text, scope, indent, element, name)
        if inside is not None and element.get("kind") == "enum":
            for value in element.findall("enumvalue"):
                self.value(value, "enumerator", scope + "::" + name, inside)

    def value(self, element, kind, scope, indent):
        name = words(element.find("name"))
        self.declare(kind, name, scope, indent, element, name)

    def compound(self, element, indent, outer):
        full = words(element.find("compoundname"))
        scope = full.rpartition("::")[0]
        name = full[len(outer) + 2 :] if outer and full.startswith(outer + "::") else full
        template = element.find("templateparamlist")
        front = (
            ""
            if template is None
            else "template<"
            + ", ".join(
                words(p.find("type")) + (" " + words(p.find("declname")) if p.find("declname") is not None else "") for p in template.findall("param")
            )
            + "> "
        )
        kind = element.get("kind") if element.get("kind") in ("struct", "class") else "struct"
        bases = [words(b) for b in element.findall("basecompoundref") if b.get("prot") == "public"]
        text = front + name + (" : public " + ", public ".join(bases) if bases else "")
        inside = self.declare(kind, text, scope, indent, element, name.rpartition("::")[2])
        if inside is None:
            return
        for inner in element.findall("innerclass"):
            if inner.get("prot") == "public" and inner.get("refid") in self.compounds:
                self.compound(self.compounds[inner.get("refid")], inside, full)
        for member in element.findall("sectiondef/memberdef"):
            self.member(member, full, inside)


def compounds_of(xml):
    """Every class by its id, every header by its path."""
    classes, files, inner = {}, {}, set()
    for path in sorted(xml.glob("*.xml")):
        if path.name in ("index.xml", "Doxyfile.xml"):
            continue
        for element in ET.parse(path).getroot().findall("compounddef"):
            if element.get("kind") in ("class", "struct", "union"):
                classes[element.get("id")] = element
                inner |= {i.get("refid") for i in element.findall("innerclass")}
            elif element.get("kind") == "file":
                files[element.find("location").get("file")] = element
    return classes, files, inner


def header_part(page, header, files, inner):
    """All that one header declares, by namespace."""
    element = files[header]
    scopes = {}
    for one in element.findall("innerclass"):
        compound = page.compounds.get(one.get("refid"))
        if compound is None or one.get("prot") == "private" or one.get("refid") in inner or "@" in words(one):
            continue
        full = words(compound.find("compoundname"))
        scopes.setdefault(full.rpartition("::")[0], []).append(("class", compound))
    for member in element.findall("sectiondef/memberdef"):
        full = words(member.find("qualifiedname")) or words(member.find("name"))
        scopes.setdefault(full.rpartition("::")[0], []).append(("member", member))
    for scope, items in scopes.items():
        if "@" in scope or scope.endswith("::detail"):
            continue
        if page.language == "cpp":
            page.lines += [f".. cpp:namespace:: {scope or 'NULL'}", ""]
        for what, item in items:
            if what == "class":
                page.compound(item, 0, scope)
            else:
                page.member(item, scope, 0)


def heading(text, line):
    return [text, line * len(text), ""]


def formulas(code):
    """What a header says above its formulas: (name, comment) of all that name their source, as they stand."""
    for block in re.finditer(r"((?:^///.*\n)+)((?:template <.*\n)?.*\n)", code, re.M):
        if "Source:" not in block[1]:
            continue
        declared = re.sub(r"template <[^\n]*\n", "", block[2])
        name = re.search(r"(?:struct|class) (\w+)|(\w+)\(|(\w+)(?= ?[={])", declared)
        if not name:
            continue
        element = ET.Element("member")
        ET.SubElement(ET.SubElement(element, "detaileddescription"), "verbatim").text = block[1]
        yield name[1] or name[2] or name[3], comment(element)


def folder_page(folder, says, headers, xml_of, example):
    """The page of one folder, and the names on it as (scope, name)."""
    classes, files, inner = xml_of
    page = Page("cpp", classes)
    page.lines += heading(f"C++: {folder}", "=")
    page.lines += [
        escaped(says["what"][0].upper() + says["what"][1:] + "."),
        "",
        escaped(says["threads"]),
        "",
        ".. code-block:: cpp",
        "",
        *("   " + line for line in example.split("\n")),
        "",
    ]
    for header in headers:
        page.lines += heading(header, "-")
        header_part(page, header, files, inner)
    return "\n".join(page.lines) + "\n", page.names, page.unparsed


def c_page(header, raw, xml_of, example):
    """The page of raceway.h."""
    classes, files, inner = xml_of
    page = Page("c", classes)
    page.lines += heading("C API", "=")
    head = re.match(r"((?:///.*\n)+)", raw)[1]
    element = ET.Element("member")
    ET.SubElement(ET.SubElement(element, "detaileddescription"), "verbatim").text = "\n".join(" " + line[4:] for line in head.split("\n"))
    page.lines += comment(element)
    page.lines += [".. code-block:: c", "", *("   " + line if line else "" for line in example.split("\n")), ""]
    page.lines += heading("raceway/raceway.h", "-")
    header_part(page, header, files, inner)
    return "\n".join(page.lines) + "\n", page.names, page.unparsed
