"""Lays the pages of the site together in build/docs/source; called by scripts/docs.

The pages of docs/ and the notebooks stay where they are in the tree and in the copy, so that their links hold
for both. What the program knows is asked of it: its commands, effects, laws and keys of files; what the headers know, of
Doxygen. What must be found on which page goes into build/docs/expected.json, for scripts/docs_check.py.
"""

import inspect
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

import docs_cpp
import docs_json

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "build/docs"
SOURCE = WORK / "source"
PROGRAM = ROOT / "build/release/raceway"
UMBRELLA = ROOT / "build/release/umbrella"
FOLDERS = "record fit verdict tolerance loop bearing friction life effects model rig shaft spindle correction text files results report control session".split()
# Pages outside docs/ that pages link to.
OTHER_PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "bench/README.md"]
# What a link to a folder means here.
FOLDER_PAGES = {
    **{f: f"reference/cpp/{f}.rst" for f in FOLDERS},
    "friction/contact": "reference/cpp/friction.rst",
    "docs": "index.md",
    "examples": "tutorials.md",
    "cli": "reference/commands/index.md",
    "python": "reference/python/index.rst",
    "c": "reference/c.rst",
}

expected = []


def expect(name, page, kind):
    expected.append({"name": name, "page": page, "kind": kind})


def asked(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True, cwd=ROOT).stdout


def write(page, text):
    path = SOURCE / page
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def for_table(text):
    """Plain words in a cell of Markdown."""
    return re.sub(r"([|*_<>\[\]`\\])", r"\\\1", text)


def prose(text):
    return re.sub(r"([*_<>\[\]`\\])", r"\\\1", text)


def code(text, language=""):
    return f"```{language}\n{text.strip(chr(10))}\n```\n"


def number(value):
    return "" if value is None else f"{value:.6g}"


# ---- pages that people write


def with_links_of_the_site(text, page):
    """Links to folders lead to the page that says what is in them; those to folders without one become words."""
    base = (ROOT / page).parent

    def one(match):
        shown, target = match[1], match[2]
        if re.match(r"[a-z]+:|#", target):
            return match[0]
        path = (base / target.partition("#")[0]).resolve()
        if not path.exists():
            sys.exit(f"{page}: {match[0]} leads to nothing")
        inside = path.relative_to(ROOT).as_posix()
        if path.is_dir():
            to = FOLDER_PAGES.get(inside)
            return f"[{shown}]({'../' * page.count('/')}{to})" if to else f"`{inside}/`"
        if not inside.startswith(("docs/", "examples/")) and inside not in OTHER_PAGES:
            copy = SOURCE / "files" / inside
            copy.parent.mkdir(parents=True, exist_ok=True)
            # Pages of data are read as they are; of this suffix Sphinx would make pages.
            copy = copy.with_name(copy.name + ".txt") if copy.suffix == ".md" else copy
            shutil.copy(path, copy)
            return f"[{shown}]({'../' * page.count('/')}files/{copy.relative_to(SOURCE / 'files').as_posix()})"
        return match[0]

    return re.sub(r"(?<!!)\[([^\]\[]*(?:\[[^\]]*\][^\]\[]*)*)\]\(([^)\s]+)\)", one, text)


def copy_pages():
    shutil.copytree(ROOT / "docs/site", SOURCE, ignore=shutil.ignore_patterns("__pycache__", "site.css"))
    (SOURCE / "_static").mkdir()
    for page in ("docs/site/site.css", "build/share/raceway/workbench.html"):
        shutil.copy(ROOT / page, SOURCE / "_static")
    for page in [*OTHER_PAGES, *(f"docs/{p.name}" for p in sorted((ROOT / "docs").glob("*.md")) if p.name != "README.md")]:
        write(page, with_links_of_the_site((ROOT / page).read_text(encoding="utf-8"), page))
    for picture in (ROOT / "docs").iterdir():
        if picture.suffix in (".svg", ".png"):
            shutil.copy(picture, SOURCE / "docs")
    (SOURCE / "examples").mkdir()
    for path in sorted((ROOT / "build/notebooks").glob("*.ipynb")):
        notebook = json.loads(path.read_text(encoding="utf-8"))
        for cell in notebook["cells"]:
            if cell["cell_type"] == "markdown":
                words = with_links_of_the_site("".join(cell["source"]), f"examples/{path.name}")
                cell["source"] = words
        write(f"examples/{path.name}", json.dumps(notebook))


# ---- what the program says of itself


def help_of(words):
    """The parts of a help text: sentences, usage, tables of (name, meaning), example."""
    parts, title = {"": []}, ""
    for line in words.split("\n"):
        head = re.match(r"([A-Z][A-Za-z ]*):$", line)
        if head:
            title = head[1]
            parts[title] = []
        elif line.startswith("Usage: "):
            parts["Usage"] = [line[7:]]
        else:
            parts[title].append(line)
    return parts


def options(lines):
    rows = []
    for line in lines:
        row = re.match(r"  (\S.*?)(?:  +(.*))?$", line)
        if line[:1] not in ("", " "):
            break  # what stands below a table
        if row and not line.startswith("   "):
            rows.append([row[1], [row[2]] if row[2] else []])
        elif line.strip() and rows:
            rows[-1][1].append(line.strip())
    return [(name, " ".join(meaning)) for name, meaning in rows]


def command_pages():
    top = help_of(asked("--help"))
    groups = {title: options(lines) for title, lines in top.items() if title not in ("", "Usage", "Options", "Example")}
    commands = [command for group in groups.values() for command in group]
    for name, meaning in commands:
        parts = help_of(asked(name, "--help"))
        text = f"# raceway {name}\n\n" + prose(" ".join(parts[""]).strip().rstrip(".") or meaning) + ".\n\n"
        text += code(parts["Usage"][0], "text") + "\n"
        for title, lines in parts.items():
            if title in ("", "Usage", "Example", "Examples"):
                continue
            rows = options(lines)
            if rows:
                text += f"## {title}\n\n| | |\n| --- | --- |\n"
                text += "".join(f"| `{n}` | {for_table(m)} |\n" for n, m in rows) + "\n"
        for title in ("Example", "Examples"):
            if title in parts:
                text += "## Example\n\n" + code("\n".join("$ " + l.strip() for l in parts[title] if l.strip()), "console")
        write(f"reference/commands/{name}.md", text)
        expect(name, f"reference/commands/{name}", "command")
    text = "# Commands\n\nThe arguments and flags of each command, as its `--help` prints them.\n\n"
    for group, rows in groups.items():
        text += f"## {group}\n\n| command | what it does |\n| --- | --- |\n"
        text += "".join(f"| [`{n}`]({n}.md) | {for_table(m)} |\n" for n, m in rows) + "\n"
    said = [line for line in top["Options"] if line and not line.startswith(" ")]
    text += "\n" + prose(" ".join(said)) + "\n\n"
    text += code("\n".join("$ " + l.strip() for l in top["Example"] if l.strip()), "console")
    text += "\n```{toctree}\n:hidden:\n\n" + "\n".join(n for n, _ in commands) + "\n```\n"
    write("reference/commands/index.md", text)


def joined(value):
    return ", ".join(value) if isinstance(value, list) else str(value)


def effect_pages():
    pages = {}
    for effect in json.loads(asked("effects", "--json"))["effects"]:
        pages.setdefault(effect["id"], []).append(effect)
    where = {"rig": "a bearing on a rig", "shaft": "a shaft with an `[arrangement]`", "spindle": "a whole spindle"}
    for name, forms in pages.items():
        said = asked("effects", name)
        blocks = re.findall(r"in a model file:\n\n((?:  .*\n)+)", said + "\n")
        text = f"# {name}\n\n"
        for form in forms:
            over_time = "of_this_record_alone" in form
            title = form["title"]
            text += f"## {prose(title[0].upper() + title[1:])}\n\n" if len(forms) > 1 else f"**{prose(title[0].upper() + title[1:])}.** "
            text += (prose(form["mechanism"]) if form.get("mechanism") else "") + "\n\n"
            facts = [("changes", joined(form["acts_on"]).replace("_", " "))]
            if form.get("acts_in"):
                facts.append(("in a model of", ", ".join(where[one] for one in form["acts_in"])))
            if over_time:
                facts.append(("in a model of", "a displacement over time, `[correction]`"))
            for key, label in (
                ("kind", "kind"),
                ("acts_at", "acts at"),
                ("needs", "needs"),
                ("supplies", "with the supply"),
                ("within_contact_law", "the law contact has it as"),
                ("confused_with", "looks like"),
                ("source", "source"),
            ):
                if form.get(key):
                    value = for_table(joined(form[key]))
                    if key == "confused_with":
                        value = ", ".join(
                            f"[{one}]({one}.md)" if one in pages else for_table(one)
                            for one in (form[key] if isinstance(form[key], list) else [form[key]])
                        )
                    facts.append((label, value))
            text += code(form["formula"], "text") + "\n| | |\n| --- | --- |\n"
            text += "".join(f"| {label} | {value} |\n" for label, value in facts) + "\n"
            if form["parameters"]:
                text += "| parameter | unit | start | range | usual | no effect at |\n| --- | --- | --- | --- | --- | --- |\n"
                for key, p in form["parameters"].items():
                    usual = f"{number(p.get('usual_lower'))} to {number(p.get('usual_upper'))}" if p.get("usual_upper") is not None else ""
                    limits = f"{number(p['lower'])} to {number(p['upper'])}" if p.get("lower") is not None and p.get("upper") is not None else ""
                    text += (
                        f"| `{key}` | {for_table(p['unit'])} | {number(p.get('initial'))} | {limits} | {usual} | "
                        f"{number(p.get('no_effect_at'))} |\n"
                    )
                    expect(key, f"reference/effects/{name}", "number of an effect")
                text += "\n"
        for block in blocks:
            text += "In a model file:\n\n" + code("\n".join(line[2:] for line in block.rstrip("\n").split("\n")), "toml") + "\n"
        over_time = "of_this_record_alone" in forms[0]
        files = "machine.toml" if over_time else "rig.toml"
        text += "Found in a record, and added where it helps on rows that the fit did not see:\n\n"
        text += code(f"$ raceway diagnose {files} record.csv\n$ raceway add {files} {name} --data record.csv -o better.toml", "console")
        write(f"reference/effects/{name}.md", text)
        expect(name, f"reference/effects/{name}", "effect")
    text = "# Effects\n\nThe catalogues, as `raceway effects` has them; [docs/effects.md](../../docs/effects.md) says how they are used, and how "
    text += "one of your own is written.\n\n" + code("$ raceway effects windage", "console") + "\n| effect | |\n| --- | --- |\n"
    text += "".join(f"| [{n}]({n}.md) | {for_table('; '.join(f['title'] for f in forms))} |\n" for n, forms in pages.items())
    text += "\n```{toctree}\n:hidden:\n\n" + "\n".join(pages) + "\n```\n"
    write("reference/effects/index.md", text)


def key_pages():
    """The keys of model files, a page for each table with the tables in it."""
    pages = {}
    for key in json.loads(asked("keys", "--json"))["keys"]:
        pages.setdefault(key["table"].split(".")[0], {}).setdefault(key["table"], []).append(key)
    for page, tables in pages.items():
        title = ", ".join(f"[{t}]" for t in tables) if len(tables) <= 2 else f"[{page}]"
        text = f"# Keys of {prose(title)}\n\n"
        text += "Asked of the program, on the command line:\n\n" + code(f'$ raceway keys "[{page}]"', "console") + "\n"
        for table, keys in tables.items():
            if len(tables) > 1:
                text += f"## {prose('[' + table + ']')}\n\n"
            text += "| key | meaning | range | default |\n| --- | --- | --- | --- |\n"
            for key in keys:
                unit = "" if key["unit"] in (None, "1") else " " + key["unit"]
                limits = f"{number(key['from'])} to {number(key['to'])}{unit}" if key["from"] is not None and key["to"] is not None else unit
                if key["choices"]:
                    limits = ", ".join(f'`"{one}"`' for one in key["choices"])
                default = "**required**" if key["required"] else for_table(key["default"] or "")
                text += f"| `{key['key']}` | {for_table(key['meaning'])} | {limits if key['choices'] else for_table(limits)} | {default} |\n"
                expect(key["key"], f"reference/keys/{page}", "key")
            text += "\n"
        write(f"reference/keys/{page}.md", text)
    text = "# Keys of model files\n\nEvery key of a model, with its unit, its range, its default and what it means. "
    text += "[Files](../../docs/files.md) says how they go together, and what measurements and results look like; numbers of effects are "
    text += "on [their pages](../effects/index.md).\n\n"
    text += code('[bearing]\ncatalogue = "S 6014 C"\n\n[lubricant]\nviscosity_40C_mm2_s = 22.0\nviscosity_100C_mm2_s = 4.8', "toml") + "\n"
    text += "| table | keys |\n| --- | --- |\n"
    for page, tables in pages.items():
        for table, keys in tables.items():
            text += f"| [{prose('[' + table + ']')}]({page}.md) | " + ", ".join(f"`{k['key']}`" for k in keys) + " |\n"
    text += "\n```{toctree}\n:hidden:\n\n" + "\n".join(pages) + "\n```\n"
    write("reference/keys/index.md", text)


def unit_page():
    """The units of columns with their spellings, and the columns of measurements, from the tables that read them."""
    source = (ROOT / "text/units.cpp").read_text(encoding="utf-8")
    units = re.findall(r'Unit\{"([^"]*)", "([^"]*)", D::(\w+),(.*?)\}(?:,|;)', source, re.S)
    text = "# Units and columns\n\nThe units that a column may have, at the end of its name or in brackets: [files](../docs/files.md#units). An `_` is a `/` in a header.\n\n"
    text += code("friction_torque_Nm\nspeed [1/min]\nDrehmoment (N m)", "text") + "\n| quantity | unit | also |\n| --- | --- | --- |\n"
    for suffix, words, dimension, rest in units:
        also = " ".join("".join(re.findall('"([^"]*)"', one)) for one in re.split(r",\s+", rest) if '"' in one).split()
        text += f"| {dimension.replace('moment', 'torque')} | `{suffix}`, {for_table(words)} | {for_table(', '.join(dict.fromkeys(also)))} |\n"
    text += "\n## Columns of measurements\n\n| column | | range |\n| --- | --- | --- |\n"
    for fields in re.findall(r"Channel\{(\.name = .*?)\}", (ROOT / "record/channel.h").read_text(encoding="utf-8"), re.S):
        field = {key: value.strip().strip('"') for key, value in re.findall(r"\.(\w+) = ([^,]*)", fields)}
        limits = [field.get(key, "") for key in ("lower", "upper")]
        limits = "" if "" in limits or "endless" in limits else f"{limits[0]} to {limits[1]} {field['unit']}"
        text += f"| `{field['name']}` | {field.get('role', 'setting').removeprefix('Role::')} | {for_table(limits)} |\n"
    write("reference/units.md", text)


def document_page():
    """The documents of --json and the codes of notes."""
    text, codes = docs_json.page(ROOT, PROGRAM, for_table)
    write("reference/documents.md", text)
    for code_of_note in codes:
        expect(code_of_note, "reference/documents", "code of a note")


LAWS = {
    "palmgren": ["friction/palmgren.h"],
    "skf": ["friction/skf.h"],
    "contact": [
        "friction/contact/rolling.h",
        "friction/contact/film.h",
        "friction/contact/traction.h",
        "friction/contact/hysteresis.h",
        "friction/contact/shear.h",
        "friction/contact/oil.h",
        "friction/contact/roelands.h",
        "friction/contact/contact_law.h",
    ],
    "powers, contact-powers": ["friction/powers.h"],
    "table": ["friction/torque_table.h"],
    "spin-friction": ["friction/spin.h"],
    "lubricant, heat": ["friction/lubricant.h", "friction/heat.h"],
}


def law_page():
    """The formulas of the laws, from the comments above the code that evaluates them."""
    text = "Laws\n====\n\nThe formulas with source, domain and accuracy, as they stand above the code that evaluates them. Which law when, and "
    text += "what each ignores of a bearing: :doc:`/docs/laws`. References: :download:`references.bib </files/data/references.bib>`.\n\n"
    text += '.. code-block:: toml\n\n   [friction]\n   law = "palmgren"   # or "skf", "contact", "powers", "contact-powers", "table"\n\n'
    copy = SOURCE / "files/data/references.bib"
    copy.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(ROOT / "data/references.bib", copy)
    for title, headers in LAWS.items():
        text += title + "\n" + "-" * len(title) + "\n\n"
        for header in headers:
            for name, lines in docs_cpp.formulas((ROOT / header).read_text(encoding="utf-8")):
                text += f"{name}\n{'~' * len(name)}\n\n" + "\n".join(lines) + f"\n*{header}*\n\n"
                expect(name, "reference/laws", "law")
    write("reference/laws.rst", text)


# ---- Python


def python_pages():
    sys.path.insert(0, str(ROOT / "build/release/python"))
    import raceway
    import raceway.plot
    import raceway.sweep

    groups = {
        "models": ("Models and records", ["Model", "Record", "read"]),
        "results": (
            "Results",
            [
                "Solution",
                "Table",
                "Displacement",
                "Comparison",
                "Check",
                "Calibration",
                "Diagnosis",
                "Addition",
                "Sensitivity",
                "KinematicLaw",
                "fit_law",
            ],
        ),
        "correction": ("Corrections of machines", ["Correction", "Identification", "CorrectionRun", "Program"]),
        "spindle": ("Spindles", ["SteadyStates", "SpindleRun", "Modes", "Deflection", "StepResponses"]),
        "effect": ("Effects of your own, errors", ["Effect", "Number", "State", "InputError", "NotConverged", "Doubt", "Note"]),
    }
    left = set(raceway.__all__) - {"__version__"} - {name for _, names in groups.values() for name in names}
    if left:
        sys.exit(f"scripts/docs_pages.py: no page for {', '.join(sorted(left))} of the package raceway")
    for page, (title, names) in groups.items():
        text = f"Python: {title}\n" + "=" * (len(title) + 8) + "\n\n.. py:currentmodule:: raceway\n\n"
        example = PYTHON_EXAMPLES[page]
        text += ".. code-block:: python\n\n" + "\n".join("   " + line for line in example.strip().split("\n")) + "\n\n"
        for name in names:
            text += entry(raceway, name, name, page)
        write(f"reference/python/{page}.rst", text)
    for page, title, module in (("plot", "pictures", raceway.plot), ("sweep", "many items", raceway.sweep)):
        text = f"Python: {title}\n" + "=" * (len(title) + 8) + f"\n\n.. py:currentmodule:: {module.__name__}\n\n"
        if page in PYTHON_EXAMPLES:
            text += ".. code-block:: python\n\n" + "\n".join("   " + line for line in PYTHON_EXAMPLES[page].strip().split("\n")) + "\n\n"
        text += inspect.getdoc(module) + "\n\n"
        for name in module.__all__:
            text += entry(module, name, f"{page}.{name}", page)
        write(f"reference/python/{page}.rst", text)
    text = "Python API\n==========\n\n" + inspect.getdoc(raceway) + "\n\n.. toctree::\n   :maxdepth: 1\n\n"
    text += "".join(f"   {page}\n" for page in [*groups, "plot", "sweep"])
    write("reference/python/index.rst", text)


def entry(module, name, shown, page):
    """The section of a class or a function, which the search must find, and so the members of a class."""
    one = getattr(module, name)
    expect(shown, f"reference/python/{page}", "python")
    if inspect.isclass(one):
        own = [c for c in one.__mro__ if c.__module__.startswith("raceway")]
        for member in dict.fromkeys(member for c in own for member in vars(c)):
            if not member.startswith("_") and inspect.getdoc(getattr(one, member, None)):
                expect(f"{shown}.{member}", f"reference/python/{page}", "python")
    kind = "class" if inspect.isclass(one) else "function"
    return f"{name}\n{'-' * len(name)}\n\n.. auto{kind}:: {module.__name__}.{name}\n\n"


PYTHON_EXAMPLES = {
    "plot": """
import raceway
model = raceway.Model.new("S 6014 C")
table = model.table(speed_rpm=range(0, 12001, 500), axial_load_N=[100, 300])
raceway.plot.stribeck(table).figure.savefig("stribeck.pdf")
""",
    "models": """
import raceway
model = raceway.Model.new("S 6014 C")
print(model.solve(speed_rpm=[0, 6000, 12000], axial_load_N=300).friction_torque_Nmm)
""",
    "results": """
train = raceway.Record.read("train.csv")
diagnosis = raceway.Model.read("model.toml").diagnose(train)
print(diagnosis.headline)
print(diagnosis.fit_report())
""",
    "correction": """
machine = raceway.Correction.read("correction.toml")
record = raceway.Record.read("train.csv")
print(machine.diagnose(record).headline)
""",
    "spindle": """
spindle = raceway.Model.read("data/spindles/small.toml")
steady = spindle.steady([2000, 6000])
""",
    "effect": """
drag = raceway.Effect("my-drag", numbers={"size_Nmm": raceway.Number(10.0, unit="N mm")},
                      moment=lambda state, numbers: numbers["size_Nmm"])
""",
}


# ---- C++ and C


def cpp_pages():
    headers = {f: re.findall(r'#include "(.*)"', (UMBRELLA / f / "all.h").read_text(encoding="utf-8")) for f in FOLDERS}
    xml = docs_cpp.compounds_of(docs_cpp.run_doxygen(ROOT, [h for f in FOLDERS for h in headers[f]] + ["c/raceway.h"], WORK))
    table = dict(re.findall(r"^\| `(\w+)/` \| (.*?) \|", (ROOT / "docs/design.md").read_text(encoding="utf-8"), re.M))
    unparsed = []
    for folder in FOLDERS:
        head = (UMBRELLA / folder / "all.h").read_text(encoding="utf-8")
        threads = re.search(r"// (Threads: .*\n(?:// .*\n)*)", head)[1].replace("\n// ", " ").strip()
        example = f'#include "{folder}/all.h"  // of the CMake target raceway::{folder}'
        text, names, left = docs_cpp.folder_page(folder, {"what": table[folder], "threads": threads}, headers[folder], xml, example)
        write(f"reference/cpp/{folder}.rst", text)
        unparsed += left
        for scope, name in names:
            expect(name, f"reference/cpp/{folder}", "C++")
    text = "C++ API\n=======\n\nBy folder; each includes from those above it. Every header that users of the library need is here, "
    text += "with the comments that stand in it.\n\n.. code-block:: cmake\n\n   find_package(raceway REQUIRED)\n"
    text += "   target_link_libraries(my_program PRIVATE raceway::friction)\n\n.. toctree::\n   :maxdepth: 1\n\n"
    text += "".join(f"   {f}\n" for f in FOLDERS)
    write("reference/cpp/index.rst", text)
    raw = (ROOT / "c/raceway.h").read_text(encoding="utf-8")
    example = (ROOT / "tests/install/example.c").read_text(encoding="utf-8")
    text, names, left = docs_cpp.c_page("c/raceway.h", raw, xml, example.strip())
    write("reference/c.rst", text)
    for _, name in names:
        expect(name, "reference/c", "C")
    print(f"{sum(e['kind'] == 'C++' for e in expected)} declarations of C++, " f"{len(unparsed)} of them as code that Sphinx does not parse")
    return unparsed + left


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    copy_pages()
    command_pages()
    effect_pages()
    key_pages()
    unit_page()
    document_page()
    law_page()
    python_pages()
    cpp_pages()
    write("reference/index.md", (SOURCE / "reference.md").read_text(encoding="utf-8"))
    (SOURCE / "reference.md").unlink()
    (WORK / "expected.json").write_text(json.dumps(expected, indent=0), encoding="utf-8")


if __name__ == "__main__":
    main()
