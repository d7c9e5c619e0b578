#!/usr/bin/env bash
# Set up a test environment (.venv-test) and run every check: format, lint, types, import contracts, tests, and that the
# lowest versions of everything are enough (tests/lowest.sh).
#
#   bash tests/run.sh                      everything; needs Python >= 3.11 and installs missing system packages; ends
#                                          with the short form of tests/programs.sh
#   bash tests/run.sh -k store -x          further arguments go to pytest
#   PYTHON=python3.12 bash tests/run.sh    with another interpreter
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { printf '\n== %s\n' "$*"; }
fail() { printf '\nerror: %s\n' "$*" >&2; exit 1; }

find_python() {
    local candidate
    for candidate in ${PYTHON:-python3 python3.14 python3.13 python3.12 python3.11}; do
        if "$candidate" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
            command -v "$candidate"
            return
        fi
    done
    fail "no Python >= 3.11 found; install one, or name it: PYTHON=/path/to/python3.12 bash tests/run.sh"
}

# TEOBResumS comes as C source: a compiler, GSL and the headers of Python; what is in deploy/ is run by its
# programs, some of which Debian keeps in /usr/sbin; the clients in examples/clients are built and run, curl and openssl ask
# servers with TLS, a browser looks at the pages, and shells complete commands. Names of the Debian packages that are missing.
missing_packages() {
    command -v gcc >/dev/null || echo gcc libc6-dev
    command -v pkg-config >/dev/null || echo pkg-config
    [ -e /usr/include/gsl/gsl_version.h ] || pkg-config --exists gsl 2>/dev/null || echo libgsl-dev
    PATH="$PATH:/usr/sbin:/usr/local/sbin" command -v haproxy >/dev/null || echo haproxy
    PATH="$PATH:/usr/sbin:/usr/local/sbin" command -v nginx >/dev/null || echo nginx
    command -v curl >/dev/null || echo curl
    command -v openssl >/dev/null || echo openssl
    [ -x /lib/systemd/systemd ] || echo systemd
    command -v promtool >/dev/null || echo prometheus
    PATH="$PATH:/usr/sbin" command -v slurmctld >/dev/null || echo slurmctld slurmd slurm-client munge
    command -v zsh >/dev/null || echo zsh
    command -v fish >/dev/null || echo fish
    command -v node >/dev/null || echo nodejs
    command -v npm >/dev/null || echo npm
    command -v chromium >/dev/null || echo chromium fonts-dejavu-core
    command -v go >/dev/null || echo golang-go
    [ -d /usr/share/gocode/src/github.com/vmihailenco/msgpack ] || echo golang-github-vmihailenco-msgpack.v5-dev
    pkg-config --exists libcurl 2>/dev/null || echo libcurl4-openssl-dev
    pkg-config --exists msgpack 2>/dev/null || echo libmsgpack-dev
    "$python" - <<'PYTHON_END'
import importlib.util, os, sys, sysconfig
debian = f"python{sys.version_info.major}.{sys.version_info.minor}" if sys.base_prefix == "/usr" else None
if debian and importlib.util.find_spec("ensurepip") is None:
    print(f"{debian}-venv")
if debian and not os.path.exists(os.path.join(sysconfig.get_paths()["include"], "Python.h")):
    print(f"{debian}-dev")
PYTHON_END
}

install_packages() {
    local as_root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || fail "system packages are missing and there is no sudo; as root: apt-get install $*"
        as_root=(sudo)
    fi
    command -v apt-get >/dev/null ||
        fail "this system has no apt-get; install its equivalents of: $*, then run this again"
    say "Installing system packages: $*"
    if ! { "${as_root[@]}" apt-get update -qq &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" >/dev/null; }
    then
        fail "apt-get could not install: $*; see its message above"
    fi
}

python=$(find_python)
mapfile -t packages < <(missing_packages | tr ' ' '\n')
[ "${#packages[@]}" -eq 0 ] || install_packages "${packages[@]}"

say "Environment .venv-test ($("$python" --version))"
if ! .venv-test/bin/python -m pip --version >/dev/null 2>&1; then
    rm -rf .venv-test
    "$python" -m venv .venv-test
fi
export PIP_DISABLE_PIP_VERSION_CHECK=1
.venv-test/bin/pip install --quiet --upgrade pip
.venv-test/bin/pip install --quiet ".[train,lal,test]"
# The rooms once more, editable: the checks look at this checkout, not at copies of it.
.venv-test/bin/pip install --quiet --no-deps \
    -e ./protocol -e ./model_store -e ./surrogate -e ./inference -e ./posterior -e ./jax_model -e ./service -e ./client

export PATH="$PWD/.venv-test/bin:$PATH"
summary=()
status=0
check() {
    local name=$1
    shift
    say "$name: $*"
    local start=$SECONDS
    if "$@"; then
        summary+=("$(printf '  %-18s passed  %5d s' "$name" $((SECONDS - start)))")
    else
        summary+=("$(printf '  %-18s FAILED  %5d s' "$name" $((SECONDS - start)))")
        status=1
    fi
}

check format ruff format --check .
check lint ruff check .
check types mypy
check imports lint-imports --no-logo
check tests pytest --numprocesses 2 --dist loadfile "$@"
# Once more, shortly, on the lowest versions that are declared; wheels of all of them are there for Python 3.11 alone.
if [ "$#" -eq 0 ]; then
    if command -v python3.11 >/dev/null; then
        check "lowest versions" env PYTHON=python3.11 bash tests/lowest.sh
    else
        summary+=("  lowest versions    not checked: there is no python3.11")
    fi
    check programs env PYTHON="$PWD/.venv-test/bin/python" bash tests/programs.sh --short bilby
fi

say "Summary"
printf '%s\n' "${summary[@]}"
exit "$status"
