"""XML of packages: elements with their content at once, and files in a zip whose bytes depend on nothing but them."""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Iterable, Mapping
from xml.etree import ElementTree
from xml.etree.ElementTree import Element
from xml.sax.saxutils import unescape

HEADER = '<?xml version="1.0" encoding="UTF-8"?>\n'
_ILLEGAL = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_PATH = re.compile(r"[A-Za-z0-9][\w-]*(?:\.[a-z0-9]+)?(?:/[A-Za-z0-9][\w-]*(?:\.[a-z0-9]+)?)*", re.ASCII)
_FIRST_DATE = 1980, 1, 1, 0, 0, 0
_READABLE = 0o644 << 16


def node(tag: str, *content: Element | str, **attributes: str) -> Element:
    """Return an element with its content, texts and elements in order.

    A name that is a word of Python ends in `_`; `xml_lang` is `xml:lang`.
    """
    named = {name.removesuffix("_").replace("xml_", "xml:"): legal(value) for name, value in attributes.items()}
    made = Element(tag, named)
    for each in content:
        if isinstance(each, Element):
            made.append(each)
        else:
            append_text(made, legal(each))
    return made


def append_text(parent: Element, text: str) -> None:
    """Add a text to the end of an element."""
    if len(parent):
        parent[-1].tail = (parent[-1].tail or "") + text
    else:
        parent.text = (parent.text or "") + text


def contents_of(element: Element) -> list[Element | str]:
    """Return what is in an element, texts and elements in order."""
    found: list[Element | str] = [element.text or ""]
    for each in element:
        found += [each, each.tail or ""]
        each.tail = None
    return [each for each in found if isinstance(each, Element) or each]


def legal(text: str) -> str:
    """Return a text without the signs that XML cannot hold."""
    return _ILLEGAL.sub("", text)


def read(fragment: str) -> list[Element]:
    """Return the elements of well-formed XHTML that was written here; text between them is white."""
    root = ElementTree.fromstring(f"<div>{legal(fragment)}</div>")  # noqa: S314 - of our own writers, without entities
    return list(root)


def read_line(fragment: str) -> Element:
    """Return a paragraph with XHTML of one line that was written here."""
    return ElementTree.fromstring(f"<p>{legal(fragment)}</p>")  # noqa: S314 - as above


def file_of(root: Element, *, indented: bool = False, literal: str = "") -> bytes:
    """Return a document; only one without mixed content may be `indented`.

    Elements with the name `literal` hold text only; it stands in CDATA sections where it has signs to be escaped.
    """
    if indented:
        ElementTree.indent(root)
    document = ElementTree.tostring(root, encoding="unicode")
    if literal:
        document = re.sub(rf"(?<=<{literal}>)[^<]*&[^<]*(?=</{literal}>)", _section, document)
    return (HEADER + document + "\n").encode()


def _section(escaped: re.Match[str]) -> str:
    """Return a text in a CDATA section, or in several where it has the end of one in it."""
    return f"<![CDATA[{unescape(escaped[0]).replace(']]>', ']]]]><![CDATA[>')}]]>"


def zipped(files: Mapping[str, bytes], folders: Iterable[str] = ()) -> bytes:
    """Return a zip of files by their paths, in this order, the same bytes for the same files."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in [*files.items(), *((f"{folder}/", b"") for folder in folders)]:
            if not _PATH.fullmatch(path.removesuffix("/")):
                raise AssertionError(f"{path!r} is no path of a file in a package")
            entry = zipfile.ZipInfo(path, _FIRST_DATE)
            entry.create_system, entry.external_attr = 3, _READABLE
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    return stream.getvalue()
