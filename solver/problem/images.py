"""Images of the statement and the prompts: files below the folder of the problem, checked before they are shown."""

from __future__ import annotations

import re
from dataclasses import dataclass
from hashlib import sha256
from html import unescape
from pathlib import Path, PurePosixPath

from solver.problem.source import Source

LARGEST = 2 * 2**20
"""Bytes of an image; a page holds it whole."""

KINDS = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg", ".svg": "image/svg+xml"}

STARTS = {"image/png": b"\x89PNG\r\n\x1a\n", "image/jpeg": b"\xff\xd8\xff"}

ACTIVE = re.compile(
    r"<script|<foreignobject|<!entity|<\?xml-stylesheet|<(?:animate|set)\b|\son\w+\s*=|javascript:|@import"
    r"|(?:href|src)\s*=\s*[\"']\s*(?!#|data:image/(?:png|jpeg))|url\(\s*[\"']?(?!#)",
    re.IGNORECASE,
)
"""What makes an SVG more than a drawing: scripts, foreign content, references to anything outside of it."""


@dataclass(frozen=True, slots=True)
class Image:
    """An image by its media type and its bytes."""

    media_type: str
    content: bytes

    @property
    def is_drawing(self) -> bool:
        """Whether it is an SVG, which TeX cannot include."""
        return self.media_type == KINDS[".svg"]

    @property
    def file_name(self) -> str:
        """A name for a file of its own, the same for the same image."""
        suffix = {"image/png": ".png", "image/jpeg": ".jpg"}.get(self.media_type, ".svg")
        return f"image-{sha256(self.content).hexdigest()[:12]}{suffix}"


class NoImage(Exception):  # noqa: N818 - said to the user at the place of the image
    """The image can't be shown; the message says why, in words."""


def load_image(address: str, source: Source) -> Image:
    """Return the image at an address relative to the file of a problem; raises NoImage."""
    media_type = KINDS.get(PurePosixPath(address).suffix.lower())
    if media_type is None:
        raise NoImage("an image is a PNG, JPEG or SVG file")
    if source.name.startswith("<"):
        raise NoImage("an image stands below the folder of its problem, and this text is in no folder")
    folder = Path(source.name).parent.resolve()
    try:
        path = (folder / address).resolve()
        if not path.is_relative_to(folder):
            raise NoImage("it lies outside of the folder of the problem")
        if not path.is_file():
            raise NoImage("there is no such file")
        if path.stat().st_size > LARGEST:
            raise NoImage(f"it is larger than {LARGEST // 2**20} MB")
        content = path.read_bytes()[: LARGEST + 1]
    except (OSError, ValueError) as error:  # ValueError: a NUL in the path
        raise NoImage(f"it cannot be read: {getattr(error, 'strerror', None) or 'its name is not valid'}") from None
    _check(media_type, content)
    return Image(media_type, content)


def _check(media_type: str, content: bytes) -> None:
    """Raise NoImage if the bytes are not what the name promises, or an SVG does more than draw."""
    if media_type in STARTS:
        if not content.startswith(STARTS[media_type]):
            raise NoImage("it is not what the ending of its name says")
        return
    if b"<svg" not in content[:4096] or b"\0" in content:
        raise NoImage("it is not what the ending of its name says")
    text = content.decode("utf-8", "replace")
    if ACTIVE.search(text) or ACTIVE.search(unescape(text)):
        raise NoImage("an SVG may hold no scripts and nothing from outside")
