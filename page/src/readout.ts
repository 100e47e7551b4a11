// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of the point that is shown.
import { Hover } from "./hover";
import { Model } from "./data";
import { Mesh, Sample } from "./mesh";
import { byId, coordinate, readable, row } from "./text";

const kNothing = "\u2013";

function matrixText([a, b, c, d]: readonly number[]): string[] {
  return [`${readable(a)}  ${readable(c)}`, `${readable(b)}  ${readable(d)}`];
}

/** Name, value, explanation. */
type Row = [string, string, string];

/** The rows of a point, or with dashes for none. */
export function readoutRows(model: Model, mesh: Mesh, hover: Hover | null): Row[] {
  const p = hover?.sample, [first, second] = p ? matrixText(p.jacobian) : ["", ""];
  const show = (value: (point: Sample) => string) => (p ? value(p) : kNothing);
  return [
    ["Shape", show((q) => `${coordinate(q.x, model.extent)}, ${coordinate(q.y, model.extent)}`), "x, y in the input's units"],
    ["Domain", show((q) => `${coordinate(q.u, model.domainFrame.extent)}, ${coordinate(q.v, model.domainFrame.extent)}`), "u, v"],
    ["Triangle", show((q) => String(q.triangle)), "counted from 0, as in the file"],
    ["Barycentric", show((q) => q.at.map((x) => Math.max(0, x).toFixed(3)).join("  ")), "at its corners"],
    ["Jacobian", show(() => `${first}\n${second}`), "dx/du dx/dv, dy/du dy/dv"],
    ["det J", show((q) => readable(q.det, 5)), "how much areas grow"],
    ["Distortion", show((q) => readable(q.distortion, 5)), "|J|\u00b2 / det J here; 2 is a similarity"],
    ["Bound g", show((q) => readable(mesh.distortion[q.triangle], 5)), "g of the triangle: bounds its distortion"],
    ["C1 deviation", show((q) => readable(mesh.deviation[q.triangle], 3)), "largest d_ei of the triangle's edges, relative to the extent"],
  ];
}

export class Readout {
  private readonly body = byId<HTMLTableSectionElement>("point-rows");
  private readonly places = { shape: byId("shape-place"), domain: byId("domain-place") };

  constructor(private readonly model: Model, private readonly mesh: Mesh) {}

  show(hover: Hover | null, pinned: boolean): void {
    byId("point-hint").textContent = !hover ? "hover over a view" : pinned ? "pinned" : "click to pin";
    byId("point").dataset.pinned = String(pinned && hover !== null);
    const rows = readoutRows(this.model, this.mesh, hover);
    this.body.replaceChildren(...rows.map(([name, value, title]) => row(name, [value], title)));
    this.places.shape.textContent = hover ? rows[0][1] : "";
    this.places.domain.textContent = hover ? rows[1][1] : "";
  }

  /** For who hears the page. */
  say(hover: Hover | null): void {
    byId("live").textContent = hover
      ? readoutRows(this.model, this.mesh, hover).slice(0, 3).map(([name, value]) => `${name} ${value}`).join("; ")
      : "No point";
  }
}
