#!/usr/bin/env bash
# A release, dry: wheels and source distributions of all rooms, installed and tried from these files alone.
#
#   bash release/build.sh              into dist/, with the bill of materials of the container and digests of all files
#   bash release/build.sh -m "not slow"   further arguments go to pytest, in place of the tests of the contract
#
# Nothing is uploaded. The umbrella at the root is for checkouts, and no distribution.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

rooms=(protocol model_store surrogate inference posterior jax_model service client)
dist=$PWD/dist
work=$(mktemp -d "${TMPDIR:-/tmp}/bnserve-release.XXXXXX")
trap 'rm -rf "$work"' EXIT
export PIP_DISABLE_PIP_VERSION_CHECK=1 PYTHONDONTWRITEBYTECODE=1
unset PYTHONPATH # or what is tried would be this checkout
say() { printf '\n== %s\n' "$*"; }

version=$(sed -n 's/^__version__ = "\(.*\)"/\1/p' protocol/bnserve_protocol/_version.py)
say "bnserve $version"
grep -q "^## \[$version\]" CHANGELOG.md || { echo "error: CHANGELOG.md has no heading for $version" >&2; exit 1; }
grep -q "^version: $version$" CITATION.cff || { echo "error: CITATION.cff names another version" >&2; exit 1; }

say "Source distributions, and wheels that are built from them"
rm -rf "$dist"
"${PYTHON:-python3}" -m venv "$work/build"
"$work/build/bin/pip" install --quiet build "hatchling>=1.26" packaging
for room in "${rooms[@]}"; do
    "$work/build/bin/python" -m build --no-isolation --outdir "$dist" "$room" >"$work/build.log" 2>&1 ||
        { cat "$work/build.log" >&2; exit 1; }
done
python=$work/venv/bin/python
"$work/build/bin/python" release/lock.py sbom >"$dist/bnserve-$version.cdx.json"
(cd "$dist" && sha256sum -- * >SHA256SUMS && cat SHA256SUMS)

say "An environment of what was built"
"${PYTHON:-python3}" -m venv "$work/venv"
# Ours from the files alone, before anything else is looked for: nobody else's package of that name can take their place.
"$python" -m pip install --quiet --no-index --no-deps "$dist"/*.whl
requirements=$("$python" - "${#rooms[@]}" <<'PYTHON_END'
import sys
from importlib.metadata import distributions
ours = [found for found in distributions() if found.name.startswith("bnserve-")]
assert len(ours) == int(sys.argv[1]), ours
for found in ours:
    for needed in found.requires or []:
        if not needed.startswith("bnserve-") and ("extra ==" not in needed or "demo" in needed.partition(";")[2]):
            print(needed.partition(";")[0].strip())
PYTHON_END
)
# shellcheck disable=SC2086  # a list
"$python" -m pip install --quiet $requirements "pytest>=8.4" "hypothesis>=6.130" "msgpack>=1.2" "jsonschema>=4.23"
"$python" -m pip check

say "Tests, of what is installed, in a folder without the rooms"
mkdir "$work/checkout"
cp -r tests pyproject.toml CHANGELOG.md "$work/checkout/"
cd "$work/checkout"
"$python" -W error - <<'PYTHON_END'
import bnserve_client, bnserve_service, bnserve_surrogate
assert all("/venv/" in module.__file__ for module in (bnserve_client, bnserve_service, bnserve_surrogate))
PYTHON_END
if [ "$#" -eq 0 ]; then set -- tests/contract/test_waveform_model.py; fi
"$python" -m pytest -q -p no:cacheprovider "$@"
"$work/venv/bin/bnserve" demo --output "$work/demo.png"
say "Built, and works: $dist"
