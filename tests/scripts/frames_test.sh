#!/usr/bin/env bash
# Frames of a shot: named, skipped where they are there, made again where they are not whole; runs that meet in one folder, are
# killed, or fail; exports of frames; job files.
#   frames_test.sh BUILD
# shellcheck source=tests/scripts/test_kit.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/test_kit.sh"
cd "$scratch"

render() { shatterpave render shot.toml --size 48x32 --threads 1 "$@"; }
# The pictures of a folder, each with its sum.
pictures() { (cd "$1" && sha256sum ./*.exr ./*.png); }
# All that is in a folder but frames.
others() { find "$1" -mindepth 1 ! -name 'shot.[0-9]*.exr' ! -name 'shot.[0-9]*.png' ! -name 'shot.[0-9]*.frame.json'; }
no_others() { [[ -z $(others "$1") ]] || fail "$2: left over: $(others "$1")"; }

cat >shot.toml <<'END'
seed = 3
[[pane]]
name = "window"
size_mm = [300, 200]
[[pane.impact]]
at_mm = [140, 90]
radial_count = 7
[camera]
at_mm = [150, -600, 120]
look_at_mm = [150, 0, 100]
[still]
setting = "own"
[frames]
range = "1-4"
[[frames.key]]
set = "camera.at_mm"
at = [[1, [150, -600, 120]], [4, [250, -500, 160]]]
END

# Names, lines on stdout and stderr, sidecars.
render -o out --frames 1-9 >stdout 2>stderr || fail "render: $(<stderr)"
for n in 1 2 3 4; do for e in exr png frame.json; do echo "out/shot.000$n.$e"; done; done | diff - stdout || fail "stdout"
grep -q '^shatterpave: --frames: left out what is not of the scene.s range 1-4: 5-9$' stderr || fail "not told of frames 5-9: $(<stderr)"
[[ $(grep -c '^frame [1-4]: .* s, .* MiB ([1-4] of 4)$' stderr) == 4 ]] || fail "a line a frame: $(<stderr)"
no_others out "a whole shot"
pictures out >first
python3 - out <<'END'
import hashlib, json, pathlib, sys
origins = set()
for n in range(1, 5):
    side = json.loads(pathlib.Path(sys.argv[1], f"shot.{n:04}.frame.json").read_text())
    assert side["format"] == "shatterpave-frame" and side["frame"] == n and side["seed"] == 3, side
    assert side["size_px"] == [48, 32] and side["quality"] == "draft", side
    assert [f["name"] for f in side["files"]] == [f"shot.{n:04}.exr", f"shot.{n:04}.png"], side
    for f in side["files"]:
        content = pathlib.Path(sys.argv[1], f["name"]).read_bytes()
        assert len(content) == f["bytes"] and hashlib.sha256(content).hexdigest() == f["sha256"], f
    assert side["cost"]["seconds"] > 0 and side["cost"]["most_memory_kib"] > 1000, side
    origins.add(side["fingerprint"])
assert len(origins) == 4, origins
END

# What is there is skipped; what is not whole, or of other settings, is not.
again() { render -o out --frames 1-4 --skip-existing "${@:2}" 2>&1 >/dev/null | sed -n 's/^frame \([0-9]*\): [0-9].*/\1/p' | tr '\n' ' ' >made
  [[ $(<made) == "$1" ]] || fail "${*:2}: made '$(<made)' in place of '$1'"; }
again ""
printf '\xAA' | dd of=out/shot.0002.exr bs=1 seek=700 conv=notrunc status=none
truncate -s -1 out/shot.0003.png
again "2 3 "
pictures out | diff first - || fail "frames that are made again are others"
rm out/shot.0001.png
echo '{' >out/shot.0004.frame.json
again "1 4 "
pictures out | diff first - || fail "frames that are made again are others"
again "1 2 3 4 " --quality final
again "1 2 3 4 " --quality draft
again "1 2 3 4 " --set light.exposure_ev=1
again "1 2 3 4 "
# Who changes the end of a shot, or makes it longer, has its beginning.
sed -i 's/\[4, \[250, -500, 160\]\]/[3, [216, -533, 146]], [4, [250, -500, 190]]/' shot.toml
render -o out --frames 1-4 2>/dev/null >/dev/null
sed -i 's/-500, 190/-500, 200/; s/range = "1-4"/range = "1-6"/' shot.toml
again "4 "
compgen -G "out/.shatterpave-frames-*/shared-*" >/dev/null || fail "what is shared goes before the shot is complete"
sed -i 's/range = "1-6"/range = "1-4"/' shot.toml
again ""
no_others out "a whole shot again"
pictures out >first

# What does not change is written once, also for another process.
rm -rf out
render -o out --frames 1-2 >/dev/null 2>&1
shared=$(echo out/.shatterpave-frames-*/shared-*)
[[ -f $shared/window.inc && ! -f $shared/shot.pov ]] || fail "shared: $(find out)"
stat -c %i%Y "$shared/window.inc" >before
(cd "$shared" && sha256sum --quiet -c SHA256SUMS) || fail "sums of what is shared"
render -o out --frames 3 >/dev/null 2>&1
stat -c %i%Y "$shared/window.inc" | diff before - || fail "shared files were made again"
printf 'x' >>"$shared/window.inc"
render -o out --frames 4 >/dev/null 2>&1 || fail "shared files that were changed are taken"
no_others out "two runs"
pictures out | diff first - || fail "frames by several processes are others"

# Two processes over one range, at once.
rm -rf out
render -o out --frames 1-4 --skip-existing >/dev/null 2>&1 &
render -o out --frames 1-4 >/dev/null 2>&1 || fail "two processes at once"
wait $! || fail "two processes at once"
no_others out "two processes"
pictures out | diff first - || fail "frames by two processes are others"

# Other settings are refused while a run lives, whichever is quicker.
rm -rf out
render -o out --frames 1-4 >/dev/null 2>one & one=$!
render -o out --frames 1-4 --seed 4 >/dev/null 2>two & two=$!
status=0; wait $one || status=$?
other=0; wait $two || other=$?
case $status$other in
  20) grep -q 'expected no other run that writes frames' one || fail "$(<one)" ;;
  02) grep -q 'expected no other run that writes frames' two || fail "$(<two)" ;;
  00) ;;  # one after the other
  *) fail "two runs of other seeds: $status $other: $(cat one two)" ;;
esac
[[ $(grep -h '"seed"' out/*.json | sort -u | wc -l) == 1 ]] || fail "frames of two seeds"
no_others out "runs of two seeds"

# Killed at any moment, and resumed.
rm -rf out
for delay in 0.05 0.2 0.35 0.5; do
  setsid "$build/shatterpave" render shot.toml --size 48x32 --threads 1 -o out --frames 1-4 --skip-existing >/dev/null 2>&1 & run=$!
  sleep "$delay"
  kill -9 -- "-$run" 2>/dev/null || true
  wait "$run" 2>/dev/null || true
done
render -o out --frames 1-4 --skip-existing >/dev/null 2>&1 || fail "after kills"
no_others out "kills"
pictures out | diff first - || fail "frames after kills are others"

# A renderer that fails leaves what was there; progress as a worker reads it.
mkdir bin
printf '#!/bin/sh\nexit 9\n' >bin/povray
chmod +x bin/povray
PATH=$scratch/bin:$PATH ends 3 render -o out --frames 1-2 --progress openjd
[[ ! -s said ]] || fail "a failure writes: $(<said)"
grep -q '^openjd_fail: POV-Ray failed' message || fail "openjd_fail: $(<message)"
PATH=$scratch/bin:$PATH render -o new --frames 1-2 >/dev/null 2>&1 && fail "no failure"
[[ ! -e new ]] || fail "a failure leaves: $(find new)"
no_others out "a failure"
pictures out | diff first - || fail "a failure changes frames"
render -o out --frames 2,4 --progress openjd 2>stderr >/dev/null
grep -q '^openjd_progress: 100.0$' stderr || fail "openjd: $(<stderr)"
grep -Ev '^openjd_(progress: [0-9.]+|status: frame [24]: .*)$' stderr && fail "other lines"
render -o out --frames 2 --progress none 2>stderr >/dev/null
[[ ! -s stderr ]] || fail "--progress none: $(<stderr)"

# Refused in words.
refused() { refuses "$1" shatterpave "${@:2}"; }
refused "--frames: expected frames of the scene's range 1-4, got 7-9" render shot.toml -o out --frames 7-9
refused "with a negative frame" render shot.toml -o out --frames=-3
refused "--skip-existing: expected --frames beside it" render shot.toml -o out --skip-existing
sed '/^\[frames\]/,$d' shot.toml >still.toml
refused "expected a scene with a table \[frames\]" render still.toml -o out --frames 1
sed 's/-500, 200/0, 100/' shot.toml >glass.toml
refused "frame 4: camera.at_mm: expected a camera outside the glass" check glass.toml
shatterpave check shot.toml >/dev/null || fail "check"
cp still.toml shot.0002.toml
shatterpave render shot.0002.toml --size 16x16 -o named >/dev/null 2>&1
refused "expected no file of that name or a frame of the scene 'shot'" render shot.toml --size 16x16 -o named --frames 2

# Exports of frames: what does not change is there once.
shatterpave export shot.toml -o exported --frames 1,3 --target povray --target json --target gltf >stdout 2>/dev/null
diff - <(LC_ALL=C sort stdout) <<'END' || fail "export"
exported/shatterpave_glass.inc
exported/shot.0001.glb
exported/shot.0001.json
exported/shot.0001.pov
exported/shot.0003.glb
exported/shot.0003.json
exported/shot.0003.pov
exported/shot_sky.exr
exported/window.inc
END
printf '[[frames.key]]\nset = "pane.window.thickness_mm"\nat = [[1, 2], [4, 5]]\n' | cat shot.toml - >thick.toml
shatterpave export thick.toml -o exported2 --frames 1,3 --target povray >/dev/null 2>&1
grep -q '#include "window.0003.inc"' exported2/thick.0003.pov || fail "includes of a pane that changes"
[[ -f exported2/window.0001.inc && ! -e exported2/window.inc ]] || fail "$(find exported2)"
(cd exported2 && povray +Ithick.0003.pov +W8 +H6 -D -F Declare=Quality=0 >../log 2>&1) || fail "POV-Ray: $(<log)"

# Job files: nothing of this machine, and as the shell reads them.
for system in slurm openjd parallel; do
  shatterpave farm shot.toml -o farm --system "$system" --size 48x32 --threads 1 --chunk 2 --set pane.window.glass=annealed \
    >stdout 2>stderr || fail "farm: $(<stderr)"
  grep -q '^shatterpave: farm: measured frame 3 as a draft of 48x32' stderr || fail "$(<stderr)"
done
find farm -mindepth 1 | sort | diff - <(printf 'farm/%s\n' .scenes.shatterpave shot.openjd.yaml shot.parallel.sh shot.slurm.sh) ||
  fail "farm"
grep -rnE "$scratch|$(hostname)" farm && fail "a path or a host in a job file"
for script in farm/shot.slurm.sh farm/shot.parallel.sh; do bash -n "$script"; done
grep -q '^chunks=(1-2 3-4)$' farm/shot.slurm.sh || fail "chunks"
for task in 0 1; do SLURM_ARRAY_TASK_ID=$task SHATTERPAVE=$build/shatterpave bash farm/shot.slurm.sh >>tasks 2>/dev/null; done
[[ $(grep -c '^farm/shot.000[1-4].exr$' tasks) == 4 ]] || fail "tasks of the array: $(<tasks)"
