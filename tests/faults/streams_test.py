# SPDX-License-Identifier: GPL-3.0-or-later
"""Standard output that is full, closed or left by its reader: status 1 and a message, or a whole
result in the files."""
from common import *  # noqa: F403

SILENT_END = -signal.SIGPIPE


class Streams(FaultTest):
    def printing(self):
        result = self.make_result()
        return [["run", self.example("blob.svg"), "-o", "-"],
                ["draw", result, "-o", "-"],
                ["evaluate", self.path("good")],
                ["--version"],
                ["run", "--help"]]

    def test_a_full_standard_output(self):
        for arguments in self.printing():
            with open("/dev/full", "wb") as full:
                done = run(*arguments, stdout=full)
            self.assert_fails(done, 1, "cannot write to standard output")

    def test_a_closed_standard_output(self):
        for arguments in self.printing():
            done = run(*arguments, before=lambda: os.close(1))
            self.assert_fails(done, 1, "cannot write to standard output")

    def test_a_reader_that_leaves(self):
        for arguments in self.printing():
            out, into = os.pipe()
            os.close(out)
            done = run(*arguments, stdout=into)
            os.close(into)
            self.assert_fails(done, 1, "cannot write to standard output")

    # The data is larger than a pipe holds, so that head is gone before the end.
    def test_a_reader_of_one_line(self):
        write(self.path("many.svg"), polygons(200))
        done = subprocess.run(
            f"'{PROGRAM}' run -q '{self.path('many.svg')}' -o - | head -n 1; "
            "echo ${PIPESTATUS[0]}", shell=True, executable="/bin/bash", capture_output=True,
            check=False)
        self.assertEqual(done.stdout.split(b"\n")[1], b"1", done)
        self.assertIn(b"cannot write to standard output", done.stderr)

    # What is said to people may get lost; the work goes on.
    def test_messages_that_nobody_reads(self):
        whole = run("run", self.example("blob.svg"), "-o", self.path("whole"))
        self.assertEqual(whole.status, 0)
        for k, close in enumerate((lambda: os.close(2), lambda: (os.close(1), os.close(2)),
                                   lambda: (os.close(0), os.close(1), os.close(2)))):
            done = run("-v", "run", self.example("blob.svg"), "-o", self.path(f"out{k}"), before=close)
            self.assertEqual(done.status, 0, done)
            self.assertEqual(digest(contents(self.path(f"out{k}"))),
                             digest(contents(self.path("whole"))))
        out, into = os.pipe()
        os.close(out)
        process = subprocess.Popen([PROGRAM, "-v", "run", self.example("blob.svg"), "-o",
                                    self.path("broken")], stderr=into, stdout=subprocess.DEVNULL)
        os.close(into)
        self.assertEqual(process.wait(timeout=60), 0)
        self.assertEqual(digest(contents(self.path("broken"))), digest(contents(self.path("whole"))))

    # Else the journal would be file number 2, and the table of counts in it.
    def test_a_batch_without_standard_error(self):
        write(self.path("list"), self.example("blob.svg").encode())
        for name, before in (("one", None), ("two", lambda: os.close(2))):
            done = run("batch", self.path("list"), "-o", self.path(name), before=before)
            self.assertEqual(done.status, 0, done)
            for line in read(self.path(name, "journal.jsonl")).splitlines():
                json.loads(line)
        self.assertEqual(read(self.path("one", "index.jsonl")), read(self.path("two", "index.jsonl")))


if __name__ == "__main__":
    unittest.main(verbosity=2)
