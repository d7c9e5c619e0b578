"""The page about the architecture names what there is, and all that there is."""

from __future__ import annotations

import re

from tests.architecture.rooms import ROOMS, ROOT

PAGE = (ROOT / "docs" / "explanations" / "architecture.md").read_text(encoding="utf-8")
_PATH = re.compile(rf"`((?:{'|'.join(ROOMS)}|benchmarks|docs)/[\w./-]+)`")


def test_every_folder_and_file_that_it_names_exists() -> None:
    named = set(_PATH.findall(PAGE))
    assert len(named) > 20
    assert not [path for path in sorted(named) if not (ROOT / path).exists()]


def test_every_folder_of_the_service_is_named() -> None:
    service = ROOT / "service" / "bnserve_service"
    folders = {f.parent.relative_to(ROOT).as_posix() for f in service.glob("*/__init__.py")}
    assert folders <= set(_PATH.findall(PAGE))


def test_its_picture_names_the_rooms_the_stages_of_training_and_the_folders_of_a_question() -> None:
    picture = (ROOT / "docs" / "images" / "architecture.svg").read_text(encoding="utf-8")
    training = ROOT / "surrogate" / "bnserve_surrogate" / "training"
    stages = {f.parent.name for f in training.glob("*/__init__.py")}
    for name in stages | {"http", "admission", "evaluation", "models", "uploads"}:
        assert f">{name}<" in picture, name
    for room in ROOMS:
        assert f">{room}/" in picture, room
