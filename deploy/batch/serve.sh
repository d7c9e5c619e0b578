#!/usr/bin/env bash
# A bnserve for other jobs, as a job: it says in a file where it is, and lets in who has the token in another file.
#
#   deploy/batch/serve.sh [OPTION OF bnserve serve ...]
#
# BNSERVE_ADDRESS_FILE  where its address is written once it is ready, and removed at the end  (~/.bnserve/address)
# BNSERVE_TOKEN_FILE    the token, made if it is not there, for its owner's eyes alone          (~/.bnserve/token)
#
# Callers: BNSERVE_URL=$(cat ~/.bnserve/address) BNSERVE_TOKEN_FILE=~/.bnserve/token. With --tls-cert and --tls-key the
# token does not travel in clear. SIGTERM drains: what is under way is answered.
set -euo pipefail
address_file=${BNSERVE_ADDRESS_FILE:-$HOME/.bnserve/address}
token_file=${BNSERVE_TOKEN_FILE:-$HOME/.bnserve/token}
umask 077
mkdir -p "$(dirname "$address_file")" "$(dirname "$token_file")"
[ -s "$token_file" ] || head -c 32 /dev/urandom | base64 | tr '+/' '-_' | tr -d '=\n' >"$token_file"

host=$(hostname -f 2>/dev/null || hostname)
log=$(mktemp "${TMPDIR:-/tmp}/bnserve.XXXXXX")
server=

finish() {
    [ "$(cat "$address_file" 2>/dev/null)" != "${address:-}" ] || rm -f "$address_file" # not that of a later server
    rm -f "$log"
}
trap finish EXIT

bnserve serve --host 0.0.0.0 --port 0 --allowed-host "$host" --token-file "$token_file" "$@" > >(tee "$log") &
server=$!
trap 'kill -TERM "$server" 2>/dev/null || true' TERM INT
until grep -q '^bnserve is ready' "$log"; do
    kill -0 "$server" 2>/dev/null || { wait "$server" && exit 1 || exit; } # it has said why
    sleep 0.1
done

address=$(sed -n "s#^bnserve listens on \(https*\)://.*:\([0-9]*\)\$#\1://$host:\2#p" "$log" | head -n 1)
echo "$address" >"$address_file.new"
mv "$address_file.new" "$address_file" # whole, or not there
echo "callers find $address in $address_file"
status=0
while true; do
    wait "$server" && status=0 || status=$?
    kill -0 "$server" 2>/dev/null || break # a signal ends the waiting, not the server
done
wait "$server" && status=0 || status=$? # both may have ended at the same moment
exit "$status"
