#!/usr/bin/env bash
# The live view: what it refuses, how it ends, and a session in a headless Chromium (serve_page.js).
#   serve_test.sh BUILD   the build folder, in which playwright-core is installed
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
server=
window=
at_end() { for process in $server $window; do kill -9 "$process" 2>/dev/null || true; done; }
export TMPDIR=$scratch/tmp
mkdir "$TMPDIR"

cat >"$scratch/window.toml" <<'TOML'
# A window that a stone has hit.
seed = 7      # lucky

[[pane]]
name         = "window"
size_mm      = [400, 300]
thickness_mm = 2.0   # of a picture frame

[[pane.impact]]
at_mm        = [168, 165]
radial_count = 60
TOML
cat >"$scratch/plaza.toml" <<'TOML'
[[pavement]]
name = "plaza"
size_mm = [7600, 7600]
stone_mm = [100, 100]
joint_mm = 8
TOML

# start SCENE [OPTION…]: sets `server` and `address`.
start() {
  : >"$scratch/address"
  # A shell lets what it starts in the background ignore SIGINT.
  env --default-signal=INT "$build/shatterpave" serve "$@" >"$scratch/address" 2>"$scratch/messages" &
  server=$!
  for _ in {1..300}; do
    [[ ! -s $scratch/address ]] || break
    kill -0 "$server" 2>/dev/null || fail "the live view has ended: $(<"$scratch/messages")"
    sleep 0.05
  done
  address=$(<"$scratch/address")
  [[ $address =~ ^http://127\.0\.0\.1:[0-9]+/$ ]] || fail "an address expected, got '$address'"
}
# status [OPTION…] PATH: the status that curl is told.
status() { curl -s -o "$scratch/body" -w '%{http_code}' --max-time 5 --path-as-is "${@:1:$#-1}" "${address%/}${*: -1}" || true; }
expect() {
  local found
  found=$(status "${@:2}")
  [[ $found == "$1" ]] || fail "status $1 expected, got $found: ${*:2}"
}

start "$scratch/window.toml" --port 0
port=${address##*:}
port=${port%/}

# Nothing but the page's own files, for this host and its own page alone.
expect 200 /
expect 200 -I /
expect 200 /keys.json
for path in /../etc/passwd /..%2f..%2fetc/passwd //etc/passwd /./window.toml /window.toml /plan/../../x /plan/99.svg /plan/-1.svg \
  /view.js/.. '/%2e%2e/%2e%2e/etc/passwd' /scene.toml/ '/model.glb%00'; do
  expect 404 "$path"
done
expect 403 -H 'Host: evil.example' /
expect 403 -H "Host: evil.example:$port" /state.json
expect 403 -H 'Host: 127.0.0.1' /
expect 200 -H "Host: localhost:$port" /
json=(-H 'Content-Type: application/json')
expect 403 "${json[@]}" -H 'Origin: http://evil.example' -d '{"by": 1}' /seed
expect 403 "${json[@]}" -H 'Sec-Fetch-Site: cross-site' -d '{"by": 1}' /seed
expect 415 -d '{"by": 1}' /seed
expect 405 -X DELETE /
expect 404 "${json[@]}" -d '{}' /nothing
expect 422 "${json[@]}" -d '{"light.environment": "/etc/passwd"}' /set
expect 422 "${json[@]}" -d '{"pane[0].name": "other"}' /set
expect 422 "${json[@]}" -d '{"pane[0].thickness_mm": {"a": 1}}' /set
expect 422 "${json[@]}" -d 'no JSON' /set
head -c 270000 /dev/zero | tr '\0' '[' >"$scratch/large"
expect 413 "${json[@]}" --data-binary "@$scratch/large" /set
head -c 200000 /dev/zero | tr '\0' '[' >"$scratch/deep"
expect 422 "${json[@]}" --data-binary "@$scratch/deep" /set
truncate -s 1G "$scratch/huge"
begin=$(date +%s%N)
expect 413 "${json[@]}" -X POST -T "$scratch/huge" /set
(($(date +%s%N) - begin < 2000000000)) || fail "a POST of 1 GB is not refused at once"
expect 411 "${json[@]}" -H 'Transfer-Encoding: chunked' --data-binary "@$scratch/deep" /set
[[ $(ss -Hltn "sport = :$port" 2>/dev/null | awk '{print $4}') =~ ^(127\.0\.0\.1:$port)?$ ]] || fail "it listens elsewhere"

# A second one at the port is told so, and the first goes on.
refuses . shatterpave serve "$scratch/plaza.toml" --port "$port"
[[ $(wc -l <"$scratch/message") == 1 ]] || fail "one message expected, got: $(<"$scratch/message")"

# Clients that send half a request, more than there are threads: others are answered soon after.
for _ in {1..14}; do (exec 3<>"/dev/tcp/127.0.0.1/$port"; printf 'GET / HTTP/1.1\r\nHost: ' >&3; sleep 8) & done 2>/dev/null
slow=$(jobs -p | grep -v "^$server$" || true)
sleep 0.3
expect 200 /state.json
# The signal is obeyed with such clients, too.
begin=$(date +%s%N)
kill -TERM "$server"
wait "$server" && found=0 || found=$?
spent=$((($(date +%s%N) - begin) / 1000000))
# shellcheck disable=SC2086
kill $slow 2>/dev/null || true
server=
[[ $found == 0 ]] || fail "status 0 expected after SIGTERM, got $found"
# Half a second is promised; other tests run beside this one.
((spent < 2000)) || fail "SIGTERM obeyed after $spent ms"
echo "SIGTERM with slow clients: $spent ms"

# Killed while it renders, it leaves nothing that the next does not clear.
start "$scratch/window.toml" --port 0
for _ in {1..200}; do
  [[ $(status "${json[@]}" -d '{"width": 640, "height": 480}' /render) != 200 ]] || break
  sleep 0.1
done
for _ in {1..100}; do
  compgen -G "$TMPDIR/shatterpave-serve-*/.shatterpave-*" >/dev/null && break
  sleep 0.05
done
compgen -G "$TMPDIR/shatterpave-serve-*/.shatterpave-*" >/dev/null || fail "no draft is begun"
kill -9 "$server"
wait "$server" 2>/dev/null || true
sleep 2.5  # the renderer ends when it next tells of its progress
start "$scratch/window.toml" --port 0
[[ -z $(ls -A "$TMPDIR") ]] || fail "left of a killed run: $(ls -A "$TMPDIR"/*)"
kill -INT "$server"
wait "$server" || fail "status 0 expected after SIGINT"
server=

# A session in a browser.
modules=$(node_tools browser playwright-core@1.65.1)
start "$scratch/window.toml" --port 0
pane=$address
window=$server
start "$scratch/plaza.toml" --port 0
pictures=$build/serve-pictures
mkdir -p "$pictures"
node "$here/serve_page.js" "$modules" "$pane" "$scratch/window.toml" "$address" "$pictures" || fail "$(<"$scratch/messages")"
