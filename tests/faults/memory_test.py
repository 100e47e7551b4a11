# SPDX-License-Identifier: GPL-3.0-or-later
"""Too little memory at any level: status 5 and no files, never an end by a signal."""
from common import *  # noqa: F403

# Below this the dynamic linker has the last word.
LOADER = ("error while loading shared libraries", "cannot allocate memory in static TLS",
          "cannot create shared object descriptor", "cannot map")
MB = 1 << 20


class Memory(FaultTest):
    def enough(self, arguments):
        """MB of address space with which it works, to several per cent."""
        low, high = 1, 4096
        while high - low > max(1, low // 16):
            middle = (low + high) // 2
            done = run(*arguments(self.path("try")),
                       before=limited(resource.RLIMIT_AS, middle * MB))
            if done.status in (0, 4):
                high = middle
            else:
                low = middle
        shutil.rmtree(self.path("try"), ignore_errors=True)
        return high

    def levels(self, name, arguments, good=(0,), steps=10):
        enough = self.enough(arguments)
        refused = 0
        for k in range(steps):
            level = int(MB * enough * (0.25 + 0.78 * k / steps)) + 4096 * k
            out = self.path(f"{name}{k}")
            with self.subTest(command=name, megabytes=level / MB):
                os.makedirs(out, exist_ok=True)
                done = run(*arguments(out), before=limited(resource.RLIMIT_AS, level))
                if done.status in (1, 127) and any(words in done.err for words in LOADER):
                    continue
                self.assertIn(done.status, (5, *good), (done, contents(out).keys()))
                self.assertEqual(hidden(out), [])
                if done.status == 5:
                    self.assertIn("memory", done.err)
                    self.assertEqual(contents(out), {})
                    refused += 1
        return refused

    def test_run(self):
        arguments = lambda out: ["run", self.example("puzzle.svg"), "-o", out]  # noqa: E731
        self.assertGreater(self.levels("run", arguments), 0)

    def test_run_with_one_thread(self):
        self.levels("one", lambda out: ["run", "--threads", "1", self.example("annulus.svg"), "-o",
                                        out])

    def test_the_method_of_the_paper(self):
        self.levels("paper", lambda out: ["run", "--method", "paper", self.example("blob.svg"),
                                          "-o", out], (0, 4), 8)

    def test_commands_on_results(self):
        result = self.make_result()
        for name, arguments in (
                ("convert", lambda out: ["convert", result, "-o", f"{out}/a.obj",
                                         "--tessellation", "256"]),
                ("project", lambda out: ["project", result, "-o", out, "--conformance-bound",
                                         "1"]),
                ("evaluate", lambda out: ["evaluate", self.path("good"), "-o", out])):
            self.levels(name, arguments, (0,), 6)


if __name__ == "__main__":
    unittest.main(verbosity=2)
