"""Campaigns in folders."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from . import _etalon, documents
from ._errors import Message
from .documents import Document, load
from .kinematics import json_of

Progress = Callable[[int, int], Any]


class Run:
    """What a campaign gave. Documents of the output folder are attributes: ``.parameters``, ``.accuracy``, ``.iso9283`` ...

    Attributes:
        met: True if every limit is met, and the result can be that of a robot.
        folder: Output folder.
        messages: Warnings.
    """

    def __init__(self, met: bool, folder: Path, messages: Sequence[Message]) -> None:
        self.met = met
        self.folder = folder
        self.messages = tuple(messages)

    def __getattr__(self, name: str) -> Document:
        path = self.__dict__["folder"] / f"{name.replace('_', '-')}.json" if "folder" in self.__dict__ else None
        if path is None or name.startswith("_") or not path.is_file():
            raise AttributeError(f"the campaign has no {name!r}")
        return load(path.read_text(encoding="utf-8"))

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *(path.stem.replace("-", "_") for path in self.folder.glob("*.json"))})

    def __repr__(self) -> str:
        return f"Run(met={self.met}, folder={str(self.folder)!r})"

    def _repr_html_(self) -> str:
        verdict = "every limit is met" if self.met else "a limit is not met, or the result can be no robot"
        parts = [f"<p>{verdict}; {self.folder}</p>"]
        parts += [getattr(self, name)._repr_html_() for name in ("parameters",) if (self.folder / f"{name}.json").is_file()]
        return "".join(parts)


def run(folder: str | os.PathLike[str], *, reports: bool = True) -> Run:
    """Run a campaign: exports and logs in, parameters and report out, as ``etalon run``.

    Args:
        folder: Folder of the campaign, or its ``campaign.toml``.
        reports: Writes the reports and the tables of points and observations too.

    Raises:
        Error: Everything that is wrong with the campaign; nothing is written.
    """
    met, output, messages = _etalon.run(os.fspath(folder), reports)
    return Run(met, Path(output), [Message(stated) for stated in json.loads(messages)])


def check(folder: str | os.PathLike[str]) -> documents.CheckDocument:
    """Find everything that is wrong with a campaign, without computing.

    Returns:
        :class:`etalon.documents.CheckDocument`: ``.errors`` and ``.warnings``.
    """
    return load(_etalon.check(os.fspath(folder)))  # type: ignore[return-value]


def validate(folder: str | os.PathLike[str], parameters: Any = None, *, frames: str = "refit") -> documents.AccuracyDocument:
    """Judge given parameters on the data of a campaign.

    Args:
        folder: Folder of the campaign.
        parameters: A parameters document, or the path of one; nominal values if None.
        frames: Where base and targets come from: ``"refit"``, ``"given"`` or ``"prior"``.

    Returns:
        :class:`etalon.documents.AccuracyDocument`.

    Raises:
        Error: The campaign does not read, or the parameters are those of another robot.
    """
    return load(_etalon.validate(os.fspath(folder), json_of(parameters), frames))  # type: ignore[return-value]


def recommend(folder: str | os.PathLike[str], *, progress: Progress | None = None) -> documents.RecommendationDocument:
    """Find out which identified parameters of a campaign deserve to be loaded.

    Args:
        folder: Folder of the campaign.
        progress: Called with what is done and the whole: ``lambda done, whole: ...``.

    Returns:
        :class:`etalon.documents.RecommendationDocument`.
    """
    return load(_etalon.recommend(os.fspath(folder), progress))  # type: ignore[return-value]


def uncertainty(
    folder: str | os.PathLike[str],
    *,
    draws: int = 20_000,
    resamples: int = 1_000,
    seed: int = 1,
    progress: Progress | None = None,
) -> documents.UncertaintyDocument:
    """Compute distributions of the results of a campaign by Monte Carlo (JCGM 101) and bootstrap.

    Args:
        folder: Folder of the campaign.
        draws: Largest number of draws.
        resamples: Resamples of poses and cycles.
        seed: Seed of the draws.
        progress: As in :func:`recommend`.

    Returns:
        :class:`etalon.documents.UncertaintyDocument`.
    """
    return load(_etalon.uncertainty(os.fspath(folder), (draws, resamples, seed), progress))  # type: ignore[return-value]


def batch(folders: Sequence[str | os.PathLike[str]], *, reports: bool = False, progress: Progress | None = None) -> documents.BatchDocument:
    """Run many campaigns on all cores; one of which nothing has changed is read back.

    Args:
        folders: Campaigns, folders of campaigns, or texts that list campaigns.
        reports: Writes the reports too.
        progress: As in :func:`recommend`.

    Returns:
        :class:`etalon.documents.BatchDocument`: ``.campaigns`` says how each ended.
    """
    return load(_etalon.batch([os.fspath(folder) for folder in folders], reports, progress))  # type: ignore[return-value]
