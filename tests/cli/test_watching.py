"""`solve FILE --watch`: what is served and to whom, what is made again when, and a browser that shows it anew."""

import http.client
import json
import os
import re
import signal
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path

import pytest

from solver.cli.serving import Board, Server, listening
from solver.cli.watching import TICK, Watched, beside_problem, watch
from solver.render.page import POLICY
from tests.helpers.small_problems import BAD, GOOD
from tests.render.test_browser import browser  # noqa: F401 - a fixture

PAGE = f'<html><head><meta content="{POLICY.replace(chr(39), "&#39;")}"></head><body><p>one</p></body></html>'.encode()


@pytest.fixture
def served():
    """A server with one page."""
    board = Board()
    board.show({"a.html": PAGE})
    with Server(board) as server:
        yield server


def ask(server, path, host=None, method="GET"):
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=10)
    connection.request(method, path, headers={"Host": host} if host else {})
    answer = connection.getresponse()
    return answer, answer.read()


def test_the_page_is_served_by_its_name_and_without_one(served):
    for path in ("/", "/a.html", "/a.html?x=1"):
        answer, content = ask(served, path)
        assert answer.status == 200
        assert answer.headers["Content-Type"] == "text/html; charset=utf-8"
        assert b"<p>one</p>" in content
        assert b'<script src="/watch.js" data-version="' in content


def test_the_policy_lets_the_one_script_run_and_nothing_else(served):
    answer, content = ask(served, "/")
    allowed = f"script-src http://127.0.0.1:{served.server_port}/watch.js; connect-src"
    assert allowed in answer.headers["Content-Security-Policy"]
    assert allowed in content.decode()
    assert "frame-ancestors 'none'" in answer.headers["Content-Security-Policy"]
    assert answer.headers["X-Content-Type-Options"] == "nosniff"
    assert answer.headers["Cross-Origin-Resource-Policy"] == "same-origin"


@pytest.mark.parametrize(
    "host", ["evil.example", "evil.example:{port}", "127.0.0.1", "localhost:1", "127.0.0.1.evil:{port}", "[::1]:{port}"]
)
@pytest.mark.parametrize("path", ["/", "/a.html", "/events", "/watch.js"])
def test_a_site_that_takes_the_address_reads_nothing(served, host, path):
    answer, content = ask(served, path, host.format(port=served.server_port))
    assert answer.status == 421
    assert b"<p>" not in content


@pytest.mark.parametrize(
    "path", ["/../a.html", "/../../etc/passwd", "/%2e%2e/x", "//etc/passwd", "/a.html/..", "/a.html%00", "/A.html"]
)
def test_no_path_leads_anywhere_else(served, path):
    assert ask(served, path)[0].status == 404


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "OPTIONS", "HEAD"])
def test_it_only_gives(served, method):
    assert ask(served, "/", method=method)[0].status == 501


def test_it_listens_on_the_loopback_address_only(served):
    assert served.server_address[0] == "127.0.0.1"


def test_several_pages_are_listed_with_names_as_text():
    board = Board()
    board.show({"<b>.html": PAGE, "x/a.html": PAGE})
    with Server(board) as server:
        _, content = ask(server, "/")
        assert b'<a href="/%3Cb%3E.html">&lt;b&gt;.html</a>' in content
        assert content.count(b"<script") == 1
        assert ask(server, "/x/a.html")[0].status == 200


@contextmanager
def listener(server):
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=10)
    connection.request("GET", "/events")
    answer = connection.getresponse()
    yield lambda: json.loads(answer.readline().removeprefix(b"data: ") + (answer.readline() and b""))
    connection.close()


def test_news_are_told_as_they_come(served):
    board = served.board
    with listener(served) as news:
        first = news()
        assert first == {"version": board.version, "fault": ""}
        board.show({}, "a.yaml:1:2: error")
        assert news() == {"version": first["version"], "fault": "a.yaml:1:2: error"}
        board.show({"a.html": PAGE.replace(b"one", b"two")})
        assert news()["version"] != first["version"]


def test_a_page_that_came_out_the_same_is_not_shown_again(served):
    version = served.board.version
    served.board.show({"a.html": PAGE})
    assert served.board.version == version


def test_a_page_without_an_end_gets_the_script_too():
    assert listening(b"<p>x", "1", POLICY).startswith(b"<p>x<script ")


def run_watch(monkeypatch, tmp_path, work, changes):
    """Watch a file while changes are made between two looks; return what was shown after each work."""
    shown = []
    todo = list(changes)

    def sleep(seconds):
        if seconds == TICK and not todo:
            raise KeyboardInterrupt
        if seconds == TICK:
            todo.pop(0)()

    monkeypatch.setattr("solver.cli.watching.time.sleep", sleep)
    monkeypatch.setattr("solver.cli.watching.MISSING", 0.0)

    def noted(file):
        result = work(file)
        shown.append(Path(file).read_text("utf-8") if Path(file).exists() else None)
        return result

    path = tmp_path / "p.yaml"
    watched = Watched(str(path), lambda name: beside_problem(name, tmp_path / "templates"))
    code = watch([watched], noted, port=0, tell=lambda _: None, serves=False)
    return code, shown


def test_changes_of_the_file_its_pictures_and_the_templates_count(monkeypatch, tmp_path):
    path = tmp_path / "p.yaml"
    path.write_text("statement: ![a](sub/a%20b.png)\n", encoding="utf-8")
    (tmp_path / "sub").mkdir()
    (tmp_path / "templates").mkdir()

    def replaced():
        other = tmp_path / ".p.yaml.swp"
        other.write_text("replaced ![a](sub/a%20b.png)", encoding="utf-8")
        other.rename(path)

    code, shown = run_watch(monkeypatch, tmp_path, lambda _: (0, []), [
        lambda: path.write_text("written ![a](sub/a%20b.png)", encoding="utf-8"),
        replaced,
        lambda: (tmp_path / "sub" / "a b.png").write_bytes(b"x"),
        lambda: (tmp_path / "templates" / "t.jinja").write_text("x"),
        lambda: (tmp_path / "other.yaml").write_text("x"),
        path.unlink,
        lambda: path.write_text("back", encoding="utf-8"),
    ])  # fmt: skip
    assert code == 0
    texts = [text and text.split()[0] for text in shown]
    assert texts == ["statement:", "written", "replaced", "replaced", "replaced", None, "back"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["-", "--watch"], "--watch looks at files"),
        (["good.yaml", "--watch", "-o", "-"], "--watch looks at files"),
        (["good.yaml", "--port", "8000"], "--port is that of the pages of --watch"),
        (["good.yaml", "--watch", "--port", "0"], "--port"),
    ],
)
def test_what_cannot_be_watched_is_refused(solve, good, words, message):
    done = solve(*words)
    assert done.code == 2
    assert message in done.err


def test_a_port_that_is_taken_is_told(solve, good, served):
    done = solve("good.yaml", "--watch", "--port", served.server_port)
    assert done.code == 2
    assert f"no page can be served at port {served.server_port}" in done.err


@contextmanager
def watching(folder, *words):
    """The command in a process of its own; yields the address of its page."""
    command = [sys.executable, "-m", "solver", *words, "--watch"]
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    process = subprocess.Popen(command, cwd=folder, env=environment, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
    try:
        address = ""
        for line in process.stderr:
            address = address or (re.search(rb"http://\S+", line) or [b""])[0].decode()
            if re.match(rb"\d\d:\d\d:\d\d  ", line):
                break
        yield process, address
    finally:
        process.kill()
        process.wait()
        process.stderr.close()


def wait_for_title(page, title):
    """Wait without scripts in the page, which its policy refuses."""
    end = time.monotonic() + 60
    while page.title() != title and time.monotonic() < end:
        page.wait_for_timeout(50)
    assert page.title() == title


def test_a_browser_shows_what_changed_and_keeps_it_where_a_file_is_bad(browser, good):  # noqa: F811 - the fixture
    with watching(good.parent, "good.yaml") as (process, address):
        page = browser.new_page()
        complaints = []
        page.on("console", lambda message: complaints.append(message.text))
        page.on("pageerror", lambda error: complaints.append(str(error)))
        page.goto(address)
        assert page.title() == "A small problem"
        good.write_text(GOOD.replace("A small", "Another"), encoding="utf-8")
        wait_for_title(page, "Another problem")
        good.write_text(BAD, encoding="utf-8")
        page.wait_for_selector("pre[role=alert]", timeout=60_000)
        assert "did you mean 'eigenstructure'?" in page.text_content("pre[role=alert]")
        assert page.title() == "Another problem"
        good.write_text(GOOD.replace("A small", "A third"), encoding="utf-8")
        wait_for_title(page, "A third problem")
        assert page.query_selector("pre[role=alert]") is None
        assert not complaints
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=30) == 0
        page.wait_for_selector("pre[role=alert]", timeout=30_000)
        assert "has ended" in page.text_content("pre[role=alert]")
    assert b"<script" not in (good.parent / "good.html").read_bytes()


@pytest.mark.skipif(not Path("/proc").exists(), reason="tells processes by /proc")
def test_it_ends_with_all_it_started(good):
    with watching(good.parent, "good.yaml") as (process, _):
        before = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text("utf-8").split()
        process.send_signal(signal.SIGTERM)
        assert process.wait(timeout=30) == 128 + signal.SIGTERM
        end = time.monotonic() + 20
        while any(Path(f"/proc/{each}").exists() for each in before) and time.monotonic() < end:
            time.sleep(0.05)
        assert not [each for each in before if Path(f"/proc/{each}").exists()]
