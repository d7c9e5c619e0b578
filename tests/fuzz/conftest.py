"""What the tests of readers have together."""

import pytest

from tests.fuzz import framing_server


@pytest.fixture(scope="session", autouse=True)
def _server_of_conversations():
    """It is started by the first conversation, and looks at its models for as long as it runs."""
    yield
    framing_server.stop()
