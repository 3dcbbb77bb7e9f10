"""The README's picture: four mechanisms as `solution.view` shows them, photographed by a headless Chromium.

python docs/images/make_front.py
"""

import runpy
import subprocess
import tempfile
from pathlib import Path

from PIL import Image

from runtime import load_model, simulate
from symgen.generate import generate
from symgen.scenes import SCENES, generated_folder

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[1] / "examples"
TILE = (600, 350)
# what, until when [s], what is shown, the part of a window of 1366 x 768 that is kept (left, top, width)
SHOWN = [
    ("spatial_slider_crank", 0.05, "t=0.03&hide=names&with=colour%3A%20stress", (120, 120, 800)),
    ("double_wishbone", 1.8, "t=1.6&hide=names", (245, 150, 620)),
    ("spinning_satellite", 4.0, "t=0.6&hide=names&x=20&with=colour%3A%20stress", (165, 160, 720)),
    ("build_slider_crank", 0.1, "t=0.06&hide=names&trace=rod.start&with=colour%3A%20stress", (110, 60, 760)),
]
BROWSER = (
    "chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars".split()
)


def photographed(name: str, t_end: float, state: str, kept: tuple[int, int, int], folder: Path) -> Image.Image:
    """The part of the page that shows the mechanism."""
    page, picture = folder / f"{name}.html", folder / f"{name}.png"
    built_in = name in SCENES
    model = load_model(
        generated_folder(name)
        if built_in
        else generate(runpy.run_path(str(EXAMPLES / f"{name}.py"))["build"](), folder / name)
    )
    simulate(model, t_end=t_end).view(page)
    text = page.read_text(encoding="utf-8")
    bare = text.replace("</head>", "<style>.box, #hint, #scale { display: none }</style></head>")
    page.write_text(bare, encoding="utf-8")
    more = ["--virtual-time-budget=5000", "--window-size=1366,768", f"--screenshot={picture}"]
    subprocess.run(
        [*BROWSER, f"--user-data-dir={folder / 'profile'}", *more, f"{page.as_uri()}#{state}"],
        check=True,
        capture_output=True,
    )
    left, top, width = kept
    with Image.open(picture) as image:
        area = (left, top, left + width, top + width * TILE[1] // TILE[0])
        return image.convert("RGB").crop(area).resize(TILE, Image.Resampling.LANCZOS)


def main() -> None:
    """Write front.png beside this script."""
    sheet = Image.new("RGB", (2 * TILE[0] + 6, 2 * TILE[1] + 6), "#d0d4da")
    with tempfile.TemporaryDirectory() as folder:
        for k, shown in enumerate(SHOWN):
            tile = photographed(*shown, Path(folder))
            sheet.paste(tile, ((TILE[0] + 6) * (k % 2), (TILE[1] + 6) * (k // 2)))
    few = sheet.quantize(256)
    sheet.quantize(palette=few, dither=Image.Dither.FLOYDSTEINBERG).save(HERE / "front.png", optimize=True)


if __name__ == "__main__":
    main()
