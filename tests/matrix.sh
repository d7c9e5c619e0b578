#!/usr/bin/env bash
# Whether it runs on every Python that it is for: the newest of all dependencies on each, the lowest on 3.11.
#
#   bash tests/matrix.sh                     import every module, and `bnserve demo`; a minute or two each
#   bash tests/matrix.sh tests/protocol -x   with all extras: pytest, with these arguments
#   PYTHONS="3.12 3.13" bash tests/matrix.sh some of them
#
# uv finds interpreters that are installed (those of pyenv are looked for, too), and fetches those that are not where it may. One that is not to be had is
# said, and no failure; nothing to be had is one.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder=.venv-matrix
export PIP_DISABLE_PIP_VERSION_CHECK=1 UV_SYSTEM_CERTS=1 UV_NATIVE_TLS=1 # two names of one thing, as pip does it
tools=$folder/tools
[ -x "$tools/bin/uv" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install --quiet "uv>=0.7"; } || exit 1
uv=$PWD/$tools/bin/uv
PATH=$PATH$(printf ':%s' "${PYENV_ROOT:-$HOME/.pyenv}"/versions/3.*/bin)
summary=()
status=0
ran=

say() { printf '\n== %s\n' "$*"; }

on() { # an environment with this Python and the newest of everything; then the tests
    local version=$1 venv=$folder/$1 python
    shift
    python=$venv/bin/python
    if [ "$#" -gt 0 ]; then
        "$uv" pip install --quiet --python "$python" --upgrade --requirements pyproject.toml --extra train --extra lal \
            --extra test && "$python" -m pytest "$@"
    else
        "$uv" pip install --quiet --python "$python" --upgrade ./protocol ./model_store ./surrogate ./inference \
            ./posterior ./jax_model "./service[demo]" "./client[progress]" &&
            "$python" -W error tests/import_everything.py && "$venv/bin/bnserve" demo --output "$venv/demo.png"
    fi
}

record() { # a name, and what was seen
    summary+=("$(printf '  %-22s %s' "$1" "$2")")
}

for version in ${PYTHONS:-3.11 3.12 3.13 3.14}; do
    say "Python $version"
    rm -rf "${folder:?}/$version"
    if ! "$uv" venv --quiet --python "$version" "$folder/$version"; then
        record "Python $version" "not there, and not to be had"
        continue
    fi
    ran=yes
    exact=$("$folder/$version/bin/python" -c 'import platform; print(platform.python_version(), platform.machine())')
    if on "$version" "$@"; then record "Python $exact" passed; else record "Python $exact" FAILED; status=1; fi
done

if [ -x "$folder/3.11/bin/python" ]; then # wheels of all the lowest are there for this one alone
    say "Python 3.11, lowest versions"
    if PYTHON=$folder/3.11/bin/python bash tests/lowest.sh "$@"; then record "lowest versions" passed
    else record "lowest versions" FAILED; status=1; fi
fi

say "Summary"
printf '%s\n' "${summary[@]}"
[ -n "$ran" ] || status=1
exit "$status"
