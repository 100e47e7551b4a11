# SPDX-License-Identifier: GPL-3.0-or-later
"""Signals at random moments: every file is the old one or the whole new one, nothing else is left,
and the status is that of an end by a signal."""
from common import *  # noqa: F403

ASKING = [signal.SIGTERM, signal.SIGINT, signal.SIGHUP]
SHARED = random.Random(20240229)


class Killed:
    """A command that writes a folder, what it writes, and how long it takes."""

    def __init__(self, test, name, arguments, good=(0,)):
        self.test, self.name, self.good = test, name, good
        self.arguments = arguments
        whole = test.path(f"{name}.whole")
        begin = time.monotonic()
        done = run(*arguments(whole))
        self.seconds = time.monotonic() - begin
        test.assertIn(done.status, good, done)
        self.new = contents(whole)

    def once(self, kind, handlers):
        """One run that `kind` ends, over old files: (status, the folder)."""
        folder = tempfile.mkdtemp(dir=self.test.folder)
        for name in self.new:
            os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
            write(os.path.join(folder, name), b"old " + name.encode())
        process = start(*self.arguments(folder))
        if handlers:
            wait_for_handlers(process)
        time.sleep(SHARED.uniform(0, 1.1 * self.seconds))
        process.send_signal(kind)
        status, _ = end_of(process)
        return status, folder

    def check_files(self, folder, killed):
        """Old or new, and nothing else, but hidden ones after SIGKILL."""
        new = 0
        for name, text in contents(folder).items():
            if killed and os.path.basename(name).startswith("."):
                continue
            self.test.assertIn(name, self.new)
            if text != b"old " + name.encode():
                self.test.assertEqual(text, self.new[name], f"{name} is not whole")
                new += 1
        self.test.assertGreaterEqual(len(contents(folder)), len(self.new))
        return new


class Signals(FaultTest):
    def commands(self):
        result = self.make_result()
        write(self.path("many.svg"), polygons(25))
        yield Killed(self, "run", lambda out: [
            "run", self.example("blob.svg"), "-o", out, "--formats", FORMATS])
        yield Killed(self, "many", lambda out: ["run", self.path("many.svg"), "-o", out])
        yield Killed(self, "paper", lambda out: [
            "run", "--method", "paper", self.example("blob.svg"), "-o", out], (0, 4))
        yield Killed(self, "generate", lambda out: [
            "generate", "--set", "A", "--count", "40", "--formats", "json,svg", "-o", out])
        yield Killed(self, "evaluate", lambda out: ["evaluate", self.path("good"), "-o", out])
        yield Killed(self, "draw", lambda out: [
            "draw", result, "--width", "500", "-o", self.named(out, "a.svg")])
        yield Killed(self, "convert", lambda out: [
            "convert", result, "-o", self.named(out, "a.vtu")])
        yield Killed(self, "project", lambda out: [
            "project", result, "-o", out, "--conformance-bound", "1"])

    @staticmethod
    def named(folder, name):
        os.makedirs(folder, exist_ok=True)
        return os.path.join(folder, name)

    def test_asked_to_end(self):
        ends = {}
        for command in self.commands():
            for k in range(9):
                kind = ASKING[k % 3]
                with self.subTest(command=command.name, signal=kind.name, number=k):
                    status, folder = command.once(kind, True)
                    self.assertIn(status, (5, *command.good))
                    new = command.check_files(folder, False)
                    if status in command.good:
                        self.assertEqual(new, len(command.new))
                    ends[status] = ends.get(status, 0) + 1
                    shutil.rmtree(folder)
        self.assertGreater(ends.get(5, 0), 10, ends)

    # Then the next run: what was left is in nobody's way.
    def test_killed(self):
        ended = 0
        for command in self.commands():
            for k in range(9):
                with self.subTest(command=command.name, number=k):
                    status, folder = command.once(signal.SIGKILL, False)
                    self.assertIn(status, (-signal.SIGKILL, *command.good))
                    command.check_files(folder, True)
                    ended += status == -signal.SIGKILL
                    if k == 8:
                        self.assertIn(run(*command.arguments(folder)).status, command.good)
                        left = contents(folder)
                        self.assertEqual(digest({name: left[name] for name in command.new}),
                                         digest(command.new))
                    shutil.rmtree(folder)
        self.assertGreater(ended, 20)

    # The first asks, the second kills: nothing is left even then.
    def test_a_second_signal_kills_without_leftovers(self):
        write(self.path("many.svg"), polygons(25))
        command = Killed(self, "many", lambda out: ["run", self.path("many.svg"), "-o", out])
        for k in range(15):
            with self.subTest(number=k):
                folder = self.path(f"second{k}")
                process = start(*command.arguments(folder))
                wait_for_handlers(process)
                time.sleep(SHARED.uniform(0, command.seconds))
                process.send_signal(signal.SIGTERM)
                process.send_signal(signal.SIGTERM)
                status, _ = end_of(process)
                self.assertIn(status, (0, 5, -signal.SIGTERM))
                if os.path.isdir(folder):
                    self.assertEqual(hidden(folder), [])

    # Signals that no program survives: they end it, its temporary files go before.
    def test_a_crash_leaves_nothing(self):
        command = Killed(self, "generate", lambda out: [
            "generate", "--set", "A", "--count", "40", "-o", out])
        for kind in (signal.SIGSEGV, signal.SIGABRT, signal.SIGQUIT, signal.SIGUSR1):
            for k in range(4):
                with self.subTest(signal=kind.name, number=k):
                    status, folder = command.once(kind, True)
                    self.assertIn(status, (0, -kind))
                    command.check_files(folder, False)
                    shutil.rmtree(folder)

    def test_nohup_is_heeded(self):
        process = subprocess.Popen(
            [PROGRAM, "run", self.example("blob.svg"), "-o", self.path("out")],
            stderr=subprocess.DEVNULL, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        wait_for_handlers(process)
        process.send_signal(signal.SIGHUP)
        self.assertEqual(process.wait(timeout=60), 0)

    # A limit of processor time asks for the end as SIGTERM does.
    def test_a_limit_of_processor_time(self):
        done = run("run", self.example("spiral.svg"), self.example("interfaces.json"), "-o",
                   self.path("out"), "--refine", "6", "--trade-off",
                   before=lambda: resource.setrlimit(resource.RLIMIT_CPU, (1, 60)))
        self.assertIn(done.status, (0, 5), done)
        if os.path.isdir(self.path("out")):
            self.assertEqual(hidden(self.path("out")), [])

    # The result of the shape is written before its trade-off: it stays, and that is said.
    def test_a_signal_during_the_trade_off(self):
        out = self.path("out")
        process = start("run", "--trade-off", self.example("spiral.svg"), "-o", out)
        while process.poll() is None and not os.path.exists(f"{out}/spiral.svg"):
            time.sleep(0.001)
        process.send_signal(signal.SIGTERM)
        status, said = end_of(process)
        if status == 0:
            self.skipTest("the trade-off was faster")
        self.assertEqual(status, 5, said)
        self.assertEqual(sorted(contents(out)), ["spiral.c1.json", "spiral.svg"])
        self.assertIn("the result was written before", said)
        self.assertNotIn("nothing was written", said)
        self.assertEqual(run("verify", f"{out}/spiral.c1.json").status, 0)

    # A limit of time is no fault: what was reached is a valid result.
    def test_a_time_limit_leaves_a_valid_result(self):
        seconds = self.seconds_of_puzzle()
        for k, part in enumerate((1e-9, 0.1, 0.3, 0.5, 0.8)):
            out = self.path(f"out{k}")
            done = run("run", self.example("puzzle.svg"), "-o", out, "--time-limit", part * seconds)
            self.assertIn(done.status, (0, 5) if part > 0.1 else (5,), done)
            self.assertIn(run("verify", f"{out}/puzzle.c1.json", "--input",
                              self.example("puzzle.svg")).status, (0,), done)

    def seconds_of_puzzle(self):
        begin = time.monotonic()
        self.assertEqual(run("run", self.example("puzzle.svg"), "-o", self.path("p")).status, 0)
        return time.monotonic() - begin


if __name__ == "__main__":
    unittest.main(verbosity=2)
