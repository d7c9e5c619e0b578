"""A Dockerfile's steps, run without a container engine: absolute paths are moved below a folder."""

import json
import re
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path


def instructions(dockerfile: str) -> list[tuple[str, str]]:
    """Keyword and text of every instruction, comments removed and continued lines joined."""
    lines = [line for line in dockerfile.splitlines() if not line.lstrip().startswith("#")]
    joined = re.sub(r"\\\n", " ", "\n".join(lines))
    return [tuple(line.strip().split(None, 1)) for line in joined.splitlines() if line.strip()]


def allowed_in_context(dockerignore: str) -> set[str]:
    """What a ``.dockerignore`` of the form "nothing but these" lets into the build."""
    lines = [line for line in dockerignore.splitlines() if line and not line.startswith("#")]
    assert lines[0] == "*"
    return {line[1:] for line in lines if line.startswith("!")}


@dataclass
class Image:
    """The image of the last stage: what ``docker inspect`` would say of it."""

    root: Path
    environment: dict[str, str] = field(default_factory=dict)
    user: tuple[int, int] = (0, 0)
    entrypoint: list[str] = field(default_factory=list)
    healthcheck: list[str] = field(default_factory=list)


class Builder:
    """Runs the instructions of a Dockerfile.

    Parameters
    ----------
    context:
        Folder that ``COPY`` copies from, as filtered by its ``.dockerignore``.
    root:
        Stands for ``/opt`` and ``/build``, the folders that the Dockerfile writes to.
    python:
        The interpreter that the base image would bring.
    environment:
        Of the commands that are run, beside what ``ENV`` says.
    """

    def __init__(self, context: Path, root: Path, python: str, environment: dict[str, str]) -> None:
        self.context, self.root, self.python = context, root, python
        self.outside = environment
        self.allowed = allowed_in_context((context / ".dockerignore").read_text())
        self.image = Image(root)
        self.workdir = root

    def build(self) -> Image:
        """Run every stage and return the image of the last."""
        for keyword, text in instructions((self.context / "Dockerfile").read_text()):
            getattr(self, f"do_{keyword.lower()}")(text)
        return self.image

    def inside(self, text: str) -> str:
        """The text with its absolute paths below :attr:`root`."""
        return re.sub(r"(?<![\w./])/(opt|build)\b", rf"{self.root}/\1", text)

    def do_arg(self, text: str) -> None:
        assert text.startswith("BASE=python:3"), "only the base is an argument"

    def do_from(self, text: str) -> None:
        self.image = Image(self.root)

    def do_env(self, text: str) -> None:
        self.image.environment.update(pair.split("=", 1) for pair in self.inside(text).split())

    def do_workdir(self, text: str) -> None:
        self.workdir = Path(self.inside(text))
        self.workdir.mkdir(parents=True, exist_ok=True)

    def do_copy(self, text: str) -> None:
        *sources, target = text.split()
        if sources[0].startswith("--from="):
            assert sources[1:] == [target], "a virtual environment only works where it was made"
            return
        for name in sources:
            assert name in self.allowed, f"{name} is kept out by .dockerignore"
            self._copy(self.context / name, self.workdir / self.inside(target))

    def _copy(self, source: Path, target: Path) -> None:
        if source.is_dir():
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(source, target / source.name if target.is_dir() else target)

    def do_run(self, text: str) -> None:
        script = f'python() {{ {self.python} "$@"; }}\n{self.inside(text)}'
        environment = self.outside | self.image.environment
        done = subprocess.run(["sh", "-ec", script], cwd=self.workdir, env=environment, capture_output=True, text=True)
        assert done.returncode == 0, f"RUN {text}\n{done.stdout}\n{done.stderr}"

    def do_user(self, text: str) -> None:
        user, group = text.split(":")
        self.image.user = (int(user), int(group))

    def do_expose(self, text: str) -> None:
        assert text == "8000"

    def do_healthcheck(self, text: str) -> None:
        self.image.healthcheck = json.loads(self.inside(text).partition("CMD ")[2])

    def do_entrypoint(self, text: str) -> None:
        self.image.entrypoint = json.loads(self.inside(text))
