# SPDX-License-Identifier: GPL-3.0-or-later
"""A batch that is killed at random moments, several times, and resumed gives what one that nobody
disturbs gives; a killed child is one input's failure, and is done again."""
from common import *  # noqa: F403

RANDOM = random.Random(1701)


class Batch(FaultTest):
    def setUp(self):
        super().setUp()
        run("generate", "--set", "A", "--count", "3", "-o", self.path("in"))
        write(self.path("in", "many.svg"), polygons(12))
        write(self.path("in", "torn.json"), b'[{"curve_id":0,')
        self.status = 3

    def arguments(self, out, *more):
        return ["batch", self.path("in"), "-o", self.path(out), "-j", "2", *more]

    def whole(self):
        begin = time.monotonic()
        done = run(*self.arguments("whole"))
        self.assertEqual(done.status, self.status, done)
        return self.results("whole"), time.monotonic() - begin

    def results(self, out):
        """All but what the clock says and the order in which inputs were finished."""
        files = contents(self.path(out))
        return {name: text for name, text in files.items()
                if name not in ("journal.jsonl", "times.jsonl")}

    def names_in_times(self, out):
        lines = read(self.path(out, "times.jsonl")).splitlines()
        return [(line["input"], line["name"]) for line in map(json.loads, lines)]

    def test_ended_many_times_and_resumed(self):
        whole, seconds = self.whole()
        ended = 0
        for k in range(6):
            out = f"out{k}"
            for _ in range(4):
                kind = RANDOM.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM,
                                      signal.SIGHUP])
                process = start(*self.arguments(out, "--resume"))
                if kind != signal.SIGKILL:
                    wait_for_handlers(process)
                time.sleep(RANDOM.uniform(0, 0.7 * seconds))
                process.send_signal(kind)
                status, said = end_of(process)
                if status == self.status:
                    continue
                ended += 1
                self.assertEqual(status, -kind if kind == signal.SIGKILL else 5, said)
                if not os.path.isdir(self.path(out)):
                    continue
                for name, text in self.results(out).items():
                    if os.path.basename(name).startswith("."):
                        self.assertEqual(kind, signal.SIGKILL, name)
                        continue
                    self.assertEqual(text, whole[name], f"{name} is not whole")  # the index too
            done = run(*self.arguments(out, "--resume"))
            self.assertEqual(done.status, self.status, done)
            self.assertEqual(digest(self.results(out)), digest(whole))
            self.assertEqual(self.names_in_times(out), self.names_in_times("whole"))
        self.assertGreater(ended, 6)

    # The children of a batch that is gone end by themselves, and tidy up.
    def test_children_do_not_outlive_it(self):
        for k in range(4):
            process = start(*self.arguments(f"out{k}"))
            children = []
            while process.poll() is None and not children:
                children = self.children(process.pid)
            time.sleep(RANDOM.uniform(0, 0.1))
            children += self.children(process.pid)
            process.kill()
            end_of(process)
            deadline = time.monotonic() + 10
            while any(map(self.is_alive, children)) and time.monotonic() < deadline:
                time.sleep(0.01)
            self.assertFalse(any(map(self.is_alive, children)))
            self.assertEqual(hidden(self.path(f"out{k}")), [])

    @staticmethod
    def children(pid):
        try:
            with open(f"/proc/{pid}/task/{pid}/children", encoding="ascii") as file:
                return [int(child) for child in file.read().split()]
        except OSError:
            return []

    @staticmethod
    def is_alive(pid):
        try:
            with open(f"/proc/{pid}/stat", encoding="ascii") as file:
                return file.read().rsplit(")", 1)[1].split()[0] not in "ZX"
        except OSError:
            return False

    # Children killed while they work, whichever it hits.
    def test_killed_children(self):
        whole, _ = self.whole()
        hit = 0
        for k in range(4):
            out = f"out{k}"
            process = start(*self.arguments(out))
            for _ in range(3):
                time.sleep(RANDOM.uniform(0.01, 0.1))
                for child in self.children(process.pid)[:1]:
                    try:
                        os.kill(child, signal.SIGKILL)
                    except ProcessLookupError:
                        continue
            status, said = end_of(process)
            self.assertIn(status, (1, self.status), said)
            index = [json.loads(line) for line in read(self.path(out, "index.jsonl")).splitlines()]
            killed = [line for line in index if line["status"] == 1]
            self.assertTrue(all("signal 9" in line["message"] for line in killed), killed)
            self.assertEqual(status == 1, bool(killed))
            hit += len(killed)
            self.assertEqual(hidden(self.path(out)), [])
            for name, text in self.results(out).items():
                if name != "index.jsonl":
                    self.assertEqual(text, whole[name])
            done = run(*self.arguments(out, "--resume"))
            self.assertEqual(done.status, self.status, done)
            self.assertEqual(digest(self.results(out)), digest(whole))
        self.assertGreater(hit, 0)

    # Limits at which all, some or none of the shapes get through: the largest at which something
    # fails is found by halving.
    def test_children_short_of_memory(self):
        whole, _ = self.whole()
        low, high, failed = 1, 2048, []
        while high - low > 4:
            middle = (low + high) // 2
            out = f"memory{middle}"
            done = run(*self.arguments(out, "--memory-limit", middle))
            index = [json.loads(line) for line in read(self.path(out, "index.jsonl")).splitlines()]
            self.assertEqual(len(index), 3 + 12 + 1)
            bad = [line for line in index if line["status"] not in (0, 3)]
            self.assertEqual({line["status"] for line in bad} - {5}, set(), (done, bad))
            self.assertEqual(done.status, self.status)
            self.assertEqual(hidden(self.path(out)), [])
            for name, text in self.results(out).items():
                if name != "index.jsonl":
                    self.assertEqual(text, whole[name])
            low, high = (middle, high) if bad else (low, middle)
            failed += bad
        self.assertTrue(all("memory" in line["message"] for line in failed))


if __name__ == "__main__":
    unittest.main(verbosity=2)
