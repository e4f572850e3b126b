"""The kinds of work that .ci/long/faults lets fail, and what must hold after each."""
import shutil

from bench import NOTES, Wrong

SCENE = """
seed = 3
[[pane]]
name = "window"
size_mm = [200, 150]
[[pane.impact]]
at_mm = [90, 70]
radial_count = 9
[pane.shards]
[[pavement]]
name = "court"
bond = "running"
size_mm = [600, 400]
stone_mm = [200, 100]
relief = {rms_mm = 0}
[pavement.textures]
size_px = 256
[frames]
range = "1-2"
[[frames.key]]
set = "camera.at_mm"
at = [[1, [150, -600, 120]], [2, [160, -600, 120]]]
[camera]
at_mm = [150, -600, 120]
look_at_mm = [150, 0, 100]
"""

# In place of POV-Ray: a picture that follows from what it is given.
RENDERER = """#!/bin/sh
library=.
for argument; do case $argument in +O*) picture=${argument#+O};; +L*) library=${argument#+L};; esac; done
sum=$(cat *.pov "$library"/window*.inc | cksum | cut -d' ' -f1)
printf 'P3 2 1 255 %d %d %d 0 0 0\\n' $((sum % 256)) $((sum / 256 % 256)) $((sum / 65536 % 256)) >"$picture"
"""

# The work of a run.
WORK = {
    "json svg csv": ["export", "s.toml", "--target", "json", "--target", "svg", "--target", "csv"],
    "povray": ["export", "s.toml"],
    "gltf": ["export", "s.toml", "--target", "gltf"],
    "usd": ["export", "s.toml", "--target", "usd"],
    "mitsuba": ["export", "s.toml", "--target", "mitsuba"],
    "obj ply": ["export", "s.toml", "--target", "obj", "--target", "ply"],
    "textures": ["export", "s.toml", "--target", "textures"],
    "render": ["render", "s.toml", "--size", "2x1"],
    "frames": ["render", "s.toml", "--size", "2x1", "--frames", "1-2", "--progress", "none"],
    "measure": ["measure", "s.toml", "--seeds", "2"],
    "trace": ["trace", "photograph.pgm", "--mm-per-px", "0.6"],
    "farm": ["farm", "s.toml", "--system", "parallel", "--frames", "1-2"],
}


def content(folder):
    """All files below the folder by name. Of those that tell measured times, that they are there."""
    if not folder.exists():
        return {}
    files = {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}
    measured = [name for name in files if name.endswith((".frame.json", ".parallel.sh"))]
    if "s.parallel.sh" in measured:
        measured.append(NOTES)  # which holds its sum
    return files | {name: b"measured" for name in measured if name in files}


def litter(files):
    return [name for name in files if name.split("/")[0].startswith(".shatterpave-")]


def is_told(message):
    """One message, which says what went wrong, after what farm has to say; with a renderer's own words where that failed."""
    if message.startswith("POV-Ray failed with status "):
        return True
    lines = [line for line in message.splitlines(keepends=True) if not line.startswith("shatterpave: farm: ")]
    return len(lines) == 1 and lines[0].endswith("\n") and len(lines[0]) > 20


class Case:
    """One kind of work with what its folder holds before, after, and after another seed."""

    def __init__(self, bench, name):
        self.bench, self.name, self.arguments = bench, name, WORK[name]
        self.seeded = name not in ("trace", "farm")
        self.after = self.reference(1)
        self.before = self.reference(2) if self.seeded else {}
        if self.seeded and self.after == self.before:
            raise Wrong(f"{name}: two seeds give the same files: this would see no mixture")

    def words(self, folder, seed=1):
        return [*self.arguments, *(["--seed", seed] if self.seeded else []), "-o", folder]

    def reference(self, seed):
        folder = self.bench.folder()
        self.bench.run(self.words(folder, seed))
        files = content(folder)
        shutil.rmtree(folder)
        return files

    def prepare(self, folder, is_empty):
        """A folder with a file of the user's and, unless it shall be empty, an earlier state of the scene."""
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        if not is_empty and self.seeded:
            self.bench.run(self.words(folder, 2))
        (folder / "mine").write_text("mine")
        return content(folder)

    def judge(self, folder, before, status, message, may_be_half=False):
        files = content(folder)
        left = litter(files)
        files = {name: data for name, data in files.items() if name not in left}
        whole = dict(self.after, mine=b"mine")
        if status == 0:
            if files != whole:
                raise Wrong(f"status 0, and {differences(files, whole)}")
            return "held"
        if status not in (1, 2, 3):
            raise Wrong(f"status {status}: {message}")
        if not is_told(message):
            raise Wrong(f"a message that does not tell: {message!r}")
        if self.name == "frames":
            files = self.without_done_frames(files, before)
        if without_notes(files) != without_notes(before) and not may_be_half:
            raise Wrong(f"status {status} ({message.strip()}), and {differences(files, before)}")
        return "told"

    def without_done_frames(self, files, before):
        """Frames that are done stay where a later one fails; a frame's files are all there, or none is."""
        files = dict(files)
        for frame in ("0001", "0002"):
            names = [name for name in self.after if f".{frame}." in name]
            if all(files.get(name) == self.after[name] for name in names):
                for name in names:
                    files.pop(name)
                    if name in before:
                        files[name] = before[name]
        return files | {NOTES: before[NOTES]} if NOTES in before else files

    def judge_next(self, folder):
        """The next run puts everything right."""
        self.bench.run(self.words(folder))
        files = content(folder)
        if files != dict(self.after, mine=b"mine"):
            raise Wrong(f"after the next run {differences(files, dict(self.after, mine=b'mine'))}")


def without_notes(files):
    """The file of notes may be there, empty, where there was none."""
    return {name: data for name, data in files.items() if name != NOTES or data}


def differences(files, expected):
    names = sorted(name for name in {*files, *expected} if files.get(name) != expected.get(name))
    return ", ".join(f"{name} is {'missing' if name not in files else 'there' if name not in expected else 'another'}" for name in names[:8])
