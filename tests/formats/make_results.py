# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the results that the other tests of this folder read back, in every format.

usage: make_results.py PROGRAM SOURCE OUT

Every example, twenty small real shapes, and one hand-made triangle of each degree, whose control
points are all different."""

import json
import pathlib
import random
import shutil
import subprocess
import sys

CORPUS = """
M_bi_arrow-through-heart-fill_p1 M_bi_exclamation-triangle-fill_p1 M_bi_pencil-fill_p1_s2
M_ion_archive_p1 M_oc_computer.icons.etiquette-theme.apps.gthumb_path1106
M_oc_containers.valigie_bags_architetto__01_path485 M_oc_geography.arkansas_symbol_ganson_p65
M_oc_shapes.red_lips_01_path1070 M_tango_actions.contact-new_text6970_s2 S_bi_envelope-heart-fill_p1_s3
S_bi_p-square-fill_p2 S_bi_terminal-split_p1_s2 S_ion_cloud-upload_p1_s1 S_ion_triangle_p1
S_oc_buttons.glass_buttons_lumen_desi_01_text1356_s15
S_oc_containers.recycling_box_3d_a.j._as_01_path2742_s3
S_oc_education.inservice_presentation_01_path551 S_oc_food.fruit.candied_apples_ganson_p259
S_oc_shapes.arrows.reincarnate_nurbldoff_01r_path590
S_tango_apps.preferences-desktop-remote-desktop_path2443
""".split()
HIGHEST_GMSH_DEGREE = 10
DEGREES = [*range(1, 9), 10, 11]  # the last above Gmsh's highest
OK, BOUND_MISSED = 0, 4
ZERO = {"median": 0, "p99": 0, "max": 0}


def triangle_of_degree(n):
    """A result of one triangle: the lattice of (0,0), (7,1), (2,5), every point moved a little."""
    chosen = random.Random(n)
    domain = [[0.0, 0.0], [3.0, 0.25], [0.5, 2.0]]

    def near(x):
        return (x + chosen.uniform(-0.2, 0.2)) / n

    lattice = [(i, j) for j in range(n + 1) for i in range(n + 1 - j)]
    points = [[near(7 * i + 2 * j), near(i + 5 * j)] for i, j in lattice]
    at = {ij: k for k, ij in enumerate(lattice)}
    sides = [[at[i, 0] for i in range(n + 1)], [at[n - i, i] for i in range(n + 1)],
             [at[0, n - i] for i in range(n + 1)]]
    # One curve runs against the boundary.
    against = [False, True, False]
    return {
        "format": "c1mesh", "version": 1, "degree": n,
        "domain_vertices": domain, "triangles": [[0, 1, 2]],
        "control_points": points, "triangle_control_points": [list(range(len(points)))],
        "curves": [{"poles": [points[k] for k in (reversed(side) if against[m] else side)]}
                   for m, side in enumerate(sides)],
        "boundary_edges": [[m, (m + 1) % 3, m, int(against[m]), int(not against[m])]
                           for m in range(3)],
        "feature_edges": [], "boundary_vertices": [[m, "corner"] for m in range(3)],
        "exceptional_vertices": [1], "relaxed_edges": [], "parameters": {},
        "metrics": {"d_ei": ZERO, "gradient_angle_deg": ZERO, "gradient_magnitude": ZERO,
                    "mips_bound_max": 9, "min_det_coefficient": 1, "conformance_max": 0,
                    "exceptional": 1, "exceptional_minimum": 0, "exceptional_minimum_paper": 0,
                    "surplus": 1, "flatness_ratio": 1, "domain_overlaps": False, "triangles": 1,
                    "seconds": {}}}


def main():
    program, source, out = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    examples = sorted(p for p in (source / "examples").iterdir() if p.suffix in (".svg", ".json"))
    corpus = [source / "tests" / "data" / "corpus" / (name + ".json") for name in CORPUS]
    run = subprocess.run([program, "run", *examples, *corpus, "-o", out, "--quiet", "--threads", "2",
                          "--formats", "json,vtu,msh,mesh,obj"], check=False)
    if run.returncode not in (OK, BOUND_MISSED):
        return f"c1mesh run ended with status {run.returncode}"
    for n in DEGREES:
        name = out / f"degree-{n}"
        pathlib.Path(f"{name}.c1.json").write_text(json.dumps(triangle_of_degree(n)), encoding="utf-8")
        for ending in ("vtu", "domain.vtu", "mesh", "domain.mesh", "obj", "msh", "domain.msh"):
            if ending.endswith("msh") and n > HIGHEST_GMSH_DEGREE:
                continue
            subprocess.run([program, "convert", f"{name}.c1.json", "-o", f"{name}.{ending}"], check=True)
    for result in sorted(out.glob("*.c1.json")):
        for domain in ("", ".domain"):
            lagrange = f"{str(result)[:-len('.c1.json')]}.lagrange{domain}.vtu"
            subprocess.run([program, "convert", result, "-o", lagrange, "--lagrange"], check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
