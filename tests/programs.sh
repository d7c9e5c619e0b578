#!/usr/bin/env bash
# Scripts of users of other programs, against a running server: each program from the index, in an environment of its own.
#
#   bash tests/programs.sh bilby                    one or several of: bilby bilby_pipe pycbc bajes gwfish pesummary
#                                                   umbridge jim examples beside
#   bash tests/programs.sh --short bilby            the least of it, in the environment of the tests, in a minute
#   bash tests/programs.sh --cache DIR bilby        environments and what is fetched are kept there (.venv-programs)
#
# A program is a function of its name. Environments are made once and used again: remove the folder to make them anew.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

cache=.venv-programs
short=
programs=()
while [ "$#" -gt 0 ]; do
    case "$1" in
        --short) short=yes ;;
        --cache) cache=$2; shift ;;
        -*) printf 'error: no option %s\n' "$1" >&2; exit 2 ;;
        *) programs+=("$1") ;;
    esac
    shift
done
mkdir -p "$cache"
cache=$(cd "$cache" && pwd)
export PIP_DISABLE_PIP_VERSION_CHECK=1 UV_SYSTEM_CERTS=1 UV_NATIVE_TLS=1 # two names of one thing, as pip does it
summary=()
status=0

say() { printf '\n== %s\n' "$*"; }

check() { # a name, and a command that succeeds
    local name=$1 start=$SECONDS
    shift
    say "$name: $*"
    if "$@"; then
        summary+=("$(printf '  %-44s passed  %4d s' "$name" $((SECONDS - start)))")
    else
        summary+=("$(printf '  %-44s FAILED  %4d s' "$name" $((SECONDS - start)))")
        status=1
    fi
}

environment() { # a name, and what pip installs; sets $python. What is of this checkout is installed each time
    local venv=$cache/$1 ours=() word
    shift
    python=$venv/bin/python
    if [ ! -e "$venv/complete" ]; then
        say "Environment $venv: $*"
        rm -rf "$venv"
        "${PYTHON:-python3.11}" -m venv "$venv" # the lowest that we run on: old releases have wheels for it
        "$venv/bin/pip" install --quiet "uv>=0.7"
        "$venv/bin/uv" pip install --quiet --python "$python" "$@"
        touch "$venv/complete"
        return
    fi
    for word in "$@"; do
        case "$word" in ./*) ours+=("$word") ;; esac
    done
    [ "${#ours[@]}" -eq 0 ] || "$venv/bin/uv" pip install --quiet --python "$python" --no-deps --reinstall "${ours[@]}"
}

serve() { # starts a server with $python; sets $address
    local log=$cache/server.log
    PYTHONUNBUFFERED=1 "$python" -m bnserve_service serve --port 0 --model default >"$log" 2>&1 &
    server=$!
    trap 'kill "$server" 2>/dev/null || true' EXIT
    for _ in $(seq 240); do
        grep -q '^bnserve is ready' "$log" && break
        kill -0 "$server" 2>/dev/null || { cat "$log" >&2; return 1; }
        sleep 0.5
    done
    address=$(sed -n 's/^bnserve listens on //p' "$log")
}

stop() {
    kill "$server" 2>/dev/null || true
    wait "$server" 2>/dev/null || true
    trap - EXIT
}

page() { # a page, and what its reader has: its blocks in $python's environment; sets $folder, where they ran
    local name=$1
    shift
    folder=$cache/page-$(basename "$name" .md)
    rm -rf "$folder"
    mkdir "$folder"
    [ "$#" -eq 0 ] || cp "$@" "$folder"
    check "$name" "$python" tests/programs/page.py "$name" "$address" "$folder"
}

# bilby's own example, with two lines changed, at its newest release and at the oldest that works.

rooms=(./protocol ./model_store ./surrogate ./inference ./service "./client[bilby]")

bilby_example() { # a version; fetches the source distribution and sets $example
    local folder=$cache/bilby-$1-source
    example=$folder/bilby-$1/examples/gw_examples/injection_examples/binary_neutron_star_example.py
    [ -e "$example" ] && return
    mkdir -p "$folder"
    "$python" -m pip download --quiet --no-deps --no-binary bilby --dest "$folder" "bilby==$1"
    tar xzf "$folder/bilby-$1.tar.gz" -C "$folder"
}

bilby_run() { # a version, and arguments of tests/programs/bilby_example.py
    local version=$1
    shift
    check "bilby $version $*" "$python" -W ignore tests/programs/bilby_example.py "$example" "$address" "$@"
}

bilby() {
    local newest=2.8.2 oldest=2.0.0
    if [ -n "$short" ]; then
        python=${PYTHON:-python}
        serve
        bilby_example "$newest"
        bilby_run "$newest" --iterations 100
        stop
        return
    fi
    environment "bilby-$newest" "bilby==$newest" "${rooms[@]}"
    serve
    bilby_example "$newest"
    for pool in 1 2; do
        bilby_run "$newest" --npool "$pool"
        bilby_run "$newest" --npool "$pool" --whole-prior
    done
    stop
    # What it was made for: it imports what scipy 1.14, numpy 2.3 and dynesty 2.1 do not have. Earlier ones do not sample
    # with a dynesty that runs here.
    environment "bilby-$oldest" "bilby==$oldest" "numpy<2.3" "scipy<1.14" "dynesty<2.1" "${rooms[@]}"
    serve
    bilby_example "$oldest"
    for pool in 1 2; do
        bilby_run "$oldest" --npool "$pool"
    done
    stop
}

# bilby_pipe's own chain, from the configuration of a run with LAL to its result: the source model's name is what changes.

bilby_pipe_run() { # in a folder of its own, because it writes below where it is started
    local configuration=$PWD/tests/programs/bilby_pipe.ini folder=$cache/bilby_pipe-run
    rm -rf "$folder"
    mkdir "$folder"
    (cd "$folder" && PATH=$(dirname "$python"):$PATH BNSERVE_URL=$address command bilby_pipe "$configuration" --outdir out) &&
        "$python" -c 'import bilby, sys; print("ln Z", bilby.result.read_in_result(sys.argv[1]).log_evidence)' \
            "$folder"/out/result/*_result.hdf5
}

bilby_pipe() {
    environment bilby_pipe-1.10.1 bilby==2.8.2 bilby_pipe==1.10.1 "${rooms[@]}"
    serve
    check "bilby_pipe 1.10.1" bilby_pipe_run
    stop
}

# PyCBC's waveforms and pycbc_inference with another name; it leaves out six, and dynesty 3 and emcee 3 are not for it.

pycbc() {
    environment pycbc-2.11.0 pycbc==2.11.0 six "dynesty<3" "pytest>=8.4" ./protocol ./model_store ./surrogate ./inference \
        ./service ./client
    serve
    export BNSERVE_URL=$address
    check "pycbc 2.11.0" "$python" -m pytest -q -rP --noconftest -p no:cacheprovider -o filterwarnings=default \
        tests/programs/pycbc_checks.py
    check "pycbc 2.11.0, times" "$python" -W ignore tests/programs/pycbc_times.py
    unset BNSERVE_URL
    cp tests/programs/pycbc_inference.ini "$cache/inference.ini"
    "$(dirname "$python")/pycbc_create_injections" --config-files tests/programs/pycbc_injection.ini --ninjections 1 \
        --seed 1 --force --output-file "$cache/injection.hdf"
    page docs/guides/pycbc.md "$cache/inference.ini" "$cache/injection.hdf"
    stop
}

# bajes' own MLGW-BNS with bnserve in the place of mlgw_bns, beside mlgw_bns itself in an environment of its own.

bajes() {
    # What it ships was trained and stored with these; the metadata of its wheel ask for what it does not run with.
    environment mlgw_bns-0.12.1 numpy==1.23.5 scikit-learn==1.1.3 scipy==1.10.1 numba==0.57.1 joblib==1.2.0 h5py==3.9 \
        optuna==2.10.1 sqlalchemy==1.4.54 toml dacite PyYAML sortedcontainers tqdm plotly "setuptools<81"
    "$python" -m pip install --quiet --no-deps --ignore-requires-python mlgw-bns==0.12.1
    check "mlgw_bns 0.12.1" "$python" -W ignore tests/programs/mlgw_bns_waveforms.py "$cache/mlgw_bns.npz"
    # It imports matplotlib without saying so, and scipy.misc.derivative, which scipy 1.12 has no more.
    environment bajes-1.3.0 bajes==1.3.0 matplotlib "scipy<1.12" ultranest six ./protocol ./model_store ./surrogate ./inference \
        ./service ./client
    serve
    check "bajes 1.3.0" "$python" tests/programs/bajes_waveform.py "$address" "$cache/mlgw_bns.npz"
    # Its commands start others, so that the name is registered by a file that each of them finds.
    local folder=$cache/inject
    rm -rf "$folder"
    mkdir -p "$folder"
    echo "from bnserve_client.compat.mlgw_bns import *" >"$folder/mlgw_bns.py"
    seq 2048 | sed 's/$/ 4e-24/' >"$folder/asd.txt"
    check "bajes_inject 1.3.0" env PYTHONPATH="$folder" BNSERVE_URL="$address" "$(dirname "$python")/bajes_inject" \
        --ifo H1 --asd "$folder/asd.txt" --wave tests/programs/bajes_injection.ini --srate 2048 --seglen 32 --f-min 30 \
        --f-max 1024 --zero-noise --fd-inject --ra 1.0 --dec 0.3 -o "$folder/out"
    check "its signal" awk '$2 * $2 > 1e-50 { n++ } END { print n " samples"; exit n < 10000 }' "$folder/out/H1_signal.txt"
    cp tests/programs/bajes_sampling.ini "$folder/config.ini"
    # Of bajes' own post-Newtonian approximant, so that what is wrong with ours is seen; it is sampled without spins.
    sed 's/^\(s[12]z\).*/\1 = 0.0/; s/^approx.*/approx = TaylorF2_5.5PN_7.5PNTides/' tests/programs/bajes_injection.ini \
        >"$folder/wave.ini"
    sed -i 's/ 4e-24/ 1.6e-23/' "$folder/asd.txt" # a ratio of 20, which few live points find
    page docs/guides/mlgw_bns.md "$folder/config.ini" "$folder/asd.txt" "$folder/wave.ini"
    check "its posterior" posterior_has_the_signal "$folder/out/run/posterior.dat"
    stop
}

posterior_has_the_signal() { # its chirp mass, the first column, is that of 2.8 solar masses and q = 1.2, and so is ln L
    # A tenth of the prior: few live points and steps move the mean by 1e-4, noise by as much; ln L is 200 +- 20.
    awk 'NR > 1 { n++; s += $1; t += $1 * $1; if ($4 > best) best = $4 }
         END { if (n < 100) exit 1
               mean = s / n; width = sqrt(t / n - mean * mean); print n " samples: " mean " +- " width ", ln L " best
               exit !(width < 4e-4 && (mean - 1.212717) ^ 2 < 4e-4 ^ 2 && best > 140 && best < 280) }' "$1"
}

# GWFish's Fisher matrices, from a checkout of its repository: what the index has by its name is empty.

gwfish() {
    if [ ! -e "${GWFISH:-}/GWFish/modules/waveforms.py" ]; then
        say "gwfish: no checkout of GWFish at '${GWFISH:-}': git clone https://github.com/janosch314/GWFish, and give its"
        echo "   path: GWFISH=path/of/GWFish bash tests/programs.sh gwfish"
        summary+=("  gwfish                                       left out")
        return
    fi
    # Of its pyproject.toml; numpy 2 has no trapz.
    environment gwfish "numpy<2" "pandas>=1.4.1" astropy scipy matplotlib tqdm sympy lalsuite jplephem PyYAML \
        ./protocol ./model_store ./surrogate ./inference ./service ./client
    serve
    check "gwfish" env PYTHONPATH="$GWFISH" "$python" tests/programs/gwfish_fisher.py "$address"
    check "gwfish, forecasts" env PYTHONPATH="$GWFISH" "$python" tests/programs/gwfish_forecasts.py "$address"
    PYTHONPATH=$GWFISH page docs/guides/gwfish.md
    stop
}

# jim's likelihoods, full and by relative binning, with our waveform among ripple's.

jim() {
    environment jim-0.5.2 jimgw==0.5.2 ./protocol ./model_store ./surrogate ./inference ./jax_model
    check "jim 0.5.2" "$python" tests/programs/jim_likelihoods.py
}

# The README's install in an environment that is made for it, its first command, and every example as its first lines say.

examples() {
    local venv=$cache/examples file extra word
    rm -rf "$venv" "$cache/my-models" "$cache/runs"
    "${PYTHON:-python3.11}" -m venv "$venv"
    python=$venv/bin/python
    check "pip install ." "$venv/bin/pip" install --quiet .
    check "bnserve demo" "$venv/bin/bnserve" demo --output "$cache/demo.png"
    serve
    for file in examples/*.py examples/samplers/with_*.py; do
        for word in $(sed -n "s/^ *pip install //p" "$file" | tr -d "'"); do
            "$venv/bin/pip" install --quiet "$word"
        done
        extra=()
        case "$file" in
            examples/own_generator.py)
                check "$file" env PYTHONPATH=examples "$venv/bin/bnserve" train examples/own_generator.toml \
                    --store "$cache/my-models" --work "$cache/runs" --no-progress
                continue
                ;;
            examples/samplers/*) extra=(--short) ;;
        esac
        check "$file" "$python" "$file" "$address" "${extra[@]}"
    done
    check "with_dynesty.py --batches" "$python" examples/samplers/with_dynesty.py "$address" --short --batches
    page docs/guides/samplers.md # it takes minutes
    stop
}

# What `bnserve analyse` leaves, read by PESummary: its file with everything, and its pages.

pesummary_reads() { # a result; PESummary's own file of it
    local folder
    folder=$(dirname "$1")
    "$(dirname "$python")/summarycombine" --webdir "$folder/combined" --samples "$1" --labels ours --gw --nsamples 300 &&
        "$python" tests/programs/pesummary_checks.py "$1" "$folder"/combined/samples/posterior_samples.h5
}

pesummary() {
    environment pesummary-1.8.1 pesummary==1.8.1 "bilby==2.8.2" ./protocol ./model_store ./surrogate ./inference ./posterior ./service
    local folder=$cache/pesummary-run
    check "bnserve analyse" "$(dirname "$python")/bnserve" analyse tests/posterior/small.toml --output "$folder" --force \
        --no-progress
    check "pesummary 1.8.1" pesummary_reads "$folder/pesummary-run_result.json"
}

# UM-Bridge's clients for PyMC and emcee, as the guide has them; those for C++ and R, from a checkout of its repository.

umbridge() {
    environment umbridge-1.2.10 umbridge==1.2.10 pymc emcee ./protocol ./model_store ./surrogate ./inference ./service ./client
    serve
    page docs/guides/umbridge.md
    if [ -e "${UMBRIDGE:-}/lib/umbridge.h" ]; then
        check "umbridge, C++ and R" "$python" tests/programs/umbridge_clients.py "$address" "$UMBRIDGE" "$cache/umbridge-clients"
    else
        say "umbridge, C++ and R: no checkout of UM-Bridge at '${UMBRIDGE:-}': git clone"
        echo "   https://github.com/UM-Bridge/umbridge, and give its path: UMBRIDGE=path/of/umbridge bash tests/programs.sh umbridge"
        summary+=("  umbridge, C++ and R                          left out")
    fi
    stop
}

# Nothing that others brought is replaced: the client, and what builds analyses, beside three programs.

nothing_replaced() { # what is installed into $python's environment
    local plan
    plan=$("$(dirname "$python")/uv" pip install --dry-run --python "$python" "$@" 2>&1) || { echo "$plan"; return 1; }
    echo "$plan"
    ! grep -q '^ - ' <<<"$plan"
}

beside() {
    local client=(./protocol ./client) analyses=(./protocol ./model_store ./surrogate ./inference) name
    environment beside-gwfast "gwfast==1.1.2" "numpy<2" "scipy<1.14" # it imports what later ones do not have
    check "client beside gwfast" nothing_replaced "${client[@]}"
    check "analyses beside gwfast" nothing_replaced "${analyses[@]}"
    for name in bilby pycbc; do
        environment "beside-$name" "$name"
        check "client beside $name" nothing_replaced "${client[@]}"
        check "analyses beside $name" nothing_replaced "${analyses[@]}"
    done
}

[ "${#programs[@]}" -gt 0 ] || { printf 'error: which program? bilby bilby_pipe pycbc bajes gwfish pesummary umbridge jim examples beside\n' >&2; exit 2; }
for program in "${programs[@]}"; do
    case "$program" in
        bilby | bilby_pipe | pycbc | bajes | gwfish | pesummary | umbridge | jim | examples | beside) "$program" ;;
        *) printf 'error: no program %s; there are bilby, bilby_pipe, pycbc, bajes, gwfish, pesummary, umbridge, jim, examples, beside\n' "$program" >&2; exit 2 ;;
    esac
done

say "Summary"
printf '%s\n' "${summary[@]}"
exit "$status"
