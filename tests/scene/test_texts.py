"""Text of a stranger is data in everything that is written of a scene: it is refused, or arrives as it was."""

from __future__ import annotations

import ast
import csv
import json
import os
import subprocess
import unicodedata
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from runtime import Solution, load_model, simulate
from runtime.contract.escapes import c_comment, c_string
from runtime.contract.model import EmittedModel
from runtime.engine.c_source import find_compiler
from runtime.export.c_bundle import Exported, exported, write_c
from runtime.export.fmu import fmu_texts
from symgen.generate import generate, model_of
from symgen.scene import SceneError, SceneRecord
from symgen.schema.fields import StrictModel
from symgen.urdf import read as read_urdf

LINES = {  # one line each: where they stand
    "title": ("title",),
    "unit of k": ("parameters", "k", "unit"),
    "unit of u": ("inputs", "u", "unit"),
    "unit of s": ("states", "s", "unit"),
}
PARAGRAPHS = {
    "description": ("description",),
    "k": ("parameters", "k", "description"),
    "u": ("inputs", "u", "description"),
    "s": ("states", "s", "description"),
    "table": ("tables", "c", "description"),
    "surface": ("tables", "d", "description"),
    "event": ("events", "late", "description"),
}
FIELDS = LINES | PARAGRAPHS
FRAGMENTS = [
    '"""', "'''", "\\", '\\"""', "\\N{", "\\x", "\\u12", "*/", "/*", "??/", "//", "#", "{", "}", "${", "%s", "@@data@@",
    "</script>", "<script>alert(1)</script>", "<!--", "-->", "]]>", "&amp;", "<", ">", '"', "'", "`", "|", "```", "$",
    "\\[", "[a](b)", "![", "- ", "1. ", "=", "---", ",", ";", "=1+1", "@", "\ufeff", "\u200d", "é", "漢", "𝄞", "\xa0",
]  # fmt: skip
ANY = st.text(st.characters(exclude_categories=()), max_size=12)
TEXTS = st.lists(st.one_of(st.sampled_from(FRAGMENTS), ANY), max_size=5).map("".join)
GOOD_TEXTS = TEXTS.map(lambda text: "".join(char for char in text if allowed(char)))
SLOW = [HealthCheck.too_slow, HealthCheck.function_scoped_fixture]


def allowed(char: str) -> bool:
    """By the rules of Unicode, apart from the code: prints, and neither ends a line nor turns the direction."""
    turns = unicodedata.bidirectional(char) in {"LRE", "RLE", "LRO", "RLO", "PDF", "LRI", "RLI", "FSI", "PDI"}
    no_character = ord(char) & 0xFFFE == 0xFFFE or 0xFDD0 <= ord(char) < 0xFDF0
    return unicodedata.category(char) not in ("Cc", "Cs", "Zl", "Zp") and not turns and not no_character


def scene_data(texts: dict[str, str]) -> dict[str, Any]:
    """A scene that has every kind of text, with these in the fields they name."""
    data: dict[str, Any] = {
        "name": "arm",
        "gravity": [0, -9.81],
        "parameters": {"k": {"default": 1.0}},
        "inputs": {"u": {"default": 0.0}},
        "states": {"s": {"rate": "u - s"}},
        "tables": {"c": {"x": [0, 1], "y": [0, 1]}, "d": {"x": [0, 1], "y": [0, 1], "z": [[0, 1], [1, 0]]}},
        "bodies": [{"type": "rigid", "name": "arm", "mass": "k", "inertia": 0.1, "center_of_mass": [0.5, 0]}],
        "joints": [{"type": "revolute", "name": "pin", "marker_a": "ground.origin", "marker_b": "arm.origin"}],
        "loads": [
            {"type": "torque", "name": "drive", "marker": "arm.origin", "value": "s + table('c', t) + table('d', t, s)"}
        ],
        "measures": [{"type": "x", "name": "tip", "of": "arm.center"}],
        "events": {"late": {"when": "t - 0.01", "action": {"u": 1.0}}},
        "simulation": {"t_end": 0.02, "dt": 0.01, "scheme": "rk4"},
    }
    for field, text in texts.items():
        place = data
        *above, last = FIELDS[field]
        for key in above:
            place = place[key]
        place[last] = text
    return data


@cache
def base_run() -> Solution:
    """A run of the scene without texts."""
    return simulate(model_of(SceneRecord(**scene_data({}))))


@cache
def base_export() -> Exported:
    """Its code to be handed on."""
    return exported(base_run().model)


def titled(model: EmittedModel, texts: dict[str, str]) -> EmittedModel:
    """The base model with the texts of a scene, as far as a run shows them; nothing is derived anew."""
    found = model_of(SceneRecord(**scene_data(texts)))
    return replace(model, description=replace(found.description, functions=model.description.functions))


class Page(HTMLParser):
    """Tags, attributes and text of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.handlers: list[str] = []
        self.attributes: list[tuple[str, str]] = []
        self.text: list[str] = []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.handlers += [name for name, _ in attrs if name.startswith("on")]
        self.attributes += [(name, value or "") for name, value in attrs]

    def handle_data(self, data: str) -> None:
        self.text.append(data)


# ---- the schema ---------------------------------------------------------------------------------------------------


def _records(cls: type[StrictModel] = StrictModel) -> Iterator[type[StrictModel]]:
    for one in cls.__subclasses__():
        yield one
        yield from _records(one)


def test_no_field_of_a_scene_takes_any_text() -> None:
    """A field of texts has something that looks at them: a name, an expression, a reference, a line, a paragraph."""
    unchecked = [
        f"{cls.__name__}.{key}"
        for cls in _records()
        for key, field in cls.model_fields.items()
        if field.annotation is str and not any(hasattr(one, "func") for one in field.metadata)
    ]
    assert SceneRecord in set(_records()) and not unchecked


@pytest.mark.parametrize("field", FIELDS)
@pytest.mark.parametrize(
    "char", ["\x00", "\x01", "\x1b", "\x7f", "\x85", "\x9b", "\r", "\u2028", "\u2029", "\ud800", "\u202e", "\u2067",
             "\ufffe", "\U0010ffff"], ids=lambda char: f"U+{ord(char):04X}",
)  # fmt: skip
def test_what_no_text_may_hold_is_refused_by_name(field: str, char: str) -> None:
    with pytest.raises(SceneError) as caught:
        SceneRecord(**scene_data({field: f"ab{char}cd"}))
    (error,) = [caught.value, *caught.value.also]
    assert error.item == ".".join(FIELDS[field])
    assert f"character 3, U+{ord(char):04X}" in error.problem and error.remedy


def test_line_breaks_are_where_they_are_meant() -> None:
    for field in LINES:
        with pytest.raises(SceneError, match="one line"):
            SceneRecord(**scene_data({field: "one\ntwo"}))
    texts = dict.fromkeys(PARAGRAPHS, "one\r\n\ttwo")
    assert SceneRecord(**scene_data(texts)) == SceneRecord(**scene_data(dict.fromkeys(PARAGRAPHS, "one\n\ttwo")))


@given(st.dictionaries(st.sampled_from(list(FIELDS)), TEXTS, min_size=1))
@settings(max_examples=100, deadline=None, suppress_health_check=SLOW)
def test_any_text_is_refused_or_kept(texts: dict[str, str]) -> None:
    """Refused where it holds a character that no text may have; else it is in the TOML that is read back."""
    bad = {
        ".".join(FIELDS[field])
        for field, text in texts.items()
        for char in (text.replace("\r\n", "\n") if field in PARAGRAPHS else text)
        if not (allowed(char) or (field in PARAGRAPHS and char in "\n\t"))
    }
    try:
        scene = SceneRecord(**scene_data(texts))
    except SceneError as error:
        assert bad and {one.item for one in (error, *error.also)} == bad
        assert all(char.isprintable() for char in str(error))
        return
    assert not bad
    assert SceneRecord.from_toml_text(scene.to_toml()) == scene
    for field, text in texts.items():
        found: Any = scene.to_dict()
        for key in FIELDS[field]:
            found = found.get(key, "")
        assert found == text.replace("\r\n", "\n")


def test_a_robot_is_looked_at_as_any_scene(tmp_path: Path) -> None:
    body = (
        '<link name="base"/><link name="a"><inertial><mass value="1"/>'
        '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
        '<joint name="j" type="revolute"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/>'
        '<limit effort="1" velocity="1" lower="-1" upper="1"/></joint></robot>'
    )
    mark = tmp_path / "ran"
    name = f"&quot;&quot;&quot;+str(open('{mark}','w'))+&quot;&quot;&quot;"
    (tmp_path / "r.urdf").write_text(f'<robot name="{name}">{body}')
    model = read_urdf(tmp_path / "r.urdf").model()
    assert model.title.startswith('"""+str(') and not mark.exists()
    for char in ("&#10;", "&#x9b;", "&#x202e;"):
        (tmp_path / "r.urdf").write_text(f'<robot name="a{char}b">{body}')
        with pytest.raises(SceneError, match="title: its character 2"):
            read_urdf(tmp_path / "r.urdf").build()


# ---- what is written ----------------------------------------------------------------------------------------------

GOOD = st.fixed_dictionaries({field: GOOD_TEXTS for field in FIELDS})
VERBATIM = {"title": '"""\\', "unit of k": "m|<b>", "k": "*/", "event": "`"}


@given(GOOD)
@settings(max_examples=15, deadline=None, suppress_health_check=SLOW)
def test_texts_are_data_in_generated_folders(tmp_path_factory: Any, texts: dict[str, str]) -> None:
    """model.py is a docstring, imports and definitions, and its docstring has the title; JSON, TOML, Markdown."""
    folder = generate(SceneRecord(**scene_data(texts)), tmp_path_factory.mktemp("texts"), frozenset({"measures"}))
    tree = ast.parse((folder / "model.py").read_text(encoding="utf-8"))
    doc, *rest = tree.body
    assert isinstance(doc, ast.Expr) and isinstance(doc.value, ast.Constant)
    assert str(doc.value.value).startswith(f"{texts['title'] or 'arm'}: equations of motion")
    assert {type(one) for one in rest} <= {ast.Import, ast.ImportFrom, ast.FunctionDef, ast.Assign, ast.AnnAssign}
    model = load_model(folder)
    about = {entry.name: (entry.unit, entry.meaning) for entry in model.parameters}
    assert model.title == (texts["title"] or "arm")
    assert about["k"] == (texts["unit of k"], texts["k"]) and about["u"] == (texts["unit of u"], texts["u"])
    assert json.loads((folder / "manifest.json").read_text(encoding="utf-8"))["description"] == texts["description"]
    assert SceneRecord.from_toml(folder / "scene.toml").title == texts["title"]
    _check_markdown((folder / "model.md").read_text(encoding="utf-8"), texts)


def _check_markdown(page: str, texts: dict[str, str]) -> None:
    renderer = pytest.importorskip("markdown")
    found = Page(renderer.markdown(page, extensions=["tables"]))
    assert set(found.tags) <= {"h1", "h2", "p", "ul", "li", "code", "table", "thead", "tbody", "tr", "th", "td"}
    assert found.tags.count("h1") == 1 and not found.handlers
    plain = "".join("".join(found.text).split())
    for text in (texts["title"], texts["unit of k"], *texts["description"].split("\n")):
        shown = "".join(char if char.isprintable() else char.encode("unicode_escape").decode() for char in text.strip())
        # this renderer leaves the backslash before some signs, where CommonMark takes it away
        bare = "".join(shown.split()).replace("\\", "")
        assert bare in plain.replace("\\", "")


@given(GOOD)
@settings(max_examples=25, deadline=None, suppress_health_check=SLOW)
def test_texts_are_data_in_what_is_seen_and_handed_on(tmp_path_factory: Any, texts: dict[str, str]) -> None:
    """Cards and pages in HTML, the description of an FMU in XML, headers of CSV, reports in JSON."""
    base, folder = base_run(), tmp_path_factory.mktemp("texts")
    run = replace(base, model=titled(base.model, texts))
    title = texts["title"] or "arm"
    for thing in (SceneRecord(**scene_data(texts)), run.model, run):
        card = Page(thing._repr_html_())
        assert "script" not in card.tags and "img" not in card.tags and not card.handlers
        assert title in "".join(card.text)
    cells = Page(run.model._repr_html_()).text
    assert all(not text or text in cells for text in (texts["unit of k"], texts["k"]))
    page = Page(run.view(folder / "view.html").text)
    assert page.tags.count("script") == Page(base.view(folder / "view.html").text).tags.count("script")
    (record,) = [json.loads(text) for text in page.text if text.lstrip().startswith("{") and '"title":' in text]
    assert record["title"] == title
    assert not page.handlers
    run.export(folder / "run.csv")
    with open(folder / "run.csv", encoding="utf-8", newline="") as file:
        head, *rows = csv.reader(file)
    unit = texts["unit of s"]
    assert ("measure.s" + (f" [{unit}]" if unit else "")) in head
    assert len(head) > 10 and all(len(row) == len(head) for row in rows)
    assert json.loads(json.dumps(run.report()))["model"]["title"] == title
    for fmi in (2, 3):
        document = ET.fromstring(_description(run.model, fmi))
        assert document.get("description") == title
        meanings = {one.get("name"): (one.get("description"), one) for one in document.iter()}
        assert meanings["k"][0] == texts["k"]
        units = {one.get("name") for one in document.iter("Unit")}
        assert not texts["unit of k"] or texts["unit of k"] in units


def _description(model: EmittedModel, fmi: int) -> str:
    from runtime.export.fmu_texts import description

    return description(replace(base_export(), model=model), fmi, "token")


OF_A_PAGE = (
    "html head meta title style body header section h1 h2 p div span b table thead tbody tr th td figure img "
    "figcaption iframe pre details summary"
)


def _check_page(texts: dict[str, str], folder: Path) -> None:
    """Tags of the page and no others, no script but those of the view inside, and the texts as they are."""
    run = replace(base_run(), model=titled(base_run().model, texts))
    found = Page(run.page(folder / "page.html").text)
    assert set(found.tags) <= set(OF_A_PAGE.split()) and not found.handlers
    for tag, count in (("style", 1), ("h1", 1), ("iframe", 1), ("title", 1), ("pre", 2)):
        assert found.tags.count(tag) == count, tag
    assert (texts["title"] or "arm") in found.text
    assert all(not one or one in found.text for one in (texts["unit of k"], texts["k"]))
    (frame,) = [value for name, value in found.attributes if name == "srcdoc"]
    inside = Page(frame)
    assert inside.tags.count("script") == 4 and not inside.handlers and "iframe" not in inside.tags


NO_GLYPH = pytest.mark.filterwarnings("ignore:Glyph")  # of a picture whose font lacks a sign
EVERY_FRAGMENT = "".join(FRAGMENTS)


@NO_GLYPH
def test_all_that_ends_or_begins_markup_is_text_in_the_page_of_a_run(tmp_path: Path) -> None:
    _check_page(dict.fromkeys(FIELDS, EVERY_FRAGMENT), tmp_path)


@NO_GLYPH
@pytest.mark.long
@given(GOOD)
@settings(max_examples=8, deadline=None, suppress_health_check=SLOW)
def test_texts_are_data_in_the_page_of_a_run(tmp_path_factory: Any, texts: dict[str, str]) -> None:
    _check_page(texts, tmp_path_factory.mktemp("texts"))


@given(st.lists(st.tuples(TEXTS, TEXTS), min_size=60, max_size=60))
@settings(max_examples=2, deadline=None, suppress_health_check=SLOW)
def test_c_reads_texts_as_they_were(tmp_path_factory: Any, pairs: list[tuple[str, str]]) -> None:
    """Comments hide nothing of the code between them; strings print the bytes that went in."""
    texts = [text.encode("utf-8", "replace").replace(b"\0", b"?").decode() for text, _ in pairs]
    lines = ["#include <stdio.h>", "int main(void) {"]
    for text, (_, comment) in zip(texts, pairs, strict=True):
        lines += [f"/* {c_comment(comment)} */ fputs({c_string(text)}, stdout); putchar(0); /* {c_comment(text)} */"]
    _, out = _compiled(tmp_path_factory.mktemp("c"), "\n".join([*lines, "return 0; }", ""]))
    assert out.split(b"\0")[:-1] == [text.encode() for text in texts]


def test_exported_code_has_texts_as_data(tmp_path: Path) -> None:
    """What would run when the library is loaded stays a comment, and a string."""
    evil = '*/ __attribute__((constructor)) static void hacked(void){ puts("HACKED"); } /*'
    texts = {"title": f"{evil} ??/ \\", "unit of k": evil, "k": f"{evil}\n*/ int x;", "unit of u": '"; }', "u": "\\"}
    model = model_of(SceneRecord(**scene_data(texts)))
    write_c(exported(model), tmp_path)
    text = '#include "arm.h"\n#include <stdio.h>\nint main(void) { fputs(arm_parameters[0].unit, stdout); putchar(0);'
    text += " fputs(arm_parameters[0].meaning, stdout); return 0; }\n"
    warnings, out = _compiled(tmp_path, text, "arm.c", "-Wall", "-trigraphs")
    assert out == f"{evil}\0{texts['k']}".encode()
    assert "comment" not in warnings
    assert ET.fromstring(fmu_texts(exported(model), 2)["modelDescription.xml"]).get("description") == texts["title"]


def test_names_of_exported_code_are_names() -> None:
    for name in ("../arm", "a*/b", "1st", "", "é", "a\nb", "a" * 100):
        with pytest.raises(ValueError, match="is no name"):
            exported(base_run().model, name=name)


def _compiled(folder: Path, text: str, *more: str) -> tuple[str, bytes]:
    """(what the compiler says, what the program prints)."""
    compiler = find_compiler()
    if not compiler:
        pytest.skip("no C compiler")
    (folder / "texts.c").write_text(text, encoding="utf-8")
    command = [*compiler.split(), "-std=c99", "-o", "texts", "texts.c", *more, "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stderr, subprocess.run([folder / "texts"], capture_output=True, check=True).stdout


def test_pictures_take_formulas_for_text(tmp_path: Path) -> None:
    """matplotlib sets what is between two $ as a formula, and raised what its parser says of one that is none."""
    run = replace(base_run(), model=titled(base_run().model, {"title": r"$\nonsense{$ 5", "unit of s": r"$\frac{$"}))
    run.plot(tmp_path / "run.png")
    assert os.path.getsize(tmp_path / "run.png") > 1000
