"""TeX between dollars as MathML: browsers draw it themselves, so pages need no script, no font and no network."""

import re

from latex2mathml.converter import convert

CODE = re.compile(r"(^```.*?^```|^~~~.*?^~~~|``.+?``|`[^`\n]+`)", re.DOTALL | re.MULTILINE)
DISPLAY = re.compile(r"\$\$(.+?)\$\$", re.DOTALL)
INLINE = re.compile(r"(?<![\\\w$])\$(?![\s$])([^$\n]+?)(?<!\s)\$(?![\w$])")


def as_mathml(markdown: str) -> str:
    """The page with its equations as MathML; code is left alone."""
    parts = CODE.split(markdown)
    parts[::2] = [_converted(part) for part in parts[::2]]
    return "".join(parts)


def _converted(text: str) -> str:
    text = DISPLAY.sub(lambda found: f"\n{convert(found[1].strip(), display='block')}\n", text)
    return INLINE.sub(lambda found: convert(found[1]), text)
