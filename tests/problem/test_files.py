from __future__ import annotations

import os
import socket
import sys
from pathlib import Path

import pytest

from solver.problem.files import load
from solver.problem.source import InputError


def refusal(path):
    with pytest.raises(InputError) as caught:
        load(path)
    return caught.value.render()


def test_a_file_is_read_as_utf8(tmp_path):
    path = tmp_path / "servo.yaml"
    path.write_bytes("title: Φ(t) – µ\n".encode())
    source = load(path)
    assert (source.name, source.text) == (str(path), "title: Φ(t) – µ\n")


def test_a_byte_order_mark_is_dropped(tmp_path):
    path = tmp_path / "servo.yaml"
    path.write_bytes(b"\xef\xbb\xbftitle: x\n")
    assert load(path).text == "title: x\n"


def test_a_missing_file_suggests_a_similar_one_of_its_folder(tmp_path):
    (tmp_path / "servo.yaml").write_text("a: 1")
    path = tmp_path / "sevro.yaml"
    assert refusal(path) == f"{path}: error: there is no such file\n       = did you mean '{tmp_path / 'servo.yaml'}'?"


def test_a_missing_file_in_a_missing_folder(tmp_path):
    path = tmp_path / "no" / "servo.yaml"
    assert refusal(path) == f"{path}: error: there is no such file"


def test_a_folder_is_refused(tmp_path):
    assert refusal(tmp_path) == f"{tmp_path}: error: it is a folder, not a file"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes on this system")
def test_a_pipe_is_refused_without_waiting_for_it(tmp_path):
    path = tmp_path / "pipe"
    os.mkfifo(path)
    assert "it is not a regular file" in refusal(path)


@pytest.mark.skipif(sys.platform == "win32", reason="no sockets in folders on this system")
def test_a_socket_is_refused(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # paths of sockets are short
    with socket.socket(socket.AF_UNIX) as listening:
        listening.bind("s")
        assert "it is not a regular file" in refusal("s")


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="no devices on this system")
def test_a_device_is_refused():
    assert "it is not a regular file" in refusal("/dev/zero")


def test_a_large_file_is_refused_before_it_is_read(tmp_path):
    path = tmp_path / "large.yaml"
    with path.open("wb") as file:
        file.truncate(10**12)  # sparse: takes no room
    assert refusal(path) == f"{path}: error: the file is larger than 256 KB"


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="this user may read everything")
def test_a_file_without_permission(tmp_path):
    path = tmp_path / "servo.yaml"
    path.write_text("a: 1")
    path.chmod(0)
    assert refusal(path) == f"{path}: error: no permission to read it"


def test_no_permission_is_said_in_words(tmp_path, monkeypatch):
    path = tmp_path / "servo.yaml"
    path.write_text("a: 1")

    def forbidden(*args, **kwargs):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("pathlib.Path.open", forbidden)
    assert refusal(path) == f"{path}: error: no permission to read it"


@pytest.mark.parametrize("name", ["a\0b", "x" * 5000])
def test_an_impossible_name_is_refused(name):
    assert "error: " in refusal(name)


@pytest.mark.parametrize(
    ("content", "place"),
    [
        (b"\x89PNG\r\n\x1a\n\0\0", "1:1"),
        (b"title: x\nsource: \xff\n", "2:9"),
        ("title: é\n".encode("latin-1"), "1:8"),
        ("title: x".encode("utf-16"), "1:1"),
    ],
)
def test_what_is_not_utf8_is_refused_at_its_place(tmp_path, content, place):
    path = tmp_path / "servo.yaml"
    path.write_bytes(content)
    assert refusal(path).startswith(f"{path}:{place}: error: it is not a text in UTF-8 (byte 0x")
