"""What .ci/long/runs and .ci/long/faults share: a folder of their own, the command, programs in place of POV-Ray, and parts to do."""
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

NOTES = ".scenes.shatterpave"


class Wrong(Exception):
    pass


class Bench:
    def __init__(self, options, name):
        self.options = options
        self.scratch = pathlib.Path(tempfile.mkdtemp(prefix=f"{name}-"))
        self.command = str(pathlib.Path(options.build).resolve() / "shatterpave")
        self.random = random.Random(options.seed)
        self.count = 0

    def renderer(self, name, text):
        """A script that stands in for POV-Ray where a run asks for it by that name."""
        folder = self.scratch / name
        folder.mkdir()
        (folder / "povray").write_text(text)
        (folder / "povray").chmod(0o755)

    def folder(self):
        self.count += 1
        return self.scratch / f"out{self.count}"

    def environment(self, renderer="quick", **more):
        environment = dict(os.environ)
        if renderer:
            environment["PATH"] = f"{self.scratch / renderer}:{environment['PATH']}"
        return environment | more

    def start(self, arguments, renderer="quick", prefix=(), **more):
        more.setdefault("env", self.environment(renderer))
        more.setdefault("stdout", subprocess.PIPE)
        more.setdefault("stderr", subprocess.PIPE)
        return subprocess.Popen([*prefix, self.command, *map(str, arguments)], cwd=self.scratch, **more)

    def finish(self, process, limit_s=None):
        """Status, output and messages; a run that hangs is wrong."""
        try:
            out, err = process.communicate(timeout=limit_s)
        except subprocess.TimeoutExpired:
            kill(process)
            raise Wrong(f"hangs for more than {limit_s:.0f} s") from None
        return process.returncode, (out or b"").decode(errors="replace"), (err or b"").decode(errors="replace")

    def run(self, arguments, status=0, **more):
        got, out, err = self.finish(self.start(arguments, **more))
        if got != status:
            raise Wrong(f"{arguments}: expected status {status}, got {got}: {err}")
        return out, err


def kill(process):
    """The program and what it has started, as the loss of a host does; of one that began a session of its own."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()


def do_parts(bench, parts):
    """Each part by its name, with a line of what was counted. The exit status: 1 where anything was wrong."""
    failed = 0
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        for name, part in parts.items():
            begin = time.monotonic()
            try:
                result = part(bench)
            except Wrong as wrong:
                failed += 1
                result = f"WRONG: {wrong}"
            print(f"{name}: {result} ({time.monotonic() - begin:.0f} s)", flush=True)
    finally:
        shutil.rmtree(bench.scratch, ignore_errors=True)
    return 1 if failed else 0
