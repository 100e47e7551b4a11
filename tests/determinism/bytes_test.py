# SPDX-License-Identifier: GPL-3.0-or-later
"""The same input and options give the same bytes, in every file, whatever else differs."""
import os
import pty
import select
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "faults"))
from common import *  # noqa: E402,F403

INPUTS = ["blob.svg", "puzzle.svg", "annulus.svg", "interfaces.json"]


class Determinism(FaultTest):
    """Everything is compared with one run that `reference` keeps."""

    @classmethod
    def setUpClass(cls):
        cls.home = tempfile.mkdtemp(prefix="c1mesh_determinism_")
        cls.inputs = os.path.join(cls.home, "in")
        os.mkdir(cls.inputs)
        for name in INPUTS:
            shutil.copy(os.path.join(EXAMPLES, name), cls.inputs)
        done = run(*cls.arguments(os.path.join(cls.home, "whole")))
        assert done.status in (0, 4), done
        cls.status = done.status
        cls.reference = contents(os.path.join(cls.home, "whole"))
        assert len(cls.reference) > 9 * len(INPUTS)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.home, ignore_errors=True)

    @classmethod
    def arguments(cls, out, *more, folder=None, command="run"):
        files = [os.path.join(folder or cls.inputs, name) for name in INPUTS]
        return [command, *files, "-o", out, "--formats", FORMATS, "--trace",
                os.path.join(out, "trace.jsonl"), *more]

    def same(self, out, done=None):
        if done is not None:
            self.assertEqual(done.status, self.status, done)
        self.assertEqual(digest(contents(out)), digest(self.reference))

    def test_repeated(self):
        for k in range(2):
            out = self.path(f"out{k}")
            self.same(out, run(*self.arguments(out)))
        self.same(out, run(*self.arguments(out)))  # over itself

    def test_threads(self):
        for threads in (1, 2, 8):
            out = self.path(f"out{threads}")
            self.same(out, run(*self.arguments(out, "--threads", threads)))

    def test_folders(self):
        done = run(*self.arguments("relative", folder=os.path.relpath(self.inputs, self.folder)),
                   cwd=self.folder)
        self.same(self.path("relative"), done)
        os.mkdir(self.path("below"))
        shutil.copytree(self.inputs, self.path("copy"))
        self.same(self.path("up"), run(*self.arguments("../up", folder="../copy"),
                                       cwd=self.path("below")))
        os.symlink(self.inputs, self.path("link"))
        self.same(self.path("linked"),
                  run(*self.arguments(self.path("linked"), folder=self.path("link")), cwd="/"))

    def test_environment(self):
        known = subprocess.run(["locale", "-a"], capture_output=True, text=True,
                               check=False).stdout.split()
        locales = ["C", "POSIX"] + [name for name in known
                                    if name.startswith(("C.", "de_DE", "fr_FR", "tr_TR"))]
        plain = {"PATH": os.environ["PATH"]}
        for k, more in enumerate(
                [{}, {"HOME": "/nonexistent", "TMPDIR": "/nonexistent", "COLUMNS": "20",
                      "NO_COLOR": "1", "TERM": "dumb", "TZ": "Asia/Tokyo",
                      "OMP_NUM_THREADS": "3", "MALLOC_PERTURB_": "85"}]
                + [{"LC_ALL": name, "LANG": name} for name in locales]):
            out = self.path(f"out{k}")
            with self.subTest(environment=more):
                self.same(out, run(*self.arguments(out), env=dict(plain, **more)))

    # What malloc gives out is filled with other bytes: what is read before it is set would differ.
    def test_memory_that_is_not_clean(self):
        for byte in ("1", "127", "255"):
            out = self.path("out" + byte)
            env = dict(os.environ, MALLOC_PERTURB_=byte)
            self.same(out, run(*self.arguments(out, "--threads", "1"), env=env))

    def test_without_random_addresses(self):
        if not shutil.which("setarch"):
            self.skipTest("no setarch")
        if subprocess.run(["setarch", "-R", "true"], capture_output=True, check=False).returncode:
            self.skipTest("setarch -R is not allowed here")
        out = self.path("out")
        self.same(out, run(*self.arguments(out), prefix=["setarch", "-R"]))

    def test_a_terminal(self):
        out = self.path("out")
        master, slave = pty.openpty()
        process = subprocess.Popen([PROGRAM, *map(str, self.arguments(out))], stdin=slave,
                                   stdout=slave, stderr=slave,
                                   env=dict(os.environ, TERM="xterm-256color"))
        os.close(slave)
        said = b""
        while True:
            ready = select.select([master], [], [], 0.05)[0]
            try:
                block = os.read(master, 4096) if ready else b""
            except OSError:
                break
            if not block and process.poll() is not None:
                break
            said += block
        os.close(master)
        self.assertEqual(process.wait(), self.status)
        self.assertIn(b"\033[", said)  # it did take it for a terminal
        self.same(out)

    def test_verbosity(self):
        for option in ("--quiet", "--verbose"):
            out = self.path(option)
            self.same(out, run(option, *self.arguments(out)))

    # Whether a shape is done alone, after others, or by a batch.
    def test_company(self):
        for name in INPUTS:
            out = self.path(name + ".out")
            self.assertIn(run("run", os.path.join(self.inputs, name), "-o", out, "--formats",
                              FORMATS).status, (0, 4))
            alone = contents(out)
            expected = {file: text for file, text in self.reference.items() if file in alone}
            self.assertEqual(digest(alone), digest(expected))
        for jobs in (1, 2):
            out = self.path(f"batch{jobs}")
            done = run("batch", self.inputs, "-o", out, "-j", jobs, "--formats", FORMATS)
            self.assertEqual(done.status, self.status, done)
            found = contents(out)
            for name, text in self.reference.items():
                if name != "trace.jsonl":
                    self.assertEqual(digest({name: found[name]}), digest({name: text}))
        self.assertEqual(read(self.path("batch1", "index.jsonl")),
                         read(self.path("batch2", "index.jsonl")))

    # From results: pictures, other formats, projections, tables.
    def test_other_commands(self):
        whole = os.path.join(self.home, "whole")
        result = os.path.join(whole, "puzzle.c1.json")
        outs = []
        for k, env in enumerate((dict(os.environ), {"LC_ALL": "C", "MALLOC_PERTURB_": "200"})):
            out = self.path(f"out{k}")
            os.mkdir(out)
            commands = [["convert", result, "-o", f"{out}/a.{extension}"]
                        for extension in FORMATS.split(",")]
            commands += [["draw", result, "-o", f"{out}/b.svg", "--colour", "distortion"],
                         ["draw", os.path.join(whole, "trace.jsonl"), "-o", f"{out}/t.svg"],
                         ["project", result, "-o", out, "--conformance-bound", "1"],
                         ["evaluate", whole, "-o", f"{out}/e", "--threads", 1 + 3 * k],
                         ["generate", "--set", "C", "--count", "3", "-o", f"{out}/g",
                          "--formats", "json,svg"]]
            for command in commands:
                done = run(*command, env=env)
                self.assertEqual(done.status, 0, (command, done))
            outs.append(contents(out))
        self.assertEqual(digest(outs[0]), digest(outs[1]))


if __name__ == "__main__":
    unittest.main(verbosity=2)
