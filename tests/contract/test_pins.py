"""A model pinned by its digest, and what it was made with: the same for a local and a remote model."""

import asyncio

import numpy as np
import pytest

from bnserve_client import AsyncModel
from bnserve_client import Model as RemoteModel
from bnserve_protocol import DigestUnknown, InvalidRequest, ParametersWithExtrinsic
from bnserve_surrogate import Model as LocalModel

FREQUENCIES, ONE = np.geomspace(20.0, 1500.0, 100), ParametersWithExtrinsic.gw170817()
ABSENT = "sha256:" + "0" * 64


@pytest.fixture(params=["local", "remote"])
def get(request):
    """``get(**options)``: the model called default."""
    if request.param == "local":
        store = request.getfixturevalue("one_mode")
        return lambda **options: LocalModel.load("default", store=store, **options)
    address = request.getfixturevalue("address")
    return lambda **options: RemoteModel.connect(address, "default", **options)


def test_the_digest_of_one_run_gets_the_same_artifact_in_the_next(get, local):
    model = get(digest=local.description.digest)
    assert model.description == local.description
    assert model.predict(FREQUENCIES, ONE).plus.tobytes() == local.predict(FREQUENCIES, ONE).plus.tobytes()


def test_a_digest_that_is_not_there_is_never_answered_by_something_else(get, local):
    with pytest.raises(DigestUnknown, match=local.description.digest):
        get(digest=ABSENT)
    with pytest.raises(InvalidRequest, match="64 hexadecimal"):
        get(digest=local.description.digest[:-1])


def test_the_manifest_names_the_model_the_kernel_and_the_processor(get, local):
    told, own = get().manifest(), local.manifest()
    assert local.description.digest in [model.digest for model in told.models]
    assert (told.kernel, told.processor, told.platform) == (own.kernel, own.processor, own.platform)
    assert own.software.items() <= told.software.items()
    assert told == told.sealed()


def test_the_asynchronous_model_has_both(address, local):
    async def ask():
        model = await AsyncModel.connect(address, digest=local.description.digest)
        try:
            return await model.manifest(), await model.predict(FREQUENCIES, ONE)
        finally:
            await model.close()

    told, answer = asyncio.run(ask())
    assert local.description.digest in [model.digest for model in told.models]
    assert answer.plus.tobytes() == local.predict(FREQUENCIES, ONE).plus.tobytes()
