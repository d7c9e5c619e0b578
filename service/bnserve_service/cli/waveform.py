"""``bnserve waveform``: one binary, from here or from a server, into a file or a picture."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence

    from bnserve_protocol import EvaluationOptions, Polarizations, UniformGrid, WaveformModel

OURS = {
    "mass_ratio": "heavier over lighter star (1.2)",
    "total_mass": "in the detector's frame, in solar masses (2.76)",
    "lambda_1": "tidal polarisability of the heavier star (400)",
    "lambda_2": "of the lighter star (600)",
    "chi_1": "spin of the heavier star along the orbital angular momentum (0.01)",
    "chi_2": "of the lighter star (0)",
    "distance_mpc": "luminosity distance in Mpc (40)",
    "inclination": "of the orbital angular momentum to the line of sight, in radians (2.5)",
    "reference_phase": "added to the phase, in radians (0)",
    "time_shift": "of the signal, in seconds (0)",
}
"""The protocol's parameters (which needs numpy, and the help does not), what they are, and those like GW170817's."""
CONVERTED = {
    "mass_1": "with mass_2, in solar masses",
    "mass_2": "with mass_1",
    "chirp_mass": "in solar masses",
    "symmetric_mass_ratio": "in place of the mass ratio",
    "eta": "the same",
    "lambda_tilde": "with delta_lambda_tilde",
    "delta_lambda_tilde": "with lambda_tilde",
    "a_1": "with a tilt, of an aligned spin",
    "a_2": "as a_1",
    "tilt_1": "with a_1, in radians",
    "tilt_2": "with a_2",
    "cos_tilt_1": "in place of tilt_1",
    "cos_tilt_2": "in place of tilt_2",
    "luminosity_distance": "distance_mpc",
    "theta_jn": "inclination",
    "iota": "inclination",
    "spin_1z": "chi_1",
    "spin_2z": "chi_2",
    "spin1z": "chi_1",
    "spin2z": "chi_2",
    "lambda1": "lambda_1",
    "lambda2": "lambda_2",
}
"""Names of bilby, PyCBC and LAL that the protocol converts, and what goes with them or which of ours they are."""
EXPLAINED = (
    "mass1", "mass2", "m1", "m2", "phase", "coa_phase", "phi_ref", "geocent_time", "tc", "geocentric_end_time",
    "redshift",
)  # fmt: skip  # as above
"""Names of theirs that have no exact counterpart; what to give in their place is said where they are given."""
PICTURES = (".png", ".pdf", ".svg")


def add_parser(subparsers: Any) -> None:
    """Add the subcommand, with an option for every parameter under every name."""
    parser: argparse.ArgumentParser = subparsers.add_parser(
        "waveform",
        help="evaluate one binary: into a file or a picture",
        description="Evaluate one binary and say what it is, here or with --url by a server. What is not given is that "
        "of a binary like GW170817. --output takes the numbers (.npz, .csv, .h5) or a picture (.png, .pdf, .svg).",
    )
    add = parser.add_argument
    add("--output", type=Path, metavar="FILE", help="FILE.npz, .csv, .h5: the numbers; FILE.png, .pdf, .svg: a picture")
    add("--model", default="default", metavar="NAME[@VERSION]", help="which model (default)")
    add("--store", type=Path, action="append", metavar="DIR", help="model store, searched before the shipped models")
    add("--url", metavar="URL", help="of a server: http://host:8000, host:8000 or unix:/path/to/socket")
    add("--token", metavar="TOKEN", help="where the server wants one ($BNSERVE_TOKEN or $BNSERVE_TOKEN_FILE)")
    add("--f-min", type=float, default=20.0, metavar="HZ", help="lowest frequency of the numbers (20)")
    add("--f-max", type=float, metavar="HZ", help="highest (2048, or where the model ends)")
    add("--delta-f", type=float, default=0.25, metavar="HZ", help="between two (0.25)")
    add("--modes", metavar="LM,LM", help="modes that count, such as 22,33 (all that the model has)")
    add("--json", action="store_true", help="print what it is as one JSON object")
    binary = parser.add_argument_group("the binary")
    for name, text in OURS.items():
        _add_parameter(binary, name, text)
    other = parser.add_argument_group("the same by names of bilby, PyCBC and LAL")
    for name, text in CONVERTED.items():
        _add_parameter(other, name, text)
    for name in EXPLAINED:
        _add_parameter(other, name, argparse.SUPPRESS)
    parser.set_defaults(run=run)


def _add_parameter(group: Any, name: str, text: str) -> None:
    group.add_argument(f"--{name.replace('_', '-')}", dest=name, type=float, metavar="X", help=text)
    if "_" in name:
        group.add_argument(f"--{name}", dest=name, type=float, help=argparse.SUPPRESS)


def run(options: argparse.Namespace) -> int:
    """Evaluate, write, say."""
    from bnserve_protocol import EvaluationOptions, InvalidRequest, UniformGrid, chosen_modes
    from bnserve_service.cli.places import modes_of

    ending = options.output.suffix.lower() if options.output else None
    if ending is not None:
        _check(options.output, ending)
    if options.url and options.store:
        raise InvalidRequest("--store is for models here; a server has its own stores. Leave out one of the two.")
    chosen = EvaluationOptions(modes=modes_of(options.modes))
    parameters = _parameters(options)
    model = _model(options)
    modes = chosen_modes(chosen, model.description.modes)
    f_max = _end(model, parameters) if options.f_max is None else options.f_max
    grid = UniformGrid(f_min=options.f_min, f_max=f_max, delta_f=options.delta_f)
    answer = _predict(model, grid, parameters, chosen)
    if ending in PICTURES:
        from bnserve_service.demo.chirp import evaluate_chirp
        from bnserve_service.demo.picture import save_picture

        where = f"at {options.url}" if options.url else "evaluated here"
        save_picture(
            options.output, evaluate_chirp(model, parameters, modes), model.description, "A binary neutron star", where
        )
    elif ending is not None:
        from bnserve_service.cli.places import save_numbers

        arrays = {"frequencies": grid.frequencies(), "h_plus": answer.plus, "h_cross": answer.cross}
        save_numbers(options.output, arrays, _summary(options, model, parameters, grid, modes))
    _say(options, _summary(options, model, parameters, grid, modes))
    return 0


def _predict(model: WaveformModel, grid: UniformGrid, parameters: Any, options: EvaluationOptions) -> Polarizations:
    from bnserve_protocol import OutOfDomain

    try:
        return model.predict(grid, parameters, options=options)
    except OutOfDomain as error:  # it speaks of rows and of Python's options
        reasons = "; ".join(f"{each.parameter} = {each.value}: {each.reason}" for each in error.errors)
        raise OutOfDomain(f"The model was not trained on this binary. {reasons}.", errors=error.errors) from error


def _check(path: Path, ending: str) -> None:
    from bnserve_protocol import InvalidRequest, require
    from bnserve_service.cli.places import WRITERS, check_place

    if ending not in (*PICTURES, *WRITERS):
        known = ", ".join((*WRITERS, *PICTURES))
        raise InvalidRequest(f"'{path}' does not say what to write; end its name in one of {known}.")
    check_place(path, "--output")
    if ending in PICTURES:
        require("matplotlib", "A picture")  # better missed now than at the end
        require("bnserve_client", "A picture")
    if ending in (".h5", ".hdf5"):
        require("h5py", "An HDF5 file")


def _parameters(options: argparse.Namespace) -> Any:
    """The binary: what is given, by our names; the rest is that of GW170817."""
    import dataclasses

    from bnserve_protocol import ParametersWithExtrinsic, convert

    names = (*OURS, *CONVERTED, *EXPLAINED)
    given = {name: value for name in names if (value := getattr(options, name)) is not None}
    usual = ParametersWithExtrinsic.gw170817()
    if not given.keys() & {"mass_ratio", "symmetric_mass_ratio", "eta", "mass_1", "mass_2"}:
        given["mass_ratio"] = usual.mass_ratio  # chirp mass and tides are converted with it
    return dataclasses.replace(usual, **convert(given))


def _model(options: argparse.Namespace) -> WaveformModel:
    from bnserve_service.cli.places import open_model

    found: WaveformModel = open_model(
        options.model, options.store, url=options.url, token=options.token, purpose="A waveform of a server"
    )
    return found


def _end(model: WaveformModel, parameters: Any) -> float:
    """Hz: 2048, or where the model ends for this binary."""
    known = model.description
    end = known.training_band[1] * known.reference_mass / parameters.total_mass * (1.0 - 1e-9)
    return float(min(2048.0, end))


def _summary(
    options: argparse.Namespace, model: WaveformModel, parameters: Any, grid: UniformGrid, modes: Sequence[Any]
) -> dict[str, Any]:
    import dataclasses

    known = model.description
    return {
        "model": known.name,
        "version": known.version,
        "digest": known.digest,
        "modes": [list(mode) for mode in modes],
        "server": options.url,
        "parameters": {name: float(value) for name, value in dataclasses.asdict(parameters).items()},
        "grid": {"f_min": grid.f_min, "f_max": grid.f_max, "delta_f": grid.delta_f, "frequencies": len(grid)},
        "seconds_until_merger": float(model.time_until_merger(grid.f_min, parameters)),
        "output": str(options.output) if options.output else None,
    }


def _say(options: argparse.Namespace, summary: dict[str, Any]) -> None:
    from bnserve_service.cli.places import print_json

    if options.json:
        print_json(summary)
        return
    print(f"model    {summary['model']} {summary['version']} ({summary['digest']}), {options.url or 'evaluated here'}")
    print("binary   " + ", ".join(f"{name} {value:g}" for name, value in summary["parameters"].items()))
    print("modes    " + " ".join(f"({degree}, {order})" for degree, order in summary["modes"]))
    f_min, f_max, delta_f, count = summary["grid"].values()
    print(f"grid     {f_min:g} to {f_max:g} Hz in steps of {delta_f:g} Hz: {count} frequencies")
    print(f"merger   {summary['seconds_until_merger']:.6g} s after it passes {f_min:g} Hz")
    print(f"output   {options.output or 'none: --output FILE.npz, .csv, .h5 or .png takes it'}")
