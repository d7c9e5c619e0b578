"""A collection is text that comes back as it was, and training takes from it what its number of waveforms allows."""

import tomllib
from importlib import resources

import msgspec
import pytest

from bnserve_store import ModelStore
from bnserve_surrogate._artifact import SurrogateMetadata
from bnserve_surrogate.training.config import ConfigurationInvalid, parse_configuration
from bnserve_surrogate.training.pipeline import train
from bnserve_surrogate.training.publication import publish
from bnserve_surrogate.training.search.hyperparameters import (
    Hyperparameters,
    HyperparametersUnknown,
    ParetoCollection,
    ParetoEntry,
    ParetoSetup,
    collection_text,
    load_collection,
    parse_collection,
    with_best_hyperparameters,
    write_collection,
)
from bnserve_surrogate.training.search.results import search_results
from bnserve_surrogate.training.validation.fresh import validate_artifact
from tests.surrogate.searching import NETWORK, run, table, toy_search

SETUP = ParetoSetup(
    regressor="polynomial",
    reduction="metric",
    coordinates="physical",
    generator='a "quoted" one, with ümlauts and \\',
    sampling="uniform",
    waveforms=400,
    waveform_seconds=0.1,
    trials=3,
    mass_ratio=(1.0, 3.0),
    chi=(-0.5, 0.5),
    tidal_deformability=(5.0, 5000.0),
)


def entry(trial, waveforms, error, degree, components=6):
    return ParetoEntry(
        trial=trial,
        waveforms=waveforms,
        reconstruction_error=error,
        median_mismatch=1e-07,
        training_seconds=0.25,
        cost_seconds=0.1 * waveforms + 0.25,
        hyperparameters=Hyperparameters(
            reduction={"components": components},
            regressor={"polynomial": {"degree": degree, "weights": [1.0, 0.8, 1.0, 1.5, 1.5], "terms": 40}},
        ),
    )


COLLECTION = ParetoCollection(setup=SETUP, entry=(entry(4, 60, 1e-2, 1.5), entry(1, 200, 1e-5, 3.0)))


@pytest.fixture
def asking(tmp_path):
    """A configuration, as a table, that asks for the best of a file."""
    path = tmp_path / "mine.toml"
    write_collection(path, COLLECTION, "made by hand")

    def make(count=100, **regressor):
        return table({"kind": "polynomial", "coordinates": "physical", "hyperparameters": "best", "pareto": str(path),
                      **regressor}, dataset={"count": count})  # fmt: skip

    return make


def test_a_collection_comes_back_as_it_was_written():
    text = collection_text(COLLECTION, "first line\nsecond line")
    assert text.startswith("# first line\n# second line\n")
    assert parse_collection(text, "x") == COLLECTION


def test_an_entry_is_a_fragment_of_a_configuration():
    read = tomllib.loads(collection_text(COLLECTION, ""))["entry"][0]
    filled = parse_configuration(table() | read["hyperparameters"])
    assert (filled.reduction.components, filled.regressor.polynomial.terms) == (6, 40)


def test_what_a_search_found_comes_back_as_it_was_written(tmp_path):
    search = toy_search(tmp_path / "study.jsonl", NETWORK)
    run(search, tmp_path, trials=4)
    found = search_results(search).pareto
    assert parse_collection(collection_text(found, "comment"), "x") == found


@pytest.mark.parametrize(
    ("count", "trial"), [(60, 4), (199, 4), (200, 1), (10**6, 1)], ids=lambda value: str(value)
)  # fmt: skip
def test_the_best_of_those_with_no_more_waveforms_is_taken(count, trial):
    assert COLLECTION.best_for(count).trial == trial


def test_the_more_accurate_is_taken_whether_it_has_as_many_waveforms_or_fewer():
    twice = msgspec.structs.replace(COLLECTION, entry=(entry(1, 200, 1e-3, 2.0), entry(2, 200, 1e-4, 2.0)))
    assert twice.best_for(500).trial == 2
    fewer = msgspec.structs.replace(COLLECTION, entry=(entry(1, 100, 1e-4, 2.0), entry(2, 200, 1e-3, 2.0)))
    assert fewer.best_for(500).trial == fewer.best_for(199).trial == 1


@pytest.mark.parametrize("name", ["pareto_polynomial.toml", "pareto_network.toml"])
def test_more_waveforms_never_mean_worse_hyperparameters(name):
    text = (resources.files("bnserve_surrogate") / "data" / name).read_text(encoding="utf-8")
    collection = parse_collection(text, name)
    errors = [collection.best_for(entry.waveforms).reconstruction_error for entry in collection.entry]
    assert errors == sorted(errors, reverse=True)


def test_fewer_waveforms_than_any_entry_is_an_error():
    with pytest.raises(HyperparametersUnknown, match="has 60 waveforms; this configuration has 59"):
        COLLECTION.best_for(59)


def test_the_lookup_fills_the_configuration_in_and_says_what_it_took(asking):
    configuration, sentence = with_best_hyperparameters(parse_configuration(asking(100)))
    assert "trial 4 of" in sentence
    assert "found with 60 waveforms" in sentence
    assert "this training has 100" in sentence
    assert configuration.regressor.polynomial.degree == 1.5
    assert configuration.reduction.components == 6
    assert (configuration.regressor.hyperparameters, configuration.regressor.pareto) == ("given", "")
    assert configuration.dataset.count == 100


def test_training_takes_the_best_and_records_them(asking, tmp_path):
    made = asking(100) | {"validation": {"count": 8, "edge_count": 0}}
    configuration, said = parse_configuration(made), []
    trained = train(configuration, tmp_path, n_jobs=1, backend="sequential", progress=False, say=said.append)
    assert said[0].startswith("Hyper-parameters: trial 4 of ")
    assert trained.tensors["22/polynomial_coefficients"].shape[1] == 6 + 3
    (tmp_path / "mine.toml").unlink()  # a published model does not depend on it
    publish(configuration, trained, tmp_path / "store")
    artifact = ModelStore([tmp_path / "store"]).load("toy")
    recorded = SurrogateMetadata.read(artifact.manifest.metadata).provenance["configuration"]
    assert recorded["regressor"]["polynomial"]["degree"] == 1.5
    own = recorded["generator"]["options"]["path"]
    found = validate_artifact(artifact, tmp_path, counts={"uniform": 4}, seed=5, n_jobs=1, own_function=own)
    assert len(found["uniform"].theta) == 4


def test_a_collection_for_something_else_is_refused(asking):
    wrong = parse_configuration(asking(coordinates="raw"))
    with pytest.raises(HyperparametersUnknown, match=r"coordinates physical; this .* coordinates raw"):
        with_best_hyperparameters(wrong)


def test_a_collection_that_is_not_there(asking):
    missing = parse_configuration(asking(pareto="nowhere.toml"))
    with pytest.raises(HyperparametersUnknown, match=r"no collection of hyper-parameters nowhere\.toml"):
        with_best_hyperparameters(missing)
    unsearched = parse_configuration(asking(kind="sum", pareto=""))
    with pytest.raises(HyperparametersUnknown, match=r"pareto_sum\.toml.*bnserve search"):
        with_best_hyperparameters(unsearched)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("trials = 3", "trails = 3"),
        ("waveforms = 60", "waveforms = 'many'"),
        ("hyperparameters.reduction.components", "hyperparameters.generator.options.path"),
        ("[setup]", "[setup"),
    ],
)
def test_a_collection_with_anything_else_in_it_is_refused(old, new):
    text = collection_text(COLLECTION, "")
    assert old in text
    with pytest.raises(ConfigurationInvalid, match="my file is not a collection"):
        parse_collection(text.replace(old, new, 1), "my file")


@pytest.mark.parametrize(
    ("key", "message"),
    [
        ("polynomial.degre", "did you mean 'degree'"),
        ("polinomial.degree", "did you mean 'polynomial'"),
        ("kind.degree", "'kind' has no keys"),
    ],
)
def test_a_hyperparameter_that_does_not_exist_is_an_error(asking, tmp_path, key, message):
    path = tmp_path / "mine.toml"
    path.write_text(path.read_text().replace("regressor.polynomial.degree", f"regressor.{key}", 1))
    with pytest.raises(ConfigurationInvalid, match=message):
        with_best_hyperparameters(parse_configuration(asking(100)))


@pytest.mark.parametrize("value", ["bset", 1])
def test_a_misspelt_choice_is_an_error(value):
    with pytest.raises(ConfigurationInvalid, match="hyperparameters"):
        parse_configuration(table({"kind": "polynomial", "coordinates": "physical", "hyperparameters": value}))


@pytest.mark.parametrize(
    ("kind", "reduction", "coordinates"), [("polynomial", "metric", "physical"), ("network", "paper", "raw")]
)
def test_a_collection_ships_for_every_entry_of_which_a_training_can_be_configured(kind, reduction, coordinates):
    regressor = {"kind": kind, "coordinates": coordinates, "hyperparameters": "best"}
    asked = parse_configuration(table(regressor, reduction={"kind": reduction}, dataset={"count": 2**17}))
    name, collection = load_collection(asked)
    assert name == f"pareto_{kind}.toml"
    assert len(collection.entry) >= 5
    for each in collection.entry:
        counted = msgspec.structs.replace(asked, dataset=msgspec.structs.replace(asked.dataset, count=each.waveforms))
        filled, sentence = with_best_hyperparameters(counted)
        assert f"found with {each.waveforms} waveforms" in sentence
        assert filled.regressor.hyperparameters == "given"
    shipped = (resources.files("bnserve_surrogate") / "data" / name).read_text(encoding="utf-8")
    assert shipped.startswith("# ")
    assert "bnserve search" in shipped
