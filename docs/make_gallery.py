"""The gallery from examples/: each script draws its picture, and its docstrings become the card.

python docs/make_gallery.py [NAME ...]    pictures of these examples (of all without a name), and docs/gallery.md
"""

import ast
import runpy
import sys
from pathlib import Path

from PIL import Image

DOCS = Path(__file__).resolve().parent
EXAMPLES, PICTURES = DOCS.parent / "examples", DOCS / "images" / "gallery"
COLOURS = 96  # of a picture in the repository
SECTIONS = {
    "Mechanisms in a plane": [
        "build_slider_crank",
        "from_toml",
        "crane",
        "bridge_crane",
        "quarter_car",
        "hanging_chain",
        "four_bar_crossing",
        "end_stops",
        "bouncing_ball",
        "stacked_balls",
    ],
    "Driven mechanisms and robots": [
        "five_bar_robot",
        "quick_return",
        "four_bar_300rpm",
        "geared_arm",
        "urdf_arm",
        "faulty_robot",
    ],
    "In space": ["double_wishbone", "build_spatial_arm", "gyroscope", "tumbling_body", "spinning_satellite"],
    "Flexible bodies": [
        "overhung_rotor",
        "rotor_blades",
        "spin_up",
        "finite_element_bar",
        "mesh_connecting_rod",
        "rod_over_speed",
    ],
    "Control, optimisation, studies": [
        "cart_pole",
        "speed_loop",
        "crane_mpc",
        "optimise_torque",
        "train_controller",
        "swing_up_environment",
        "parameter_study",
        "monte_carlo",
        "design_rod",
        "thin_coupler",
        "identify_hub_beam",
        "identify_payload",
    ],
    "The paper: its figures and its schemes": [
        "partitioned_bar",
        "floating_frame",
        "compare_schemes",
        "linear_structure",
    ],
}
HEAD = """# Gallery

A short script draws each picture (`python examples/crane.py crane.png`) and prints
figures that only right physics gives: a closed form, a conservation law, a published value. A test
runs every script and checks the figures. A click on a picture opens the script.
"""


def described(name: str) -> tuple[str, str]:
    """What the example shows, and what its figures are compared with: its own docstring and that of `main`."""
    tree = ast.parse((EXAMPLES / f"{name}.py").read_text(encoding="utf-8"))
    main = next(node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == "main")
    return tuple((ast.get_docstring(node) or "").split("\n\n")[0].replace("\n", " ") for node in (tree, main))


def page() -> str:
    """The page as Markdown: a heading for each section, two cards in a row."""
    parts = [HEAD]
    for section, names in SECTIONS.items():
        cells = []
        for name in names:
            shows, checks = described(name)
            script = f"../examples/{name}.py"
            cells.append(f"[![{name}](images/gallery/{name}.png)]({script})<br>**{shows}** {checks}")
        cells += [""] * (len(cells) % 2)
        rows = [f"| {a} | {b} |" for a, b in zip(cells[::2], cells[1::2], strict=True)]
        parts += [f"\n## {section}\n", "| | |", "|---|---|", *rows]
    return "\n".join(parts) + "\n"


def main(names: list[str]) -> None:
    """Draw, then write the page."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    for name in names:
        path = PICTURES / f"{name}.png"
        runpy.run_path(str(EXAMPLES / f"{name}.py"))["main"](path)
        with Image.open(path) as image:
            image.convert("RGB").quantize(COLOURS).save(path, optimize=True)
    (DOCS / "gallery.md").write_text(page(), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:] or [name for names in SECTIONS.values() for name in names])
