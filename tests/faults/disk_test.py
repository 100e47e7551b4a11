# SPDX-License-Identifier: GPL-3.0-or-later
"""Full disks, protected folders and files, and names that are taken: status 1, nothing changes."""
from common import *  # noqa: F403


class Disk(FaultTest):
    def disk(self, kilobytes=400):
        disk = SmallDisk(self.path("disk"), kilobytes)
        disk.__enter__()
        self.addCleanup(disk.__exit__)
        return disk

    def commands(self):
        """(arguments, the names they write) of all that writes to the folder `disk`."""
        result = self.make_result()
        out = self.path("disk")
        blob = ["blob.c1.json", "blob.svg", "blob.obj"]
        blob += [f"blob{part}.{mesh}" for part in ("", ".domain") for mesh in ("vtu", "msh", "mesh")]
        yield ["run", self.example("blob.svg"), "-o", out, "--formats", FORMATS], blob
        yield ["run", self.example("blob.svg"), "-o", out], ["blob.c1.json", "blob.svg"]
        yield ["draw", result, "-o", f"{out}/a.svg"], ["a.svg"]
        for extension in FORMATS.split(","):
            yield ["convert", result, "-o", f"{out}/a.{extension}"], [f"a.{extension}"]
        yield ["generate", "--set", "C", "--count", "2", "--formats", "json,svg", "-o", out], [
            "C-0001.json", "C-0001.svg", "C-0002.json", "C-0002.svg"]
        yield ["project", result, "-o", out, "--conformance-bound", "1"], ["blob.c1.json"]
        yield ["evaluate", self.path("good"), "-o", out], [
            "evaluation.json", "evaluation.csv", "evaluation.txt", "histograms.svg",
            "projection.svg"]

    def test_a_full_disk_changes_nothing(self):
        disk = self.disk()
        for arguments, names in self.commands():
            with self.subTest(command=arguments):
                for name in names:
                    write(f"{disk.folder}/{name}", b"old " + name.encode())
                disk.leave(0)
                before = contents(disk.folder)
                self.assert_fails(run(*arguments), 1, "No space left on device")
                self.assertEqual(digest(contents(disk.folder)), digest(before))
                for name in before:
                    os.remove(f"{disk.folder}/{name}")

    # Of the files of one shape either all are new or all are old, wherever the space ends.
    def test_a_disk_that_fills_up_in_the_middle(self):
        disk = self.disk()
        names = ["blob.c1.json", "blob.svg"]
        seen = set()
        for kilobytes in range(0, 60, 4):
            for name in names:
                write(f"{disk.folder}/{name}", b"old")
            disk.leave(kilobytes)
            before = contents(disk.folder)
            done = run("run", self.example("blob.svg"), "-o", disk.folder)
            after = contents(disk.folder)
            self.assertEqual(sorted(after), sorted(before))
            seen.add(done.status)
            if done.status == 0:
                self.assertEqual(run("verify", f"{disk.folder}/blob.c1.json").status, 0)
                self.assertTrue(after["blob.svg"].rstrip().endswith(b"</svg>"))
            else:
                self.assert_fails(done, 1, "No space left on device")
                self.assertEqual(digest(after), digest(before))
            os.remove(f"{disk.folder}/ballast")
        self.assertEqual(seen, {0, 1})

    def test_a_read_only_disk(self):
        for arguments, names in self.commands():
            with self.subTest(command=arguments), SmallDisk(self.path("disk"), 400) as disk:
                for name in names[:1]:
                    write(f"{disk.folder}/{name}", b"old")
                disk.make_read_only()
                self.assert_fails(run(*arguments), 1, "Read-only file system")
                self.assertEqual(contents(disk.folder), {names[0]: b"old"})

    # The inputs that find no room are done when there is.
    def test_a_batch_goes_on_when_there_is_room_again(self):
        disk = self.disk(300)
        inputs = self.path("in")
        run("generate", "--set", "A", "--count", "4", "-o", inputs)
        arguments = ["batch", inputs, "--formats", "json,svg", "-j", "2", "-o"]
        self.assertEqual(run(*arguments, self.path("whole")).status, 0)
        for kilobytes in (0, 8, 60, 120):
            disk.leave(kilobytes)
            done = run(*arguments, disk.folder, "--resume")
            self.assert_fails(done, 1)
            self.assertEqual(hidden(disk.folder), [])
            os.remove(f"{disk.folder}/ballast")
        done = run(*arguments, disk.folder, "--resume")
        self.assertEqual(done.status, 0, done)
        whole, resumed = contents(self.path("whole")), contents(disk.folder)
        for files in (whole, resumed):
            del files["journal.jsonl"], files["times.jsonl"]
        self.assertEqual(digest(resumed), digest(whole))


class FileSize(FaultTest):
    """A limit of the size of files: what a quota does, and needs no file system."""

    def test_a_file_that_may_not_grow(self):
        result = self.make_result()
        before = limited(resource.RLIMIT_FSIZE, 2048)
        os.mkdir(self.path("out"))
        for name in ("blob.c1.json", "blob.svg", "a.vtu"):
            write(self.path("out", name), b"old")
        old = contents(self.path("out"))
        for arguments in (["run", self.example("blob.svg"), "-o", self.path("out")],
                          ["convert", result, "-o", self.path("out", "a.vtu")],
                          ["draw", result, "-o", self.path("out", "blob.svg")],
                          ["batch", self.path("list"), "-o", self.path("out")]):
            write(self.path("list"), self.example("blob.svg").encode())
            done = run(*arguments, before=before)
            self.assertEqual(done.status, 1, (arguments, done))
            now = {name: text for name, text in contents(self.path("out")).items()
                   if not name.endswith(".jsonl")}
            self.assertEqual(digest(now), digest(old), arguments)


class Permissions(FaultTest):
    """As a user who may not: root may do everything."""

    def as_nobody(self, *arguments):
        if os.geteuid() != 0:
            return run(*arguments)
        if "C1MESH_UNSHARED" in os.environ or not shutil.which("setpriv"):
            self.skipTest("there is no other user here, or no setpriv")
        prefix = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
        probe = subprocess.run([*prefix, PROGRAM, "--version"], capture_output=True, check=False)
        if probe.returncode != 0:
            self.skipTest("the program cannot be started as another user")
        return run(*arguments, prefix=prefix)

    def test_a_folder_that_is_not_ours(self):
        result = self.make_result()
        os.mkdir(self.path("out"), 0o555)
        for arguments in (["run", self.example("blob.svg"), "-o", self.path("out")],
                          ["run", self.example("blob.svg"), "-o", self.path("out", "new")],
                          ["convert", result, "-o", self.path("out", "a.obj")],
                          ["draw", result, "-o", self.path("out", "a.svg")],
                          ["generate", "--set", "A", "--count", "1", "-o", self.path("out")],
                          ["project", result, "-o", self.path("out"), "--conformance-bound", "1"],
                          ["evaluate", self.path("good"), "-o", self.path("out")],
                          ["batch", EXAMPLES, "-o", self.path("out")]):
            self.assert_fails(self.as_nobody(*arguments), 1, "Permission denied")
            self.assertEqual(os.listdir(self.path("out")), [])

    # rename() would replace it: the folder may be written.
    def test_a_file_that_is_protected_stays(self):
        result = self.make_result()
        os.mkdir(self.path("out"))
        os.chmod(self.path("out"), 0o777)
        for name in ("a.obj", "blob.svg"):
            write(self.path("out", name), b"old")
            os.chmod(self.path("out", name), 0o444)
        old = contents(self.path("out"))
        for arguments in (["convert", result, "-o", self.path("out", "a.obj")],
                          ["run", self.example("blob.svg"), "-o", self.path("out")]):
            self.assert_fails(self.as_nobody(*arguments), 1, "Permission denied")
            self.assertEqual(digest(contents(self.path("out"))), digest(old))


class Names(FaultTest):
    def test_a_folder_where_a_file_is_wanted(self):
        result = self.make_result()
        for name in ("a.svg", "out/blob.svg"):
            os.makedirs(self.path(name))
        self.assert_fails(run("draw", result, "-o", self.path("a.svg")), 1, "Is a directory")
        done = run("run", self.example("blob.svg"), "-o", self.path("out"))
        self.assert_fails(done, 1, "Is a directory")
        self.assertEqual(contents(self.path("out")), {})  # the .c1.json neither

    def test_a_file_where_a_folder_is_wanted(self):
        result = self.make_result()
        write(self.path("file"), b"old")
        for arguments in (["run", self.example("blob.svg"), "-o", self.path("file")],
                          ["run", self.example("blob.svg"), "-o", self.path("file", "below")],
                          ["project", result, "-o", self.path("file"), "--conformance-bound", "1"],
                          ["evaluate", self.path("good"), "-o", self.path("file")],
                          ["batch", EXAMPLES, "-o", self.path("file")]):
            self.assert_fails(run(*arguments), 1, "cannot create the folder")
        self.assert_fails(run("draw", result, "-o", self.path("file", "a.svg")), 1)
        self.assertEqual(read(self.path("file")), b"old")

    def test_a_link_leads_to_its_file_and_stays(self):
        result = self.make_result()
        os.mkdir(self.path("elsewhere"))
        write(self.path("elsewhere", "real.svg"), b"old")
        os.symlink("elsewhere/real.svg", self.path("a.svg"))
        self.assertEqual(run("draw", result, "-o", self.path("a.svg")).status, 0)
        self.assertTrue(os.path.islink(self.path("a.svg")))
        self.assertIn(b"</svg>", read(self.path("elsewhere", "real.svg")))
        self.assertEqual(os.listdir(self.path("elsewhere")), ["real.svg"])

    def test_a_replaced_file_keeps_its_permissions(self):
        result = self.make_result()
        write(self.path("a.svg"), b"old")
        os.chmod(self.path("a.svg"), 0o640)
        self.assertEqual(run("draw", result, "-o", self.path("a.svg")).status, 0)
        self.assertEqual(os.stat(self.path("a.svg")).st_mode & 0o777, 0o640)

    # A device must not become a file: else root could lose /dev/null.
    def test_a_pipe_or_a_device_is_written_as_it_is(self):
        result = self.make_result()
        whole = run("draw", result, "-o", "-").out
        os.mkfifo(self.path("pipe.svg"))
        reader = subprocess.Popen(["cat", self.path("pipe.svg")], stdout=subprocess.PIPE)
        self.assertEqual(run("draw", result, "-o", self.path("pipe.svg")).status, 0)
        self.assertEqual(reader.communicate()[0], whole)
        self.assertFalse(os.path.isfile(self.path("pipe.svg")))
        self.assertEqual(run("draw", result, "-o", "/dev/stdout").out, whole)
        device = self.path("full")
        try:
            os.mknod(device, 0o600 | 0o020000, os.makedev(1, 7))
            with open(device, "wb"):
                pass
        except OSError:
            return  # only root may, and not in every name space
        self.assert_fails(run("draw", result, "-o", device), 1, "No space left on device")
        self.assertFalse(os.path.isfile(device))


if __name__ == "__main__":
    with_mounts()
    unittest.main(verbosity=2)
