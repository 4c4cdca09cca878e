"""Campaigns in folders."""

from __future__ import annotations

import html
import json
import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from keyword import iskeyword
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from . import _etalon, documents
from ._errors import Error, Message, warn, with_warnings
from ._options import Progress, called, whole
from ._residuals import Residuals
from .documents import load
from .kinematics import json_of

class Run(Residuals):
    """What a campaign gave. Documents of the output folder are attributes: ``.parameters``, ``.accuracy``, ``.iso9283``, ``.import_`` ...

    A document that the campaign does not have raises AttributeError.

    Attributes:
        met: True if every limit is met, and the result can be that of a robot.
        folder: Output folder.
        messages: Warnings.
    """

    parameters: documents.ParametersDocument
    accuracy: documents.AccuracyDocument
    verdict: documents.VerdictDocument
    frames: documents.FramesDocument
    features: documents.FeaturesDocument
    geometric: documents.GeometricDocument
    iso9283: documents.Iso9283Document
    iso9283_streams: documents.Iso9283StreamsDocument
    iso9283_compliance: documents.Iso9283ComplianceDocument
    uncertainty: documents.UncertaintyDocument
    recommendation: documents.RecommendationDocument
    controllers: documents.ControllersDocument
    field: documents.FieldDocument
    import_: documents.ImportDocument
    manifest: documents.ManifestDocument

    def __init__(self, met: bool, folder: Path, messages: Sequence[Message]) -> None:
        self.met = met
        self.folder = folder
        self.messages = tuple(messages)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> documents.Document:
            # a copy is asked for its methods before it has a folder
            if name.startswith("_") or "folder" not in self.__dict__:
                raise AttributeError(name)
            path = self.folder / f"{name.rstrip('_').replace('_', '-')}.json"
            if not path.is_file():
                raise AttributeError(f"the campaign has no {name!r}: it has {', '.join(self._documents())}")
            return load(path.read_text(encoding="utf-8"))

    def _residual_columns(self) -> str:
        if not (self.folder / "accuracy.json").is_file():
            raise Error(f"the campaign has no residuals, because it identifies no parameters: it has {', '.join(self._documents())}")
        return _etalon.residuals(str(self.folder))

    def _documents(self) -> list[str]:
        stems = sorted(path.stem.replace("-", "_") for path in self.folder.glob("*.json"))
        return [stem + "_" if iskeyword(stem) else stem for stem in stems]

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._documents()})

    def __repr__(self) -> str:
        said = "".join(f"\n  {message.severity}: {message.id}: {message.what}" for message in self.messages)
        return f"Run(met={self.met}, folder={str(self.folder)!r})" + said

    def _repr_html_(self) -> str:
        verdict = "every limit is met" if self.met else "a limit is not met, or the result can be no robot"
        parts = [f"<p>{verdict}; {html.escape(str(self.folder))}</p>"]
        items = [f"<li><b>{message.severity}</b> <code>{message.id}</code>: {html.escape(message.what)}</li>" for message in self.messages]
        parts += [f"<ul>{''.join(items)}</ul>"] if items else []
        parts += [getattr(self, name)._repr_html_() for name in ("parameters",) if (self.folder / f"{name}.json").is_file()]
        return "".join(parts)


def run(folder: str | os.PathLike[str], *, reports: bool = True) -> Run:
    """Run a campaign: exports and logs in, parameters and report out, as ``etalon run``.

    Args:
        folder: Folder of the campaign, or its ``campaign.toml``.
        reports: Writes the reports and the tables of points and observations too.

    Raises:
        Error: Everything that is wrong with the campaign; nothing is written.

    Warns:
        MessageWarning: Messages of the campaign, by id.
    """
    with _keys():
        met, output, messages = _etalon.run(_path(folder), reports)
    found = Run(met, Path(output).absolute(), [Message(stated, in_campaign=True) for stated in json.loads(messages)])
    warn(found.messages)
    return found


def check(folder: str | os.PathLike[str]) -> documents.CheckDocument:
    """Find everything that is wrong with a campaign, without computing.

    Returns:
        :class:`etalon.documents.CheckDocument`: ``.errors`` and ``.warnings``.
    """
    with _keys():
        found = cast(documents.CheckDocument, load(_etalon.check(_path(folder))))
    warn(Message(stated, in_campaign=True) for stated in found.to_dict().get("warnings") or [])
    return found


def validate(
    folder: str | os.PathLike[str],
    parameters: Any = None,
    *,
    field: Any = None,
    frames: Literal["refit", "given", "prior"] = "refit",
) -> documents.AccuracyDocument:
    """Judge given parameters on the data of a campaign.

    Args:
        folder: Folder of the campaign.
        parameters: A parameters document, or the path of one; nominal values if None.
        field: Residual field that belongs to the parameters: the document of the same run, or the path of its ``field.json``.
        frames: Where base and targets come from: ``"refit"``, ``"given"`` or ``"prior"``.

    Returns:
        :class:`etalon.documents.AccuracyDocument`.

    Raises:
        Error: The campaign does not read, or the parameters belong to another robot.
    """
    if field is not None and parameters is None:
        raise Error("`field` needs `parameters`: a residual field belongs to identified parameters")
    with _keys():
        text = _etalon.validate(_path(folder), json_of(parameters), json_of(field, "field"), json.dumps({"frames": frames}))
    return cast(documents.AccuracyDocument, with_warnings(load(text), in_campaign=True))


def recommend(folder: str | os.PathLike[str], *, progress: Progress | None = None) -> documents.RecommendationDocument:
    """Find out which identified parameters of a campaign deserve to be loaded.

    Args:
        folder: Folder of the campaign.
        progress: Called with what is done and the whole: ``lambda done, whole: ...``; an exception of it ends the computation.

    Returns:
        :class:`etalon.documents.RecommendationDocument`.
    """
    with _keys():
        text = _etalon.recommend(_path(folder), called(progress))
    return cast(documents.RecommendationDocument, with_warnings(load(text), in_campaign=True))


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
    with _keys():
        drawn = {"draws": whole(draws, "draws"), "resamples": whole(resamples, "resamples"), "seed": whole(seed, "seed")}
        text = _etalon.uncertainty(_path(folder), drawn, called(progress))
    return cast(documents.UncertaintyDocument, with_warnings(load(text), in_campaign=True))


def batch(folders: Sequence[str | os.PathLike[str]] | str | os.PathLike[str], *, reports: bool = False, progress: Progress | None = None) -> documents.BatchDocument:
    """Run many campaigns on all cores; one of which nothing has changed is read back.

    Args:
        folders: Campaigns, folders of campaigns, or texts that list campaigns.
        reports: Writes the reports too.
        progress: As in :func:`recommend`.

    Returns:
        :class:`etalon.documents.BatchDocument`: ``.campaigns`` says how each ended.
    """
    listed = [folders] if isinstance(folders, (str, os.PathLike)) else folders
    if not isinstance(listed, Iterable):
        raise Error(f"`folders` is of type {type(folders).__name__}: expected paths of campaigns")
    with _keys():
        return cast(documents.BatchDocument, load(_etalon.batch([_path(folder) for folder in listed], reports, called(progress))))


@contextmanager
def _keys() -> Iterator[None]:
    """Raise errors with hints in the keys of campaign.toml."""
    try:
        yield
    except Error as error:
        raise error.for_campaign() from None


def _path(folder: str | os.PathLike[str]) -> str:
    if not isinstance(folder, (str, os.PathLike)):
        raise Error(f"`folder` is of type {type(folder).__name__}: expected the path of a folder with campaign.toml")
    return os.fspath(folder)
