"""The hyper-parameters that are searched, as overrides of a training configuration.

The network's are those of the paper's appendix "Hyperparameters used" and its number of epochs; the polynomial's are
its degree, its terms, the weights of its coordinates and the number of components.
"""

from __future__ import annotations

from typing import Any, Protocol

from bnserve_surrogate.training.reduction.reductions import SCALARS
from bnserve_surrogate.training.regressors import weighted_exponents
from bnserve_surrogate.training.search.hyperparameters import Values
from bnserve_surrogate.training.sections import TrainingConfiguration

FEWEST_WAVEFORMS = 50
"""The paper's smallest training set."""
MULTIPLY_ADDS = 20_000
"""A polynomial has at most this many coefficients: more would always be better, and slower to evaluate."""
_MOST_TERMS = 1500
"""Before pruning: a fit with more takes minutes."""
_SAMPLES_PER_TERM = 1.25
"""Fewer samples than this for every term, and least squares follows single waveforms."""
_WEIGHTS = 5


class Suggester(Protocol):
    """What is used of an ``optuna.Trial``."""

    def suggest_float(self, name: str, low: float, high: float, *, step: float | None = None, log: bool = False) -> Any:
        """A number between ``low`` and ``high``."""

    def suggest_int(self, name: str, low: int, high: int, *, step: int = 1, log: bool = False) -> Any:
        """An integer between ``low`` and ``high``, both included."""

    def suggest_categorical(self, name: str, choices: Any) -> Any:
        """One of ``choices``."""


def suggest(trial: Suggester, configuration: TrainingConfiguration, most_waveforms: int) -> Values:
    """Draw what the configuration's regressor leaves open, the number of training waveforms (``dataset.count``) first.

    The values are those that are used: rounded to three digits, batches no larger than the training set, no more
    terms than the training set determines.
    """
    waveforms = trial.suggest_int("waveforms", min(FEWEST_WAVEFORMS, most_waveforms), most_waveforms, log=True)
    values: Values = {"dataset.count": waveforms}
    kind = configuration.regressor.kind
    if kind in ("network", "sum"):
        values |= _network(trial, configuration, waveforms)
    if kind in ("polynomial", "sum"):
        values |= _polynomial(trial, waveforms)
    if configuration.reduction.kind == "paper":
        exponent = trial.suggest_float("eigenvalue_exponent", 0.0, 1.0)
        values["reduction.eigenvalue_exponent"] = _rounded(exponent)
    return values


def searched_keys(configuration: TrainingConfiguration) -> set[str]:
    """What :func:`suggest` overrides for this configuration, by dotted key."""
    return set(suggest(_Given(configuration, FEWEST_WAVEFORMS), configuration, FEWEST_WAVEFORMS))


def first_suggestions(configuration: TrainingConfiguration, most_waveforms: int) -> list[Values]:
    """What the configuration gives, by name of the suggestion, for all waveforms, a quarter, a sixteenth and so on."""
    found: list[Values] = []
    while not found or most_waveforms >= FEWEST_WAVEFORMS:
        given = _Given(configuration, most_waveforms)
        suggest(given, configuration, most_waveforms)
        found.append(given.noted)
        most_waveforms //= 4
    return found


class _Given:
    """Suggests what a configuration gives, at the nearest end where that is out of range, and notes it."""

    def __init__(self, configuration: TrainingConfiguration, waveforms: int) -> None:
        network, polynomial = configuration.regressor.network, configuration.regressor.polynomial
        self.noted: Values = {}
        self._given = {
            "waveforms": waveforms,
            "components": configuration.reduction.components,
            "eigenvalue_exponent": configuration.reduction.eigenvalue_exponent,
            "layers": len(network.hidden_layer_sizes),
            **{f"layer_{i}": size for i, size in enumerate(network.hidden_layer_sizes)},
            **{name: getattr(network, name) for name in network.__struct_fields__},
            "degree": polynomial.degree / polynomial.weights[0],
            **{f"weight_{i}": weight / polynomial.weights[0] for i, weight in enumerate(polynomial.weights)},
            "terms": _MOST_TERMS if polynomial.terms is None else polynomial.terms,
        }

    def suggest_float(self, name: str, low: float, high: float, *, step: float | None = None, log: bool = False) -> Any:
        value = min(max(self._given[name], low), high)
        self.noted[name] = value if step is None else low + step * round((value - low) / step)
        return self.noted[name]

    def suggest_int(self, name: str, low: int, high: int, *, step: int = 1, log: bool = False) -> Any:
        self.noted[name] = min(max(self._given.get(name, low), low), high)
        return self.noted[name]

    def suggest_categorical(self, name: str, choices: Any) -> Any:
        self.noted[name] = self._given[name]
        return self.noted[name]


def _network(trial: Suggester, configuration: TrainingConfiguration, waveforms: int) -> Values:
    layers = trial.suggest_int("layers", 1, 3)
    fraction = _rounded(trial.suggest_float("validation_fraction", 0.05, 0.25))
    batch = trial.suggest_int("batch_size", 16, 512, log=True)
    values = {
        "hidden_layer_sizes": [trial.suggest_int(f"layer_{i}", 8, 128, log=True) for i in range(layers)],
        "activation": trial.suggest_categorical("activation", ["tanh", "relu", "logistic"]),
        "alpha": _rounded(trial.suggest_float("alpha", 1e-9, 1e-1, log=True)),
        "batch_size": min(batch, int((1.0 - fraction) * waveforms) - 1),
        "learning_rate_init": _rounded(trial.suggest_float("learning_rate_init", 2e-4, 2e-2, log=True)),
        "max_iter": trial.suggest_int("max_iter", 30, max(30, configuration.regressor.network.max_iter), log=True),
        "validation_fraction": fraction,
        "tol": _rounded(trial.suggest_float("tol", 1e-15, 1e-4, log=True)),
        "n_iter_no_change": trial.suggest_int("n_iter_no_change", 5, 100, log=True),
    }
    return {f"regressor.network.{name}": value for name, value in values.items()}


def _polynomial(trial: Suggester, waveforms: int) -> Values:
    components = trial.suggest_int("components", 8, 40)
    others = [_rounded(trial.suggest_float(f"weight_{i}", 0.6, 2.0, step=0.1)) for i in range(1, _WEIGHTS)]
    weights = [1.0, *others]  # a common factor of all weights is the degree's
    allowed = min(_MOST_TERMS, int(waveforms / _SAMPLES_PER_TERM))
    degree = _determined(trial.suggest_float("degree", 1.0, 11.0, step=0.5), weights, allowed)
    terms = trial.suggest_int("terms", 50, _MOST_TERMS, log=True)
    return {
        "reduction.components": min(components, waveforms),
        "regressor.polynomial.degree": degree,
        "regressor.polynomial.weights": weights,
        "regressor.polynomial.terms": min(terms, MULTIPLY_ADDS // (components + len(SCALARS))),
    }


def _determined(degree: float, weights: list[float], allowed: int) -> float:
    """The largest degree up to ``degree``, in steps of a half, with at most ``allowed`` terms."""
    while degree > 0.0 and len(weighted_exponents(degree, weights)) > allowed:
        degree -= 0.5
    return degree


def _rounded(value: float) -> float:
    return float(f"{value:.3g}")
