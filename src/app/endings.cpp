// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/endings.h"

namespace c1mesh::app {
namespace {

constexpr const char* kStatuses = R"(
Exit status: 0 all that was asked holds and was verified; 1 internal error; 2 wrong command line;
3 invalid input, nothing written; 4 valid, but a bound is missed; 5 ended by a limit or a signal.
Of several inputs the worst counts, from best to worst: 0, 4, 5, 3, 2, 1.
)";

struct Ending {
  const char* command;
  const char* notes;  ///< lines that end in a line feed, or none
  const char* examples;
};

// The examples follow one another: what one uses an earlier one made, of shape.svg and list.txt.
constexpr Ending kEndings[] = {
    {"", "Help of a command: c1mesh COMMAND --help.\n",
     "  c1mesh check shape.svg           is it a shape?\n"
     "  c1mesh run shape.svg -o out      the map: out/shape.c1.json, and a picture of it\n"
     "  c1mesh verify out/shape.c1.json  certified from the file alone"},
    {"run", "Many shapes: c1mesh batch.\n",
     "  c1mesh run shape.svg -o out\n"
     "  c1mesh run shape.svg -o out --formats json,svg,vtu,msh,mesh\n"
     "  c1mesh run shape.svg -o low --exceptional 4 --refine 4    for a lower distortion\n"
     "  c1mesh run --font DejaVuSans.ttf --text Bezier -o out     every letter a shape"},
    {"batch",
     "Each input is worked on in a process of its own; what ends one ends no other. index.jsonl "
     "has "
     "a line\nper result, times.jsonl its seconds; journal.jsonl is for --resume.\n",
     "  c1mesh batch shapes -o results                        every .json and .svg of a folder\n"
     "  c1mesh batch list.txt -o listed --jobs 8 --resume     goes on where it was ended\n"
     "  c1mesh batch shapes -o sharded --shard 3/16           every 16th input, from the third on\n"
     "  LC_ALL=C sort sharded/index.*-of-16.jsonl > sharded/index.jsonl"},
    {"check", "",
     "  c1mesh check shape.svg\n"
     "  c1mesh check drawing.svg --together    all of a drawing as one arrangement"},
    {"verify", "",
     "  c1mesh verify out/shape.c1.json\n"
     "  c1mesh verify out/shape.c1.json --input shape.svg    and that it is of this shape\n"
     "  c1mesh verify out/DejaVuSans-1-B.c1.json --font DejaVuSans.ttf --text Bezier\n"
     "  c1mesh verify out/shape.c1.json --write-certificate shape.cert\n"
     "  c1mesh verify out/shape.c1.json --certificate shape.cert"},
    {"project", "",
     "  c1mesh run shape.svg -o paper --method paper\n"
     "  c1mesh project paper/shape.c1.json -o projected"},
    {"draw", "",
     "  c1mesh draw out/shape.c1.json -o shape.svg.svg\n"
     "  c1mesh draw out/shape.c1.json -o distortion.svg --colour distortion --grid 0\n"
     "  c1mesh draw out/shape.c1.json low/shape.c1.json -o both.svg --parts shape --columns 2"},
    {"convert", "",
     "  c1mesh convert out/shape.c1.json -o shape.vtu     for ParaView\n"
     "  c1mesh convert out/shape.c1.json -o shape.msh     for Gmsh\n"
     "  c1mesh convert out/shape.c1.json -o shape.mesh    for MFEM\n"
     "  c1mesh convert out/shape.c1.json -o shape.html    a page to explore it"},
    {"generate", "",
     "  c1mesh generate --set A --count 3 -o shapes\n"
     "  c1mesh generate --family spiral --count 4 --formats svg -o spirals"},
    {"evaluate", "",
     "  c1mesh evaluate results\n"
     "  c1mesh evaluate results -o tables --labels mine"},
    {"manual", "",
     "  c1mesh manual run | man -l -\n"
     "  c1mesh manual -o man1    a page for every command"},
    {"completion", "",
     "  c1mesh completion bash > c1mesh-completion.bash    to be sourced by ~/.bashrc"},
};

}  // namespace

void add_endings(CLI::App& program) {
  for (const Ending& ending : kEndings) {
    CLI::App* app = &program;
    if (*ending.command != '\0') app = program.get_subcommand(ending.command);
    app->footer(std::string(kStatuses) + ending.notes + kExamples + "\n" + ending.examples);
  }
}

}  // namespace c1mesh::app
