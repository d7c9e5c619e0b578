#!/usr/bin/env bash
# Whether the lowest versions that pyproject.toml declares are enough.
#
#   bash tests/lowest.sh                      without extras: import every module, and `bnserve demo`; a minute or two
#   bash tests/lowest.sh tests/protocol -x    with all extras: pytest, with these arguments
#   PYTHON=python3.12 bash tests/lowest.sh    with another interpreter than python3.11, the lowest
#
# What was transitive stays as new as it can be. Each form has an environment of its own, made anew at every call.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

fresh() { # the environment in $venv, with uv in it
    rm -rf "$venv"
    "${PYTHON:-python3.11}" -m venv "$venv"
    export PIP_DISABLE_PIP_VERSION_CHECK=1 UV_SYSTEM_CERTS=1 UV_NATIVE_TLS=1 # two names of one thing, as pip does it
    "$venv/bin/pip" install --quiet "uv>=0.7"
    "$venv/bin/uv" pip install --quiet --python "$venv/bin/python" --resolution lowest-direct "$@"
}

if [ "$#" -gt 0 ]; then
    venv=.venv-lowest
    fresh --requirements pyproject.toml --extra train --extra lal --extra test
    exec "$venv/bin/python" -m pytest "$@"
fi

venv=.venv-lowest-core
fresh -e ./protocol -e ./model_store -e ./surrogate -e ./inference -e ./posterior -e ./jax_model -e "./service[demo]" \
    -e "./client[progress]"
"$venv/bin/python" -W error tests/import_everything.py
"$venv/bin/bnserve" demo --output "$venv/demo.png"
