#!/usr/bin/env bash
# Run a command beside a bnserve of its own, on this node, for as long as the command runs:
#
#   deploy/batch/with_server.sh python sample.py
#
# The command finds the server in BNSERVE_URL: a Unix socket in a folder that nobody else can enter, so that it needs
# neither a port nor a token. Options of `bnserve serve` are in BNSERVE_OPTIONS: "--workers 4 --store /models". Its exit
# status is that of the command, which gets the signals that this script gets. The log of the server is shown if it fails.
#
# SLURM tells every process of a step, the server as well. That one answers until the command has ended all the same (told
# to stop, it has a day of grace; this script tells it again), for a checkpoint may need it; and the command is not told again.
set -euo pipefail
[ "$#" -gt 0 ] || { echo "usage: with_server.sh COMMAND [ARGUMENT ...]" >&2; exit 2; }

# The path of a Unix socket has at most 107 characters; some schedulers' scratch folders take most of that.
parent=${TMPDIR:-/tmp}
[ "${#parent}" -le 80 ] || parent=/tmp
folder=$(mktemp -d "$parent/bnserve.XXXXXX")
server=
command=

finish() {
    if [ -n "$server" ]; then
        # The second time it waits for nobody; two at once may arrive as one.
        for _ in $(seq 100); do
            kill "$server" 2>/dev/null || break
            sleep 0.1
        done
        kill -KILL "$server" 2>/dev/null || true
        wait "$server" 2>/dev/null || true
    fi
    rm -rf "$folder"
}
trap finish EXIT

# shellcheck disable=SC2086  # several options, divided at blanks
(trap '' USR1 USR2 && exec bnserve serve --uds "$folder/socket" --drain-grace 86400 ${BNSERVE_OPTIONS:-}) >"$folder/log" 2>&1 &
server=$!
until grep -q '^bnserve is ready' "$folder/log"; do
    kill -0 "$server" 2>/dev/null || { echo "with_server.sh: the server did not start:" >&2; cat "$folder/log" >&2; exit 1; }
    sleep 0.1
done

export BNSERVE_URL="unix:$folder/socket"
"$@" &
command=$!
for signal in TERM INT HUP USR1 USR2; do
    # shellcheck disable=SC2064  # this command, now
    if [ -n "${SLURM_STEP_ID:-}" ]; then trap : "$signal"; else trap "kill -$signal $command 2>/dev/null || true" "$signal"; fi
done
status=0
while true; do
    wait "$command" && status=0 || status=$?
    kill -0 "$command" 2>/dev/null || break # a signal ends the waiting, not the command
done
wait "$command" && status=0 || status=$? # both may have ended at the same moment
kill -0 "$server" 2>/dev/null || { echo "with_server.sh: the server ended before the command:" >&2; cat "$folder/log" >&2; }
exit "$status"
