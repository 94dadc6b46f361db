"""The pages that are being watched, served to this computer alone, so that a browser shows them anew by itself.

Only what was written is served, from memory and by its own name: no path leads anywhere else. The files on disk
stay without scripts; what is served has a few lines that listen for news. The address is 127.0.0.1 and the name in
a request must be that of this server, so that no other site reads it under a name of its own.
"""

from __future__ import annotations

import json
import secrets
import threading
from collections.abc import Mapping, Sequence
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any
from urllib.parse import quote, unquote, urlsplit

from markupsafe import escape

from solver.cli.destination import AtFault
from solver.render.page import POLICY

LOOPBACK = "127.0.0.1"
ALIVE = 10.0
"""Seconds after which a listener is told that there is nothing new, to see whether it is still there."""

TYPES = {".html": "text/html", ".pdf": "application/pdf", ".json": "application/json"}
SCRIPT, EVENTS = "/watch.js", "/events"

LISTEN = """\
const version = document.currentScript.dataset.version;
let bar = null;
function say(text) {
  if (!text) { if (bar) bar.remove(); bar = null; return; }
  if (!bar) {
    bar = document.createElement("pre");
    bar.setAttribute("role", "alert");
    Object.assign(bar.style, {position: "fixed", left: "0", right: "0", bottom: "0", margin: "0", zIndex: "9",
      padding: "0.75rem 1rem", maxHeight: "40vh", overflow: "auto", whiteSpace: "pre-wrap", fontSize: "0.85rem",
      background: "#7f1d1d", color: "#fff", borderTop: "3px solid #f87171"});
    document.body.append(bar);
  }
  bar.textContent = text;
}
const news = new EventSource("/events");
news.onmessage = event => {
  const state = JSON.parse(event.data);
  if (state.version !== version) { location.reload(); return; }
  say(state.fault);
};
news.onerror = () => say("solve --watch has ended: what you see is the last state.");
addEventListener("pagehide", () => news.close());
"""


class Board:
    """What is shown: pages by their names, and what is wrong at the moment. Every page has a version of its own."""

    def __init__(self) -> None:
        self.changed = threading.Condition()
        self.session = secrets.token_hex(4)
        self.number = 0
        self.pages: dict[str, bytes] = {}
        self.fault = ""

    @property
    def version(self) -> str:
        """Tells states apart, those of another session too."""
        return f"{self.session}-{self.number}"

    def show(self, pages: Mapping[str, bytes], fault: str = "") -> None:
        """Show pages in place of those of the same names, and what is wrong; where nothing is new they stay."""
        with self.changed:
            if any(self.pages.get(name) != content for name, content in pages.items()):
                self.pages |= pages
                self.number += 1
            self.fault = fault
            self.changed.notify_all()

    def state(self) -> dict[str, str]:
        """Return what a page must know."""
        return {"version": self.version, "fault": self.fault}


class Server(ThreadingHTTPServer):
    """Serves a board on the loopback address. Who leaves its context ends it."""

    daemon_threads = True
    block_on_close = False

    def __init__(self, board: Board, port: int = 0) -> None:
        self.board = board
        try:
            super().__init__((LOOPBACK, port), _Handler)
        except OSError as error:
            reason = error.strerror or error
            raise AtFault(f"no page can be served at port {port}: {reason}; name another --port") from None
        self.names = {f"{host}:{self.server_port}" for host in (LOOPBACK, "localhost")}
        self.thread = threading.Thread(target=self.serve_forever, args=(0.05,), daemon=True)

    def address_of(self, name: str = "") -> str:
        """Return the address of a page, or of what leads to all."""
        return f"http://{LOOPBACK}:{self.server_port}/{quote(name)}"

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Say nothing where a browser has gone away."""

    def __enter__(self) -> Server:
        self.thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self.shutdown()
        self.server_close()


class _Handler(BaseHTTPRequestHandler):
    server: Server
    server_version = "solve"
    sys_version = ""
    timeout = 30

    def do_GET(self) -> None:
        """Answer with a page, the script, or news as they come."""
        host = self.headers.get("Host", "")
        if host.lower() not in self.server.names:
            self._send(b"this server is for this computer alone\n", "text/plain", HTTPStatus.MISDIRECTED_REQUEST)
            return
        path = urlsplit(self.path).path
        if path == SCRIPT:
            self._send(LISTEN.encode(), "text/javascript")
        elif path == EVENTS:
            self._tell_news()
        else:
            self._send_page(unquote(path).removeprefix("/"), host)

    def _send_page(self, name: str, host: str) -> None:
        board = self.server.board
        with board.changed:
            pages, version = dict(board.pages), board.version
        if not name:
            name = next(iter(pages), "") if len(pages) == 1 else ""
        content = pages.get(name) if name else list_of(sorted(pages))
        if content is None:
            self._send(b"there is no such page\n", "text/plain", HTTPStatus.NOT_FOUND)
            return
        kind = TYPES.get(Path(name).suffix.lower(), "text/plain") if name else "text/html"
        if kind != "text/html":
            self._send(content, kind)
            return
        policy = f"{POLICY}; script-src http://{host}{SCRIPT}; connect-src http://{host}{EVENTS}"
        self._send(listening(content, version, policy), kind, policy=f"{policy}; frame-ancestors 'none'")

    def _send(self, content: bytes, kind: str, status: HTTPStatus = HTTPStatus.OK, policy: str = POLICY) -> None:
        self.send_response(status)
        text = "; charset=utf-8" if kind.startswith("text/") else ""
        headers = {
            "Content-Type": kind + text,
            "Content-Length": str(len(content)),
            "Content-Security-Policy": policy,
            "Cross-Origin-Resource-Policy": "same-origin",
            "X-Content-Type-Options": "nosniff",
            "Referrer-Policy": "no-referrer",
            "Cache-Control": "no-store",
        }
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)

    def _tell_news(self) -> None:
        """Send the state, and again whenever it changes, until the browser goes away."""
        self.send_response(HTTPStatus.OK)
        for name, value in {"Content-Type": "text/event-stream", "Cache-Control": "no-store"}.items():
            self.send_header(name, value)
        self.end_headers()
        board, told = self.server.board, None
        while True:
            with board.changed:
                if board.state() == told:
                    board.changed.wait(ALIVE)
                state = board.state()
            self.wfile.write(b": alive\n\n" if state == told else f"data: {json.dumps(state)}\n\n".encode())
            told = state

    def log_message(self, format: str, *arguments: Any) -> None:  # noqa: A002 - the name of the base class
        """Say nothing of what is asked for."""


def listening(page: bytes, version: str, policy: str) -> bytes:
    """Return a page that listens for news: with the script, and a policy that lets it run."""
    script = f'<script src="{SCRIPT}" data-version="{version}"></script>'.encode()
    before, end, after = page.rpartition(b"</body>")
    whole = before + script + end + after if end else page + script
    return whole.replace(str(escape(POLICY)).encode(), str(escape(policy)).encode(), 1)


def list_of(names: Sequence[str]) -> bytes:
    """Return a page that leads to several."""
    items = "".join(f'<li><a href="/{escape(quote(name))}">{escape(name)}</a></li>' for name in names)
    head = f'<meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="{escape(POLICY)}">'
    title = "<title>solve --watch</title>"
    return f'<!doctype html><html lang="en"><head>{head}{title}</head><body><ul>{items}</ul></body></html>'.encode()
