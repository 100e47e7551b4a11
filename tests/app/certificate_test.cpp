// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates and --c1-bound through the program.
#include "c1mesh/certificate.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "c1mesh/result.h"
#include "program.h"

namespace c1mesh {
namespace {

using testing_app::Folder;
using testing_app::Ran;

std::string example(const std::string& name) {
  return C1MESH_EXAMPLES "/" + name;
}

std::string run_with_bound(double bound) {
  return fmt::format("run -o out --c1-bound {} ", bound);
}

TEST(CertificateCommand, IsWrittenAndFollowed) {
  const Folder folder;
  const Ran run =
      folder.run("run -o out --certificate proofs/blob.cert.json " + example("blob.svg"));
  ASSERT_EQ(run.status, 0) << run.err;
  const Ran followed = folder.run("verify out/blob.c1.json --certificate proofs/blob.cert.json");
  EXPECT_EQ(followed.status, 0) << followed.err;
  EXPECT_NE(followed.err.find("all its proofs and bounds hold"), std::string::npos);
  // The same proofs, searched for in the file alone.
  EXPECT_EQ(folder.run("verify out/blob.c1.json --write-certificate again.json").status, 0);
  const Certificate first = parse_certificate(folder.read("proofs/blob.cert.json"));
  const Certificate second = parse_certificate(folder.read("again.json"));
  ASSERT_EQ(first.triangles.size(), second.triangles.size());
  EXPECT_EQ(first.g, second.g);
  EXPECT_EQ(first.det, second.det);
  EXPECT_EQ(first.c1, second.c1);
  EXPECT_EQ(first.g, parse_result(folder.read("out/blob.c1.json"), "blob").metrics.mips_bound_max);
}

TEST(CertificateCommand, AFalseBoundHasStatus4) {
  const Folder folder;
  ASSERT_EQ(folder.run("run -o out --formats json,cert " + example("blob.svg")).status, 0);
  Certificate bad = parse_certificate(folder.read("out/blob.cert.json"));
  bad.triangles[0].det *= 2;
  folder.write("bad.json", format_certificate(bad));
  const Ran ran = folder.run("verify out/blob.c1.json --certificate bad.json");
  EXPECT_EQ(ran.status, 4);
  EXPECT_NE(ran.err.find("triangle 0"), std::string::npos) << ran.err;
  folder.write("cut.json", folder.read("bad.json").substr(0, 300));
  // What cannot be read is told under its own name.
  for (const std::string name : {"cut.json", "none.json"}) {
    const Ran unread = folder.run("verify out/blob.c1.json --certificate " + name);
    EXPECT_EQ(unread.status, 3);
    EXPECT_NE(unread.err.find(name), std::string::npos) << unread.err;
    EXPECT_EQ(unread.err.find("blob.c1.json"), std::string::npos) << unread.err;
  }
}

// One file holds one certificate.
TEST(CertificateCommand, IsForOneShape) {
  const Folder folder;
  const std::string both = example("blob.svg") + " " + example("puzzle.svg");
  const Ran ran = folder.run("run -o out --certificate c.json " + both);
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_EQ(parse_certificate(folder.read("c.json")).name, "blob");
  EXPECT_EQ(folder.run("verify a.c1.json b.c1.json --certificate c.json").status, 2);
  EXPECT_EQ(folder.run("verify a.c1.json --certificate c.json --write-certificate d.json").status,
            2);
}

// Status 0 only if the certified bound is kept; the file claims it and is held to it.
TEST(C1Bound, IsKeptOrMissedAsMeasured) {
  const Folder folder;
  ASSERT_EQ(folder.run("run -o out " + example("blob.svg")).status, 0);
  const double found = parse_result(folder.read("out/blob.c1.json"), "blob").metrics.d_ei.max;
  ASSERT_GT(found, 0);
  const auto bounded = [&](double bound) {
    return folder.run(run_with_bound(bound) + example("blob.svg"));
  };
  EXPECT_EQ(bounded(2 * found).status, 0);
  EXPECT_EQ(folder.run("verify out/blob.c1.json").status, 0);
  const Ran missed = bounded(found / 2);
  EXPECT_EQ(missed.status, 4) << missed.err;
  EXPECT_NE(missed.err.find("C1 is invalid"), std::string::npos) << missed.err;
  EXPECT_EQ(folder.run("verify out/blob.c1.json").status, 4);
}

}  // namespace
}  // namespace c1mesh
