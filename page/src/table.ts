// SPDX-License-Identifier: GPL-3.0-or-later
// What the result states, beside what this page computes of it in doubles.
import { Model, Plain, Spread } from "./data";
import { Mesh } from "./mesh";
import { byId, compact, element, plural, readable, row } from "./text";

/** What a result claims where its parameters say nothing (docs/format.md). */
const kC1Bound = 1e-11, kConformanceBound = 1e-13;

function parameter(model: Model, name: string): Plain | undefined {
  return model.parameters.find(([key]) => key === name)?.[1];
}

function numberParameter(model: Model, name: string, otherwise: number): number {
  const value = parameter(model, name);
  return typeof value === "number" ? value : otherwise;
}

export interface Claim {
  holds: boolean;
  text: string;
}

/** The claims of the file, and whether its own metrics and this page's figures agree with them. */
export function claims(model: Model, mesh: Mesh): Claim[] {
  const m = model.metrics, c1 = numberParameter(model, "c1_bound", kC1Bound);
  const conformance = numberParameter(model, "conformance_bound", kConformanceBound);
  const surplus = m.surplus ?? 0;
  const relaxed = mesh.interiorEdges - mesh.c1Edges;
  return [
    {
      holds: mesh.leastDet > 0,
      text: mesh.leastDet > 0 ? "Regular: det J is positive everywhere" : "A coefficient of det J is not positive",
    },
    {
      holds: mesh.c1Edges > 0 && (m.d_ei?.max ?? 0) <= c1,
      text: mesh.c1Edges === 0
        ? "C1 across no edge"
        : `C1 across ${relaxed === 0 ? "all" : `${mesh.c1Edges.toLocaleString("en")} of`} ${plural(mesh.interiorEdges, "inner edge", "inner edges")}, d_ei \u2264 ${readable(c1, 2)}`,
    },
    {
      holds: (m.conformance_max ?? 0) <= conformance,
      text: `The boundary is the input's, to ${readable(conformance, 2)} of its extent`,
    },
    {
      holds: surplus <= 0,
      text: surplus <= 0 ? "No more exceptional vertices than are needed"
                         : `${plural(surplus, "exceptional vertex", "exceptional vertices")} more than the bound from corners`,
    },
    { holds: !m.domain_overlaps, text: m.domain_overlaps ? "The domain overlaps itself in the plane" : "The domain does not overlap itself" },
  ];
}

function spreadCells(spread: Spread | undefined): string[] {
  return [spread?.median, spread?.p99, spread?.max].map(compact);
}

function fillMetrics(model: Model, mesh: Mesh): void {
  const m = model.metrics;
  byId("metric-rows").replaceChildren(
    row("Triangles", [plural(model.triangleCount, "", "").trim()]),
    row("Degree", [String(model.degree)]),
    row("Input curves", [String(model.curveCount)]),
    row("Boundary corners", [String(model.corners)]),
    row("Exceptional vertices", [String(m.exceptional ?? model.exceptional.length)], "where C1 is given up"),
    row("\u2026 at least needed", [String(m.exceptional_minimum ?? "\u2013")]),
    row("\u2026 surplus", [String(m.surplus ?? "\u2013")]),
    row("Flat smooth vertices", [m.flatness_ratio == null ? "\u2013" : `${readable(100 * m.flatness_ratio, 4)} %`]),
    row("Conformance", [readable(m.conformance_max, 3)], "largest distance of a boundary control point from its exact place"),
  );
  byId("check-rows").replaceChildren(
    row("Largest g", [readable(m.mips_bound_max), readable(mesh.largestDistortion)], "bound of the distortion, over all triangles"),
    row("Least det J", [compact(m.min_det_coefficient), compact(mesh.leastDet)], "least Bernstein coefficient, both planes scaled to extent 1"),
    row("Largest d_ei", [compact(m.d_ei?.max), compact(mesh.largestDeviation)], "C1 deviation where C1 is asked, relative to the extent"),
  );
  byId("spread-rows").replaceChildren(
    row("d_ei", spreadCells(m.d_ei)),
    row("Gradient angle,\u00a0\u00b0", spreadCells(m.gradient_angle_deg), "between the two triangles' gradients along an edge"),
    row("Gradient length", spreadCells(m.gradient_magnitude), "relative difference of the lengths of the two triangles' gradients"),
  );
}

export function fillTables(model: Model, mesh: Mesh): void {
  fillMetrics(model, mesh);
  byId("claim-list").replaceChildren(
    ...claims(model, mesh).map((claim) => {
      const item = element("li", "", { "data-holds": String(claim.holds) });
      item.append(element("span", claim.holds ? "Holds: " : "Does not hold: ", { class: "unseen" }), claim.text);
      return item;
    }));
  byId("parameter-rows").replaceChildren(...model.parameters.map(([name, value]) => row(name, [String(value)])));
  byId("seconds-rows").replaceChildren(
    ...Object.entries(model.metrics.seconds ?? {}).map(([stage, seconds]) => row(stage, [`${readable(seconds, 3)} s`])));
}

/** The line below the name. */
export function summaryText(model: Model): string {
  const m = model.metrics, count = model.exceptional.length;
  const vertices = count === 0 ? "C1 everywhere"
    : `${plural(count, "exceptional vertex", "exceptional vertices")}${(m.surplus ?? 1) <= 0 ? ", the fewest possible" : ""}`;
  return `${plural(model.triangleCount, "triangle", "triangles")} of degree ${model.degree} \u00b7 ${vertices} \u00b7 g ${readable(m.mips_bound_max, 3)}`;
}
