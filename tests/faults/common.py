# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of faults share: running the program, looking at folders, small file systems.

The program is the one that C1MESH_PROGRAM names."""
import hashlib
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM = os.environ["C1MESH_PROGRAM"]
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples")
EXAMPLES = os.path.normpath(EXAMPLES)
FORMATS = "json,svg,vtu,msh,mesh,obj"
SKIPPED = 77  # what CTest shows as skipped


class Ran:
    """How a run ended: `status` is minus the signal if one ended it."""

    def __init__(self, status, out, err):
        self.status, self.out, self.err = status, out, err

    def __repr__(self):
        return f"status {self.status}, said {self.err[-500:]!r}"


def run(*arguments, cwd=None, stdout=subprocess.PIPE, before=None, prefix=(), env=None, stdin=None,
        timeout=120):
    """Runs `PREFIX… c1mesh ARGUMENTS…`; `before` runs in the child before the program."""
    done = subprocess.run([*prefix, PROGRAM, *map(str, arguments)], cwd=cwd, stdout=stdout,
                          stderr=subprocess.PIPE, stdin=stdin or subprocess.DEVNULL,
                          preexec_fn=before, env=env, timeout=timeout, check=False)
    return Ran(done.returncode, done.stdout, done.stderr.decode(errors="replace"))


def start(*arguments, cwd=None):
    return subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=cwd, stdin=subprocess.DEVNULL,
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def wait_for_handlers(process):
    """Until the program catches SIGTERM: what comes earlier ends it before it has begun."""
    while process.poll() is None:
        with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
            caught = [line for line in status if line.startswith("SigCgt")]
        if caught and int(caught[0].split()[1], 16) >> (signal.SIGTERM - 1) & 1:
            return
        time.sleep(0.001)


def end_of(process):
    """(status, standard error) of a process that was started; it must end by itself."""
    try:
        _, err = process.communicate(timeout=120)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        raise
    return process.returncode, err.decode(errors="replace")


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write(path, content):
    with open(path, "wb") as file:
        file.write(content)


def contents(folder):
    """{relative path: bytes} of every file, hidden ones too."""
    found = {}
    for base, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(base, name)
            found[os.path.relpath(path, folder)] = read(path)
    return found


def hidden(folder):
    return sorted(name for name in contents(folder) if os.path.basename(name).startswith("."))


def digest(files):
    """Short, for messages: {name: bytes} as {name: hash}."""
    return {name: hashlib.sha256(text).hexdigest()[:8] for name, text in files.items()}


def polygons(count):
    """An SVG drawing of so many triangles: each takes milliseconds."""
    paths = "".join(f'<path id="t{k}" d="M{5 * k} 0h4v3z"/>' for k in range(count))
    return f'<svg xmlns="http://www.w3.org/2000/svg">{paths}</svg>'.encode()


class FaultTest(unittest.TestCase):
    """A test with a folder of its own, `self.folder`, and results to work on."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="c1mesh_faults_")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        os.chmod(self.folder, 0o755)

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def example(self, name):
        return os.path.join(EXAMPLES, name)

    def make_result(self, *extra):
        """blob.c1.json in the folder `good`."""
        done = run("run", self.example("blob.svg"), "-o", self.path("good"), "--formats", "json",
                   *extra)
        self.assertEqual(done.status, 0, done)
        return self.path("good", "blob.c1.json")

    def assert_fails(self, done, status, *words):
        self.assertEqual(done.status, status, done)
        for word in words:
            self.assertIn(word, done.err)


def mount(folder, options):
    subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder], check=True,
                   stderr=subprocess.DEVNULL)


def can_mount():
    folder = tempfile.mkdtemp()
    try:
        mount(folder, "size=64k")
        subprocess.run(["umount", folder], check=True)
        return True
    except (OSError, subprocess.CalledProcessError):
        return False
    finally:
        os.rmdir(folder)


def with_mounts():
    """Sees to it that this process may mount: else it starts anew in a name space where it may, or
    ends as skipped."""
    if can_mount():
        return
    inner = ["unshare", "-rm", sys.executable, "-B", *sys.argv]
    if "C1MESH_UNSHARED" not in os.environ and shutil.which("unshare"):
        trial = subprocess.run(["unshare", "-rm", "true"], stderr=subprocess.DEVNULL, check=False)
        if trial.returncode == 0:
            os.environ["C1MESH_UNSHARED"] = "1"
            os.execvp(inner[0], inner)
    print("skipped: this process may not mount a file system, and unshare -rm does not help")
    sys.exit(SKIPPED)


class SmallDisk:
    """A file system of so many kB at `folder`, for a with statement."""

    def __init__(self, folder, kilobytes):
        self.folder, self.options = folder, f"size={kilobytes}k,mode=755"
        os.makedirs(folder, exist_ok=True)

    def __enter__(self):
        mount(self.folder, self.options)
        return self

    def __exit__(self, *_):
        subprocess.run(["umount", self.folder], check=True)

    def make_read_only(self):
        subprocess.run(["mount", "-o", "remount,ro", self.folder], check=True)

    def leave(self, kilobytes):
        """Fills it up until only so many kB are free."""
        state = os.statvfs(self.folder)
        free = state.f_bavail * state.f_frsize - 1024 * kilobytes
        write(os.path.join(self.folder, "ballast"), b"x" * max(0, free))


def limited(kind, amount):
    """For `before`: a resource limit of the program."""
    return lambda: resource.setrlimit(kind, (amount, amount))


__all__ = [name for name in dir() if not name.startswith("_")]
